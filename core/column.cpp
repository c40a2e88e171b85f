// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/column.hpp"

namespace isograsp {

Text ColumnWords::text() const {
  const auto value = [this](std::size_t place) { return Known{std::string(values_[place])}; };
  if (!values_[1].empty()) return Phrase<2>(english_)(value(0), value(1));
  if (!values_[0].empty()) return Phrase<1>(english_)(value(0));
  return Words(english_);
}

std::vector<std::string> names_of(std::span<const Column> columns) {
  return {columns.begin(), columns.end()};
}

std::string_view unit_of(std::string_view column) noexcept {
  constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
      {"_Nm", "N m"},    {"_N", "N"},     {"_mps", "m/s"}, {"_radps", "rad/s"},
      {"_rad", "rad"},   {"_m", "m"},     {"_s", "s"},     {"_counts", "counts"},
      {"_percent", "%"}, {"_deg", "deg"}, {"_Hz", "Hz"}};
  for (const auto& [ending, unit] : kUnits)
    if (column.ends_with(ending)) return unit;
  return "";
}

}  // namespace isograsp
