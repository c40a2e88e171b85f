// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a pose-matching trial. The automaton of the task (kinematics/pose_task.cpp) runs once
// more over the recorded rows, so that live, offline and later scores are the same bits. Rows of a
// pause are left out, as rows of a gap are.
//   completion_time   cue to entry, on the task's clock; not reached: longer than the limit
//   recognition_time  cue to the first 10 % of the object's rotation (kinematics/movement.hpp)
//   movement_time     from there to the entry
//   position_error, angle_error   mean from reached to the next cue, over the reached targets
//   rotation …        of forearm against elbow, hand against forearm, object against hand: medians
//                     over the reached targets
#include <algorithm>

#include "hand/arm_columns.hpp"
#include "statistics/percentile.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/kinds/arm/pose_trial.hpp"
#include "tasks/kinds/arm/segment_poses.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

class PoseMatchingScore {
 public:
  PoseMatchingScore(const PoseMatchingSpec& spec, const Record& record)
      : spec_(spec),
        record_(record),
        whole_(record.select(kSought, columns_of_pose_trial())),
        times_(spec.targets()) {
    if (!whole_.reason.empty()) return;
    trial_ = pose_trial(spec, record.signals());
    movements_ = movement_measures(trial_.rig, trial_.movements);
    read_times();
  }

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<Measure> all;
    add_target_times(all, whole_, times_, spec_.time_limit_s);
    add_errors(all);
    add_times(all);
    for (const std::string_view link : {"forearm", "wrist", "fingers"}) {
      add_of_link(all, "rotation", link, "rad", "rotation");
      add_of_link(all, "relative_rotation", link, "", "share_angle");
      add_of_link(all, "rotation_t10", link, "s", "t10");
      add_of_link(all, "rotation_t63", link, "s", "t63");
    }
    all.push_back(seen(record_, whole_));
    return all;
  }

 private:
  static constexpr std::initializer_list<Phase> kSought = {Phase::transport, Phase::hold,
                                                           Phase::active};

  /// How each target ended on the task's clock.
  void read_times() {
    for (const PoseEvent& event : trial_.events)
      times_[event.reference].completion = event.time_s
                                               ? statistics::Completion{*event.time_s, true}
                                               : statistics::Completion{spec_.time_limit_s, false};
    if (trial_.unended)
      times_[trial_.unended->target].completion = statistics::Completion{
          std::clamp(trial_.unended->sought_s, 0.0, spec_.time_limit_s), false};
    for (std::size_t i = 0; i < times_.size(); ++i)
      if (times_[i].completion) times_[i].rows = rows_of(i);
  }

  /// In which a target was shown.
  [[nodiscard]] Section rows_of(std::size_t target) const {
    const auto index = record_.signals().column(columns::target_index);
    std::size_t first = record_.rows();
    std::size_t last = 0;
    for (std::size_t row = 0; row < record_.rows(); ++row)
      if (!record_.paused(row) && index[row] == static_cast<double>(target)) {
        first = std::min(first, row);
        last = row + 1;
      }
    return first < last ? record_.select(first, last, kSought, {}) : Section{};
  }

  [[nodiscard]] Text none_reached() const {
    return trial_.events.empty() ? "no target came to its end"_text : "no target was reached"_text;
  }

  void add_errors(std::vector<Measure>& all) const {
    const auto add = [&](const char* name, const char* unit,
                         std::optional<double> PoseEvent::*error) {
      std::vector<double> errors;
      for (const PoseEvent& event : trial_.events)
        if (event.*error) errors.push_back(*(event.*error));
      all.push_back(make_measure(name, "object", unit, whole_, mean_of(errors)));
    };
    add("position_error", "m", &PoseEvent::position_error_m);
    add("angle_error", "rad", &PoseEvent::angle_error_rad);
  }

  [[nodiscard]] statistics::Computed mean_of(const std::vector<double>& values) const {
    if (values.empty()) return none_reached();
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }

  /// The value of one measure in each movement that has it, and why the first other has none.
  struct Each {
    std::vector<double> values;
    Text reason;
  };
  [[nodiscard]] Each each(std::string_view measure, std::string_view channel) const {
    Each found;
    for (const MovementMeasure& one : movements_) {
      if (one.measure.name != measure || one.measure.channel != channel) continue;
      if (one.measure.value)
        found.values.push_back(*one.measure.value);
      else if (found.reason.empty() && trial_.events[one.movement].enter_s)
        found.reason = reason_words(one.measure.reason);
    }
    return found;
  }
  [[nodiscard]] statistics::Computed median_of(Each found) const {
    if (!trial_.unmeasured.empty()) return trial_.unmeasured;
    if (found.values.empty()) return found.reason.empty() ? none_reached() : found.reason;
    return statistics::median(found.values);
  }

  void add_times(std::vector<Measure>& all) const {
    Each recognition = each("t10", "object");
    Each movement;
    movement.reason = recognition.reason;
    for (const MovementMeasure& one : movements_)
      if (one.measure.name == "t10" && one.measure.channel == "object" && one.measure.value)
        if (const PoseEvent& event = trial_.events[one.movement]; event.enter_s)
          movement.values.push_back(*event.enter_s - event.cue_s - *one.measure.value);
    all.push_back(
        make_measure("recognition_time", "object", "s", whole_, median_of(std::move(recognition))));
    all.push_back(
        make_measure("movement_time", "object", "s", whole_, median_of(std::move(movement))));
  }

  void add_of_link(std::vector<Measure>& all, const char* name, std::string_view link,
                   const char* unit, std::string_view measure) const {
    all.push_back(
        make_measure(name, std::string(link), unit, whole_, median_of(each(measure, link))));
  }

  const PoseMatchingSpec& spec_;
  const Record& record_;
  Section whole_;  ///< all rows in which a target was sought or shown
  PoseTrial trial_;
  std::vector<TargetTime> times_;
  std::vector<MovementMeasure> movements_;
};

}  // namespace

std::vector<Measure> score_pose_matching(const PoseMatchingSpec& spec, const Record& record) {
  return PoseMatchingScore(spec, record).measures();
}

}  // namespace isograsp::tasks
