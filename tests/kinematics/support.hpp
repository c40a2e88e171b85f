// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the moving arm share: reference values, rigs and random attitudes.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "kinematics/calibration.hpp"
#include "kinematics/movement.hpp"
#include "kinematics/rig.hpp"
#include "tests/support/golden_table.hpp"
#include "tests/support/must.hpp"
#include "tests/support/random_pose.hpp"

namespace isograsp::test {

inline std::string golden(const std::string& name) {
  return std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/isotonic/" + name;
}

inline Rig golden_rig(const std::string& name) {
  return must(parse_rig(must(read_text(golden(name))), name));
}

/// By movement, name and channel, for comparing with tables of reference values.
inline std::map<std::string, Measure> by_movement(const std::vector<MovementMeasure>& measures) {
  std::map<std::string, Measure> all;
  for (const auto& [movement, measure] : measures)
    all[std::to_string(movement) + " " + measure.name + " " + measure.channel] = measure;
  return all;
}

inline Pose pose_in(const Fields& row, const std::string& name) {
  const auto at = [&](const char* ending) { return number_in(row, name + ending); };
  return {{at("_x_m"), at("_y_m"), at("_z_m")}, {at("_qw"), at("_qx"), at("_qy"), at("_qz")}};
}

/// A table of markers: t_s, NAME_x_m, …
inline MarkerRows golden_markers(const std::string& name) {
  auto csv = must(CsvReader::open(golden(name)));
  MarkerRows rows;
  for (std::size_t c = 1; c < csv.columns().size(); c += 3)
    rows.markers.push_back(csv.columns()[c].substr(0, csv.columns()[c].size() - 4));
  std::vector<double> row(csv.columns().size());
  while (must(csv.next(row))) {
    rows.t_s.push_back(row[0]);
    std::vector<Vec3> p_W;
    for (std::size_t c = 1; c < row.size(); c += 3)
      p_W.emplace_back(row[c], row[c + 1], row[c + 2]);
    rows.p_W.push_back(std::move(p_W));
  }
  return rows;
}

/// Of a position [m] and an attitude [rad] against independent reference values.
inline constexpr double kGoldenPosition_m = 1e-9;
inline constexpr double kGoldenAngle_rad = 1e-8;

}  // namespace isograsp::test
