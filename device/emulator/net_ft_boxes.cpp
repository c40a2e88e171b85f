// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "device/config/family_facts.hpp"
#include "device/emulator/net_ft_server.hpp"

namespace isograsp {

Result<std::unique_ptr<Bus>> open_net_ft_boxes(const std::string& on, const DeviceConfig& config,
                                               std::string& uri) {
  const auto first = NetFtAddress::parse(on);
  if (!first)
    return refused("'%1' is no address of boxes"_text(on),
                   "use --on 127.0.0.1:49152:8080 (records, web pages)"_text)
        .about("--on");
  NetFtServerOptions options;
  uri = "udp://";
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    auto& box = options.boxes[f];
    box.records = first->records;
    box.pages = first->pages;
    box.records.address += static_cast<std::uint32_t>(f);
    box.pages.address += static_cast<std::uint32_t>(f);
    box.config.rate_Hz = config.rate_Hz;
    const auto& serial = config.sensors[f].serial_number;
    box.config.serial_number = serial.empty() ? "EMUL-" + std::to_string(f + 1) : serial;
    uri += (f == 0 ? "" : ",") + box.records.text() + ":" + std::to_string(box.pages.port);
  }
  uri += "?protocol=" + std::string(config.family->name);
  auto server = NetFtServer::open(std::move(options));
  if (!server) return server.error();
  return std::unique_ptr<Bus>(*std::move(server));
}

}  // namespace isograsp
