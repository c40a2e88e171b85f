// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/open_sensors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "device/bus/bus.hpp"
#include "device/bus/tapped_bus.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/fir.hpp"
#include "device/protocol/make_sessions.hpp"
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
      return refused("not the addresses of three sensors"_text,
                     "write thumb, index, middle separated by commas, or give them in the "
                     "configuration and write %1://?config=FILE"_text(uri.scheme))
          .at(uri.text);
    begin = end + 1;
  }
  return addresses;
}

/// nullptr: the family is on no such bus.
const FamilyBus* bus_of(const FamilyFacts& family, const std::string& scheme) {
  const auto found = std::find_if(family.buses.begin(), family.buses.end(),
                                  [&](const FamilyBus& bus) { return bus.scheme == scheme; });
  return found == family.buses.end() ? nullptr : &*found;
}

bool fits(const std::string& scheme, const FamilyFacts& family) {
  return scheme == "replay" ? family.on_wire() : bus_of(family, scheme) != nullptr;
}

}  // namespace

Result<DeviceConfig> config_of(const Uri& uri) {
  const bool recorded = uri.scheme == "replay";
  if (auto known = recorded ? uri.require_known({"protocol", "config", "rate", "speed"})
                            : uri.require_known({"protocol", "config", "rate", "fir"});
      !known)
    return known.error();
  const auto name = uri.text_or("protocol", "");
  const FamilyFacts* named = family_named(name);
  if (!name.empty() && named == nullptr)
    return refused("no protocol is called '%1'"_text(name), "use %1"_text(any_family()))
        .at(uri.text)
        .about("protocol");
  const auto file = uri.text_or("config", "");
  if (file.empty() && named == nullptr)
    return refused("the protocol is missing"_text, "add ?protocol=rft or ?config=FILE"_text)
        .at(uri.text)
        .about("protocol");
  DeviceConfig config;
  if (file.empty()) {
    config = DeviceConfig::standard(*named);
  } else {
    auto read = DeviceConfig::read(file);
    if (!read) return read.error();
    if (named != nullptr && named != read->family)
      return refused("the configuration is for %1"_text(read->family->name),
                     "leave protocol out or use another configuration"_text)
          .at(uri.text)
          .about("protocol");
    config = *std::move(read);
  }
  const FamilyFacts& family = *config.family;
  if (!fits(uri.scheme, family))
    return refused("%1 sensors do not speak over %2://"_text(family.title, uri.scheme),
                   "see: isograsp devices"_text)
        .at(uri.text)
        .about("protocol");
  const auto rate_Hz = uri.number_or("rate", config.rate_Hz, 10.0, 1000.0);
  if (!rate_Hz) return rate_Hz.error();
  if (!family.has_rate(*rate_Hz))
    return refused("the sensors have no such rate"_text, family.rate_remedy)
        .at(uri.text)
        .about("rate");
  config.rate_Hz = *rate_Hz;
  const auto taps = uri.number_or("fir", config.fir_taps, 0.0, static_cast<double>(kMostFirTaps));
  if (!taps) return taps.error();
  if (*taps != std::floor(*taps))
    return refused("is not a whole number"_text, "give an odd number of taps"_text)
        .at(uri.text)
        .about("fir");
  config.fir_taps = static_cast<int>(*taps);

  if (recorded) return config;
  if (uri.scheme == "can") {
    if (!uri.target.empty()) config.interface = uri.target;
    if (config.interface.empty())
      return refused("no interface is named"_text, "write can://can0?protocol=rft"_text)
          .at(uri.text);
  } else if (!uri.target.empty() && family.set_address != nullptr) {
    const auto addresses = addresses_in(uri);
    if (!addresses) return addresses.error();
    for (std::size_t f = 0; f < kFingerCount; ++f)
      family.set_address(config.sensors[f], (*addresses)[f]);
  }
  return config;
}

Result<std::unique_ptr<ForceDevice>> open_sensors(const Uri& uri, const DeviceOptions& options) {
  auto config = config_of(uri);
  if (!config) return config.error();
  std::vector<double> fir;
  if (config->fir_taps != 0) {
    auto designed = design_fir(config->fir_taps, config->rate_Hz, config->fir_cutoff_Hz);
    if (!designed)
      return refused(designed.error().what, designed.error().remedy).at(uri.text).about("fir");
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
  auto sessions = ask_sessions(*config);
  if (!sessions) return sessions.error();
  auto opened = bus_of(*config->family, uri.scheme)->open(uri, *config);
  if (!opened) return named(opened.error());
  std::unique_ptr<Bus> bus = *std::move(opened);
  if (options.tap != nullptr) bus = std::make_unique<TappedBus>(std::move(bus), options.tap);
  return std::unique_ptr<ForceDevice>(std::make_unique<SensorDevice>(
      std::move(bus), *std::move(sessions), *config, fir, uri.text, place));
}

}  // namespace isograsp
