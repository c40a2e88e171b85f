// SPDX-License-Identifier: GPL-3.0-or-later
// One effort, force over time:
//   peak = largest force,  total = largest mean force over window_s without interruption
//   above rest = total - resting force
// Coflexion is computed from force - mean force of the lead-in before the effort, digit by digit.
#include "tasks/kinds/tools/effort_score.hpp"

#include <cmath>

#include "hand/columns.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

EffortForces effort_of(const Record& record, const Part& part, double window_s,
                       const Column& force_column, const Column& resting_column) {
  const auto force = record.signals().column(force_column);
  // A window must be uninterrupted, so this list keeps the rows that do not count.
  std::vector<double> force_N;
  std::vector<double> weight_s;
  std::vector<bool> valid;
  EffortForces effort;
  if (force.empty()) return effort;
  for (std::size_t row = part.first; row < part.last; ++row) {
    force_N.push_back(force[row]);
    weight_s.push_back(record.hold_s(row));
    valid.push_back(record.counts(row) && !std::isnan(force[row]));
    if (valid.back() && (!effort.peak.value || force[row] > *effort.peak.value))
      effort.peak = force[row];
  }
  effort.total = best_moving_mean(force_N, weight_s, valid, window_s);
  effort.above_rest = effort.total;
  const double resting_N = known_in(record, part, resting_column);
  if (effort.total.value)
    effort.above_rest = std::isnan(resting_N)
                            ? statistics::Computed("the resting force was not measured"_text)
                            : statistics::Computed(*effort.total.value - resting_N);
  return effort;
}

void add_coflexion(const Record& record, const Part& part, const std::string& channel,
                   double window_s, MeasureList& list) {
  std::size_t first = part.first;
  while (first > 0 && record.phase(first - 1) == Phase::lead_in) --first;
  const NormalForces before = normal_forces(record, first, part.first);
  const Section opening = record.select(part.first, part.last, {}, names_of(columns::normal_force));
  statistics::Computed share = "the force before the cue is not known"_text;
  if (!before.section.rows.empty() && opening.reason.empty()) {
    // A window must be uninterrupted, so these lists keep the rows that do not count.
    const std::size_t rows = part.last - part.first;
    std::array<std::vector<double>, kFingerCount> force_N;
    std::vector<double> weight_s;
    std::vector<bool> valid(rows, false);
    for (const std::size_t row : opening.rows) valid[row - part.first] = true;
    for (std::size_t k = 0; k < rows; ++k) weight_s.push_back(record.hold_s(part.first + k));
    const PerDigit resting_N = before.mean();
    DigitForces forces;
    for (const Finger finger : kFingers) {
      const std::size_t f = index_of(finger);
      const auto column = record.signals().column(columns::normal_force[f]);
      for (std::size_t k = 0; k < rows; ++k)
        force_N[f].push_back(valid[k] ? column[part.first + k] - resting_N[f] : 0.0);
      forces.force_N[f] = force_N[f];
    }
    forces.weight = weight_s;
    share = coflexion(forces, valid, window_s);
  }
  list.add("coflexion", channel, "%", opening, share);
}

std::vector<Part> efforts_of(const Record& record) {
  std::vector<Part> efforts;
  for (const Part& part : parts_of(record))
    if (part.phase == Phase::active) efforts.push_back(part);
  return efforts;
}

}  // namespace isograsp::tasks
