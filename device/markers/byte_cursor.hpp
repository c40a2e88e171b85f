// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/markers/ only. Numbers and texts taken off bytes one after the other, never beyond
// their end: what is not there makes the cursor bad and everything after it 0.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/spatial.hpp"
#include "device/markers/little_endian.hpp"

namespace isograsp {

class ByteCursor {
 public:
  explicit ByteCursor(std::span<const std::uint8_t> bytes) noexcept : rest_(bytes) {}

  [[nodiscard]] bool good() const noexcept { return good_; }
  [[nodiscard]] std::size_t left() const noexcept { return rest_.size(); }

  template <class Unsigned>
  Unsigned number() noexcept {
    if (rest_.size() < sizeof(Unsigned)) return fail<Unsigned>();
    const auto value = little_endian<Unsigned>(rest_, 0);
    rest_ = rest_.subspan(sizeof(Unsigned));
    return value;
  }
  double single() noexcept {
    return static_cast<double>(std::bit_cast<float>(number<std::uint32_t>()));
  }
  double real() noexcept { return std::bit_cast<double>(number<std::uint64_t>()); }
  Vec3 vector() noexcept {
    const double x = single(), y = single(), z = single();
    return {x, y, z};
  }
  /// Up to its 0.
  std::string_view text() noexcept {
    const auto end = std::find(rest_.begin(), rest_.end(), std::uint8_t{0});
    if (end == rest_.end()) return fail<std::string_view>();
    const auto size = static_cast<std::size_t>(end - rest_.begin());
    const std::string_view text(reinterpret_cast<const char*>(rest_.data()), size);
    rest_ = rest_.subspan(size + 1);
    return text;
  }
  void skip(std::size_t size) noexcept { static_cast<void>(part(size)); }
  /// The next bytes, as a cursor of their own.
  ByteCursor part(std::size_t size) noexcept {
    if (size > rest_.size()) return fail<ByteCursor>();
    const ByteCursor cut(rest_.first(size));
    rest_ = rest_.subspan(size);
    return cut;
  }
  /// How many things follow, each of `least` bytes or more: a number that the bytes cannot hold is
  /// none.
  std::size_t count(std::size_t least) noexcept {
    const std::size_t many = number<std::uint32_t>();
    return many <= rest_.size() / least ? many : fail<std::size_t>();
  }

 private:
  ByteCursor() noexcept : good_(false) {}
  template <class Nothing>
  Nothing fail() noexcept {
    good_ = false;
    rest_ = {};
    if constexpr (std::is_same_v<Nothing, ByteCursor>)
      return ByteCursor();
    else
      return Nothing{};
  }

  std::span<const std::uint8_t> rest_;
  bool good_ = true;
};

}  // namespace isograsp
