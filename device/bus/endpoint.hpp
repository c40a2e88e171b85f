// SPDX-License-Identifier: GPL-3.0-or-later
// An IPv4 address with a port, in numbers: "192.168.1.1:49152".
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace isograsp {

struct Endpoint {
  std::uint32_t address = 0;  ///< 192.168.1.1 is 0xC0A80101
  std::uint16_t port = 0;

  /// By address as a number, then by port.
  [[nodiscard]] auto operator<=>(const Endpoint&) const = default;
  [[nodiscard]] std::string address_text() const;
  [[nodiscard]] std::string text() const;
};

/// "192.168.1.1": four numbers up to 255 without leading zeros; nullopt: no such address.
[[nodiscard]] std::optional<std::uint32_t> parse_ipv4(std::string_view text) noexcept;
/// 1 … 65535 without leading zeros; nullopt: no such number.
[[nodiscard]] std::optional<std::uint16_t> parse_port(std::string_view text) noexcept;
/// "192.168.1.1:49152"; nullopt: no address with a port.
[[nodiscard]] std::optional<Endpoint> parse_endpoint(std::string_view text) noexcept;

}  // namespace isograsp
