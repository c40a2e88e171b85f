// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over rows, w: how long a row lasts:
//   slip = 100 (sum of w where a finger touches and one slips) / (sum of w where one touches)
// Times on the task's own clock:
//   completion time = time at the end row - time at which the target appeared; at most limit_s
#include "tasks/kinds/tools/object_score.hpp"

#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "tasks/measures/motion.hpp"
#include "tasks/measures/smoothness.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

void append(Section& sum, const Section& part) {
  if (sum.reason.empty()) sum.reason = part.reason;
  sum.rows.insert(sum.rows.end(), part.rows.begin(), part.rows.end());
  sum.t_s.insert(sum.t_s.end(), part.t_s.begin(), part.t_s.end());
  sum.weight_s.insert(sum.weight_s.end(), part.weight_s.begin(), part.weight_s.end());
  sum.excluded += part.excluded;
}

ObjectRecord::ObjectRecord(const Record& record)
    : record_(record),
      actual_q_(components(columns::actual_attitude)),
      target_q_(components(columns::target_attitude)),
      actual_angle_(record.signals().column(columns::actual_angle_rad)),
      target_angle_(record.signals().column(columns::target_angle_rad)),
      contact_(flags(columns::contact, "the columns contact_* are missing"_text)),
      slip_(flags(columns::slip, "the columns slip_* are missing"_text)) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    actual_m_[axis] = record.signals().column(columns::actual_position[axis]);
    target_m_[axis] = record.signals().column(columns::target_position[axis]);
  }
  // A height that only one of the two has cannot be compared.
  if (actual_m_[2].empty() || target_m_[2].empty()) actual_m_[2] = target_m_[2] = {};
}

ObjectRecord::Components ObjectRecord::components(const columns::OfComponents& attitude) const {
  Components found;
  for (std::size_t i = 0; i < 4; ++i) found[i] = record_.signals().column(attitude[i]);
  const bool complete =
      std::none_of(found.begin(), found.end(), [](const auto& column) { return column.empty(); });
  return complete ? found : Components{};
}

ObjectRecord::Flags ObjectRecord::flags(const columns::OfFingers& of, Words absent) const {
  Flags found;
  bool known = false;
  for (const Finger finger : kFingers) {
    const Column& name = of[index_of(finger)];
    known = known || record_.signals().has(name);
    if (!record_.constant(name)) continue;  // never a value: the scene lacks this finger
    found.names.emplace_back(name);
    found.columns.push_back(record_.signals().column(name));
  }
  if (!known) found.absent = absent;
  return found;
}

bool ObjectRecord::any(const Flags& flags, std::size_t row) {
  return std::any_of(flags.columns.begin(), flags.columns.end(),
                     [row](const auto& column) { return column[row] > 0.5; });
}

bool ObjectRecord::touch_known(std::size_t row) const {
  return std::none_of(contact_.columns.begin(), contact_.columns.end(),
                      [row](const auto& column) { return std::isnan(column[row]); });
}

Section ObjectRecord::select_positions(std::size_t first, std::size_t last,
                                       std::initializer_list<Phase> phases) const {
  const auto& [x, y, z] = columns::actual_position;
  const auto& [target_x, target_y, target_z] = columns::target_position;
  if (!actual_m_[2].empty())
    return record_.select(first, last, phases, {x, y, z, target_x, target_y, target_z});
  return record_.select(first, last, phases, {x, y, target_x, target_y});
}

Section ObjectRecord::select_attitudes(std::size_t first, std::size_t last,
                                       std::initializer_list<Phase> phases) const {
  std::vector<std::string> names;
  const auto add = [&](const columns::OfComponents& attitude, const Column& angle,
                       const Components& q) {
    if (q[0].empty()) return names.push_back(angle);
    for (const Column& component : attitude) names.push_back(component);
  };
  add(columns::actual_attitude, columns::actual_angle_rad, actual_q_);
  add(columns::target_attitude, columns::target_angle_rad, target_q_);
  return record_.select(first, last, phases, names);
}

std::vector<Quat> ObjectRecord::attitudes(const Section& section) const {
  std::vector<Quat> q;
  q.reserve(section.rows.size());
  for (const std::size_t row : section.rows) q.push_back(attitude(row));
  return q;
}

std::vector<Quat> ObjectRecord::target_attitudes(const Section& section) const {
  std::vector<Quat> q;
  q.reserve(section.rows.size());
  for (const std::size_t row : section.rows) q.push_back(target_attitude(row));
  return q;
}

void ObjectRecord::add_hold_errors(std::vector<Measure>& all, const Section& position,
                                   const Section& attitude) const {
  std::vector<Vec3> actual_m;
  std::vector<Vec3> target_m;
  for (const std::size_t row : position.rows) {
    actual_m.push_back(this->position(row));
    target_m.push_back(target(row));
  }
  const auto actual = attitudes(attitude);
  const auto target = target_attitudes(attitude);
  all.push_back(make_measure("hold_error_position", "position", "m", position,
                             mean_distance(actual_m, target_m, position.weight_s)));
  all.push_back(make_measure("hold_error_angle", "angle", "rad", attitude,
                             mean_angle(target, actual, attitude.weight_s)));
  // An object that turns in the plane of the screen alone keeps its axis.
  const bool leans = std::any_of(actual.begin(), actual.end(),
                                 [](const Quat& q) { return q.x() != 0.0 || q.y() != 0.0; });
  if (leans)
    all.push_back(make_measure("hold_error_axis", "angle", "rad", attitude,
                               mean_axis_angle(actual, target, Vec3::UnitZ(), attitude.weight_s)));
}

statistics::Computed ObjectRecord::tilt(const Section& section) const {
  return rms_angle(target_attitudes(section), attitudes(section), section.weight_s);
}

Measure ObjectRecord::slip(std::initializer_list<Phase> phases) const {
  std::vector<std::string> columns = contact_.names;
  columns.insert(columns.end(), slip_.names.begin(), slip_.names.end());
  Section section = record_.select(phases, columns);
  if (section.reason.empty())
    section.reason = !contact_.absent.empty() ? contact_.absent : slip_.absent;
  double contact_s = 0.0;
  double slip_s = 0.0;
  for (std::size_t i = 0; i < section.rows.size(); ++i) {
    if (!touched(section.rows[i])) continue;
    contact_s += section.weight_s[i];
    if (slips(section.rows[i])) slip_s += section.weight_s[i];
  }
  return make_measure("slip", "contact", "%", section,
                      contact_s > 0.0 ? statistics::Computed(100.0 * slip_s / contact_s)
                                      : statistics::Computed("there was no contact"_text));
}

Measure ObjectRecord::mean_grip(std::initializer_list<Phase> phases) const {
  const Section force = record_.select(phases, {columns::actual_force_N});
  return make_measure("mean_grip", "grip", "N", force, mean_over(force, columns::actual_force_N));
}

Smoothness ObjectRecord::smoothness_of_motion(const Section& section) const {
  constexpr Words too_short = "fewer than two samples"_text;
  if (section.rows.size() < 2) return {too_short, too_short};
  const statistics::UniformSamples speed = speed_of(position_of(section));
  return {sparc(speed), ldlj(speed)};
}

Smoothness ObjectRecord::smoothness_of_grip(const Section& section) const {
  constexpr Words too_short = "fewer than two samples"_text;
  if (section.rows.size() < 2) return {too_short, too_short};
  const statistics::UniformSamples rate =
      rate_of(statistics::on_uniform_grid(section.t_s, section.values(columns::actual_force_N)));
  return {sparc(rate), ldlj(rate)};
}

Attempts attempts_of(const Record& record, std::size_t count) {
  const Signals& signals = record.signals();
  Attempts attempts;
  attempts.all.resize(count);
  for (const std::string_view name :
       {columns::phase, columns::target_index, columns::targets_reached})
    if (!signals.has(name) && attempts.absent.empty()) attempts.absent = kColumnMissing(name);
  if (!attempts.absent.empty()) return attempts;
  const auto index = signals.column(columns::target_index);
  const auto reached = signals.column(columns::targets_reached);
  double reached_before = 0.0;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const bool working = record.phase(row) == Phase::transport || record.phase(row) == Phase::hold;
    if (!working || !(index[row] >= 0.0) || index[row] >= static_cast<double>(count)) continue;
    Attempt& attempt = attempts.all[static_cast<std::size_t>(index[row])];
    if (!attempt.shown) attempt.first_row = row;
    attempt.shown = true;
    attempt.last_row = row;
    attempt.reached = attempt.reached || reached[row] > reached_before;
    reached_before = std::max(reached_before, reached[row]);
  }
  for (Attempt& attempt : attempts.all) {
    if (!attempt.reached) continue;
    attempt.hold_row = attempt.last_row;
    for (std::size_t row = attempt.last_row; row > attempt.first_row;) {
      --row;
      if (record.paused(row)) continue;
      if (record.phase(row) != Phase::hold) break;
      attempt.hold_row = row;
    }
  }
  return attempts;
}

statistics::Completion completion_of(const Record& record, const Attempt& attempt,
                                     std::size_t end_row, double limit_s) {
  const double start_s = record.task_time_s(attempt.first_row);
  if (attempt.reached) return {record.task_time_s(end_row) - start_s, true};
  const double tried_s =
      record.task_time_s(attempt.last_row) - start_s + record.hold_s(attempt.last_row);
  constexpr double kRoundingSlack = 1e-6;  // a sum of many hold lengths
  return {tried_s >= limit_s * (1.0 - kRoundingSlack) ? limit_s : tried_s, false};
}

void add_target_times(std::vector<Measure>& measures, const Section& whole,
                      const std::vector<TargetTime>& targets, double limit_s) {
  std::vector<statistics::Completion> completions;
  std::vector<Measure> times;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const TargetTime& target = targets[i];
    Section rows = target.rows;
    statistics::Computed time_s = 0.0;
    if (!whole.reason.empty()) {
      rows.reason = whole.reason;
    } else if (!target.completion) {
      rows.reason = "the trial ended before this target"_text;
    } else {
      completions.push_back(*target.completion);
      const statistics::Completion& completion = completions.back();
      if (completion.reached)
        time_s = completion.time_s;
      else if (completion.time_s >= limit_s)
        time_s = kNotReached(shortest(limit_s));
      else
        time_s = "the trial ended before it was reached"_text;
    }
    times.push_back(
        make_measure("completion_time", "target_" + std::to_string(i + 1), "s", rows, time_s));
  }
  measures.push_back(make_measure("targets_reached", "targets",
                                  "of " + std::to_string(targets.size()), whole,
                                  static_cast<double>(statistics::reached_of(completions).count)));
  for (Measure& time : times) measures.push_back(std::move(time));
  measures.push_back(make_measure("median_completion_time", "targets", "s", whole,
                                  statistics::median_completion(completions)));
  measures.push_back(make_measure("restricted_mean_time", "targets", "s", whole,
                                  statistics::restricted_mean_time(completions, limit_s)));
}

Measure drops_measure(const Record& record) {
  Section section = record.select(kMoving, {columns::drops});
  double most = 0.0;
  for (const double drops : section.values(columns::drops)) most = std::max(most, drops);
  return make_measure("drops", "contact", "", section, most);
}

namespace {

/// The path that ended at the target, from where the object appeared last. It begins one row after
/// the object appeared again: in that row its position is still the old one.
Section last_path(const Record& record, const Attempt& attempt) {
  const auto drops = record.signals().column(columns::drops);
  std::size_t first = attempt.first_row + 1;
  if (!drops.empty()) {
    double before = drops[attempt.first_row];
    for (std::size_t row = first; row <= attempt.hold_row; ++row) {
      if (drops[row] > before) first = row + 1;
      if (!std::isnan(drops[row])) before = drops[row];
    }
  }
  return record.select_position(first, attempt.hold_row + 1, kMoving);
}

}  // namespace

Measure path_efficiency_measure(const Record& record, const Attempts& attempts) {
  Section paths;
  paths.reason = attempts.absent;
  std::vector<std::vector<Vec3>> paths_m;
  for (const Attempt& attempt : attempts.all) {
    if (!attempt.reached) continue;
    const Section path = last_path(record, attempt);
    append(paths, path);
    paths_m.push_back(path_of(path));
  }
  if (paths.reason.empty() && paths.rows.empty()) paths.reason = "nothing was placed"_text;
  return make_measure("path_efficiency", "position", "%", paths, path_efficiency(paths_m));
}

void add_completions(std::vector<Measure>& measures, const Record& record, const Attempts& attempts,
                     double limit_s, std::size_t Attempt::*end_row) {
  Section whole = record.select(kMoving, {});
  if (!attempts.absent.empty()) whole.reason = attempts.absent;
  std::vector<TargetTime> targets;
  for (const Attempt& attempt : attempts.all) {
    TargetTime target;
    if (attempt.shown) {
      target.rows = record.select(attempt.first_row, attempt.last_row + 1, kMoving, {});
      target.completion = completion_of(record, attempt, attempt.*end_row, limit_s);
    }
    targets.push_back(std::move(target));
  }
  add_target_times(measures, whole, targets, limit_s);
}

}  // namespace isograsp::tasks
