// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/open_sensors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "device/bus/bus.hpp"
#include "device/bus/tapped_bus.hpp"
#include "device/comedi/comedi_bus.hpp"
#include "device/config/fir.hpp"
#include "device/protocol/make_sessions.hpp"
#include "device/sensors/net_ft_setup.hpp"
#include "device/sensors/sensor_device.hpp"

namespace isograsp {

namespace {

/// "A,B,C" to three addresses.
Result<std::array<std::string, kFingerCount>> addresses_in(const Uri& uri) {
  std::array<std::string, kFingerCount> addresses;
  std::size_t begin = 0;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto end = uri.target.find(',', begin);
    addresses[f] = uri.target.substr(begin, end == std::string::npos ? end : end - begin);
    const bool last = f + 1 == kFingerCount;
    if (addresses[f].empty() || (end == std::string::npos) != last)
      return uri.error("", "not the addresses of three sensors",
                       "write thumb, index, middle separated by commas, or give them in the "
                       "configuration and write " +
                           uri.scheme + "://?config=FILE");
    begin = end + 1;
  }
  return addresses;
}

bool fits(const std::string& scheme, Protocol protocol) {
  if (scheme == "replay") return protocol != Protocol::jr3_comedi;
  switch (protocol) {
    case Protocol::rft: return scheme == "can" || scheme == "udp" || scheme == "serial";
    case Protocol::ati_netcanoem:
    case Protocol::jr3_can: return scheme == "can";
    case Protocol::net_ft: return scheme == "udp";
    case Protocol::jr3_comedi: return scheme == "comedi";
  }
  return false;
}

void set_address(SensorConfig& sensor, const std::string& address) {
  if (auto* rft = std::get_if<RftSensor>(&sensor.way)) rft->address = address;
  if (auto* box = std::get_if<NetFtSensor>(&sensor.way)) box->host = address;
}

Result<std::unique_ptr<Bus>> open_bus(const Uri& uri, const DeviceConfig& config) {
  if (uri.scheme == "can") return open_socketcan(config.interface, sensor_ids(config));
  if (uri.scheme == "comedi") {
    std::array<unsigned, kFingerCount> subdevices{};
    for (std::size_t f = 0; f < kFingerCount; ++f)
      subdevices[f] = std::get<Jr3ComediSensor>(config.sensors[f].way).subdevice;
    return open_comedi_bus(uri.target, subdevices);
  }
  std::array<std::string, kFingerCount> addresses = udp_addresses(config);
  if (uri.scheme == "serial")
    for (std::size_t f = 0; f < kFingerCount; ++f)
      addresses[f] = std::get<RftSensor>(config.sensors[f].way).address;
  for (const auto& address : addresses)
    if (address.empty())
      return uri.error("config", "the address of a sensor is missing",
                       "give address for each [[sensor]]");
  return uri.scheme == "udp" ? open_udp(addresses) : open_serial(addresses, config.baud);
}

/// Every box tells on its web page what its counts mean.
Result<NetFtBoxes> ask_boxes(const DeviceConfig& config) {
  constexpr Timestamp kPatience = std::chrono::seconds(2);
  NetFtBoxes boxes;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    auto box = set_up_net_ft_box(config, f, kPatience);
    if (!box) return box.error();
    boxes[f] = *std::move(box);
  }
  return boxes;
}

}  // namespace

std::array<std::string, kFingerCount> udp_addresses(const DeviceConfig& config) {
  constexpr const char* kRftPort = ":311";
  std::array<std::string, kFingerCount> addresses;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const SensorWay& way = config.sensors[f].way;
    if (const auto* rft = std::get_if<RftSensor>(&way); rft != nullptr && !rft->address.empty())
      addresses[f] = rft->address + (rft->address.find(':') == std::string::npos ? kRftPort : "");
    if (const auto* box = std::get_if<NetFtSensor>(&way))
      if (const auto address = NetFtAddress::parse(box->host))
        addresses[f] = address->records.text();
  }
  return addresses;
}

std::vector<std::uint32_t> sensor_ids(const DeviceConfig& config) {
  std::vector<std::uint32_t> ids;
  for (const auto& sensor : config.sensors) {
    if (const auto* rft = std::get_if<RftSensor>(&sensor.way)) {
      ids.push_back(rft->ids.first);
      ids.push_back(rft->ids.second);
    } else if (const auto* ati = std::get_if<AtiSensor>(&sensor.way)) {
      for (std::uint32_t op = 0; op < 16; ++op) ids.push_back(ati->base * 16U + op);
    } else if (const auto* jr3 = std::get_if<Jr3Sensor>(&sensor.way)) {
      for (const std::uint32_t op : {0x100U, 0x600U, 0x680U, 0x700U}) ids.push_back(op + jr3->node);
    }
  }
  return ids;
}

std::vector<std::uint32_t> command_ids(const DeviceConfig& config) {
  std::vector<std::uint32_t> ids;
  for (const auto& sensor : config.sensors) {
    if (const auto* rft = std::get_if<RftSensor>(&sensor.way)) {
      ids.push_back(rft->ids.command);
    } else if (const auto* ati = std::get_if<AtiSensor>(&sensor.way)) {
      for (std::uint32_t op = 0; op < 16; ++op) ids.push_back(ati->base * 16U + op);
    } else if (const auto* jr3 = std::get_if<Jr3Sensor>(&sensor.way)) {
      constexpr std::uint32_t kSync = 0x080;
      if (ids.empty()) ids.push_back(kSync);
      for (std::uint32_t op = 0x180; op <= 0x580; op += 0x80) ids.push_back(op + jr3->node);
    }
  }
  return ids;
}

Result<DeviceConfig> config_of(const Uri& uri) {
  const bool recorded = uri.scheme == "replay";
  if (auto known = recorded ? uri.require_known({"protocol", "config", "rate", "speed"})
                            : uri.require_known({"protocol", "config", "rate", "fir"});
      !known)
    return known.error();
  const auto name = uri.text_or("protocol", "");
  const auto protocol = protocol_from_name(name);
  if (!name.empty() && !protocol)
    return uri.error("protocol", "no protocol is called '" + name + "'",
                     "use rft, ati-netcanoem, jr3-can or net-ft");
  const auto file = uri.text_or("config", "");
  if (file.empty() && !protocol)
    return uri.error("protocol", "the protocol is missing", "add ?protocol=rft or ?config=FILE");
  DeviceConfig config = DeviceConfig::standard(protocol.value_or(Protocol::rft));
  if (!file.empty()) {
    auto read = DeviceConfig::read(file);
    if (!read) return read.error();
    if (protocol && *protocol != read->protocol)
      return uri.error("protocol",
                       "the configuration is for " + std::string(name_of(read->protocol)),
                       "leave protocol out or use another configuration");
    config = *std::move(read);
  }
  if (!fits(uri.scheme, config.protocol))
    return uri.error(
        "protocol",
        std::string(title_of(config.protocol)) + " sensors do not speak over " + uri.scheme + "://",
        "see: isograsp devices");
  const auto rate_Hz = uri.number_or("rate", config.rate_Hz, 10.0, 1000.0);
  if (!rate_Hz) return rate_Hz.error();
  if (config.protocol == Protocol::rft && !rft_rate_code(*rate_Hz))
    return uri.error("rate", "the sensors have no such rate",
                     "use 10, 20, 50, 100, 200, 333, 500 or 1000");
  config.rate_Hz = *rate_Hz;
  const auto taps = uri.number_or("fir", config.fir_taps, 0.0, static_cast<double>(kMostFirTaps));
  if (!taps) return taps.error();
  if (*taps != std::floor(*taps))
    return uri.error("fir", "is not a whole number", "give an odd number of taps");
  config.fir_taps = static_cast<int>(*taps);

  if (recorded) return config;
  if (uri.scheme == "can") {
    if (!uri.target.empty()) config.interface = uri.target;
    if (config.interface.empty())
      return uri.error("", "no interface is named", "write can://can0?protocol=rft");
  } else if (!uri.target.empty() && uri.scheme != "comedi") {
    const auto addresses = addresses_in(uri);
    if (!addresses) return addresses.error();
    for (std::size_t f = 0; f < kFingerCount; ++f) set_address(config.sensors[f], (*addresses)[f]);
  }
  return config;
}

Result<std::unique_ptr<ForceDevice>> open_sensors(const Uri& uri, const DeviceOptions& options) {
  auto config = config_of(uri);
  if (!config) return config.error();
  std::vector<double> fir;
  if (config->fir_taps != 0) {
    auto designed = design_fir(config->fir_taps, config->rate_Hz, config->fir_cutoff_Hz);
    if (!designed) return uri.error("fir", designed.error().what, designed.error().remedy);
    fir = *std::move(designed);
  }
  std::string place = uri.target;
  if (uri.scheme == "can") place = config->interface;
  if (uri.scheme == "udp") place = "the network";
  if (uri.scheme == "serial") place = "serial lines";
  const auto named = [&](Error error) {
    error.file = uri.text;
    return error;
  };
  NetFtBoxes boxes;
  if (config->protocol == Protocol::net_ft) {
    auto asked = ask_boxes(*config);
    if (!asked) return asked.error();
    boxes = *std::move(asked);
  }
  auto sessions = make_sessions(*config, boxes);
  auto opened = open_bus(uri, *config);
  if (!opened) return named(opened.error());
  std::unique_ptr<Bus> bus = *std::move(opened);
  if (options.tap != nullptr) bus = std::make_unique<TappedBus>(std::move(bus), options.tap);
  return std::unique_ptr<ForceDevice>(std::make_unique<SensorDevice>(
      std::move(bus), std::move(sessions), *config, fir, uri.text, place));
}

}  // namespace isograsp
