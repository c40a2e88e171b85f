// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the pose-target tasks. Time is task time: a device fault costs the patient nothing.
// Movements after Fitts: from where the target appeared (start) to the target (goal):
//   distance = |goal - start|
//   end = mean over the hold of (position - start) . (goal - start) / distance
//   error = end - distance
//   index of difficulty = mean of those of the movements (tasks/measures/fitts.cpp)
#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/kinds/tools/object_score.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/measures/fitts.hpp"
#include "tasks/measures/motion.hpp"

namespace isograsp::tasks {

namespace {

class PoseScore {
 public:
  PoseScore(const PoseTargetsSpec& spec, const Record& record)
      : spec_(spec),
        record_(record),
        object_(record),
        attempts_(attempts_of(record, spec.targets.size())) {}

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<Measure> all;
    add_completions(all, record_, attempts_, spec_.time_limit_s, &Attempt::hold_row);
    add_hold_errors(all);
    all.push_back(tilt_in_transport());
    add_path(all);
    all.push_back(drops());
    all.push_back(object_.slip(kMoving));
    add_smoothness(all);
    add_fitts(all);
    all.push_back(object_.mean_grip(kMoving));
    add_grasp(all, record_, kMoving);
    return all;
  }

 private:
  [[nodiscard]] bool held(std::size_t target) const {
    return attempts_.all[target].reached && spec_.targets[target].hold_s > 0.0;
  }
  /// Why there is no value about holds, or about paths to a target. `otherwise`: the reason if
  /// targets were held.
  [[nodiscard]] Words nothing_held(Words otherwise) const {
    const bool asked = std::any_of(spec_.targets.begin(), spec_.targets.end(),
                                   [](const PoseTarget& target) { return target.hold_s > 0.0; });
    if (!asked) return "the targets ask for no hold"_text;
    for (std::size_t i = 0; i < attempts_.all.size(); ++i)
      if (held(i)) return otherwise;
    return "no target that asks for a hold was reached"_text;
  }
  [[nodiscard]] Words nothing_reached() const {
    const bool reached = std::any_of(attempts_.all.begin(), attempts_.all.end(),
                                     [](const Attempt& attempt) { return attempt.reached; });
    return reached ? "no reached target appeared outside its tolerance"_text
                   : "no target was reached"_text;
  }

  /// Over the holds that reached their target: from entering for exactly hold_s.
  void add_hold_errors(std::vector<Measure>& all) const {
    Section position;
    Section angle;
    position.reason = angle.reason = attempts_.absent;
    for (std::size_t i = 0; i < attempts_.all.size(); ++i) {
      const Attempt& attempt = attempts_.all[i];
      if (!held(i)) continue;
      append(position, object_.select_positions(attempt.hold_row, attempt.last_row, {Phase::hold}));
      append(angle, object_.select_attitudes(attempt.hold_row, attempt.last_row, {Phase::hold}));
    }
    if (position.reason.empty() && position.rows.empty())
      position.reason = angle.reason = nothing_held("no row of a hold counts"_text);
    object_.add_hold_errors(all, position, angle);
  }

  [[nodiscard]] Measure tilt_in_transport() const {
    Section level;
    level.reason = attempts_.absent;
    for (std::size_t i = 0; i < attempts_.all.size(); ++i) {
      const Attempt& attempt = attempts_.all[i];
      if (spec_.targets[i].level && attempt.shown)
        append(level, object_.select_attitudes(attempt.first_row, attempt.last_row + 1,
                                               {Phase::transport}));
    }
    if (level.reason.empty() && level.rows.empty())
      level.reason = "there was no level transport"_text;
    return make_measure("tilt_in_transport", "angle", "rad", level, object_.tilt(level));
  }

  /// From the appearance of a target to the start of its hold.
  [[nodiscard]] Section path_to(const Attempt& attempt) const {
    return object_.select_positions(attempt.first_row, attempt.hold_row + 1, kMoving);
  }
  /// The object had to be moved there, not only turned.
  [[nodiscard]] bool is_transport(const Section& path) const {
    return path.rows.size() > 1 && object_.distance(path.rows.front()) > spec_.position_tolerance_m;
  }

  void add_path(std::vector<Measure>& all) const {
    const Section motion = record_.select_position(0, record_.rows(), kMoving);
    all.push_back(path_length(motion));
    Section transports;
    transports.reason = attempts_.absent.empty() ? motion.reason : attempts_.absent;
    std::vector<std::vector<Vec3>> paths_m;
    for (const Attempt& attempt : attempts_.all) {
      if (!attempt.reached) continue;
      const Section path = path_to(attempt);
      if (!is_transport(path)) continue;
      paths_m.push_back(path_of(path));
      append(transports, path);
    }
    if (transports.reason.empty() && transports.rows.empty()) transports.reason = nothing_reached();
    all.push_back(
        make_measure("path_efficiency", "position", "%", transports, path_efficiency(paths_m)));
  }

  /// How often touch was lost on the way; a loss across a pause is not counted.
  [[nodiscard]] Measure drops() const {
    Section touched = record_.select(kMoving, object_.contact_columns());
    if (touched.reason.empty())
      touched.reason = attempts_.absent.empty() ? object_.no_contact_columns() : attempts_.absent;
    int drops = 0;
    bool held_before = false;
    for (std::size_t row = 0; row < record_.rows(); ++row) {
      const Phase phase = record_.phase(row);
      if ((phase != Phase::transport && phase != Phase::hold) || record_.missing(row) ||
          !object_.touch_known(row)) {
        held_before = false;
        continue;
      }
      const bool held = object_.touched(row);
      if (held_before && !held && phase == Phase::transport) ++drops;
      held_before = held;
    }
    return make_measure("drops", "contact", "", touched, static_cast<double>(drops));
  }

  /// Means over the single level transports (over all ways, if none is level).
  void add_smoothness(std::vector<Measure>& all) const {
    const bool has_level = std::any_of(spec_.targets.begin(), spec_.targets.end(),
                                       [](const PoseTarget& target) { return target.level; });
    Section motion;
    Section force;
    motion.reason = force.reason = attempts_.absent;
    std::vector<statistics::Computed> motion_arcs, motion_jerks, force_arcs, force_jerks;
    for (std::size_t i = 0; i < attempts_.all.size(); ++i) {
      const Attempt& attempt = attempts_.all[i];
      if (!attempt.reached || (has_level && !spec_.targets[i].level)) continue;
      const std::size_t end = attempt.hold_row + 1;
      const Section path = record_.select_position(attempt.first_row, end, kMoving);
      append(motion, path);
      const Smoothness of_motion = object_.smoothness_of_motion(path);
      motion_arcs.push_back(of_motion.sparc);
      motion_jerks.push_back(of_motion.ldlj);
      const Section grip =
          record_.select(attempt.first_row, end, kMoving, {columns::actual_force_N});
      append(force, grip);
      const Smoothness of_grip = object_.smoothness_of_grip(grip);
      force_arcs.push_back(of_grip.sparc);
      force_jerks.push_back(of_grip.ldlj);
    }
    const Words none =
        has_level ? "no level transport reached its target"_text : "no target was reached"_text;
    for (Section* section : {&motion, &force})
      if (section->reason.empty() && section->rows.empty()) section->reason = none;
    const auto add = [&](const char* name, const char* channel, const Section& section,
                         const std::vector<statistics::Computed>& each) {
      all.push_back(make_measure(name, channel, "", section, mean_of_repetitions(each, none)));
    };
    add("sparc", "transport", motion, motion_arcs);
    add("sparc", "force_rate", force, force_arcs);
    add("ldlj", "transport", motion, motion_jerks);
    add("ldlj", "force_rate", force, force_jerks);
  }

  /// Research measures after Fitts. A target without a hold is reached at the edge of its
  /// tolerance, so that its end point says nothing about the hand: only held ones count. The end
  /// point is the mean position of the hold, the movement time that of completion_time.
  void add_fitts(std::vector<Measure>& all) const {
    Section section;
    section.reason = attempts_.absent;
    std::vector<AimedTrial> trials;
    double difficulty_bit = 0.0;
    double least_m = 0.0;
    double most_m = 0.0;
    for (std::size_t i = 0; i < attempts_.all.size(); ++i) {
      if (!held(i)) continue;
      const Attempt& attempt = attempts_.all[i];
      const Section path = path_to(attempt);
      const Section hold =
          object_.select_positions(attempt.hold_row, attempt.last_row, {Phase::hold});
      if (section.reason.empty()) section.reason = path.reason;
      if (!is_transport(path) || hold.rows.empty()) continue;
      append(section, path);
      const Vec3 start = object_.position(path.rows.front());
      const Vec3 goal = object_.target(path.rows.front());
      const double distance_m = (goal - start).norm();
      double end_m = 0.0;
      for (const std::size_t row : hold.rows)
        end_m += (object_.position(row) - start).dot(goal - start) / distance_m;
      end_m /= static_cast<double>(hold.rows.size());
      trials.push_back(
          {end_m, end_m - distance_m,
           completion_of(record_, attempt, attempt.hold_row, spec_.time_limit_s).time_s});
      difficulty_bit +=
          index_of_difficulty(distance_m, spec_.position_tolerance_m).value.value_or(0.0);
      least_m = trials.size() == 1 ? distance_m : std::min(least_m, distance_m);
      most_m = std::max(most_m, distance_m);
    }
    if (section.reason.empty() && trials.empty())
      section.reason = nothing_held("no held target appeared outside its tolerance"_text);
    all.push_back(make_measure(
        "index_of_difficulty", "position", "bit", section,
        trials.empty()
            ? statistics::Computed(section.reason)
            : statistics::Computed(difficulty_bit / static_cast<double>(trials.size()))));
    // Every start lies within the tolerance of the target before, so distances may differ by that.
    const bool alike = most_m - least_m <= 2.0 * spec_.position_tolerance_m;
    all.push_back(
        make_measure("throughput", "position", "bit/s", section,
                     alike ? throughput(trials)
                           : statistics::Computed("the targets lie at different distances"_text)));
  }

  const PoseTargetsSpec& spec_;
  const Record& record_;
  ObjectRecord object_;
  Attempts attempts_;
};

}  // namespace

std::vector<Measure> score_pose_targets(const PoseTargetsSpec& spec, const Record& record) {
  return PoseScore(spec, record).measures();
}

}  // namespace isograsp::tasks
