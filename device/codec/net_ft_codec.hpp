// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of ATI Net F/T boxes and Ethernet Axia sensors: RDT requests and records over UDP, and the
// status words. Pure: datagrams in, records out; no socket, no clock, no allocation. Source:
// docs/devices.md. Values are in the sensor frame, before zero and mounting.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

inline constexpr std::uint16_t kNetFtPort = 49152;
inline constexpr std::size_t kNetFtRecord = 36;  ///< bytes of one record
/// Fastest sampling inside any of these sensors [Hz] (Axia; the Net box has 7000).
inline constexpr double kNetFtFastest_Hz = 8000.0;

enum class NetFtCommand : std::uint16_t {
  stop = 0x0000,  ///< not answered
  start = 0x0002,
  start_buffered = 0x0003,  ///< several records in a datagram
  reset_latch = 0x0041,
  set_bias = 0x0042
};

struct NetFtRequest {
  NetFtCommand command = NetFtCommand::stop;
  std::uint32_t samples = 0;  ///< 0: without end

  [[nodiscard]] bool operator==(const NetFtRequest&) const = default;
};

/// One measurement.
struct NetFtRecord {
  std::uint32_t rdt_sequence = 0;  ///< from 1 with each start
  std::uint32_t ft_sequence = 0;   ///< measurements inside the sensor since power-up
  std::uint32_t status = 0;
  RawCounts raw{};

  [[nodiscard]] bool operator==(const NetFtRecord&) const = default;
};

/// 8 bytes to sensor number `peer`.
[[nodiscard]] BusFrame encode_net_ft_request(std::uint32_t peer,
                                             const NetFtRequest& request) noexcept;
/// nullopt: no request that is known here.
[[nodiscard]] std::optional<NetFtRequest> decode_net_ft_request(
    std::span<const std::uint8_t> bytes) noexcept;
/// 36 bytes from sensor number `peer`.
[[nodiscard]] BusFrame encode_net_ft_record(std::uint32_t peer, const NetFtRecord& record) noexcept;
/// nullopt: not 36 bytes.
[[nodiscard]] std::optional<NetFtRecord> decode_net_ft_record(
    std::span<const std::uint8_t> bytes) noexcept;

/// Counts of one newton and one newton metre.
struct NetFtScale {
  double counts_per_unit_force = 1e6;  ///< as the box says it: per unit_force_N
  double counts_per_unit_torque = 1e6;
  double unit_force_N = 1.0;
  double unit_torque_Nm = 1.0;
};
/// In the sensor frame [N, N m]. Divides, so that 12 340 000 counts are 12.34 N to the last bit.
[[nodiscard]] Wrench wrench_of(const RawCounts& raw, const NetFtScale& scale) noexcept;
/// [N, N m] per count.
[[nodiscard]] Vec6 units_per_count(const NetFtScale& scale) noexcept;

/// The meanings of the status word differ.
enum class NetFtProduct : std::uint8_t { net_box, axia };

/// Whether the values of a record can be used.
struct NetFtVerdict {
  bool critical = false;   ///< the sensor itself says that the values mean nothing
  bool saturated = false;  ///< a gage at its end (by status), or a value at the end of 32 bits
  bool overload = false;   ///< more force or torque than the calibrated range

  [[nodiscard]] bool valid() const noexcept { return !critical && !saturated; }
};
/// Every bit of the status is critical, known or not, except a latched threshold alone, which the
/// clinic may have set in the box.
[[nodiscard]] NetFtVerdict judge(const NetFtRecord& record, NetFtProduct product) noexcept;

/// For logs: "saturated" and "status_…" of every bit, from the highest down, joined by "+"; empty
/// for a healthy record. Allocates.
[[nodiscard]] std::string flag_words(const NetFtRecord& record, NetFtProduct product);

/// Cut-off [Hz] of a filter code of the Net box (setuserfilter); 0: no filter or an unknown code.
[[nodiscard]] double net_ft_filter_Hz(unsigned code) noexcept;
/// nullopt: the box has no such filter.
[[nodiscard]] std::optional<unsigned> net_ft_filter_code(double cutoff_Hz) noexcept;

}  // namespace isograsp
