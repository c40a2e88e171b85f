// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resting.hpp"

#include <algorithm>
#include <cmath>
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

}  // namespace

std::optional<RestingForce> resting_force(const Signals& trial) {
  if (!trial.has(columns::finger_force[0][0])) return std::nullopt;  // of both hands
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

Text words_of(const RestingForce& rest) {
  std::array<Number, kFingerCount> normal;
  std::vector<Text> pressing;
  std::vector<Text> pulling;
  double unsteady_N = 0.0;
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    const double normal_N = rest.mean[f][kNormalForce];
    normal[f] = fixed(normal_N, 1);
    const Known name{std::string(name_of(finger))};
    if (normal_N >= kTone_N) pressing.push_back(name);
    if (normal_N <= -kTone_N) pulling.push_back(name);
    unsteady_N = std::max(unsteady_N, rest.sd[f][kNormalForce]);
  }
  std::vector<Text> words{
      "At rest thumb %1, index %2, middle %3 N."_text(normal[0], normal[1], normal[2])};
  if (!pressing.empty()) {
    words.push_back("Pressing though relaxed (%1): muscle tone or a tight strap."_text(
        joined(pressing, ", "_text)));
    words.push_back("It is kept as it is and never subtracted."_text);
  }
  if (!pulling.empty())
    words.push_back(
        "Pulling though relaxed (%1): look at the strap and the position of the hand."_text(
            joined(pulling, ", "_text)));
  if (unsteady_N > kMoving_N)
    words.push_back("The hand was not still: repeat it if the patient can relax more."_text);
  return joined(words);
}

}  // namespace isograsp::session
