// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/endpoint.hpp"

#include <algorithm>
#include <charconv>

namespace isograsp {

namespace {

/// A decimal number from 0 to `most` without leading zeros.
std::optional<std::uint32_t> parse_number(std::string_view text, std::uint32_t most) noexcept {
  constexpr std::size_t kMostDigits = 5;
  const bool digits =
      !text.empty() && text.size() <= kMostDigits &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits || (text.size() > 1 && text.front() == '0')) return std::nullopt;
  std::uint32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  if (value > most) return std::nullopt;
  return value;
}

}  // namespace

std::string Endpoint::address_text() const {
  std::string text;
  for (unsigned shift = 32; shift > 0; shift -= 8)
    text += (text.empty() ? "" : ".") + std::to_string(address >> (shift - 8) & 0xFF);
  return text;
}

std::string Endpoint::text() const {
  return address_text() + ":" + std::to_string(port);
}

std::optional<std::uint32_t> parse_ipv4(std::string_view text) noexcept {
  std::uint32_t address = 0;
  for (int part = 0; part < 4; ++part) {
    const auto dot = part < 3 ? text.find('.') : text.size();
    if (dot == std::string_view::npos) return std::nullopt;
    const auto value = parse_number(text.substr(0, dot), 255);
    if (!value) return std::nullopt;
    address = address << 8 | *value;
    text.remove_prefix(std::min(dot + 1, text.size()));
  }
  return address;
}

std::optional<std::uint16_t> parse_port(std::string_view text) noexcept {
  const auto port = parse_number(text, 65535);
  if (!port || *port == 0) return std::nullopt;
  return static_cast<std::uint16_t>(*port);
}

std::optional<Endpoint> parse_endpoint(std::string_view text) noexcept {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto address = parse_ipv4(text.substr(0, colon));
  const auto port = parse_port(text.substr(colon + 1));
  if (!address || !port) return std::nullopt;
  return Endpoint{*address, *port};
}

}  // namespace isograsp
