// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the records of one Net F/T box out of a log of datagrams and turns them into wrenches in
// the sensor frame; and says which box of a log is under which finger.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"
#include "device/codec/net_ft_codec.hpp"
#include "device/codec/net_ft_sequence.hpp"
#include "device/config/device_config.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct NetFtSample {
  Timestamp stamp{0};  ///< of the datagram
  NetFtRecord record;
  Wrench wrench_S;     ///< [N, N m], before zero
  bool valid = false;  ///< no critical status and nothing saturated
};

/// A late record still makes a sample, at its place in the log. A record that came before, or that
/// no box can have sent yet, makes none.
class NetFtDecoder {
 public:
  explicit NetFtDecoder(const NetFtScale& scale = {},
                        NetFtProduct product = NetFtProduct::net_box) noexcept
      : scale_(scale), product_(product) {}

  /// Appends the samples of a datagram from this box. Datagrams in the order of the log.
  void push(std::span<const std::uint8_t> datagram, Timestamp stamp,
            std::vector<NetFtSample>& samples);

  [[nodiscard]] NetFtProduct product() const noexcept { return product_; }
  [[nodiscard]] const NetFtSequence& sequence() const noexcept { return sequence_; }
  /// Datagrams that hold neither whole records nor a request, and impossible records.
  [[nodiscard]] std::uint64_t foreign() const noexcept { return foreign_ + sequence_.impossible(); }
  [[nodiscard]] std::uint64_t requests() const noexcept { return requests_; }

 private:
  NetFtScale scale_;
  NetFtProduct product_;
  NetFtSequence sequence_;
  std::uint64_t foreign_ = 0;
  std::uint64_t requests_ = 0;
};

/// Whether a datagram of this size holds one or more whole records.
[[nodiscard]] constexpr bool holds_net_ft_records(std::size_t bytes) noexcept {
  return bytes > 0 && bytes % kNetFtRecord == 0;
}

/// Which box is under which finger.
struct NetFtFingers {
  std::array<std::optional<Endpoint>, kFingerCount> box;  ///< port 0: any

  /// nullopt: the box of no finger.
  [[nodiscard]] std::optional<std::size_t> finger_of(const Endpoint& from) const noexcept;
  /// The boxes that sent records are thumb, index and middle in ascending order. Errors: there are
  /// none, or more than three; they name `log`.
  [[nodiscard]] static Result<NetFtFingers> in_order(std::vector<Endpoint> senders,
                                                     const std::string& log);
  /// As the configuration says: "192.168.1.1" or with a port.
  [[nodiscard]] static Result<NetFtFingers> of(const DeviceConfig& config);
};

}  // namespace isograsp
