// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of JR3 sensors behind the open CAN adaptor: one synchronisation frame makes all adaptors
// send force and moment at once, both with the number of the sensor's own frame. Pure: frames and
// arrival times in, samples and answers out; no bus, no clock, no allocation. Little-endian.
// Wrenches are in the sensor frame. Source: docs/devices.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Numbers of the three adaptors (1 … 127): thumb, index, middle.
inline constexpr std::array<std::uint8_t, kFingerCount> kJr3Nodes{1, 2, 3};

/// An identifier is this value plus the number of the adaptor; for `sync` it is the value alone.
enum class Jr3Opcode : std::uint16_t {
  sync = 0x080,
  acknowledge = 0x100,  ///< from the adaptor: it does not say what it answers
  start_sync = 0x180,
  start_async = 0x200,
  stop = 0x280,
  zero_offsets = 0x300,
  set_filter = 0x380,
  state = 0x400,
  force_scales = 0x480,
  moment_scales = 0x500,
  reset = 0x580,
  force = 0x600,    ///< from the adaptor
  moment = 0x680,   ///< from the adaptor
  boot_up = 0x700,  ///< from the adaptor: it has forgotten everything
  gripper = 0x780   ///< unrelated
};

/// What a frame with an adaptor's number is.
enum class Jr3Word : std::uint8_t {
  foreign,  ///< no word of this protocol: wrong length, extended, remote
  request,  ///< asks the adaptor
  answer    ///< from the adaptor
};
/// Whether the frame has one of the adaptor's numbers.
[[nodiscard]] bool jr3_owns(std::uint8_t node, const BusFrame& frame) noexcept;
/// Whether it is the synchronisation of all adaptors.
[[nodiscard]] bool is_jr3_sync(const BusFrame& frame) noexcept;
/// @pre jr3_owns(node, frame)
[[nodiscard]] Jr3Word jr3_word(const BusFrame& frame) noexcept;
[[nodiscard]] Jr3Opcode jr3_opcode(const BusFrame& frame) noexcept;

/// Also the boot-up. @pre 1 <= node <= 127; the request has no content
[[nodiscard]] BusFrame jr3_request(std::uint8_t node, Jr3Opcode opcode) noexcept;
[[nodiscard]] BusFrame jr3_sync() noexcept;
/// Low-pass of the adaptor in steps of 0.01 Hz, 0 … 655.35 Hz; 0: none. Nullopt outside.
[[nodiscard]] std::optional<std::uint16_t> jr3_cutoff(double cutoff_Hz) noexcept;
[[nodiscard]] BusFrame jr3_start_sync(std::uint8_t node, std::uint16_t cutoff_cHz) noexcept;
[[nodiscard]] BusFrame jr3_start_async(std::uint8_t node, std::uint16_t cutoff_cHz,
                                       std::uint32_t period_us) noexcept;
[[nodiscard]] BusFrame jr3_set_filter(std::uint8_t node, std::uint16_t cutoff_cHz) noexcept;

/// Full scales of three axes as sent.
using Jr3Scales = std::array<std::uint16_t, 3>;
struct Jr3Acknowledge {
  bool ready = true;
  std::optional<Jr3Scales> scales;  ///< answer to a question for full scales
};
[[nodiscard]] BusFrame jr3_acknowledge(std::uint8_t node, const Jr3Acknowledge& content) noexcept;
/// @pre jr3_word(frame) is an answer with the opcode `acknowledge`
[[nodiscard]] Jr3Acknowledge jr3_acknowledge_of(const BusFrame& frame) noexcept;

/// What turns counts into a wrench.
struct Jr3Calibration {
  Jr3Scales force_N{};
  Jr3Scales moment_dNm{};  ///< in 0.1 N m

  /// No full scale is zero.
  [[nodiscard]] bool usable() const noexcept;
  [[nodiscard]] Vec6 units_per_count() const noexcept;
  [[nodiscard]] bool operator==(const Jr3Calibration&) const = default;
};

/// One measurement in counts: ±16384 is the full scale, and 16 bits reach twice as far.
struct Jr3Reading {
  std::uint16_t number = 0;  ///< of the sensor's frame, at most 8 kHz; wraps
  RawCounts raw{};           ///< Fx Fy Fz Mx My Mz

  [[nodiscard]] bool operator==(const Jr3Reading&) const = default;
  /// A value at the end of its 16 bits was clipped. (Beyond the full scale it still measures.)
  [[nodiscard]] bool saturated() const noexcept;
};
/// Force, then moment. @pre the counts fit 16 bits
[[nodiscard]] std::array<BusFrame, 2> jr3_reading_frames(std::uint8_t node,
                                                         const Jr3Reading& reading) noexcept;
/// force = count FS / 16384 [N], moment = count FS / 163840 [N m].
[[nodiscard]] Wrench wrench_of(const Jr3Reading& reading,
                               const Jr3Calibration& calibration) noexcept;

/// Joins force and moment with the same number, in any order, at most 100 ms apart (the number
/// returns after 8 s). Everything else is counted and dropped.
class Jr3Pairing {
 public:
  struct Reading {
    Jr3Reading reading;
    Timestamp stamp{0};  ///< arrival of the frame that completed it
  };
  /// A frame with values. @pre jr3_word() is an answer with the opcode `force` or `moment`
  [[nodiscard]] std::optional<Reading> push(const BusFrame& frame, Timestamp stamp) noexcept;
  /// Drops what waits, because it can no longer be completed: the adaptor began anew, or the log
  /// ends.
  void forget() noexcept;

  /// Halves without the other half.
  [[nodiscard]] std::uint64_t torn() const noexcept { return torn_; }
  /// Halves that came twice: while the first one still waits, or within 2 ms of the newest complete
  /// sample. After 2 ms they make a sample with the same number: the sensor itself stands still.
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return duplicate_; }

 private:
  struct Half {
    std::array<std::int16_t, 3> raw{};
    std::uint16_t number = 0;
    bool force = false;
    Timestamp stamp{0};
    bool waiting = false;
  };
  void drop(Half& half) noexcept;

  std::array<Half, 4> halves_;
  std::optional<std::uint16_t> newest_;  ///< number of the newest complete sample
  Timestamp newest_stamp_{0};
  std::uint64_t torn_ = 0;
  std::uint64_t duplicate_ = 0;
};

}  // namespace isograsp
