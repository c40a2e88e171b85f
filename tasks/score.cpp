// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the force tasks and of free handling. Definitions: docs/measures.md.
#include "tasks/score.hpp"

#include <algorithm>

#include "tasks/kinds/score_kinds.hpp"

namespace isograsp {

std::vector<Measure> score(const TaskSpec& spec, const Signals& signals) {
  const Record record(signals);
  // A new kind of task does not compile without its measures.
  return std::visit([&](const auto& kind) { return measures_of(kind, record); }, spec.kind);
}

namespace {

/// Time in which any finger touches [s]; a finger that the scene lacks has an empty column.
Computed contact_time(const Section& section, const Signals& signals) {
  double touching_s = 0.0;
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    const bool touches = std::any_of(kFingers.begin(), kFingers.end(), [&](Finger finger) {
      const auto column = signals.column("contact_" + std::string(name_of(finger)));
      return !column.empty() && column[section.rows[i]] > 0.5;
    });
    if (touches) touching_s += section.weight_s[i];
  }
  return touching_s;
}

}  // namespace

std::vector<Measure> measures_of(const ObserveSpec&, const Record& record) {
  const Signals& signals = record.signals();
  const auto grip = signals.column("actual_force_N");
  const Section force = record.select({Phase::active}, {"actual_force_N"});
  const Section motion = record.select_position(0, record.rows(), {Phase::active});
  Section contact = record.select({Phase::active}, {});
  const bool known = std::any_of(kFingers.begin(), kFingers.end(), [&](Finger finger) {
    return signals.has("contact_" + std::string(name_of(finger)));
  });
  if (!known) contact.reason = "the columns contact_* are missing";
  Computed most = "no samples";
  for (const std::size_t row : force.rows)
    if (!most.value || grip[row] > *most.value) most = grip[row];
  return {make_measure("mean_grip", "grip", "N", force, mean_over(force, grip)),
          make_measure("peak_force", "grip", "N", force, most), path_length(motion, signals),
          make_measure("contact_time", "contact", "s", contact, contact_time(contact, signals))};
}

}  // namespace isograsp
