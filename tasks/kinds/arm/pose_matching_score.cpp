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
#include <cmath>

#include "hand/arm_columns.hpp"
#include "kinematics/movement.hpp"
#include "statistics/percentile.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/kinds/arm/segment_poses.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

/// A rig of the segments that every trial of an arm records.
Rig recorded_rig() {
  Rig rig;
  const auto link = [&](const char* name, std::string_view parent, std::string_view child) {
    rig.links.push_back({name, std::string(parent), std::string(child), AngleSequence::rpy, {}});
  };
  link("forearm", "elbow", "forearm");
  link("wrist", "forearm", "dorsum");
  link("fingers", "dorsum", "object");
  link("object", kWorld, "object");
  rig.score = RigScore{"forearm", "object", "object"};
  return rig;
}

class PoseMatchingScore {
 public:
  PoseMatchingScore(const PoseMatchingSpec& spec, const Record& record)
      : spec_(spec),
        record_(record),
        whole_(record.select(kSought, needed())),
        times_(spec.targets()) {
    if (!whole_.reason.empty()) return;
    read_rows();
    read_targets();
    run();
    measure_movements();
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

  static std::vector<std::string> needed() {
    std::vector<std::string> names = columns_of_object_and_reference();
    names.emplace_back(columns::target_index);
    return names;
  }

  /// The rows that the task saw.
  void read_rows() {
    const Signals& signals = record_.signals();
    const auto t_s = signals.column(columns::t_s);
    for (std::size_t row = 0; row < record_.rows(); ++row)
      if (!record_.paused(row)) rows_.push_back(row);
    series_.source = "the recorded signals";
    for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
      const auto& columns = columns::segment_pose[s];
      const SegmentPoses poses(signals, columns.position, columns.attitude);
      if (!poses.known()) continue;
      series_.frames.emplace_back(kArmSegmentNames[s]);
      series_.X_W.emplace_back();
      for (const std::size_t row : rows_) series_.X_W.back().push_back(poses.at(row));
    }
    for (const std::size_t row : rows_) series_.t_s.push_back(t_s[row]);
  }

  /// The reference of each target is where it was first shown.
  void read_targets() {
    const Signals& signals = record_.signals();
    const auto index = signals.column(columns::target_index);
    const SegmentPoses reference(signals, columns::reference_position, columns::reference_attitude);
    task_.position_tolerance_m = spec_.position_tolerance_m;
    task_.angle_tolerance_rad = spec_.angle_tolerance_rad;
    task_.hold_s = spec_.hold_s;
    task_.display_s = spec_.display_s;
    task_.time_limit_s = spec_.time_limit_s;
    for (const std::size_t row : rows_) {
      const std::size_t next = task_.references.size();
      if (next == spec_.targets()) break;
      if (index[row] != static_cast<double>(next)) continue;
      const Pose X_WR = reference.at(row);
      if (is_missing(X_WR)) continue;
      task_.references.push_back({spec_.sequence[next % spec_.sequence.size()], X_WR});
      task_.targets.push_back(next);
    }
  }

  /// Where the object was in a row that the task saw; a row that is excluded was not seen.
  [[nodiscard]] Pose object(std::size_t k) const {
    return series_.X_W[*series_.frame(kArmSegmentNames[index_of(ArmSegment::object)])][k];
  }

  void run() {
    if (task_.targets.empty()) return;
    PoseTaskRun run(task_);
    double tried_s = 0.0;
    const auto keep = [&](const PoseEvent& event) {
      events_.push_back(event);
      times_[event.reference].completion = event.time_s
                                               ? statistics::Completion{*event.time_s, true}
                                               : statistics::Completion{spec_.time_limit_s, false};
    };
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (const auto event = run.step(series_.t_s[k], object(k))) keep(*event);
      tried_s = run.sought_s(series_.t_s[k]);
    }
    const std::size_t last = run.target();
    const bool sought = run.started() && !run.finished() && !run.matched();
    if (const auto event = run.finish()) keep(*event);
    if (sought)
      times_[last].completion =
          statistics::Completion{std::clamp(tried_s, 0.0, spec_.time_limit_s), false};
    for (std::size_t i = 0; i < times_.size(); ++i)
      if (times_[i].completion) times_[i].rows = rows_of(i);
  }

  /// In which a target was shown.
  [[nodiscard]] Section rows_of(std::size_t target) const {
    const auto index = record_.signals().column(columns::target_index);
    std::size_t first = record_.rows();
    std::size_t last = 0;
    for (const std::size_t row : rows_)
      if (index[row] == static_cast<double>(target)) {
        first = std::min(first, row);
        last = row + 1;
      }
    return first < last ? record_.select(first, last, kSought, {}) : Section{};
  }

  void measure_movements() {
    std::vector<PoseTarget> targets;
    for (const PoseEvent& event : events_)
      targets.push_back({task_.references[event.reference].name, event.cue_s, event.enter_s,
                         task_.references[event.reference].X_WR});
    auto scores = score_movements(rig_, series_, std::move(targets));
    if (!scores) {
      unmeasured_ = scores.error().what;
      return;
    }
    movements_ = movement_measures(rig_, *scores);
  }

  [[nodiscard]] Text none_reached() const {
    return events_.empty() ? "no target came to its end"_text : "no target was reached"_text;
  }

  void add_errors(std::vector<Measure>& all) const {
    const auto add = [&](const char* name, const char* unit,
                         std::optional<double> PoseEvent::*error) {
      std::vector<double> errors;
      for (const PoseEvent& event : events_)
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
      else if (found.reason.empty() && events_[one.movement].enter_s)
        found.reason = reason_words(one.measure.reason);
    }
    return found;
  }
  [[nodiscard]] statistics::Computed median_of(Each found) const {
    if (!unmeasured_.empty()) return unmeasured_;
    if (found.values.empty()) return found.reason.empty() ? none_reached() : found.reason;
    return statistics::median(found.values);
  }

  void add_times(std::vector<Measure>& all) const {
    Each recognition = each("t10", "object");
    Each movement;
    movement.reason = recognition.reason;
    for (const MovementMeasure& one : movements_)
      if (one.measure.name == "t10" && one.measure.channel == "object" && one.measure.value)
        if (const PoseEvent& event = events_[one.movement]; event.enter_s)
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
  const Rig rig_ = recorded_rig();
  std::vector<std::size_t> rows_;  ///< not paused
  PoseSeries series_;              ///< in those rows
  PoseTask task_;                  ///< of the targets that were shown
  std::vector<PoseEvent> events_;
  std::vector<TargetTime> times_;
  std::vector<MovementMeasure> movements_;
  Text unmeasured_;  ///< why no movement can be measured
};

}  // namespace

std::vector<Measure> score_pose_matching(const PoseMatchingSpec& spec, const Record& record) {
  return PoseMatchingScore(spec, record).measures();
}

}  // namespace isograsp::tasks
