// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/family/buses.hpp"

namespace isograsp {

CanIds can_ids(const DeviceConfig& config) {
  CanIds ids;
  if (config.family->add_can_ids != nullptr)
    for (const auto& sensor : config.sensors) config.family->add_can_ids(sensor, ids);
  return ids;
}

std::array<std::string, kFingerCount> udp_addresses(const DeviceConfig& config) {
  std::array<std::string, kFingerCount> addresses;
  if (config.family->udp_address != nullptr)
    for (std::size_t f = 0; f < kFingerCount; ++f)
      addresses[f] = config.family->udp_address(config.sensors[f]);
  return addresses;
}

Result<std::unique_ptr<Bus>> open_can_bus(const Uri&, const DeviceConfig& config) {
  return open_socketcan(config.interface, can_ids(config).sent);
}

Result<std::unique_ptr<Bus>> open_udp_bus(const Uri& uri, const DeviceConfig& config) {
  const auto addresses = udp_addresses(config);
  if (auto known = check_addresses(uri, addresses); !known) return known.error();
  return open_udp(addresses);
}

Result<void> check_addresses(const Uri& uri,
                             const std::array<std::string, kFingerCount>& addresses) {
  for (const auto& address : addresses)
    if (address.empty())
      return refused("the address of a sensor is missing"_text,
                     "give address for each [[sensor]]"_text)
          .at(uri.text)
          .about("config");
  return {};
}

}  // namespace isograsp
