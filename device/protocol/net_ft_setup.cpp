// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_setup.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/csv.hpp"
#include "device/bus/http_get.hpp"
#include "device/config/net_ft_sensor.hpp"

namespace isograsp {

namespace {

constexpr std::uint16_t kBoxPagePort = 80;
constexpr double kSameRate = 0.01;  // the box rounds: 333.33 for 333
constexpr const char* kPage = "/netftapi2.xml";

std::string number(double value) {
  std::string digits;
  append_number(digits, value);
  return digits;
}

/// One box and the time that is left to talk to it.
class Box {
 public:
  Box(std::size_t finger, Endpoint pages, Timestamp limit)
      : sensor_("the " + std::string(kFingerNames[finger]) + "'s sensor"),
        pages_(pages),
        until_(clock_.now() + limit) {}

  [[nodiscard]] Result<NetFtBoxConfig> ask() {
    auto page = get(kPage);
    if (!page) return page.error();
    return NetFtBoxConfig::parse(*page, place(kPage));
  }
  [[nodiscard]] Result<std::string> get(const std::string& target) {
    auto body = http_get(pages_, target, std::max(until_ - clock_.now(), Timestamp{1}));
    if (body) return body;
    Error error = body.error();
    error.what = sensor_ + ": " + error.what;
    return error;
  }
  [[nodiscard]] Error error(std::string field, const std::string& what, std::string remedy) const {
    return failed(sensor_ + " " + what, std::move(remedy)).at(place(kPage)).about(std::move(field));
  }

 private:
  [[nodiscard]] std::string place(const char* target) const {
    return "http://" + (pages_.port == kBoxPagePort ? pages_.address_text() : pages_.text()) +
           target;
  }

  SteadyClock clock_;
  std::string sensor_;
  Endpoint pages_;
  Timestamp until_;
};

bool same_rate(double a_Hz, double b_Hz) noexcept {
  return std::abs(a_Hz - b_Hz) <= kSameRate * b_Hz;
}

}  // namespace

Result<NetFtBoxConfig> set_up_net_ft_box(const DeviceConfig& config, std::size_t finger,
                                         Timestamp limit) {
  const SensorConfig& sensor = config.sensors[finger];
  const std::string& host = sensor.as<NetFtSensor>().host;
  const auto address = NetFtAddress::parse(host);
  if (!address)
    return refused("'" + host + "' is no address in numbers", "write it as 192.168.1.1")
        .about("address");
  Box box(finger, address->pages, limit);
  auto said = box.ask();
  if (!said) return said;
  if (!sensor.serial_number.empty() && said->serial_number != sensor.serial_number)
    return box.error("cfgcalsn",
                     "has the serial number '" + said->serial_number +
                         "', but the configuration says '" + sensor.serial_number + "'",
                     "connect the right sensor or correct serial_number");
  if (said->transformed)
    return box.error("cfgtfx", "shifts or turns its forces before it sends them",
                     "set the tool transformation to zero on the box's page Configurations");
  if (same_rate(said->rate_Hz, config.rate_Hz)) return said;

  if (auto set = box.get("/comm.cgi?comrdtrate=" + number(std::round(config.rate_Hz))); !set)
    return set.error();
  said = box.ask();
  if (!said || same_rate(said->rate_Hz, config.rate_Hz)) return said;
  return box.error("comrdtrate",
                   said->rate_Hz > 0.0 ? "sends at " + number(said->rate_Hz) + " Hz, not at " +
                                             number(config.rate_Hz)
                                       : "does not tell its rate",
                   "use a rate that the box has: a whole fraction of 7000 Hz");
}

}  // namespace isograsp
