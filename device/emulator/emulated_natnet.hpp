// SPDX-License-Identifier: GPL-3.0-or-later
// Motive's NatNet stream in software: requests in, messages out, in the layout of any version. No
// socket and no clock.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "device/emulator/marker_play.hpp"
#include "device/markers/natnet_layout.hpp"

namespace isograsp {

struct EmulatedNatNetOptions {
  NatNetVersion version{4, 1};
  /// Where frames go; told from 3.0 on.
  std::uint16_t data_port = 1511;
  std::uint32_t group = 0;  ///< 0: to those who ask
};

class EmulatedNatNet {
 public:
  explicit EmulatedNatNet(EmulatedNatNetOptions options) noexcept : options_(options) {}

  /// The answer to a request; empty: none. `stays`: who asked wants frames, still or from now on.
  [[nodiscard]] std::vector<std::uint8_t> answer(std::span<const std::uint8_t> request,
                                                 const std::vector<std::string>& labels,
                                                 double rate_Hz, bool& stays) const;
  /// A picture. All markers are one set with a body of its name; besides there is one of everything
  /// that the version knows: another marker, a skeleton, an asset, a force plate, a device.
  [[nodiscard]] std::vector<std::uint8_t> frame(const MarkerPicture& picture) const;

 private:
  [[nodiscard]] std::vector<std::uint8_t> server() const;
  [[nodiscard]] std::vector<std::uint8_t> models(const std::vector<std::string>& labels) const;

  EmulatedNatNetOptions options_;
};

}  // namespace isograsp
