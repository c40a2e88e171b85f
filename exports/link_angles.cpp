// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/link_angles.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "hand/columns.hpp"
#include "kinematics/attitude.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

namespace {

constexpr std::array<std::string_view, 4> kChain{"elbow", "forearm", "dorsum", "object"};

/// Attitude of a segment over the trial.
using Attitude = std::array<std::span<const double>, columns::kWxyz.size()>;

std::optional<Attitude> attitude_of(const ExportTrial& trial, std::string_view segment) {
  std::size_t next = 0;  // columns of the signals, group after group
  std::array<std::optional<std::size_t>, columns::kWxyz.size()> found;
  for (const auto& group : trial.trial.groups)
    for (const auto& column : group.columns) {
      for (std::size_t c = 0; c < found.size(); ++c)
        if (group.name == tasks::kSegmentGroup &&
            column == std::string(segment) + "_q" + std::string(columns::kWxyz[c]))
          found[c] = next;
      ++next;
    }
  Attitude attitude;
  for (std::size_t c = 0; c < found.size(); ++c) {
    if (!found[c]) return std::nullopt;
    attitude[c] = trial.signals.column(*found[c]);
  }
  return attitude;
}

Quat at(const Attitude& attitude, std::size_t row) {
  return {attitude[0][row], attitude[1][row], attitude[2][row], attitude[3][row]};
}

}  // namespace

void add_link_angles(ExportTrial& exported) {
  storage::SignalGroup group{std::string(tasks::kLinkGroup), {}};
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k + 1 < kChain.size(); ++k) {
    const auto near = attitude_of(exported, kChain[k]);
    const auto far = attitude_of(exported, kChain[k + 1]);
    if (!near || !far) continue;
    std::array<std::vector<double>, 3> phi;
    Quat first = missing_pose().q;
    for (std::size_t row = 0; row < exported.signals.rows(); ++row) {
      const Quat q = at(*near, row).conjugate() * at(*far, row);
      if (is_missing(first)) first = q;
      const Vec3 turned = is_missing(q) ? missing_pose().p : rotation_vector(first.conjugate() * q);
      for (std::size_t axis = 0; axis < phi.size(); ++axis)
        phi[axis].push_back(turned[static_cast<Eigen::Index>(axis)]);
    }
    for (std::size_t axis = 0; axis < phi.size(); ++axis) {
      group.columns.push_back(std::string(kChain[k]) + "_" + std::string(kChain[k + 1]) + "_" +
                              std::string(columns::kXyz[axis]) + "_rad");
      all.push_back(std::move(phi[axis]));
    }
  }
  if (group.columns.empty()) return;
  for (std::size_t c = 0; c < all.size(); ++c)
    exported.signals.add_column(group.columns[c], std::move(all[c]));
  exported.trial.groups.push_back(std::move(group));
}

}  // namespace isograsp::exports
