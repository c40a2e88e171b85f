// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/host.hpp"

#include <exception>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

namespace isograsp {

namespace asio = boost::asio;

std::optional<HostAndPort> parse_host(std::string_view text, std::uint16_t usual_port) {
  HostAndPort host{std::string(text), usual_port};
  if (const auto colon = text.find(':'); colon != std::string_view::npos) {
    const auto port = parse_port(text.substr(colon + 1));
    if (!port) return std::nullopt;
    host = {std::string(text.substr(0, colon)), *port};
  }
  if (host.host.empty() || host.host.find_first_of("/ ?@") != std::string::npos)
    return std::nullopt;
  return host;
}

Result<Endpoint> find_host(const HostAndPort& host) {
  if (const auto address = parse_ipv4(host.host)) return Endpoint{*address, host.port};
  const auto unknown = [&](const std::string& why) {
    return failed("no computer of this name is known: %1"_text(Known{why}),
                  "check the name, or give the address in numbers"_text)
        .about(host.host);
  };
  try {
    asio::io_context io(1);
    asio::ip::tcp::resolver resolver(io);
    boost::system::error_code failure;
    const auto found = resolver.resolve(asio::ip::tcp::v4(), host.host, "", failure);
    if (failure) return unknown(failure.message());
    for (const auto& entry : found)
      return Endpoint{entry.endpoint().address().to_v4().to_uint(), host.port};
    return unknown("");
  } catch (const std::exception& problem) {
    return unknown(problem.what());
  }
}

}  // namespace isograsp
