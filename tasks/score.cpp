// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the force tasks and of free handling. Definitions: docs/measures.md.
#include "tasks/score.hpp"

#include "tasks/kinds/object_score.hpp"
#include "tasks/kinds/score_kinds.hpp"

namespace isograsp::tasks {

std::vector<Measure> score(const TaskSpec& spec, const Signals& signals) {
  const Record record(signals);
  // A new kind of task does not compile without its measures.
  return std::visit([&](const auto& kind) { return measures_of(kind, record); }, spec.kind);
}

std::vector<Measure> measures_of(const ObserveSpec&, const Record& record) {
  const ObjectRecord object(record);
  const Section force = record.select({Phase::active}, {"actual_force_N"});
  const Section motion = record.select_position(0, record.rows(), {Phase::active});
  Section contact = record.select({Phase::active}, object.contact_columns());
  if (contact.reason.empty()) contact.reason = object.no_contact_columns();
  double touching_s = 0.0;
  for (std::size_t k = 0; k < contact.rows.size(); ++k)
    if (object.touched(contact.rows[k])) touching_s += contact.weight_s[k];
  statistics::Computed most = "no samples";
  for (const double force_N : force.values("actual_force_N"))
    if (!most.value || force_N > *most.value) most = force_N;
  return {object.mean_grip({Phase::active}), make_measure("peak_force", "grip", "N", force, most),
          path_length(motion), make_measure("contact_time", "contact", "s", contact, touching_s)};
}

}  // namespace isograsp::tasks
