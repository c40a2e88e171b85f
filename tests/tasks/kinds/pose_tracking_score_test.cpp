// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of pose tracking, on records played through the state machine.
#include <numbers>

#include <gtest/gtest.h>

#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/object_play.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::pose_tracking_score_test {
namespace {

using test::find;
using test::Handled;
using test::play_object;
using test::value_of;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kFrequency_Hz = 0.2;
constexpr double kGain = 0.8;
constexpr double kLag_s = 0.15;

TaskSpec tracking(std::vector<PoseTrackingSpec::Axis> axes, Waveform waveform = {}) {
  PoseTrackingSpec spec;
  spec.scene = "free_block";
  spec.duration_s = 20.0;  // four cycles of 0.2 Hz
  spec.axes = std::move(axes);
  for (auto& axis : spec.axes) axis.waveform = waveform;
  TaskSpec task;
  task.kind = spec;
  return task;
}
const TaskSpec kPlanar = tracking({{0, -0.05, 0.05, {}}, {5, -1.0, 1.0, {}}});

double wave(double t_s) {
  return -std::cos(kTurn_rad * kFrequency_Hz * t_s);
}
/// Late and too small, in x and about z; the scored part begins after 2 s.
Handled late(const TaskView& view, const Pose&) {
  const double t_s = view.duration_s == 0.0 ? -2.0 : view.task_time_s + 0.01 - 2.0;
  Handled now;
  const double value = kGain * wave(t_s - kLag_s);
  now.X_WO.p.x() = 0.05 * value;
  now.X_WO.q = Quat(Eigen::AngleAxisd(value, Vec3::UnitZ()));
  return now;
}
double closed_rmse(double amplitude) {
  return amplitude / std::sqrt(2.0) *
         std::sqrt(1.0 + kGain * kGain -
                   2.0 * kGain * std::cos(kTurn_rad * kFrequency_Hz * kLag_s));
}

TEST(ScorePoseTracking, ALateAndSmallSineHasTheErrorsGainAndLagOfItsClosedForm) {
  const auto measures = score(kPlanar, play_object(kPlanar, late));
  constexpr double kRounding = 1e-12;
  constexpr double kParabola_s = 1e-3;
  EXPECT_WITHIN(value_of(measures, "rmse", "x"), closed_rmse(0.05), kRounding);
  EXPECT_WITHIN(value_of(measures, "rmse", "rz"), closed_rmse(1.0), kRounding);
  EXPECT_WITHIN(value_of(measures, "rmse", "position"), closed_rmse(0.05), kRounding);
  EXPECT_WITHIN(value_of(measures, "rmse", "attitude"), closed_rmse(1.0), kRounding);
  for (const char* channel : {"x", "rz"}) {
    EXPECT_WITHIN(value_of(measures, "constant_error", channel), 0.0, kRounding);
    EXPECT_WITHIN(value_of(measures, "gain", channel), kGain, kRounding);
    EXPECT_WITHIN(value_of(measures, "lag", channel), kLag_s, kParabola_s);
    EXPECT_WITHIN(value_of(measures, "phase_lag", channel), kLag_s, kRounding);
    EXPECT_WITHIN(value_of(measures, "phase", channel), -kTurn_rad * kFrequency_Hz * kLag_s,
                  kRounding);
    EXPECT_LT(value_of(measures, "mae", channel), value_of(measures, "rmse", channel));
  }
  EXPECT_EQ(find(measures, "rmse", "x")->unit, "m");
  EXPECT_EQ(find(measures, "rmse", "rz")->unit, "rad");
  EXPECT_EQ(find(measures, "rmse", "y"), nullptr) << "the target does not move in y";
  EXPECT_EQ(find(measures, "rmse", "x")->samples, 2000) << "the lead-in is not scored";
  EXPECT_WITHIN(value_of(measures, "mean_grip"), 3.0, kRounding);
}

TEST(ScorePoseTracking, TheSameMovementAtFiveHundredHertzHasTheSameMeasures) {
  const auto at = [](double rate_Hz) {
    return score(kPlanar, play_object(
                              kPlanar,
                              [rate_Hz](const TaskView& view, const Pose& pose) {
                                TaskView shifted = view;
                                shifted.task_time_s += 1.0 / rate_Hz - 0.01;
                                return late(shifted, pose);
                              },
                              rate_Hz));
  };
  const auto slow = at(100.0);
  const auto fast = at(500.0);
  for (const char* name : {"rmse", "mae", "gain"})
    for (const char* channel : {"x", "rz"})
      EXPECT_WITHIN(value_of(slow, name, channel), value_of(fast, name, channel), 1e-4) << name;
  EXPECT_WITHIN(value_of(slow, "path_length"), value_of(fast, "path_length"), 1e-4);
}

TEST(ScorePoseTracking, AConstantOffsetIsAllErrorOfItsAxisAndOfThePosition) {
  const auto measures = score(kPlanar, play_object(kPlanar, [](const TaskView& view, const Pose&) {
                                const double t_s = std::max(0.0, view.task_time_s + 0.01 - 2.0);
                                Handled now;
                                now.X_WO.p = {0.05 * wave(t_s) + 0.003, 0.004, 0.012};
                                now.X_WO.q = Quat(Eigen::AngleAxisd(wave(t_s), Vec3::UnitZ()));
                                return now;
                              }));
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(value_of(measures, "constant_error", "x"), 0.003, kRounding);
  EXPECT_WITHIN(value_of(measures, "rmse", "x"), 0.003, kRounding);
  EXPECT_WITHIN(value_of(measures, "rmse", "position"), 0.013, kRounding);
}

TEST(ScorePoseTracking, FullTurnsOfTheObjectDoNotCountAndSignsOfQuaternionsDoNotMatter) {
  const auto plain = score(kPlanar, play_object(kPlanar, late));
  const auto turned =
      score(kPlanar, play_object(kPlanar, [](const TaskView& view, const Pose& pose) {
              Handled now = late(view, pose);
              now.X_WO.q.coeffs() = -now.X_WO.q.coeffs();
              return now;
            }));
  for (const char* name : {"rmse", "mae", "constant_error", "gain"})
    EXPECT_WITHIN(value_of(turned, name, "rz"), value_of(plain, name, "rz"), 1e-12) << name;
}

TEST(ScorePoseTracking, TargetsBeyondHalfATurnAreFollowedRound) {
  const TaskSpec wide = tracking({{5, -5.0, 5.0, {}}});
  const auto measures = score(wide, play_object(wide, [](const TaskView& view, const Pose&) {
                                const double t_s = std::max(0.0, view.task_time_s + 0.01 - 2.0);
                                Handled now;
                                now.X_WO.q =
                                    Quat(Eigen::AngleAxisd(5.0 * wave(t_s) + 0.1, Vec3::UnitZ()));
                                return now;
                              }));
  EXPECT_WITHIN(value_of(measures, "constant_error", "rz"), 0.1, 1e-10);
  EXPECT_WITHIN(value_of(measures, "rmse", "attitude"), 0.1, 1e-10);
  EXPECT_WITHIN(value_of(measures, "gain", "rz"), 1.0, 1e-10);
}

TEST(ScorePoseTracking, ATargetThatJumpsHasNoGainAndAStillObjectNoLag) {
  Waveform jumps;
  jumps.shape = Waveform::Shape::rectangle;
  const TaskSpec spec = tracking({{0, -0.05, 0.05, {}}}, jumps);
  const auto measures =
      score(spec, play_object(spec, [](const TaskView&, const Pose&) { return Handled{}; }));
  EXPECT_EQ(find(measures, "gain", "x"), nullptr);
  EXPECT_FALSE(find(measures, "lag", "x")->value);
  EXPECT_FALSE(find(measures, "lag", "x")->reason.empty());
  EXPECT_WITHIN(value_of(measures, "rmse", "x"), 0.05, 1e-12);
  EXPECT_EQ(value_of(measures, "path_length"), 0.0);
  EXPECT_FALSE(find(measures, "sparc", "position")->value);
  EXPECT_FALSE(find(measures, "sparc", "force_rate")->value) << "the grip did not change";
}

TEST(ScorePoseTracking, TheLagWithoutTheDeviceIsSmallerByItsDelay) {
  const Signals plain = play_object(kPlanar, late);
  EXPECT_FALSE(find(score(kPlanar, plain), "lag_corrected", "x")->value);
  std::vector<std::string> names = plain.names();
  names.push_back("device_delay_s");
  Signals delayed(names);
  for (std::size_t k = 0; k < plain.rows(); ++k) {
    std::vector<double> row;
    for (std::size_t c = 0; c < plain.names().size(); ++c) row.push_back(plain.column(c)[k]);
    row.push_back(0.032);
    delayed.append_row(row);
  }
  const auto measures = score(kPlanar, delayed);
  for (const char* channel : {"x", "rz"})
    EXPECT_WITHIN(value_of(measures, "lag_corrected", channel),
                  value_of(measures, "lag", channel) - 0.032, 1e-12);
}

TEST(ScorePoseTracking, WithoutItsColumnsAMeasureSaysWhichIsMissing) {
  Signals signals({"t_s", "phase"});
  for (int k = 0; k < 100; ++k) {
    const double row[] = {0.01 * k, 1.0};
    signals.append_row(row);
  }
  const auto measures = score(kPlanar, signals);
  ASSERT_FALSE(measures.empty());
  for (const Measure& measure : test::every(measures)) {
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_FALSE(measure.reason.empty()) << measure.name;
  }
  EXPECT_EQ(find(measures, "rmse", "x")->reason, "the column target_x_m is missing");
}

}  // namespace
}  // namespace isograsp::tasks::pose_tracking_score_test
