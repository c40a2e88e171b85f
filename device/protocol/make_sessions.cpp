// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/make_sessions.hpp"

#include "device/protocol/ati_session.hpp"
#include "device/protocol/jr3_comedi_session.hpp"
#include "device/protocol/jr3_session.hpp"
#include "device/protocol/net_ft_session.hpp"
#include "device/protocol/rft_session.hpp"

namespace isograsp {

namespace {

std::unique_ptr<SensorSession> rft_session(const DeviceConfig& config, std::size_t finger) {
  const SensorConfig& sensor = config.sensors[finger];
  const auto& rft = std::get<RftSensor>(sensor.way);
  RftSession::Settings settings;
  if (rft.address.empty())
    settings.way = rft.ids;
  else
    settings.way = RftPeer{static_cast<std::uint32_t>(finger)};
  settings.address = rft.address;
  settings.serial_number = sensor.serial_number;
  settings.divisors = rft.divisors;
  settings.rate_Hz = config.rate_Hz;
  settings.filter_Hz = config.filter_Hz;
  settings.filter_table = config.filter_table;
  return std::make_unique<RftSession>(settings);
}

}  // namespace

SensorSessions make_sessions(const DeviceConfig& config, const NetFtBoxes& boxes) {
  SensorSessions sessions;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    switch (config.protocol) {
      case Protocol::ati_netcanoem: sessions[f] = std::make_unique<AtiSession>(config, f); break;
      case Protocol::jr3_can: sessions[f] = std::make_unique<Jr3Session>(config, f); break;
      case Protocol::net_ft:
        sessions[f] = std::make_unique<NetFtSession>(config, f, boxes[f]);
        break;
      case Protocol::jr3_comedi: sessions[f] = std::make_unique<Jr3ComediSession>(config, f); break;
      case Protocol::rft: sessions[f] = rft_session(config, f); break;
    }
  }
  return sessions;
}

}  // namespace isograsp
