// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/score.hpp"

#include "tasks/record.hpp"

namespace isograsp::tasks {

std::vector<Measure> score(const TaskSpec& spec, const Signals& signals) {
  if (spec.kind->measures == nullptr) return {};
  return spec.kind->measures(spec.kind, Record(signals));
}

}  // namespace isograsp::tasks
