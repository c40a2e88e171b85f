// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_setup.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
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
      : sensor_(finger == 0   ? "the thumb's sensor"_text
                : finger == 1 ? "the index's sensor"_text
                              : "the middle's sensor"_text),
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
    error.what = "%1: %2"_text(sensor_, error.what);
    return error;
  }
  [[nodiscard]] Error error(std::string field, const Text& what, Text remedy) const {
    return failed("%1 %2"_text(sensor_, what), std::move(remedy))
        .at(place(kPage))
        .about(std::move(field));
  }

 private:
  [[nodiscard]] std::string place(const char* target) const {
    return "http://" + (pages_.port == kBoxPagePort ? pages_.address_text() : pages_.text()) +
           target;
  }

  SteadyClock clock_;
  Words sensor_;
  Endpoint pages_;
  Timestamp until_;
};

bool same_rate(std::optional<double> a_Hz, double b_Hz) noexcept {
  return a_Hz && std::abs(*a_Hz - b_Hz) <= kSameRate * b_Hz;
}

}  // namespace

Result<NetFtBoxConfig> set_up_net_ft_box(const DeviceConfig& config, std::size_t finger,
                                         Timestamp limit) {
  const SensorConfig& sensor = config.sensors[finger];
  const std::string& host = sensor.as<NetFtSensor>().host;
  const auto address = NetFtAddress::parse(host);
  if (!address)
    return refused("'%1' is no address in numbers"_text(host), "write it as 192.168.1.1"_text)
        .about("address");
  Box box(finger, address->pages, limit);
  auto answer = box.ask();
  if (!answer) return answer;
  if (!sensor.serial_number.empty() && answer->serial_number != sensor.serial_number)
    return box.error("cfgcalsn",
                     "has the serial number '%1', but the configuration says '%2'"_text(
                         answer->serial_number, sensor.serial_number),
                     "connect the right sensor or correct serial_number"_text);
  if (answer->transformed)
    return box.error("cfgtfx", "shifts or turns its forces before it sends them"_text,
                     "set the tool transformation to zero on the box's page Configurations"_text);
  if (same_rate(answer->rate_Hz, config.rate_Hz)) return answer;

  if (auto set = box.get("/comm.cgi?comrdtrate=" + number(std::round(config.rate_Hz))); !set)
    return set.error();
  answer = box.ask();
  if (!answer || same_rate(answer->rate_Hz, config.rate_Hz)) return answer;
  return box.error("comrdtrate",
                   answer->rate_Hz ? "sends at %1 Hz, not at %2"_text(shortest(*answer->rate_Hz),
                                                                      shortest(config.rate_Hz))
                                   : "does not tell its rate"_text,
                   "use a rate that the box has: a whole fraction of 7000 Hz"_text);
}

}  // namespace isograsp
