// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/column.hpp"

namespace isograsp {

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
