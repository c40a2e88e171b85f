// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of pick, place and release. Time is task time: a device fault costs the patient nothing.
#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/measures/motion.hpp"

namespace isograsp::tasks {

namespace {

class PickPlaceScore {
 public:
  PickPlaceScore(const PickPlaceSpec& spec, const Record& record)
      : spec_(spec),
        record_(record),
        object_(record),
        attempts_(attempts_of(record, spec.items.size())) {}

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<Measure> all;
    // Up to letting go: that is part of the task.
    add_completions(all, record_, attempts_, spec_.time_limit_s, &Attempt::last_row);
    all.push_back(drops_measure(record_));
    all.push_back(path_efficiency_measure(record_, attempts_));
    add_hold_errors(all);
    all.push_back(object_.slip(kMoving));
    all.push_back(object_.mean_grip(kMoving));
    add_grasp(all, record_, kMoving);
    return all;
  }

 private:
  /// While the object that was placed then was held inside the tolerance, until it was let go.
  void add_hold_errors(std::vector<Measure>& all) const {
    Section position;
    Section angle;
    position.reason = angle.reason = attempts_.absent;
    for (const Attempt& attempt : attempts_.all) {
      if (!attempt.reached) continue;
      append(position, object_.select_positions(attempt.hold_row, attempt.last_row, {Phase::hold}));
      append(angle, object_.select_attitudes(attempt.hold_row, attempt.last_row, {Phase::hold}));
    }
    if (position.reason.empty() && position.rows.empty()) position.reason = kNothingPlaced;
    if (angle.reason.empty() && angle.rows.empty()) angle.reason = kNothingPlaced;
    object_.add_hold_errors(all, position, angle);
  }

  static constexpr Words kNothingPlaced = "nothing was placed"_text;

  const PickPlaceSpec& spec_;
  const Record& record_;
  ObjectRecord object_;
  Attempts attempts_;
};

}  // namespace

std::vector<Measure> score_pick_place(const PickPlaceSpec& spec, const Record& record) {
  return PickPlaceScore(spec, record).measures();
}

}  // namespace isograsp::tasks
