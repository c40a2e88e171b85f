// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/trial_replay.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"

namespace isograsp::gui {

namespace {

constexpr double kNoCourse = std::numeric_limits<double>::quiet_NaN();
/// A step longer than this many periods is a gap: no row was recorded in between. Times of
/// recordings may differ by less than half a period from an even grid.
constexpr double kLongestStep = 1.5;

/// An object that moves faster was not carried: it was put somewhere else.
constexpr double kFastestHand_mps = 2.0;

double median_step(std::span<const double> t_s) {
  std::vector<double> steps;
  for (std::size_t row = 1; row < t_s.size(); ++row) steps.push_back(t_s[row] - t_s[row - 1]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

SampleQuality quality_of(double flags) {
  if (!(flags >= 0.0)) return SampleQuality::missing;
  const auto bits = static_cast<unsigned>(flags);
  if (bits & bit(SampleFlag::missing)) return SampleQuality::missing;
  return bits & bit(SampleFlag::held) ? SampleQuality::held : SampleQuality::measured;
}

bool beyond_range(double flags) {
  if (!(flags >= 0.0)) return false;
  return (static_cast<unsigned>(flags) &
          (bit(SampleFlag::saturated) | bit(SampleFlag::overload))) != 0;
}

int whole(double value, int otherwise) {
  return std::isfinite(value) ? static_cast<int>(std::lround(value)) : otherwise;
}

tasks::Phase phase_of(double value) {
  const int number = whole(value, static_cast<int>(tasks::Phase::active));
  return number >= 0 && number <= static_cast<int>(tasks::Phase::done)
             ? static_cast<tasks::Phase>(number)
             : tasks::Phase::active;
}

}  // namespace

Result<TrialReplay> TrialReplay::make(Signals signals) {
  const auto time = signals.find(columns::t_s);
  const auto t_s = signals.column(columns::t_s);
  const auto refuse = [](Words what) {
    return refused(what, "look at its measures"_text).about(columns::t_s);
  };
  if (!time || t_s.empty()) return refuse("the trial has no samples"_text);
  for (std::size_t row = 0; row < t_s.size(); ++row)
    if (!std::isfinite(t_s[row]) || (row > 0 && t_s[row] <= t_s[row - 1]))
      return refuse("the times of the samples do not increase"_text);
  TrialReplay replay;
  replay.period_s_ = t_s.size() < 2 ? 0.0 : median_step(t_s);
  const auto find_pose = [&](const columns::OfAxes& place, const columns::OfComponents& attitude,
                             const Column& angle) {
    PoseColumns pose;
    for (std::size_t i = 0; i < place.size(); ++i) pose.place_m[i] = signals.find(place[i]);
    for (std::size_t i = 0; i < attitude.size(); ++i)
      pose.quaternion[i] = signals.find(attitude[i]);
    pose.angle_rad = signals.find(angle);
    return pose;
  };
  Columns& found = replay.columns_;
  found.t_s = *time;
  found.phase = signals.find(columns::phase);
  found.flags = signals.find(columns::sample_flags);
  found.actual_N = signals.find(columns::actual_force_N);
  found.target_N = signals.find(columns::target_force_N);
  found.target_index = signals.find(columns::target_index);
  found.targets_reached = signals.find(columns::targets_reached);
  found.drops = signals.find(columns::drops);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    for (const std::size_t axis : {0U, 1U, 2U})
      found.force_N[f][axis] = signals.find(columns::finger_force[f][axis]);
    found.finger_flags[f] = signals.find(columns::finger_flags[f]);
    found.contact[f] = signals.find(columns::contact[f]);
  }
  found.object =
      find_pose(columns::actual_position, columns::actual_attitude, columns::actual_angle_rad);
  found.target =
      find_pose(columns::target_position, columns::target_attitude, columns::target_angle_rad);
  replay.signals_ = std::move(signals);
  return replay;
}

double TrialReplay::begin_s() const noexcept {
  return rows() == 0 ? 0.0 : value(columns_.t_s, 0);
}

double TrialReplay::end_s() const noexcept {
  return rows() == 0 ? 0.0 : value(columns_.t_s, rows() - 1);
}

bool TrialReplay::has_fingers() const noexcept {
  return std::any_of(columns_.force_N.begin(), columns_.force_N.end(),
                     [](const auto& axes) { return axes[2].has_value(); });
}

bool TrialReplay::has_object() const noexcept {
  return columns_.object.place_m[0] && columns_.object.place_m[1];
}

double TrialReplay::value(Place column, std::size_t row) const {
  return column ? signals_.column(*column)[row] : kNoCourse;
}

std::size_t TrialReplay::row_at(double t_s) const noexcept {
  const auto times = signals_.column(columns_.t_s);
  const auto after = std::upper_bound(times.begin(), times.end(), t_s);
  if (std::isnan(t_s) || after == times.begin()) return 0;
  return static_cast<std::size_t>(after - times.begin()) - 1;
}

bool TrialReplay::gap_after(std::size_t row) const noexcept {
  return row + 1 < rows() &&
         value(columns_.t_s, row + 1) - value(columns_.t_s, row) > kLongestStep * period_s_;
}

SampleQuality TrialReplay::quality(std::size_t row) const noexcept {
  // A recording that came without flags was measured as it is.
  return columns_.flags ? quality_of(value(columns_.flags, row)) : SampleQuality::measured;
}

SampleQuality TrialReplay::quality(std::size_t row, Finger finger) const noexcept {
  const auto f = index_of(finger);
  if (!std::isfinite(value(columns_.force_N[f][2], row))) return SampleQuality::missing;
  const Place flags = columns_.finger_flags[f];
  return flags ? quality_of(value(flags, row)) : quality(row);
}

double TrialReplay::between(Place column, std::size_t row, double share) const {
  const double here = value(column, row);
  if (share <= 0.0) return here;
  const double next = value(column, row + 1);
  return std::isfinite(next) ? here + share * (next - here) : here;
}

std::optional<Pose> TrialReplay::pose(const PoseColumns& columns, std::size_t row) const {
  const auto& [x, y, z] = columns.place_m;
  const Vec3 place(value(x, row), value(y, row), z ? value(z, row) : 0.0);
  if (!place.allFinite()) return std::nullopt;
  Eigen::Vector4d turn = Eigen::Vector4d::Constant(kNoCourse);
  for (const int i : {0, 1, 2, 3})
    turn[i] = value(columns.quaternion[static_cast<std::size_t>(i)], row);
  Pose pose;
  pose.p = place;
  if (turn.allFinite() && turn.norm() > 0.0) {
    pose.q = Quat(turn[0], turn[1], turn[2], turn[3]).normalized();
  } else {
    const double angle_rad = value(columns.angle_rad, row);
    pose.q = Quat(Eigen::AngleAxisd(std::isfinite(angle_rad) ? angle_rad : 0.0, Vec3::UnitZ()));
  }
  return pose;
}

bool TrialReplay::object_moves_on(std::size_t row) const {
  if (row + 1 >= rows() || gap_after(row)) return false;
  const auto changes = [&](Place column) {
    return whole(value(column, row), 0) != whole(value(column, row + 1), 0);
  };
  if (!changes(columns_.drops) && !changes(columns_.target_index)) return true;
  // After a drop, and with the next of several objects, it appears anew somewhere else.
  const auto here = pose(columns_.object, row);
  const auto next = pose(columns_.object, row + 1);
  const double step_s = value(columns_.t_s, row + 1) - value(columns_.t_s, row);
  return here && next && (next->p - here->p).norm() < kFastestHand_mps * step_s;
}

std::optional<Pose> TrialReplay::object_between(std::size_t row, double share) const {
  auto here = pose(columns_.object, row);
  if (!here || share <= 0.0 || !object_moves_on(row)) return here;
  const auto next = pose(columns_.object, row + 1);
  if (!next) return here;
  here->p += share * (next->p - here->p);
  here->q = here->q.slerp(share, next->q);
  return here;
}

ReplayFinger TrialReplay::finger_at(std::size_t f, std::size_t row, double share) const {
  ReplayFinger finger;
  finger.quality = quality(row, kFingers[f]);
  finger.beyond_range = beyond_range(value(columns_.finger_flags[f], row));
  finger.touching = value(columns_.contact[f], row) > 0.0;
  if (finger.quality == SampleQuality::missing) return finger;
  const bool joined = share > 0.0 && finger.quality == SampleQuality::measured &&
                      quality(row + 1, kFingers[f]) == SampleQuality::measured;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const double force_N = between(columns_.force_N[f][axis], row, joined ? share : 0.0);
    if (std::isfinite(force_N)) finger.force_C[static_cast<Eigen::Index>(axis)] = force_N;
  }
  return finger;
}

ReplayState TrialReplay::at(double t_s) const {
  ReplayState state;
  if (rows() == 0) return state;
  state.t_s = std::isnan(t_s) ? begin_s() : std::clamp(t_s, begin_s(), end_s());
  const std::size_t row = row_at(state.t_s);
  state.phase = phase_of(value(columns_.phase, row));
  state.target_index = whole(value(columns_.target_index, row), -1);
  state.targets_reached = whole(value(columns_.targets_reached, row), 0);
  state.drops = whole(value(columns_.drops, row), 0);
  const double since_s = state.t_s - value(columns_.t_s, row);
  const bool gap = gap_after(row);
  if (gap && since_s >= period_s_) return state;

  // Share of the time to the next row that has passed; 0 across a gap.
  const bool goes_on = row + 1 < rows() && !gap;
  const double share =
      goes_on ? since_s / (value(columns_.t_s, row + 1) - value(columns_.t_s, row)) : 0.0;
  state.quality = quality(row);
  for (std::size_t f = 0; f < kFingerCount; ++f) state.fingers[f] = finger_at(f, row, share);
  const auto known = [](double number) {
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
  };
  const bool joined = share > 0.0 && state.quality == SampleQuality::measured &&
                      quality(row + 1) == SampleQuality::measured;
  if (state.quality != SampleQuality::missing)
    state.actual_N = known(between(columns_.actual_N, row, joined ? share : 0.0));
  // The target is what the screen showed, frame by frame.
  state.target_N = known(value(columns_.target_N, row));
  state.X_WT = pose(columns_.target, row);
  state.X_WO = object_between(row, share);
  return state;
}

std::vector<Vec3> TrialReplay::path(double least_step_m) const {
  std::vector<Vec3> path;
  if (!has_object()) return path;
  const Vec3 end_of_stretch = Vec3::Constant(kNoCourse);
  for (std::size_t row = 0; row < rows(); ++row) {
    const auto here = pose(columns_.object, row);
    if (!here) continue;
    const bool stretch_ends = !object_moves_on(row);
    const bool begins = path.empty() || !path.back().allFinite();
    if (begins || stretch_ends || (here->p - path.back()).norm() >= least_step_m)
      path.push_back(here->p);
    if (stretch_ends && row + 1 < rows()) path.push_back(end_of_stretch);
  }
  return path;
}

void Playback::toggle() noexcept {
  if (!playing_ && t_s_ >= end_s_) t_s_ = begin_s_;
  playing_ = !playing_;
}

void Playback::seek(double t_s) noexcept {
  t_s_ = std::isnan(t_s) ? begin_s_ : std::clamp(t_s, begin_s_, end_s_);
}

void Playback::advance(double real_s) noexcept {
  if (!playing_) return;
  t_s_ = std::min(end_s_, t_s_ + speed_ * real_s);
  if (t_s_ >= end_s_) playing_ = false;
}

}  // namespace isograsp::gui
