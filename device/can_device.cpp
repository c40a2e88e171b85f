// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/can_device.hpp"

#include <array>

#include "device/can_bus.hpp"
#include "device/device_config.hpp"
#include "device/rft_device.hpp"

namespace isograsp {

Result<std::unique_ptr<ForceDevice>> open_can_device(const Uri& uri) {
  if (auto known = uri.require_known({"protocol", "config", "rate"}); !known) return known.error();
  if (uri.target.empty())
    return uri.error("", "no interface is named", "write can://can0?protocol=rft");
  const auto protocol = uri.text_or("protocol", "");
  if (protocol.empty())
    return uri.error("protocol", "the protocol is missing", "add ?protocol=rft");
  if (protocol != "rft")
    return uri.error("protocol", "no CAN protocol is called '" + protocol + "'", "use rft");

  constexpr double kStandardRate_Hz = 100.0;
  const auto rate_Hz = uri.number_or("rate", kStandardRate_Hz, 10.0, 1000.0);
  if (!rate_Hz) return rate_Hz.error();
  if (!rft_rate_code(*rate_Hz))
    return uri.error("rate", "the sensors have no such rate",
                     "use 10, 20, 50, 100, 200, 333, 500 or 1000");

  RftConfig config = RftConfig::standard();
  if (const auto file = uri.text_or("config", ""); !file.empty()) {
    auto read = RftConfig::read(file);
    if (!read) return read.error();
    config = *std::move(read);
  }
  std::array<std::uint32_t, 2 * kFingerCount> ids{};
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    ids[2 * f] = config.sensors[f].ids.first;
    ids[2 * f + 1] = config.sensors[f].ids.second;
  }
  auto bus = open_socketcan(uri.target, ids);
  if (!bus) {
    Error error = bus.error();
    error.file = uri.text;
    return error;
  }
  return std::unique_ptr<ForceDevice>(
      std::make_unique<RftDevice>(*std::move(bus), config, *rate_Hz, uri.text, uri.target));
}

}  // namespace isograsp
