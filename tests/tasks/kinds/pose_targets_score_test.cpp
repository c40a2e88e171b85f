// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the pose targets, on records played through the state machine.
#include <bit>
#include <cstdint>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::pose_targets_score_test {
namespace {

using test::edited;
using test::find;
using test::spec_of;
using test::value_of;

constexpr double kPeriod_s = 0.01;
constexpr double kRounding = 1e-12;

/// Level to the left in 2 s, a quarter turn in 1 s, both held for 0.5 s.
PoseTargetsSpec left_and_turn() {
  PoseTargetsSpec spec;
  spec.scene = "planar_block";
  spec.time_limit_s = 5.0;
  spec.targets = {{Vec3(-0.1, 0.0, 0.0), 0.0, 0.5, true},
                  {Vec3(-0.1, 0.0, 0.0), std::numbers::pi / 2, 0.5, false}};
  return spec;
}

struct Motion {
  double x_m = 0.0;
  double y_m = 0.0;
  double angle_rad = 0.0;
  bool contact = true;
  bool slip = false;
  bool paused = false;
};

/// Plays a pose task; `motion` is the object over record time.
Signals play_poses(const PoseTargetsSpec& spec, const std::function<Motion(double)>& motion) {
  TaskContext context;
  context.period_s = kPeriod_s;
  const auto task = make_task(spec_of(spec), context);
  EXPECT_TRUE(task);
  Signals signals({"t_s", "phase", "sample_flags", "actual_force_N", "target_x_m", "target_y_m",
                   "target_z_m", "target_angle_rad", "actual_x_m", "actual_y_m", "actual_z_m",
                   "actual_angle_rad", "target_index", "targets_reached", "contact_thumb",
                   "slip_thumb"});
  TaskView view;
  for (int k = 0;; ++k) {
    const double t_s = k * kPeriod_s;
    const Motion m = motion(t_s);
    ObjectState object;
    object.X_WO.p = {m.x_m, m.y_m, 0.0};
    object.X_WO.q = Quat(Eigen::AngleAxisd(m.angle_rad, Vec3::UnitZ()));
    ObjectInput input;
    input.object = &object;
    if (!m.paused) view = (*task)->step(input);
    if (view.phase == Phase::done) return signals;
    const auto& target = spec.targets[static_cast<std::size_t>(view.target_index)];
    const double row[] = {t_s,
                          static_cast<double>(m.paused ? Phase::paused : view.phase),
                          0.0,
                          3.0,
                          target.p_WT.x(),
                          target.p_WT.y(),
                          0.0,
                          target.angle_rad,
                          m.x_m,
                          m.y_m,
                          0.0,
                          m.angle_rad,
                          static_cast<double>(view.target_index),
                          static_cast<double>(view.targets_reached),
                          m.contact ? 1.0 : 0.0,
                          m.slip ? 1.0 : 0.0};
    signals.append_row(row);
  }
}

double min_jerk(double t_s, double duration_s) {
  const double s = std::clamp(t_s / duration_s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}
Motion skilled(double t_s) {
  Motion m;
  m.x_m = -0.1 * min_jerk(t_s, 2.0);
  m.angle_rad = t_s < 2.5 ? 0.0 : std::numbers::pi / 2 * min_jerk(t_s - 2.5, 1.0);
  return m;
}

TEST(ScorePoseTargets, AStraightSteadyTrialHasTheMeasuresOfItsGeometry) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, skilled));
  EXPECT_EQ(value_of(measures, "targets_reached"), 2.0);
  EXPECT_EQ(find(measures, "targets_reached")->unit, "of 2");
  // Entering 20 mm before the end: the first frame at which min_jerk(t / 2 s) >= 0.8.
  double entry_s = 0.0;
  while (min_jerk(entry_s, 2.0) < 0.8) entry_s += kPeriod_s;
  constexpr double kOneFrame_s = kPeriod_s + kRounding;
  EXPECT_WITHIN(value_of(measures, "completion_time", "target_1"), entry_s, kOneFrame_s);
  EXPECT_WITHIN(value_of(measures, "path_length"), 0.1, kRounding);
  EXPECT_WITHIN(value_of(measures, "path_efficiency"), 100.0, 1e-9);
  EXPECT_WITHIN(value_of(measures, "tilt_in_transport"), 0.0, kRounding);
  EXPECT_EQ(value_of(measures, "drops"), 0.0);
  EXPECT_EQ(value_of(measures, "slip"), 0.0);
  EXPECT_WITHIN(value_of(measures, "mean_grip"), 3.0, kRounding);
  EXPECT_EQ(find(measures, "hold_error_position")->samples, 100) << "two holds of exactly 0.5 s";
}

TEST(ScorePoseTargets, AShakyTransportIsLessSmooth) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto smooth = score(spec_of(spec), play_poses(spec, skilled));
  const auto shaky = score(spec_of(spec), play_poses(spec, [](double t_s) {
                             Motion m = skilled(t_s);
                             m.x_m += 0.003 * std::sin(2.0 * std::numbers::pi * 4.0 * t_s);
                             return m;
                           }));
  EXPECT_LT(value_of(shaky, "sparc"), value_of(smooth, "sparc"));
  EXPECT_LT(value_of(smooth, "sparc"), -1.0) << "the arc is longer than its range";
  EXPECT_LT(value_of(shaky, "ldlj", "transport"), value_of(smooth, "ldlj", "transport"));
}

TEST(ScorePoseTargets, HoldErrorsAreTheConstantOffsetsOfTheHold) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, [](double t_s) {
                                Motion m;  // jumps, so that the hold is constant from its first row
                                m.x_m = t_s < 1.0 ? 0.0 : -0.1 + 0.006;
                                m.y_m = t_s < 1.0 ? 0.0 : 0.008;
                                m.angle_rad = t_s < 2.0 ? -0.1 : std::numbers::pi / 2 + 0.1;
                                return m;
                              }));
  EXPECT_EQ(value_of(measures, "targets_reached"), 2.0);
  EXPECT_WITHIN(value_of(measures, "hold_error_position"), 0.01, kRounding);
  EXPECT_WITHIN(value_of(measures, "hold_error_angle"), 0.1, kRounding);
  EXPECT_WITHIN(value_of(measures, "tilt_in_transport"), 0.1, kRounding);
}

TEST(ScorePoseTargets, AnUnreachedTargetIsCensoredNotTimed) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, [](double t_s) {
                                Motion m = skilled(t_s);
                                m.angle_rad = 0.0;  // never turns
                                return m;
                              }));
  EXPECT_EQ(value_of(measures, "targets_reached"), 1.0);
  const Measure* second = find(measures, "completion_time", "target_2");
  EXPECT_FALSE(second->value);
  EXPECT_EQ(second->reason, "not reached within 5 s");
}

TEST(ScorePoseTargets, AnAbortedTrialIsNotATimeOut) {
  const PoseTargetsSpec spec = left_and_turn();
  const Signals whole = play_poses(spec, skilled);
  const Signals cut = edited(whole, [](std::size_t k, std::vector<double>& row) {
    if (k >= 100) row.clear();
  });
  const auto measures = score(spec_of(spec), cut);
  EXPECT_EQ(value_of(measures, "targets_reached"), 0.0);
  EXPECT_EQ(find(measures, "completion_time", "target_1")->reason,
            "the trial ended before it was reached");
  EXPECT_EQ(find(measures, "completion_time", "target_2")->reason,
            "the trial ended before this target");
}

TEST(ScorePoseTargets, ADeviceFaultCostsThePatientNoTimeAndNoDrop) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto smooth = score(spec_of(spec), play_poses(spec, skilled));
  // 20 s of fault in the first transport, longer than every time limit; the hand lets go meanwhile.
  const auto faulted =
      score(spec_of(spec), play_poses(spec, [](double t_s) {
              constexpr double kFault_s = 1.0;
              constexpr double kResume_s = 21.0;
              Motion m = skilled(t_s < kFault_s ? t_s : t_s < kResume_s ? kFault_s : t_s - 20.0);
              m.paused = t_s >= kFault_s && t_s < kResume_s;
              m.contact = t_s < 1.5 || t_s >= 21.2;
              return m;
            }));
  constexpr double kOneFrame_s = kPeriod_s + kRounding;
  EXPECT_EQ(value_of(faulted, "targets_reached"), 2.0);
  EXPECT_WITHIN(value_of(faulted, "completion_time", "target_1"),
                value_of(smooth, "completion_time", "target_1"), kOneFrame_s);
  EXPECT_EQ(value_of(faulted, "drops"), 0.0);
  EXPECT_EQ(find(faulted, "path_length")->excluded, 2000);
}

TEST(ScorePoseTargets, DropsAndSlipAreCountedInTransport) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, [](double t_s) {
                                Motion m = skilled(t_s);
                                m.contact = !(t_s > 0.295 && t_s < 0.495) &&
                                            !(t_s > 0.695 && t_s < 0.795) && t_s > 0.095;
                                m.slip = t_s > 0.895 && t_s < 0.995;
                                return m;
                              }));
  EXPECT_EQ(value_of(measures, "drops"), 2.0) << "the time before the first touch is no drop";
  EXPECT_GT(value_of(measures, "slip"), 0.0);
}

TEST(ScorePoseTargets, ADetourCostsEfficiencyAndATiltIsSeen) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, [](double t_s) {
                                Motion m;  // up, along and down: three sides of a square of 0.1 m
                                m.y_m = 0.1 * (min_jerk(t_s, 1.0) - min_jerk(t_s - 2.0, 1.0));
                                m.x_m = -0.1 * min_jerk(t_s - 1.0, 1.0);
                                m.angle_rad = t_s < 4.0 ? 0.2 : std::numbers::pi / 2;
                                return m;
                              }));
  // The transport ends 20 mm above the target, where the tolerance begins.
  const double straight_m = std::hypot(0.1, 0.02);
  constexpr double kLastStep_percent = 1.0;  // up to one frame of 1.5 mm inside the tolerance
  EXPECT_WITHIN(value_of(measures, "path_efficiency"), 100.0 * straight_m / 0.28,
                kLastStep_percent);
  EXPECT_WITHIN(value_of(measures, "tilt_in_transport"), 0.2, kRounding);
}

TEST(ScorePoseTargets, AnglesAreComparedRoundTheCircle) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto measures = score(spec_of(spec), play_poses(spec, [](double t_s) {
                                Motion m = skilled(t_s);
                                m.angle_rad += 2.0 * std::numbers::pi;
                                return m;
                              }));
  EXPECT_EQ(value_of(measures, "targets_reached"), 2.0);
  EXPECT_WITHIN(value_of(measures, "tilt_in_transport"), 0.0, kRounding);
}

TEST(ScorePoseTargets, AQuaternionServesWhereThreeRotationsAreFree) {
  const PoseTargetsSpec spec = left_and_turn();
  const Signals one_angle = play_poses(spec, [](double t_s) {
    Motion m = skilled(t_s);
    m.angle_rad += 0.1;
    return m;
  });
  Signals attitude;
  for (const auto& name : one_angle.names()) {
    const auto column = one_angle.column(name);
    if (name != "actual_angle_rad") {
      attitude.add_column(name, {column.begin(), column.end()});
      continue;
    }
    std::vector<double> w;
    std::vector<double> z;
    for (const double angle : column) {
      w.push_back(std::cos(angle / 2));
      z.push_back(std::sin(angle / 2));
    }
    const std::vector<double> zero(column.size(), 0.0);
    attitude.add_column("actual_qw", w);
    attitude.add_column("actual_qx", zero);
    attitude.add_column("actual_qy", zero);
    attitude.add_column("actual_qz", z);
  }
  const auto a = score(spec_of(spec), one_angle);
  const auto b = score(spec_of(spec), attitude);
  for (const char* name : {"tilt_in_transport", "hold_error_angle"})
    EXPECT_WITHIN(value_of(a, name), value_of(b, name), kRounding) << name;
}

/// To and fro between two places 0.1 m apart, jumping there and held for 0.5 s. The ends err by
/// `error_m` along the way.
Signals to_and_fro(const PoseTargetsSpec& spec, const std::vector<double>& error_m) {
  return play_poses(spec, [&](double t_s) {
    // Every target is reached 0.5 s after it appeared and held for 0.5 s, and the next appears one
    // frame later.
    const auto target = std::min(static_cast<std::size_t>((t_s + 1e-9) / 1.01), error_m.size() - 1);
    const double since_s = t_s - 1.01 * static_cast<double>(target);
    const bool there = since_s >= 0.5 - 1e-9;
    const auto at = [&](std::size_t i) { return i % 2 == 0 ? 0.1 + error_m[i] : -error_m[i]; };
    Motion m;
    m.x_m = there ? at(target) : target == 0 ? 0.0 : at(target - 1);
    return m;
  });
}
PoseTargetsSpec series(std::size_t count) {
  PoseTargetsSpec spec;
  spec.scene = "planar_block";
  spec.time_limit_s = 5.0;
  for (std::size_t i = 0; i < count; ++i)
    spec.targets.push_back({Vec3(i % 2 == 0 ? 0.1 : 0.0, 0.0, 0.0), 0.0, 0.5, false});
  return spec;
}

TEST(ScorePoseTargets, ASeriesHasTheDifficultyAndThroughputOfFitts) {
  const std::vector<double> error_m{0.01, -0.01, 0.01, -0.01, 0.01, -0.01,
                                    0.01, -0.01, 0.01, -0.01, 0.01, -0.01};
  const PoseTargetsSpec spec = series(error_m.size());
  const auto measures = score(spec_of(spec), to_and_fro(spec, error_m));
  ASSERT_EQ(value_of(measures, "targets_reached"), 12.0);
  EXPECT_WITHIN(value_of(measures, "completion_time", "target_5"), 0.5, kRounding);
  // Ends 0.11 and 0.01 m by turns: after the first every way begins 10 mm nearer or further off.
  double difficulty_bit = std::log2(0.1 / 0.04 + 1.0);
  for (std::size_t i = 1; i < error_m.size(); ++i)
    difficulty_bit += std::log2((0.1 + error_m[i - 1]) / 0.04 + 1.0);
  EXPECT_WITHIN(value_of(measures, "index_of_difficulty"), difficulty_bit / 12.0, kRounding);
  // Six ends 10 mm too far and six 10 mm too short; all ways but the first are 0.1 m long.
  const double sd_m = 0.01 * std::sqrt(12.0 / 11.0);
  const double mean_m = (0.11 + 11.0 * 0.10) / 12.0;
  EXPECT_WITHIN(value_of(measures, "throughput"), std::log2(mean_m / (4.133 * sd_m) + 1.0) / 0.5,
                1e-9);
}

TEST(ScorePoseTargets, ThroughputNeedsTenHeldTargetsAtOneDistance) {
  const PoseTargetsSpec few = series(4);
  const auto measures = score(spec_of(few), to_and_fro(few, {0.01, -0.01, 0.01, -0.01}));
  EXPECT_TRUE(find(measures, "index_of_difficulty")->value);
  EXPECT_EQ(find(measures, "throughput")->reason, "fewer than ten trials");
  PoseTargetsSpec uneven = series(12);
  for (std::size_t i = 1; i < uneven.targets.size(); i += 2) uneven.targets[i].p_WT.x() = 0.0;
  uneven.targets[0].p_WT.x() = 0.2;
  const auto far = score(spec_of(uneven), play_poses(uneven, [&](double t_s) {
                           const auto i = static_cast<std::size_t>((t_s + 1e-9) / 1.01);
                           Motion m;
                           const bool there = t_s - 1.01 * static_cast<double>(i) >= 0.5 - 1e-9;
                           const auto at = [&](std::size_t k) {
                             return uneven.targets[std::min<std::size_t>(k, 11)].p_WT.x();
                           };
                           m.x_m = there ? at(i) : i == 0 ? 0.0 : at(i - 1);
                           return m;
                         }));
  EXPECT_EQ(find(far, "throughput")->reason, "the targets lie at different distances");
  PoseTargetsSpec passing = series(4);
  for (auto& target : passing.targets) target.hold_s = 0.0;
  EXPECT_EQ(find(score(spec_of(passing), play_poses(passing,
                                                    [](double t_s) {
                                                      Motion m;
                                                      m.x_m = 0.1 * (static_cast<int>(t_s) % 2);
                                                      return m;
                                                    })),
                 "index_of_difficulty")
                ->reason,
            "the targets ask for no hold");
}

TEST(ScorePoseTargets, ReasonsOfHoldsAndWaysSayWhatIsMissing) {
  PoseTargetsSpec spec = left_and_turn();
  spec.targets = {{Vec3::Zero(), 0.0, 0.5, false}};
  const auto where = [&](double x_m) {
    return score(spec_of(spec), play_poses(spec, [x_m](double) {
                   Motion m;
                   m.x_m = x_m;
                   return m;
                 }));
  };
  const auto there_already = where(0.0);
  EXPECT_EQ(value_of(there_already, "targets_reached"), 1.0);
  EXPECT_EQ(find(there_already, "index_of_difficulty")->reason,
            "no held target appeared outside its tolerance");
  EXPECT_EQ(find(there_already, "path_efficiency")->reason,
            "no reached target appeared outside its tolerance");
  EXPECT_TRUE(find(there_already, "hold_error_position")->value);
  const auto never = where(0.5);
  EXPECT_EQ(value_of(never, "targets_reached"), 0.0);
  EXPECT_EQ(find(never, "index_of_difficulty")->reason,
            "no target that asks for a hold was reached");
  EXPECT_EQ(find(never, "hold_error_position")->reason,
            "no target that asks for a hold was reached");
  EXPECT_EQ(find(never, "path_efficiency")->reason, "no target was reached");
  EXPECT_EQ(find(never, "sparc", "transport")->reason, "no target was reached");
  spec.targets[0].hold_s = 0.0;
  EXPECT_EQ(find(where(0.0), "hold_error_position")->reason, "the targets ask for no hold");
}

TEST(ScorePoseTargets, TimeOutsEnterTheMedianAndTheRestrictedMeanAsLongerThanTheLimit) {
  const PoseTargetsSpec spec = left_and_turn();
  const auto both = score(spec_of(spec), play_poses(spec, skilled));
  const double first_s = value_of(both, "completion_time", "target_1");
  const double second_s = value_of(both, "completion_time", "target_2");
  EXPECT_WITHIN(value_of(both, "median_completion_time"), std::min(first_s, second_s), kRounding);
  EXPECT_WITHIN(value_of(both, "restricted_mean_time"), 0.5 * (first_s + second_s), kRounding);
  const auto one = score(spec_of(spec), play_poses(spec, [](double t_s) {
                           Motion m = skilled(t_s);
                           m.angle_rad = 0.0;  // never turns
                           return m;
                         }));
  EXPECT_WITHIN(value_of(one, "restricted_mean_time"), 0.5 * (first_s + 5.0), kRounding)
      << "never the mean of the successes";
}

TEST(ScorePoseTargets, AGripThatTremblesIsLessSmoothThoughTheObjectMovesAlike) {
  const PoseTargetsSpec spec = left_and_turn();
  const Signals calm = edited(play_poses(spec, skilled), [](std::size_t k, auto& row) {
    row[3] = 3.0 + min_jerk(static_cast<double>(k) * kPeriod_s, 2.0);
  });
  const Signals trembling = edited(calm, [](std::size_t k, auto& row) {
    row[3] += 0.05 * std::sin(2.0 * std::numbers::pi * 6.0 * static_cast<double>(k) * kPeriod_s);
  });
  const auto smooth = score(spec_of(spec), calm);
  const auto rough = score(spec_of(spec), trembling);
  EXPECT_LT(value_of(rough, "sparc", "force_rate"), value_of(smooth, "sparc", "force_rate"));
  EXPECT_EQ(value_of(rough, "sparc", "transport"), value_of(smooth, "sparc", "transport"));
}

TEST(ScorePoseTargets, AWrittenAndReadBackTrialHasTheSameScoreBitForBit) {
  const PoseTargetsSpec spec = left_and_turn();
  const Signals signals = play_poses(spec, skilled);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_signals(signals, folder.path("trial.csv")));
  const auto read = read_signals(folder.path("trial.csv"));
  ASSERT_TRUE(read) << read.error().message();
  const auto before = score(spec_of(spec), signals);
  const auto after = score(spec_of(spec), *read);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].value.has_value(), after[i].value.has_value());
    EXPECT_EQ(std::bit_cast<std::uint64_t>(before[i].value.value_or(0.0)),
              std::bit_cast<std::uint64_t>(after[i].value.value_or(0.0)))
        << before[i].name;
  }
}

}  // namespace
}  // namespace isograsp::tasks::pose_targets_score_test
