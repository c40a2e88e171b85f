// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial at any instant: linear between measured samples, and nothing made up elsewhere.
#include "gui/trial_pages/trial_replay.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "gui/trial_pages/trial_curves.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::trial_replay_test {
namespace {

using isograsp::test::every;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr double kHeld = 1.0;
constexpr double kLost = 2.0;
constexpr double kSaturated = 4.0;

/// The thumb presses 1 N more in each of `flags.size()` frames of 10 ms; the others stay at 1 N.
Signals ramp(const std::vector<double>& flags) {
  Signals signals({"t_s", "phase", "sample_flags", "target_force_N", "actual_force_N", "thumb_fx_N",
                   "thumb_fy_N", "thumb_fz_N", "index_fz_N", "thumb_flags", "index_flags"});
  for (std::size_t row = 0; row < flags.size(); ++row) {
    const auto k = static_cast<double>(row);
    const double thumb_N = flags[row] == kLost ? kMissing : k;
    signals.append_row(std::array{0.01 * k, 1.0, flags[row], 2.0 * k, k, 0.1 * k, -0.1 * k, thumb_N,
                                  1.0, flags[row], 0.0});
  }
  return signals;
}

TrialReplay replay_of(Signals signals) {
  auto replay = TrialReplay::make(std::move(signals));
  EXPECT_TRUE(replay.ok()) << replay.error().message();
  return *std::move(replay);
}

const ReplayFinger& thumb(const ReplayState& state) {
  return state.fingers[index_of(Finger::thumb)];
}

TEST(TrialReplay, ForcesAreLinearBetweenMeasuredSamples) {
  const auto replay = replay_of(ramp({0, 0, 0, 0}));
  for (const double t_s : {0.0, 0.0025, 0.01, 0.013, 0.0299}) {
    const auto state = replay.at(t_s);
    EXPECT_WITHIN(thumb(state).force_C.z(), 100.0 * t_s, 1e-12);
    EXPECT_WITHIN(thumb(state).force_C.x(), 10.0 * t_s, 1e-12);
    EXPECT_WITHIN(thumb(state).force_C.y(), -10.0 * t_s, 1e-12);
    EXPECT_WITHIN(state.actual_N.value(), 100.0 * t_s, 1e-12);
    EXPECT_EQ(thumb(state).quality, SampleQuality::measured);
  }
}

TEST(TrialReplay, TheTargetIsThatOfTheFrameAndNeverBetweenTwo) {
  const auto replay = replay_of(ramp({0, 0, 0}));
  EXPECT_EQ(replay.at(0.0199).target_N, 2.0);
  EXPECT_EQ(replay.at(0.02).target_N, 4.0);
}

TEST(TrialReplay, TimesOutsideTheTrialAreItsEnds) {
  const auto replay = replay_of(ramp({0, 0, 0}));
  EXPECT_EQ(replay.at(-5.0).t_s, 0.0);
  EXPECT_EQ(replay.at(99.0).t_s, 0.02);
  EXPECT_EQ(thumb(replay.at(99.0)).force_C.z(), 2.0);
  EXPECT_EQ(replay.at(kMissing).t_s, 0.0);
  EXPECT_EQ(thumb(replay.at(-std::numeric_limits<double>::infinity())).force_C.z(), 0.0);
}

TEST(TrialReplay, AHeldSampleIsCalledHeldAndNoSlopeLeadsToIt) {
  const auto replay = replay_of(ramp({0, 0, kHeld, 0}));
  const auto before = replay.at(0.019);
  EXPECT_EQ(thumb(before).quality, SampleQuality::measured);
  EXPECT_EQ(thumb(before).force_C.z(), 1.0) << "the held value is no measurement to go towards";
  const auto held = replay.at(0.025);
  EXPECT_EQ(thumb(held).quality, SampleQuality::held);
  EXPECT_EQ(held.quality, SampleQuality::held);
  EXPECT_EQ(thumb(held).force_C.z(), 2.0) << "and none leads away from it";
  EXPECT_EQ(held.fingers[index_of(Finger::index)].quality, SampleQuality::measured);
}

TEST(TrialReplay, AMissingSampleHasNoValueAndIsNotBridged) {
  const auto replay = replay_of(ramp({0, 0, kLost, kLost, 0, 0}));
  EXPECT_EQ(thumb(replay.at(0.015)).force_C.z(), 1.0);
  for (const double t_s : {0.02, 0.025, 0.0399}) {
    const auto state = replay.at(t_s);
    EXPECT_EQ(thumb(state).quality, SampleQuality::missing) << t_s;
    EXPECT_EQ(thumb(state).force_C, Vec3::Zero()) << t_s;
    EXPECT_FALSE(state.actual_N.has_value()) << t_s;
    EXPECT_EQ(state.fingers[index_of(Finger::index)].force_C.z(), 1.0) << t_s;
  }
  EXPECT_EQ(thumb(replay.at(0.045)).force_C.z(), 4.5);
}

TEST(TrialReplay, RowsThatWereNotRecordedAreAGap) {
  Signals signals({"t_s", "thumb_fz_N", "sample_flags"});
  for (const double t_s : {0.0, 0.01, 0.02, 0.5, 0.51})
    signals.append_row(std::array{t_s, 100.0 * t_s, 0.0});
  const auto replay = replay_of(std::move(signals));
  EXPECT_WITHIN(replay.period_s(), 0.01, 1e-12);
  EXPECT_TRUE(replay.gap_after(2));
  EXPECT_FALSE(replay.gap_after(1));
  EXPECT_EQ(thumb(replay.at(0.025)).force_C.z(), 2.0) << "a row holds for one period";
  EXPECT_EQ(thumb(replay.at(0.25)).quality, SampleQuality::missing);
  EXPECT_EQ(replay.at(0.25).quality, SampleQuality::missing);
  EXPECT_EQ(thumb(replay.at(0.505)).force_C.z(), 50.5);
}

TEST(TrialReplay, UnevenTimesOfARecordingAreNoGap) {
  Signals signals({"t_s", "thumb_fz_N"});
  for (const double t_s : {0.0, 0.009, 0.021, 0.030, 0.0395})
    signals.append_row(std::array{t_s, t_s});
  const auto replay = replay_of(std::move(signals));
  for (std::size_t row = 0; row < replay.rows(); ++row) EXPECT_FALSE(replay.gap_after(row));
  EXPECT_WITHIN(thumb(replay.at(0.015)).force_C.z(), 0.015, 1e-12);
}

TEST(TrialReplay, ASaturatedSampleIsMeasuredAndSaysSo) {
  const auto replay = replay_of(ramp({0, kSaturated, 0}));
  EXPECT_TRUE(thumb(replay.at(0.01)).beyond_range);
  EXPECT_EQ(thumb(replay.at(0.01)).quality, SampleQuality::measured);
  EXPECT_FALSE(thumb(replay.at(0.0)).beyond_range);
}

TEST(TrialReplay, ChannelsThatWereNotRecordedHaveNoValue) {
  Signals signals({"t_s", "actual_force_N"});
  for (const double t_s : {0.0, 0.01, 0.02}) signals.append_row(std::array{t_s, 3.0});
  const auto replay = replay_of(std::move(signals));
  EXPECT_FALSE(replay.has_fingers());
  EXPECT_FALSE(replay.has_object());
  const auto state = replay.at(0.005);
  EXPECT_EQ(state.actual_N, 3.0);
  EXPECT_FALSE(state.target_N.has_value());
  EXPECT_FALSE(state.X_WO.has_value());
  for (const auto& finger : every(state.fingers)) EXPECT_EQ(finger.quality, SampleQuality::missing);
}

TEST(TrialReplay, NothingIsReplayedWithoutIncreasingTimes) {
  EXPECT_FALSE(TrialReplay::make(Signals({"actual_force_N"})).ok());
  EXPECT_FALSE(TrialReplay::make(Signals({"t_s"})).ok()) << "no rows";
  for (const double second : {0.0, -1.0, kMissing}) {
    Signals signals({"t_s"});
    signals.append_row(std::array{0.0});
    signals.append_row(std::array{second});
    EXPECT_FALSE(TrialReplay::make(std::move(signals)).ok()) << second;
  }
  EXPECT_EQ(TrialReplay().rows(), 0U);
  EXPECT_FALSE(TrialReplay().at(1.0).actual_N.has_value());
}

TEST(TrialReplay, OneSampleIsATrialOfNoLength) {
  const auto replay = replay_of(ramp({0}));
  EXPECT_EQ(replay.begin_s(), replay.end_s());
  EXPECT_EQ(replay.at(1.0).actual_N, 0.0);
}

/// An object that goes along x at 0.1 m/s and turns about z at 1 rad/s.
Signals moving_object(int rows, int jump_at = -1) {
  Signals signals({"t_s", "actual_x_m", "actual_y_m", "actual_z_m", "actual_qw", "actual_qx",
                   "actual_qy", "actual_qz", "target_x_m", "target_y_m", "target_z_m",
                   "target_angle_rad", "target_index", "targets_reached", "drops"});
  for (int row = 0; row < rows; ++row) {
    const double t_s = 0.01 * row;
    const bool anew = jump_at >= 0 && row >= jump_at;
    const double x_m = 0.1 * t_s + (anew ? 0.2 : 0.0);
    signals.append_row(std::array{t_s, x_m, 0.0, 0.01, std::cos(t_s / 2), 0.0, 0.0,
                                  std::sin(t_s / 2), 0.1, kMissing, 0.0, 0.5, anew ? 1.0 : 0.0,
                                  anew ? 1.0 : 0.0, 0.0});
  }
  return signals;
}

TEST(TrialReplay, TheObjectGoesAndTurnsEvenlyBetweenSamples) {
  const auto replay = replay_of(moving_object(100));
  for (const double t_s : {0.0, 0.123, 0.4567, 0.99}) {
    const auto X_WO = replay.at(t_s).X_WO;
    ASSERT_TRUE(X_WO.has_value());
    EXPECT_WITHIN(X_WO->p.x(), 0.1 * t_s, 1e-12);
    EXPECT_EQ(X_WO->p.z(), 0.01);
    const Quat expected(Eigen::AngleAxisd(t_s, Vec3::UnitZ()));
    EXPECT_WITHIN(X_WO->q.angularDistance(expected), 0.0, 1e-7);
  }
  EXPECT_FALSE(replay.at(0.5).X_WT.has_value()) << "y of the target is not known";
}

TEST(TrialReplay, AnObjectThatAppearsAnewDoesNotFlyThere) {
  const auto replay = replay_of(moving_object(100, 50));
  EXPECT_WITHIN(replay.at(0.499).X_WO->p.x(), 0.049, 1e-12);
  EXPECT_WITHIN(replay.at(0.5).X_WO->p.x(), 0.25, 1e-12);
  EXPECT_EQ(replay.at(0.499).targets_reached, 0);
  EXPECT_EQ(replay.at(0.5).targets_reached, 1);
  int ends = 0;
  for (const auto& p : replay.path(0.001)) ends += p.allFinite() ? 0 : 1;
  EXPECT_EQ(ends, 1) << "and its path is drawn in two stretches";
}

TEST(TrialReplay, APathKeepsItsEndsAndItsShape) {
  const auto replay = replay_of(moving_object(100));
  const auto all = replay.path(0.0);
  const auto thin = replay.path(0.01);
  EXPECT_EQ(all.size(), 100U);
  EXPECT_LT(thin.size(), 15U);
  EXPECT_EQ(thin.front(), all.front());
  EXPECT_EQ(thin.back(), all.back());
}

TEST(TrialReplay, AngleStandsInForAnAttitudeThatWasNotRecorded) {
  Signals signals({"t_s", "actual_x_m", "actual_y_m", "actual_angle_rad"});
  for (const double t_s : {0.0, 0.01})
    signals.append_row(std::array{t_s, 0.0, 0.0, std::numbers::pi / 2});
  const auto X_WO = replay_of(std::move(signals)).at(0.0).X_WO;
  ASSERT_TRUE(X_WO.has_value());
  EXPECT_WITHIN((X_WO->q * Vec3::UnitX() - Vec3::UnitY()).norm(), 0.0, 1e-12);
}

TEST(TrialCurves, ReadingsSayWhatIsHeldAndWhatIsMissing) {
  const auto replay = replay_of(ramp({0, kHeld, kLost, 0}));
  const auto curves = curves_of(replay, CurveSet::forces);
  ASSERT_FALSE(curves.empty());
  EXPECT_EQ(curves.front().finger, Finger::thumb);
  EXPECT_EQ(reading(replay, curves.front(), 0.0), "0.00 N");
  EXPECT_EQ(reading(replay, curves.front(), 0.01), "1.00 N held");
  EXPECT_EQ(reading(replay, curves.front(), 0.02), "no sample");
  EXPECT_TRUE(curves.back().target);
}

TEST(TrialCurves, EveryRecordedChannelCanBeChosen) {
  const auto replay = replay_of(moving_object(3));
  for (const auto& name : every(replay.signals().names())) {
    const auto curves = curves_of(replay, CurveSet::chosen, {name});
    ASSERT_EQ(curves.size(), 1U) << name;
    EXPECT_EQ(replay.signals().names()[curves[0].column.value()], name);
  }
  EXPECT_TRUE(curves_of(replay, CurveSet::chosen, {"no_such_channel"}).empty());
  const auto place = curves_of(replay, CurveSet::chosen, {"actual_z_m"});
  EXPECT_EQ(place.front().unit, "mm");
  EXPECT_EQ(reading(replay, place.front(), 0.0), "10.0 mm");
}

TEST(Playback, RunsAtItsSpeedAndStandsAtTheEnd) {
  for (const double speed : Playback::kSpeeds) {
    Playback playback(1.0, 11.0);
    playback.set_speed(speed);
    playback.advance(1.0);
    EXPECT_EQ(playback.t_s(), 1.0) << "it does not run unasked";
    playback.toggle();
    playback.advance(1.0);
    EXPECT_EQ(playback.t_s(), 1.0 + speed);
    EXPECT_TRUE(playback.playing());
    playback.advance(1000.0);
    EXPECT_EQ(playback.t_s(), 11.0);
    EXPECT_FALSE(playback.playing());
    playback.toggle();
    EXPECT_EQ(playback.t_s(), 1.0) << "again from the begin";
  }
}

TEST(Playback, SeeksInsideTheTrialOnlyAndGoesOnPlaying) {
  Playback playback(0.0, 5.0);
  playback.toggle();
  playback.seek(7.0);
  EXPECT_EQ(playback.t_s(), 5.0);
  playback.seek(-1.0);
  EXPECT_EQ(playback.t_s(), 0.0);
  playback.seek(kMissing);
  EXPECT_EQ(playback.t_s(), 0.0);
  EXPECT_TRUE(playback.playing());
  playback.toggle();
  playback.advance(1.0);
  EXPECT_EQ(playback.t_s(), 0.0);
}

}  // namespace
}  // namespace isograsp::gui::test::trial_replay_test
