// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_codec.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace isograsp {

namespace {

constexpr std::uint16_t kMagic = 0x1234;
constexpr std::size_t kRequest = 8;
constexpr std::uint32_t kSummary = 0x80000000;  // "any error", in both maps
constexpr std::uint32_t kLatched = 0x00010000;  // a threshold, in both maps
constexpr std::uint32_t kNetBoxSaturated = 0x00020000;
constexpr std::uint32_t kAxiaSaturated = 1U << 27;
constexpr std::uint32_t kAxiaOverload = 1U << 30;

struct StatusName {
  unsigned bit;
  const char* name;
};
constexpr std::array<StatusName, 30> kNetBoxNames{
    {{31, "error_summary"},
     {30, "cpu_or_ram"},
     {29, "digital_board"},
     {28, "analog_board"},
     {27, "serial_link_communication"},
     {26, "program_memory"},
     {25, "halted_configuration"},
     {24, "settings_validation"},
     {23, "configuration_incompatible_with_calibration"},
     {22, "network"},
     {21, "can"},
     {20, "rdt"},
     {19, "ethernet_ip"},
     {18, "devicenet"},
     {17, "transducer_saturation_or_ad_error"},
     {16, "monitor_condition_latched"},
     {14, "watchdog"},
     {13, "stack"},
     {12, "eeprom_i2c"},
     {11, "flash_spi"},
     {10, "analog_watchdog"},
     {9, "excitation_high"},
     {8, "excitation_low"},
     {7, "artificial_ground"},
     {6, "analog_supply_high"},
     {5, "analog_supply_low"},
     {4, "serial_link_data_unavailable"},
     {3, "reference_or_power"},
     {2, "temperature"},
     {1, "http"}}};
constexpr std::array<StatusName, 12> kAxiaNames{{{31, "any_error"},
                                                 {30, "ft_out_of_range"},
                                                 {29, "calibration_checksum"},
                                                 {28, "simulated"},
                                                 {27, "gage_out_of_range"},
                                                 {16, "monitor_latched"},
                                                 {7, "calibration_not_accessible"},
                                                 {5, "other"},
                                                 {3, "busy"},
                                                 {2, "broken_gage"},
                                                 {1, "supply"},
                                                 {0, "temperature"}}};

// The index is the code.
constexpr std::array<double, 13> kNetFtFilters_Hz{0, 838, 326,  152,  73,   35,  18,
                                                  8, 5,   1500, 2000, 2500, 3000};

std::span<const StatusName> status_names(NetFtProduct product) noexcept {
  if (product == NetFtProduct::axia) return kAxiaNames;
  return kNetBoxNames;
}

void put_big_endian(BusFrame& frame, std::size_t at, std::uint32_t value,
                    std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i)
    frame.data[at + i] = static_cast<std::uint8_t>((value >> (8 * (bytes - 1 - i))) & 0xFF);
}

std::uint32_t get(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t value = 0;
  for (const auto byte : bytes) value = value << 8 | byte;
  return value;
}

bool is_known(std::uint32_t command) noexcept {
  switch (static_cast<NetFtCommand>(command)) {
    case NetFtCommand::stop:
    case NetFtCommand::start:
    case NetFtCommand::start_buffered:
    case NetFtCommand::reset_latch:
    case NetFtCommand::set_bias: return true;
  }
  return false;
}

}  // namespace

BusFrame encode_net_ft_request(std::uint32_t peer, const NetFtRequest& request) noexcept {
  BusFrame frame;
  frame.id = peer;
  frame.length = kRequest;
  put_big_endian(frame, 0, kMagic, 2);
  put_big_endian(frame, 2, static_cast<std::uint16_t>(request.command), 2);
  put_big_endian(frame, 4, request.samples, 4);
  return frame;
}

std::optional<NetFtRequest> decode_net_ft_request(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != kRequest || get(bytes.first(2)) != kMagic) return std::nullopt;
  const std::uint32_t command = get(bytes.subspan(2, 2));
  if (!is_known(command)) return std::nullopt;
  return NetFtRequest{static_cast<NetFtCommand>(command), get(bytes.subspan(4, 4))};
}

BusFrame encode_net_ft_record(std::uint32_t peer, const NetFtRecord& record) noexcept {
  BusFrame frame;
  frame.id = peer;
  frame.length = kNetFtRecord;
  put_big_endian(frame, 0, record.rdt_sequence, 4);
  put_big_endian(frame, 4, record.ft_sequence, 4);
  put_big_endian(frame, 8, record.status, 4);
  for (std::size_t axis = 0; axis < record.raw.size(); ++axis)
    put_big_endian(frame, 12 + 4 * axis, static_cast<std::uint32_t>(record.raw[axis]), 4);
  return frame;
}

std::optional<NetFtRecord> decode_net_ft_record(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != kNetFtRecord) return std::nullopt;
  NetFtRecord record;
  record.rdt_sequence = get(bytes.subspan(0, 4));
  record.ft_sequence = get(bytes.subspan(4, 4));
  record.status = get(bytes.subspan(8, 4));
  for (std::size_t axis = 0; axis < record.raw.size(); ++axis)
    record.raw[axis] = static_cast<std::int32_t>(get(bytes.subspan(12 + 4 * axis, 4)));
  return record;
}

Wrench wrench_of(const RawCounts& raw, const NetFtScale& scale) noexcept {
  Wrench wrench;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    wrench.force[axis] = raw[i] / scale.counts_per_unit_force * scale.unit_force_N;
    wrench.torque[axis] = raw[i + 3] / scale.counts_per_unit_torque * scale.unit_torque_Nm;
  }
  return wrench;
}

Vec6 units_per_count(const NetFtScale& scale) noexcept {
  Vec6 units;
  units.head<3>().setConstant(scale.unit_force_N / scale.counts_per_unit_force);
  units.tail<3>().setConstant(scale.unit_torque_Nm / scale.counts_per_unit_torque);
  return units;
}

NetFtVerdict judge(const NetFtRecord& record, NetFtProduct product) noexcept {
  const bool axia = product == NetFtProduct::axia;
  NetFtVerdict verdict;
  const bool only_latched =
      (record.status & ~kSummary) == kLatched;  // with or without the summary bit
  verdict.critical = record.status != 0 && !only_latched;
  verdict.saturated = (record.status & (axia ? kAxiaSaturated : kNetBoxSaturated)) != 0 ||
                      std::any_of(record.raw.begin(), record.raw.end(), [](std::int32_t value) {
                        return value == INT32_MAX || value == INT32_MIN;
                      });
  verdict.overload = axia && (record.status & kAxiaOverload) != 0;
  return verdict;
}

std::string flag_words(const NetFtRecord& record, NetFtProduct product) {
  std::string words;
  const auto add = [&](const std::string& word) {
    if (!words.empty()) words += '+';
    words += word;
  };
  if (judge(record, product).saturated) add("saturated");
  const auto names = status_names(product);
  for (unsigned bit = 32; bit-- > 0;) {
    if ((record.status >> bit & 1U) == 0) continue;
    const auto known =
        std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.bit == bit; });
    add("status_" + (known != names.end() ? known->name : "bit_" + std::to_string(bit)));
  }
  return words;
}

double net_ft_filter_Hz(unsigned code) noexcept {
  return code < kNetFtFilters_Hz.size() ? kNetFtFilters_Hz[code] : 0.0;
}

std::optional<unsigned> net_ft_filter_code(double cutoff_Hz) noexcept {
  const auto found = std::find(kNetFtFilters_Hz.begin(), kNetFtFilters_Hz.end(), cutoff_Hz);
  if (found == kNetFtFilters_Hz.end()) return std::nullopt;
  return static_cast<unsigned>(found - kNetFtFilters_Hz.begin());
}

}  // namespace isograsp
