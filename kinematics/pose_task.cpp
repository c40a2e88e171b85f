// SPDX-License-Identifier: GPL-3.0-or-later
// Inside: |p_WO - p_WR| <= position tolerance and angle(q_WO, q_WR) <= angle tolerance, exactly;
// times compare with a slack of 1e-9 s.
#include "kinematics/pose_task.hpp"

#include <algorithm>
#include <numbers>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "kinematics/pose_series.hpp"
#include "kinematics/read_attitude.hpp"

namespace isograsp {

namespace {

constexpr std::int64_t kMostTargets = 10000;

bool has_passed(double since_s, double length_s) noexcept {
  return since_s >= length_s - kMarkerTimeSlack_s;
}

double not_negative(TomlReader& root, std::string_view key, std::optional<double> fallback) {
  const double value = root.number(key, fallback);
  if (value < 0.0) root.fail(key, "is below zero"_text, "write zero or more"_text);
  return value;
}

double above_zero(TomlReader& root, std::string_view key) {
  const double value = root.number(key);
  if (!(value > 0.0)) root.fail(key, "is not above zero"_text, "write a number above zero"_text);
  return value;
}

}  // namespace

Result<PoseTask> parse_pose_task(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-pose-task-1");
  if (!root) return root.error();
  PoseTask task;
  task.name = root->text("name", "");
  task.frame = root->text("frame");
  task.position_tolerance_m = above_zero(*root, "position_tolerance_m");
  task.angle_tolerance_rad = above_zero(*root, "angle_tolerance_deg") * (std::numbers::pi / 180.0);
  task.hold_s = not_negative(*root, "hold_s", 0.0);
  task.display_s = not_negative(*root, "display_s", 2.0);
  task.time_limit_s = above_zero(*root, "time_limit_s");
  task.postures_hash = root->text("postures_hash", "");
  for (TomlReader& table : root->tables("reference")) {
    PoseReference reference{table.text("name"), read_pose(table)};
    for (const PoseReference& other : task.references)
      if (other.name == reference.name)
        table.fail("name", "'%1' appears twice"_text(reference.name), "keep one of them"_text);
    task.references.push_back(std::move(reference));
  }
  const auto sequence = root->texts("sequence");
  const std::int64_t repeats = root->integer("repeats", 1);
  if (sequence.empty())
    root->fail("sequence", "names no reference"_text, "name the references in their order"_text);
  if (repeats < 1 || repeats > kMostTargets ||
      repeats * static_cast<std::int64_t>(sequence.size()) > kMostTargets)
    root->fail("repeats", "gives none or more than %1 targets"_text(kMostTargets),
               "write a smaller whole number above zero"_text);
  std::vector<std::size_t> once;
  for (const std::string& name : sequence) {
    const auto at = std::find_if(task.references.begin(), task.references.end(),
                                 [&name](const PoseReference& one) { return one.name == name; });
    if (at == task.references.end())
      root->fail("sequence", "'%1' is no reference"_text(name), "name a [[reference]]"_text);
    once.push_back(static_cast<std::size_t>(at - task.references.begin()));
  }
  if (auto done = root->finish(); !done) return done.error();
  for (std::int64_t i = 0; i < repeats; ++i)
    task.targets.insert(task.targets.end(), once.begin(), once.end());
  return task;
}

std::string pose_task_text(const PoseTask& task) {
  std::string sequence;
  for (const std::size_t target : task.targets)
    sequence += (sequence.empty() ? "" : ", ") + toml_text(task.references[target].name);
  std::string text = "format = \"isograsp-pose-task-1\"\nname = " + toml_text(task.name) +
                     "\nframe = " + toml_text(task.frame) +
                     "\nposition_tolerance_m = " + format_number(task.position_tolerance_m) +
                     "\nangle_tolerance_deg = " +
                     format_number(task.angle_tolerance_rad * (180.0 / std::numbers::pi)) +
                     "\nhold_s = " + format_number(task.hold_s) +
                     "\ndisplay_s = " + format_number(task.display_s) +
                     "\ntime_limit_s = " + format_number(task.time_limit_s) + "\nsequence = [" +
                     sequence + "]\n";
  if (!task.postures_hash.empty())
    text += "postures_hash = " + toml_text(task.postures_hash) + "\n";
  for (const PoseReference& reference : task.references)
    text += "\n[[reference]]\nname = " + toml_text(reference.name) +
            "\nposition_m = " + toml_numbers(reference.X_WR.p) +
            "\nquaternion_wxyz = " + toml_numbers(reference.X_WR.q) + "\n";
  return text;
}

void PoseTaskRun::cue(double t_s) noexcept {
  matched_ = false;
  cue_s_ = t_s;
  cue_c_ = t_s - pauses_s_;
  enter_s_.reset();
  position_sum_m_ = angle_sum_rad_ = 0.0;
  rows_ = 0;
}

double PoseTaskRun::c(double t_s) const noexcept {
  return std::min(t_s, last_valid_s_ + kLongestStandIn_s) - pauses_s_;
}

double PoseTaskRun::clock_s(double t_s) const noexcept {
  return started_ ? c(t_s) - first_c_ : 0.0;
}

double PoseTaskRun::hold_fraction(double t_s) const noexcept {
  if (matched_) return 1.0;
  if (!enter_s_ || task_.hold_s <= 0.0) return 0.0;
  return std::clamp((c(t_s) - enter_c_) / task_.hold_s, 0.0, 1.0);
}

PoseEvent PoseTaskRun::ended() const noexcept {
  PoseEvent event;
  event.reference = task_.targets[target_];
  event.cue_s = cue_s_;
  event.done_s = done_s_;
  if (!matched_) return event;
  event.enter_s = enter_s_;
  event.time_s = enter_c_ - cue_c_;
  if (rows_ > 0) {
    event.position_error_m = position_sum_m_ / rows_;
    event.angle_error_rad = angle_sum_rad_ / rows_;
  }
  return event;
}

std::optional<PoseEvent> PoseTaskRun::seek(double t_s, const Pose& X_WO) noexcept {
  const double c = t_s - pauses_s_;
  const Pose& X_WR = task_.references[task_.targets[target_]].X_WR;
  const bool inside = (X_WO.p - X_WR.p).norm() <= task_.position_tolerance_m &&
                      angle_between(X_WO.q, X_WR.q) <= task_.angle_tolerance_rad;
  if (!inside) enter_s_.reset();
  if (inside && !enter_s_) {
    enter_s_ = t_s;
    enter_c_ = c;
  }
  if (inside && has_passed(c - enter_c_, task_.hold_s)) {
    matched_ = true;
    done_s_ = t_s;
    done_c_ = c;
    return std::nullopt;
  }
  if (!has_passed(c - cue_c_, task_.time_limit_s)) return std::nullopt;
  done_s_ = t_s;
  const PoseEvent event = ended();
  ++target_;
  cue(t_s);
  return event;
}

std::optional<PoseEvent> PoseTaskRun::step(double t_s, const Pose& X_WO) noexcept {
  if (finished()) return std::nullopt;
  const bool held = is_missing(X_WO);
  if (held && (!started_ || t_s - last_valid_s_ > kLongestStandIn_s + kMarkerTimeSlack_s))
    return std::nullopt;
  if (!started_) {
    started_ = true;
    cue(t_s);
    first_c_ = cue_c_;
  } else if (!held && t_s - last_valid_s_ > kLongestStandIn_s + kMarkerTimeSlack_s) {
    pauses_s_ += t_s - last_valid_s_ - kLongestStandIn_s;
    if (!matched_) enter_s_.reset();
  }
  if (!held) {
    last_ = X_WO;
    last_valid_s_ = t_s;
  }
  std::optional<PoseEvent> event;
  if (matched_ && has_passed(t_s - pauses_s_ - done_c_, task_.display_s)) {
    event = ended();
    ++target_;
    cue(t_s);
    if (finished()) return event;
  }
  if (!matched_) {
    // A target with a time limit of zero can end in the row of its cue; the one before it is
    // reported first.
    const auto given_up = seek(t_s, last_);
    if (!event) event = given_up;
  }
  if (matched_ && !held) {
    const Pose& X_WR = task_.references[task_.targets[target_]].X_WR;
    position_sum_m_ += (X_WO.p - X_WR.p).norm();
    angle_sum_rad_ += angle_between(X_WO.q, X_WR.q);
    ++rows_;
  }
  return event;
}

std::optional<PoseEvent> PoseTaskRun::finish() noexcept {
  if (finished() || !matched_) return std::nullopt;
  const PoseEvent event = ended();
  target_ = task_.targets.size();
  return event;
}

std::vector<PoseEvent> run_pose_task(const PoseTask& task, const std::vector<double>& t_s,
                                     const std::vector<Pose>& X_WO) {
  std::vector<PoseEvent> events;
  PoseTaskRun run(task);
  for (std::size_t row = 0; row < t_s.size(); ++row)
    if (const auto event = run.step(t_s[row], X_WO[row])) events.push_back(*event);
  if (const auto event = run.finish()) events.push_back(*event);
  return events;
}

}  // namespace isograsp
