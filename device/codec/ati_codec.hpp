// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of ATI F/T sensors with a NETCANOEM board on CAN. The host asks, and the board answers
// with six strain gages; the host itself applies matrix, counts and bias. Pure: frames and arrival
// times in, readings and answers out; no bus, no clock, no allocation. Source: ATI manual
// 9610-05-1030-04. Wrenches are in the sensor frame.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Upper seven bits of a sensor's identifiers: thumb, index, middle.
inline constexpr std::array<std::uint8_t, kFingerCount> kAtiBases{0x20, 0x21, 0x22};

/// Lower four bits of an identifier. Requests and their first answer have the same one.
enum class AtiOpcode : std::uint8_t {
  gages = 0x0,       ///< answer: status, gages 0, 2, 4; then, as `odd_gages`, gages 1, 3, 5
  odd_gages = 0x1,   ///< answers only
  matrix_row = 0x2,  ///< answer: gages 0 and 1; then 2 and 3, then 4 and 5
  row_middle = 0x3,  ///< answers only
  row_end = 0x4,     ///< answers only
  serial_number = 0x5,
  calibration = 0x6,  ///< selects a slot; the answer is the request again
  counts = 0x7,       ///< firmware 3.7 and newer
  units = 0x8,        ///< firmware 3.7 and newer
  diagnostic = 0x9,   ///< firmware 3.8 and newer
  reset = 0xC,        ///< no answer
  set_base = 0xD,     ///< acts from the next power-up on
  set_baud = 0xE,     ///< acts from the next power-up on
  firmware = 0xF
};

/// What a frame with a sensor's identifiers is.
enum class AtiWord : std::uint8_t {
  foreign,  ///< no word of this protocol: wrong length, extended, remote
  request,  ///< asks the board
  answer,   ///< told apart from a request by its length
  either    ///< selects a calibration, or is the echo of such a frame
};
/// @pre ati_owns(base, frame)
[[nodiscard]] AtiWord ati_word(const BusFrame& frame) noexcept;
/// Whether the frame has one of the sensor's sixteen numbers.
[[nodiscard]] bool ati_owns(std::uint8_t base, const BusFrame& frame) noexcept;
[[nodiscard]] AtiOpcode ati_opcode(const BusFrame& frame) noexcept;

/// Also the answers without content (set_base, set_baud) and the echo of a selected calibration.
[[nodiscard]] BusFrame ati_request(std::uint8_t base, AtiOpcode opcode,
                                   std::initializer_list<std::uint8_t> parameters = {}) noexcept;

/// One measurement in counts of the gages.
struct AtiReading {
  std::uint16_t status = 0;
  RawCounts gages{};  ///< 0 … 5 in this order, 16 bits each

  [[nodiscard]] bool operator==(const AtiReading&) const = default;
  /// A gage is at the end of its range. Every axis is computed from all gages, so none can be used.
  [[nodiscard]] bool saturated() const noexcept;
  /// The board reports a critical error. It goes on sending, but the host must refuse the values.
  [[nodiscard]] bool critical() const noexcept;
  [[nodiscard]] bool valid() const noexcept { return !saturated() && !critical(); }
};

/// Bits of the status word.
inline constexpr std::uint16_t kAtiWatchdogReset = 1U << 0;
inline constexpr std::uint16_t kAtiBadCalibration = 1U << 6;
inline constexpr std::uint16_t kAtiAnyError = 1U << 15;
/// Those that make the values meaningless: 1 … 7, 11 and 12.
inline constexpr std::uint16_t kAtiCritical = 0x18FE;
/// Name of a bit, 0 … 15: "bad_active_calibration". Empty for a reserved one.
[[nodiscard]] std::string_view ati_status_name(unsigned bit) noexcept;
/// "saturated+status_supply_too_low+status_any_error". Allocates.
[[nodiscard]] std::string ati_flags(const AtiReading& reading);

/// @pre the gages fit 16 bits
[[nodiscard]] std::array<BusFrame, 2> ati_reading_frames(std::uint8_t base,
                                                         const AtiReading& reading) noexcept;
/// One row of the matrix, gages 0 … 5.
using AtiRow = std::array<float, 6>;
[[nodiscard]] std::array<BusFrame, 3> ati_row_frames(std::uint8_t base, const AtiRow& row) noexcept;
/// At most eight characters.
[[nodiscard]] BusFrame ati_serial_frame(std::uint8_t base, std::string_view serial_number) noexcept;
struct AtiCounts {
  std::uint32_t per_force = 1'000'000;
  std::uint32_t per_torque = 1'000'000;
  [[nodiscard]] bool operator==(const AtiCounts&) const = default;
};
[[nodiscard]] BusFrame ati_counts_frame(std::uint8_t base, const AtiCounts& counts) noexcept;
/// Codes of the board.
struct AtiUnits {
  std::uint8_t force = 2;   ///< 1 lbf, 2 N, 3 klbf, 4 kN, 5 kgf, 6 gf
  std::uint8_t torque = 3;  ///< 1 lbf-in, 2 lbf-ft, 3 Nm, 4 Nmm, 5 kgf-cm, 6 kNm
  [[nodiscard]] bool operator==(const AtiUnits&) const = default;
};
[[nodiscard]] BusFrame ati_units_frame(std::uint8_t base, const AtiUnits& units) noexcept;
struct AtiFirmware {
  std::uint8_t major = 0;
  std::uint8_t minor = 0;
  std::uint16_t build = 0;
  [[nodiscard]] bool operator==(const AtiFirmware&) const = default;
  /// 3.7 and newer tell their counts and units.
  [[nodiscard]] bool tells_counts() const noexcept {
    return major > 3 || (major == 3 && minor >= 7);
  }
};
[[nodiscard]] BusFrame ati_firmware_frame(std::uint8_t base, const AtiFirmware& firmware) noexcept;
[[nodiscard]] BusFrame ati_diagnostic_frame(std::uint8_t base, std::uint16_t value) noexcept;

// Contents of answers. @pre ati_word() of the frame is AtiWord::answer and its opcode is this one.
/// The view ends with the life of the frame.
[[nodiscard]] std::string_view ati_serial_of(const BusFrame& frame) noexcept;
[[nodiscard]] AtiCounts ati_counts_of(const BusFrame& frame) noexcept;
[[nodiscard]] AtiUnits ati_units_of(const BusFrame& frame) noexcept;
[[nodiscard]] AtiFirmware ati_firmware_of(const BusFrame& frame) noexcept;
[[nodiscard]] std::uint16_t ati_diagnostic_of(const BusFrame& frame) noexcept;

/// Newtons in one unit of force, newton metres in one of torque; nullopt for an unknown code.
[[nodiscard]] std::optional<double> ati_newton(std::uint8_t force_code) noexcept;
[[nodiscard]] std::optional<double> ati_newton_metre(std::uint8_t torque_code) noexcept;

/// What turns gages into a wrench.
struct AtiCalibration {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  AtiCounts counts;
  AtiUnits units;

  /// Finite, not singular, counts above zero, known units.
  [[nodiscard]] bool usable() const noexcept;
  [[nodiscard]] bool operator==(const AtiCalibration&) const = default;
};
/// Matrix times (gages - bias), divided by the counts, in [N, N m]. `bias` is in counts.
/// @pre calibration.usable()
[[nodiscard]] Wrench wrench_of(const RawCounts& gages, const Vec6& bias,
                               const AtiCalibration& calibration) noexcept;

/// Joins the two frames of a reading, which carry no number: even gages, then odd gages within
/// 5 ms, and no request between them. Everything else is counted and dropped.
class AtiPairing {
 public:
  struct Reading {
    AtiReading reading;
    Timestamp stamp{0};  ///< arrival of the frame that completed it
  };
  /// A frame with gages. @pre ati_word() is AtiWord::answer, opcode `gages` or `odd_gages`
  [[nodiscard]] std::optional<Reading> push(const BusFrame& frame, Timestamp stamp) noexcept;
  /// Called when the gages are asked for, and at the end: a half that still waits belongs to an
  /// older question.
  void ask() noexcept;

  /// Halves without the other half.
  [[nodiscard]] std::uint64_t torn() const noexcept { return torn_; }
  /// Frames that repeat an answer to the same question bit for bit within 2 ms.
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return duplicate_; }

 private:
  struct Half {
    BusFrame frame;
    Timestamp stamp{0};
    bool known = false;
  };
  Half even_;
  Half odd_;
  bool waiting_ = false;  ///< even_ without its odd gages
  std::uint64_t torn_ = 0;
  std::uint64_t duplicate_ = 0;
};

/// Joins the three frames of a row.
class AtiRowAssembly {
 public:
  /// The row that this frame completes. @pre ati_word() is AtiWord::answer, opcode `matrix_row`,
  /// `row_middle` or `row_end`
  [[nodiscard]] std::optional<AtiRow> push(const BusFrame& frame) noexcept;
  void forget() noexcept { parts_ = 0; }

 private:
  AtiRow row_{};
  std::size_t parts_ = 0;  ///< that arrived in order
};

}  // namespace isograsp
