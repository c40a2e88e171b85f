// SPDX-License-Identifier: GPL-3.0-or-later
// JR3 PCI receiver cards as comedi's driver jr3_pci shows them: one subdevice per sensor, eight
// channels per filter. Also the short frames between card and session, so that a card can be used
// as a bus. Pure. Wrenches are in the sensor frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

inline constexpr unsigned kJr3ComediChannels = 58;  ///< of each subdevice
inline constexpr unsigned kJr3SerialChannel = 57;
inline constexpr std::uint32_t kJr3HighestSample = 0x7FFF;

/// Cut-off [Hz] to the number of the filter: 0 (none), 500, 125, 31.25, 7.8125, 1.953125 or
/// 0.48828125.
[[nodiscard]] std::optional<std::uint8_t> jr3_comedi_filter(double cutoff_Hz) noexcept;
/// Axes are Fx Fy Fz Mx My Mz.
[[nodiscard]] constexpr unsigned jr3_comedi_channel(unsigned filter, unsigned axis) noexcept {
  return 8 * filter + axis;
}
/// Full scale [N, N m] from comedi's highest value of a channel, which is in kN or kN m.
[[nodiscard]] constexpr double jr3_comedi_full_scale(double most) noexcept {
  return 1000.0 * most;
}

/// Six channels of one sensor as read.
using Jr3ComediSamples = std::array<std::uint16_t, 6>;
/// Counts: the full scale is ±16384.
[[nodiscard]] RawCounts jr3_comedi_counts(const Jr3ComediSamples& samples) noexcept;
/// A sample at the end of its range was clipped. (+full scale itself has no sample value.)
[[nodiscard]] bool jr3_comedi_saturated(const Jr3ComediSamples& samples) noexcept;
/// Full scales in [N, N m].
[[nodiscard]] Wrench wrench_of(const Jr3ComediSamples& samples, const Vec6& full_scale) noexcept;

/// What a session asks: BusFrame::id is the number of the sensor.
struct Jr3ComediQuestion {
  enum class Kind : std::uint8_t { samples, identity };
  Kind kind = Kind::samples;
  std::uint8_t subdevice = 0;
  std::uint8_t filter = 0;
};
[[nodiscard]] BusFrame jr3_comedi_frame(std::uint32_t sensor,
                                        const Jr3ComediQuestion& question) noexcept;
[[nodiscard]] std::optional<Jr3ComediQuestion> jr3_comedi_question(const BusFrame& frame) noexcept;

struct Jr3ComediIdentity {
  std::uint32_t serial_number = 0;
  Vec6 full_scale = Vec6::Zero();  ///< [N, N m]
};
[[nodiscard]] BusFrame jr3_comedi_frame(std::uint32_t sensor,
                                        const Jr3ComediSamples& samples) noexcept;
[[nodiscard]] BusFrame jr3_comedi_frame(std::uint32_t sensor,
                                        const Jr3ComediIdentity& identity) noexcept;
[[nodiscard]] std::optional<Jr3ComediSamples> jr3_comedi_samples(const BusFrame& frame) noexcept;
[[nodiscard]] std::optional<Jr3ComediIdentity> jr3_comedi_identity(const BusFrame& frame) noexcept;

}  // namespace isograsp
