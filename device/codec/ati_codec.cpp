// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/ati_codec.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>
#include <span>

#include <Eigen/LU>

namespace isograsp {

namespace {

constexpr Timestamp kLongestAtiPair = std::chrono::milliseconds(5);
constexpr Timestamp kLongestAtiRepeat = std::chrono::milliseconds(2);

constexpr std::array<std::string_view, 16> kStatusNames{"watchdog_reset",
                                                        "dac_adc_check_too_high",
                                                        "dac_adc_check_too_low",
                                                        "artificial_analog_ground_out_of_range",
                                                        "supply_too_high",
                                                        "supply_too_low",
                                                        "bad_active_calibration",
                                                        "eeprom_failure",
                                                        "configuration_invalid",
                                                        "",
                                                        "",
                                                        "temperature_too_high",
                                                        "temperature_too_low",
                                                        "",
                                                        "can_bus_error",
                                                        "any_error"};

// By code; index 0 does not exist. One pound-force is exactly 4.4482216152605 N, one inch 0.0254 m
// and one foot 0.3048 m.
constexpr std::array<double, 7> kNewton{0.0,    4.4482216152605, 1.0,       4448.2216152605,
                                        1000.0, 9.80665,         0.00980665};
constexpr std::array<double, 7> kNewtonMetre{
    0.0, 0.1129848290276167, 1.3558179483314004, 1.0, 0.001, 0.0980665, 1000.0};

void put(BusFrame& frame, std::size_t at, std::uint32_t value, std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i)
    frame.data[at + i] = static_cast<std::uint8_t>(value >> (8 * (bytes - 1 - i)) & 0xFF);
}

std::uint32_t get(const BusFrame& frame, std::size_t at, std::size_t bytes) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | frame.data[at + i];
  return value;
}

std::int32_t gage(const BusFrame& frame, std::size_t at) noexcept {
  return static_cast<std::int16_t>(get(frame, at, 2));
}

BusFrame answer(std::uint8_t base, AtiOpcode opcode, std::uint8_t length) noexcept {
  BusFrame frame = ati_request(base, opcode);
  frame.length = length;
  return frame;
}

}  // namespace

bool ati_owns(std::uint8_t base, const BusFrame& frame) noexcept {
  return !frame.error && frame.id >> 4 == base;
}

AtiOpcode ati_opcode(const BusFrame& frame) noexcept {
  return static_cast<AtiOpcode>(frame.id & 0xF);
}

AtiWord ati_word(const BusFrame& frame) noexcept {
  if (!frame.is_standard()) return AtiWord::foreign;
  struct Lengths {
    std::optional<int> request;  ///< nothing: there is none
    std::optional<int> answer;
  };
  const auto lengths = [&]() -> Lengths {
    switch (ati_opcode(frame)) {
      case AtiOpcode::gages: return {0, 8};
      case AtiOpcode::odd_gages: return {{}, 6};
      case AtiOpcode::matrix_row: return {1, 8};
      case AtiOpcode::row_middle:
      case AtiOpcode::row_end: return {{}, 8};
      case AtiOpcode::serial_number:
      case AtiOpcode::counts: return {0, 8};
      case AtiOpcode::calibration: return {1, 1};
      case AtiOpcode::units: return {0, 2};
      case AtiOpcode::diagnostic: return {1, 2};
      case AtiOpcode::reset: return {0, {}};
      case AtiOpcode::set_base:
      case AtiOpcode::set_baud: return {1, 0};
      case AtiOpcode::firmware: return {0, 4};
    }
    return {};
  }();
  if (frame.length == lengths.request)
    return lengths.request == lengths.answer ? AtiWord::either : AtiWord::request;
  return frame.length == lengths.answer ? AtiWord::answer : AtiWord::foreign;
}

BusFrame ati_request(std::uint8_t base, AtiOpcode opcode,
                     std::initializer_list<std::uint8_t> parameters) noexcept {
  assert(base < 0x80 && parameters.size() <= 8);
  BusFrame frame;
  frame.id = static_cast<std::uint32_t>(base) << 4 | static_cast<std::uint32_t>(opcode);
  frame.length = static_cast<std::uint8_t>(parameters.size());
  std::copy(parameters.begin(), parameters.end(), frame.data.begin());
  return frame;
}

bool AtiReading::saturated() const noexcept {
  return std::any_of(gages.begin(), gages.end(),
                     [](std::int32_t g) { return g <= INT16_MIN || g >= INT16_MAX; });
}

bool AtiReading::critical() const noexcept {
  return (status & kAtiCritical) != 0;
}

std::string_view ati_status_name(unsigned bit) noexcept {
  assert(bit < kStatusNames.size());
  return kStatusNames[bit];
}

std::string ati_flags(const AtiReading& reading) {
  std::string words = reading.saturated() ? "saturated" : "";
  for (unsigned bit = 0; bit < kStatusNames.size(); ++bit) {
    if ((reading.status >> bit & 1U) == 0 || kStatusNames[bit].empty()) continue;
    if (!words.empty()) words += '+';
    words += "status_";
    words += kStatusNames[bit];
  }
  return words;
}

std::array<BusFrame, 2> ati_reading_frames(std::uint8_t base, const AtiReading& reading) noexcept {
  std::array<BusFrame, 2> frames{answer(base, AtiOpcode::gages, 8),
                                 answer(base, AtiOpcode::odd_gages, 6)};
  put(frames[0], 0, reading.status, 2);
  for (std::size_t i = 0; i < reading.gages.size(); ++i) {
    const std::int32_t value = reading.gages[i];
    assert(value >= INT16_MIN && value <= INT16_MAX);
    const bool even = i % 2 == 0;
    put(frames[even ? 0 : 1], even ? 2 + i : i - 1, static_cast<std::uint32_t>(value), 2);
  }
  return frames;
}

std::array<BusFrame, 3> ati_row_frames(std::uint8_t base, const AtiRow& row) noexcept {
  std::array<BusFrame, 3> frames{answer(base, AtiOpcode::matrix_row, 8),
                                 answer(base, AtiOpcode::row_middle, 8),
                                 answer(base, AtiOpcode::row_end, 8)};
  for (std::size_t i = 0; i < row.size(); ++i)
    put(frames[i / 2], 4 * (i % 2), std::bit_cast<std::uint32_t>(row[i]), 4);
  return frames;
}

BusFrame ati_serial_frame(std::uint8_t base, std::string_view serial_number) noexcept {
  BusFrame frame = answer(base, AtiOpcode::serial_number, 8);
  assert(serial_number.size() <= 8);
  std::copy(serial_number.begin(), serial_number.end(), frame.data.begin());
  return frame;
}

BusFrame ati_counts_frame(std::uint8_t base, const AtiCounts& counts) noexcept {
  BusFrame frame = answer(base, AtiOpcode::counts, 8);
  put(frame, 0, counts.per_force, 4);
  put(frame, 4, counts.per_torque, 4);
  return frame;
}

BusFrame ati_units_frame(std::uint8_t base, const AtiUnits& units) noexcept {
  return ati_request(base, AtiOpcode::units, {units.force, units.torque});
}

BusFrame ati_firmware_frame(std::uint8_t base, const AtiFirmware& firmware) noexcept {
  BusFrame frame = ati_request(base, AtiOpcode::firmware, {firmware.major, firmware.minor, 0, 0});
  put(frame, 2, firmware.build, 2);
  return frame;
}

BusFrame ati_diagnostic_frame(std::uint8_t base, std::uint16_t value) noexcept {
  BusFrame frame = answer(base, AtiOpcode::diagnostic, 2);
  put(frame, 0, value, 2);
  return frame;
}

std::string_view ati_serial_of(const BusFrame& frame) noexcept {
  // Characters may be read through a pointer to the bytes.
  return {reinterpret_cast<const char*>(frame.data.data()), 8};
}

AtiCounts ati_counts_of(const BusFrame& frame) noexcept {
  return {get(frame, 0, 4), get(frame, 4, 4)};
}

AtiUnits ati_units_of(const BusFrame& frame) noexcept {
  return {frame.data[0], frame.data[1]};
}

AtiFirmware ati_firmware_of(const BusFrame& frame) noexcept {
  return {frame.data[0], frame.data[1], static_cast<std::uint16_t>(get(frame, 2, 2))};
}

std::uint16_t ati_diagnostic_of(const BusFrame& frame) noexcept {
  return static_cast<std::uint16_t>(get(frame, 0, 2));
}

std::optional<double> ati_newton(std::uint8_t force_code) noexcept {
  if (force_code < 1 || force_code >= kNewton.size()) return std::nullopt;
  return kNewton[force_code];
}

std::optional<double> ati_newton_metre(std::uint8_t torque_code) noexcept {
  if (torque_code < 1 || torque_code >= kNewtonMetre.size()) return std::nullopt;
  return kNewtonMetre[torque_code];
}

bool AtiCalibration::usable() const noexcept {
  if (!matrix.allFinite() || counts.per_force == 0 || counts.per_torque == 0 ||
      !ati_newton(units.force) || !ati_newton_metre(units.torque))
    return false;
  // Rows of force and torque differ by orders of magnitude, whatever the units: each row is divided
  // by its own length.
  const Vec6 lengths = matrix.rowwise().stableNorm();
  if (!(lengths.minCoeff() > 0.0) || !lengths.allFinite()) return false;
  constexpr double kSmallestPivot = 1e-5;  // relative; single precision resolves 6e-8
  Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> lu;
  lu.setThreshold(kSmallestPivot);
  lu.compute(lengths.cwiseInverse().asDiagonal() * matrix);
  return lu.isInvertible();
}

Wrench wrench_of(const RawCounts& gages, const Vec6& bias,
                 const AtiCalibration& calibration) noexcept {
  Vec6 g;
  for (std::size_t i = 0; i < gages.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    g[row] = gages[i] - bias[row];
  }
  const Vec6 sum = calibration.matrix * g;
  Wrench wrench;
  wrench.force = sum.head<3>() / calibration.counts.per_force * kNewton[calibration.units.force];
  wrench.torque =
      sum.tail<3>() / calibration.counts.per_torque * kNewtonMetre[calibration.units.torque];
  return wrench;
}

std::optional<AtiPairing::Reading> AtiPairing::push(const BusFrame& frame,
                                                    Timestamp stamp) noexcept {
  const bool is_even = ati_opcode(frame) == AtiOpcode::gages;
  Half& half = is_even ? even_ : odd_;
  if (half.known && half.frame == frame && stamp >= half.stamp &&
      stamp - half.stamp <= kLongestAtiRepeat) {
    ++duplicate_;
    return std::nullopt;
  }
  half = {frame, stamp, true};
  const bool was_waiting = waiting_;
  waiting_ = is_even;
  const bool in_time = stamp >= even_.stamp && stamp - even_.stamp <= kLongestAtiPair;
  if (is_even || !was_waiting || !in_time) {
    if (was_waiting) ++torn_;  // the even gages before
    if (!is_even) ++torn_;     // these odd ones
    return std::nullopt;
  }
  Reading out;
  out.stamp = stamp;
  out.reading.status = static_cast<std::uint16_t>(get(even_.frame, 0, 2));
  for (std::size_t i = 0; i < 3; ++i) {
    out.reading.gages[2 * i] = gage(even_.frame, 2 + 2 * i);
    out.reading.gages[2 * i + 1] = gage(odd_.frame, 2 * i);
  }
  return out;
}

void AtiPairing::ask() noexcept {
  if (waiting_) ++torn_;
  waiting_ = false;
  even_.known = odd_.known = false;
}

std::optional<AtiRow> AtiRowAssembly::push(const BusFrame& frame) noexcept {
  const auto part =
      static_cast<std::size_t>(frame.id & 0xF) - static_cast<std::size_t>(AtiOpcode::matrix_row);
  assert(part < 3);
  if (part != 0 && part + 1 == parts_) return std::nullopt;  // came twice
  if (part != 0 && part != parts_) {
    parts_ = 0;
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 2; ++i)
    row_[2 * part + i] = std::bit_cast<float>(get(frame, 4 * i, 4));
  parts_ = part + 1;
  if (parts_ < 3) return std::nullopt;
  parts_ = 0;
  return row_;
}

}  // namespace isograsp
