// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/platform_records.hpp"

#include <algorithm>

namespace isograsp::platform {

std::vector<std::string> six_axes_columns() {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (const auto* part : {&columns::finger_force[f], &columns::finger_torque[f]})
      for (const Column& column : *part) names.emplace_back(column.name);
  return names;
}

std::vector<double> as_row(const SixAxes& wrenches) {
  std::vector<double> row;
  for (const Vec6& wrench : wrenches) row.insert(row.end(), wrench.begin(), wrench.end());
  return row;
}

std::optional<SixAxes> six_axes_of(std::span<const std::string> columns,
                                   std::span<const double> row) {
  if (!std::ranges::equal(columns, six_axes_columns()) || row.size() != columns.size()) return {};
  SixAxes wrenches;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    wrenches[f] = Eigen::Map<const Vec6>(row.data() + 6 * f);
  return wrenches;
}

std::vector<std::string> two_six_axes_columns() {
  std::vector<std::string> names;
  for (const Hand hand : kBothHands)
    for (const std::string& name : six_axes_columns())
      names.push_back(std::string(name_of(hand)) + "_" + name);
  return names;
}

std::optional<OfHands<SixAxes>> two_six_axes_of(std::span<const std::string> columns,
                                                std::span<const double> row) {
  if (!std::ranges::equal(columns, two_six_axes_columns()) || row.size() != columns.size())
    return {};
  const auto own = six_axes_columns();
  return OfHands<SixAxes>{*six_axes_of(own, row.first(own.size())),
                          *six_axes_of(own, row.last(own.size()))};
}

}  // namespace isograsp::platform
