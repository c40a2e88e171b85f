// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "hand/columns.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

namespace {

// Limits of what is remarked on. Spastic fingers rest at 1 N and more.
constexpr double kTone_N = 1.0;
constexpr double kMoving_N = 0.5;  ///< SD of the normal force: a relaxed hand is steadier
constexpr Eigen::Index kNormalForce = 2;

std::vector<std::size_t> rows_that_count(const Signals& trial) {
  const auto phase = trial.column(columns::phase);
  const auto flags = trial.column(columns::sample_flags);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < phase.size(); ++row)
    if (phase[row] == static_cast<double>(tasks::Phase::active) && flags[row] == 0.0)
      rows.push_back(row);
  return rows;
}

std::string rounded_newtons(double force_N) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", force_N);
  return text;
}

}  // namespace

std::optional<RestingForce> resting_force(const Signals& trial) {
  const auto rows = rows_that_count(trial);
  if (rows.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(rows.size());
  RestingForce rest;
  rest.samples = static_cast<std::int64_t>(rows.size());
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (Eigen::Index axis = 0; axis < 6; ++axis) {
      const auto& wrench = axis < 3 ? columns::finger_force[f] : columns::finger_torque[f];
      const auto column = trial.column(wrench[static_cast<std::size_t>(axis % 3)]);
      double sum = 0.0;
      for (const std::size_t row : rows) sum += column[row];
      const double mean = sum / n;
      double squares = 0.0;
      for (const std::size_t row : rows) squares += (column[row] - mean) * (column[row] - mean);
      rest.mean[f][axis] = mean;
      rest.sd[f][axis] = std::sqrt(squares / (n - 1.0));
    }
  return rest;
}

std::string words_of(const RestingForce& rest) {
  std::string text = "At rest";
  std::string pressing;
  std::string pulling;
  double unsteady_N = 0.0;
  const auto add = [](std::string& list, Finger finger) {
    list += (list.empty() ? "" : ", ") + std::string(name_of(finger));
  };
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    const double normal_N = rest.mean[f][kNormalForce];
    text += (f == 0 ? " " : ", ") + std::string(name_of(finger)) + " " + rounded_newtons(normal_N);
    if (normal_N >= kTone_N) add(pressing, finger);
    if (normal_N <= -kTone_N) add(pulling, finger);
    unsteady_N = std::max(unsteady_N, rest.sd[f][kNormalForce]);
  }
  text += " N.";
  if (!pressing.empty())
    text += " Pressing though relaxed (" + pressing +
            "): muscle tone or a tight strap. It is kept as it is and never subtracted.";
  if (!pulling.empty())
    text += " Pulling though relaxed (" + pulling +
            "): look at the strap and the position of the hand.";
  if (unsteady_N > kMoving_N)
    text += " The hand was not still: repeat it if the patient can relax more.";
  return text;
}

}  // namespace isograsp::session
