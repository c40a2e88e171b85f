// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of Robotous RFT sensors on CAN. Pure: frames and arrival times in, samples and answers
// out; no bus, no clock, no allocation. Source: RFT Series Manual 1.82, sections 3.3 - 3.6. Values
// are in the sensor frame, before zero and mounting; Fz is positive in tension.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "core/spatial.hpp"
#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// The three identifiers of one sensor (1 … 255). first < second, so that arbitration on the bus
/// cannot turn a pair around.
struct RftIds {
  std::uint8_t command = 0x64;
  std::uint8_t first = 0x01;
  std::uint8_t second = 0x02;
};
/// The map that this program expects: thumb, index, middle.
inline constexpr std::array<RftIds, kFingerCount> kRftIds{
    RftIds{0x64, 0x01, 0x02}, RftIds{0x65, 0x03, 0x04}, RftIds{0x66, 0x05, 0x06}};

/// Counts per newton and per newton metre; most models have 50 and 2000 (docs/devices.md).
struct RftDivisors {
  double force_per_N = 50.0;
  double torque_per_Nm = 2000.0;
};

enum class RftCommand : std::uint8_t {
  model_name = 0x01,
  serial_number = 0x02,
  firmware_version = 0x03,
  set_ids = 0x04,
  read_ids = 0x05,
  set_filter = 0x08,
  read_filter = 0x09,
  read_once = 0x0A,
  start = 0x0B,
  stop = 0x0C,
  set_rate = 0x0F,
  read_rate = 0x10,
  set_bias = 0x11,
  overload_counts = 0x12
};
/// Whether the manual knows a command with this number.
[[nodiscard]] bool is_rft_command(std::uint8_t number) noexcept;

/// D1 … D16: the two frames of a sensor together. D1 tells data from answers.
struct RftPacket {
  std::uint8_t command = 0;                ///< D1
  std::array<std::uint8_t, 15> content{};  ///< R1 … R15
  Timestamp stamp{0};                      ///< arrival of the frame that completed it

  [[nodiscard]] bool is_data() const noexcept;
};

/// One measurement in counts.
struct RftCounts {
  RawCounts raw{};
  std::uint8_t overload = 0;  ///< bit 5 Fx, 4 Fy, 3 Fz, 2 Tx, 1 Ty, 0 Tz: over 120 % of the rating

  [[nodiscard]] bool operator==(const RftCounts&) const = default;
};

[[nodiscard]] BusFrame encode_command(const RftIds& ids, RftCommand command,
                                      std::initializer_list<std::uint8_t> parameters = {}) noexcept;
/// The two frames of an answer or of data. At most 15 bytes of content.
[[nodiscard]] std::array<BusFrame, 2> encode_packet(const RftIds& ids, std::uint8_t command,
                                                    std::span<const std::uint8_t> content) noexcept;
/// R1 … R13 of a measurement. @pre the counts fit 16 bits
[[nodiscard]] std::array<std::uint8_t, 13> content_of(const RftCounts& counts) noexcept;
/// @pre the counts fit 16 bits
[[nodiscard]] std::array<BusFrame, 2> encode_counts(
    const RftIds& ids, const RftCounts& counts, RftCommand command = RftCommand::start) noexcept;
/// @pre packet.is_data()
[[nodiscard]] RftCounts decode_counts(const RftPacket& packet) noexcept;
/// In the sensor frame [N, N m]. Divides, so that 617 counts are 12.34 N to the last bit.
[[nodiscard]] Wrench wrench_of(const RftCounts& counts, const RftDivisors& divisors) noexcept;

/// A value is at either end of its 16 bits: the true one may lie beyond.
[[nodiscard]] bool at_end_of_numbers(const RftCounts& counts) noexcept;

/// Output rates that the sensor knows [Hz] and their codes; nullopt for any other rate.
[[nodiscard]] std::optional<std::uint8_t> rft_rate_code(double rate_Hz) noexcept;
/// 0 for an unknown code.
[[nodiscard]] double rft_rate_Hz(std::uint8_t code) noexcept;
/// Code of the low-pass filter with this cut-off [Hz], 0 for none; nullopt if there is no such
/// step. The manual and the vendor's header disagree about the order of the codes
/// (docs/devices.md).
enum class RftFilterTable : std::uint8_t { manual, header };
[[nodiscard]] std::optional<std::uint8_t> rft_filter_code(
    double cutoff_Hz, RftFilterTable table = RftFilterTable::manual) noexcept;
/// Cut-off [Hz] of a code after the manual; 0: no filter or an unknown code.
[[nodiscard]] double rft_filter_Hz(std::uint8_t code) noexcept;

/// Joins the frames of one sensor to packets. A pair is the first frame and then the second within
/// 2 ms; everything else is counted and dropped.
class RftPairing {
 public:
  explicit RftPairing(const RftIds& ids) noexcept : ids_(ids) {}

  /// The packet that this frame completes. Frames in the order of arrival.
  [[nodiscard]] std::optional<RftPacket> push(const BusFrame& frame, Timestamp stamp) noexcept;
  /// Nothing more will come: a first frame that still waits is torn.
  void finish() noexcept;

  /// Halves without the other half. A first and a second that are too far apart are two.
  [[nodiscard]] std::uint64_t torn() const noexcept { return torn_; }
  /// Frames that repeat the one before bit for bit within 2 ms.
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return duplicate_; }
  /// Frames that carry the sensor's identifiers but are not of this protocol: wrong length, unknown
  /// D1, extended or remote.
  [[nodiscard]] std::uint64_t foreign() const noexcept { return foreign_; }
  [[nodiscard]] const RftIds& ids() const noexcept { return ids_; }

 private:
  [[nodiscard]] bool repeats(const BusFrame& frame, Timestamp stamp) const noexcept;

  RftIds ids_;
  BusFrame last_;  ///< the newest good frame
  Timestamp last_stamp_{0};
  bool has_last_ = false;
  bool waiting_ = false;  ///< last_ is a first frame without its second
  std::uint64_t torn_ = 0;
  std::uint64_t duplicate_ = 0;
  std::uint64_t foreign_ = 0;
};

}  // namespace isograsp
