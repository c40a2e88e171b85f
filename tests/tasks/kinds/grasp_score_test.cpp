// SPDX-License-Identifier: GPL-3.0-or-later
// Grip and load of a virtual object, on made-up forces.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::grasp_score_test {
namespace {

using test::edited;
using test::find;
using test::value_of;

constexpr double kFriction = 0.8;
constexpr double kGain = 1.7;
constexpr double kRounding = 1e-9;

double load_at(double t_s) {
  return 1.5 + std::sin(4.1 * t_s) + 0.2 * std::sin(9.7 * t_s + 1.0);
}

/// Thumb and both fingers carry a load on either side and grip `lag_s` later, with the unit of
/// force and the rate of choice. Before 2 s nothing is touched.
Signals carried(double lag_s, double rate_Hz = 100.0, double unit = 1.0) {
  std::vector<std::string> names{"t_s", "phase", "actual_force_N"};
  for (const char* finger : {"thumb", "index", "middle"}) {
    for (const char* of : {"_fx_N", "_fy_N", "_fz_N"}) names.push_back(std::string(finger) + of);
    for (const char* of : {"contact_", "utilisation_"}) names.push_back(of + std::string(finger));
  }
  Signals signals(names);
  for (const double t_s : test::times(static_cast<std::size_t>(20.0 * rate_Hz), rate_Hz)) {
    const double touch = t_s < 2.0 ? 0.0 : 1.0;
    const double grip_N = touch * unit * (4.0 + kGain * load_at(t_s - lag_s));
    const double load_N = touch * unit * load_at(t_s);
    std::vector<double> row{t_s, 1.0, grip_N};
    for (const double share : {1.0, 0.75, 0.25}) {
      const double normal_N = share * grip_N;
      const double tangential_N = share * load_N;
      row.insert(row.end(), {0.6 * tangential_N, -0.8 * tangential_N, normal_N, touch,
                             touch > 0.0 ? std::abs(tangential_N) / (kFriction * normal_N) : 0.0});
    }
    signals.append_row(row);
  }
  return signals;
}

TaskSpec tracking() {
  PoseTrackingSpec spec;
  spec.axes.resize(1);
  TaskSpec task;
  task.kind = spec;
  return task;
}

TEST(ScoreGrasp, AGripThatFollowsTheLoadHasItsLagAndSlopeAtAnyRate) {
  constexpr double kParabola = 3e-4;
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto late = score(tracking(), carried(0.08, rate_Hz));
    EXPECT_WITHIN(value_of(late, "grip_load_correlation"), 1.0, kParabola);
    EXPECT_WITHIN(value_of(late, "grip_load_lag"), 0.08, kParabola);
    EXPECT_WITHIN(value_of(score(tracking(), carried(0.0, rate_Hz)), "grip_load_slope"), kGain,
                  kRounding)
        << "what was not touched does not count";
  }
}

TEST(ScoreGrasp, TheMarginIsWhatTheGripHasBeyondLoadOverFriction) {
  const auto measures = score(tracking(), carried(0.0));
  double margin = 0.0;
  double most = 0.0;
  for (int k = 200; k < 2000; ++k) {
    const double load_N = load_at(0.01 * k);
    const double used = std::abs(load_N) / kFriction / (4.0 + kGain * load_N);
    margin += 100.0 * (1.0 - used) / 1800.0;
    most = std::max(most, used);
  }
  EXPECT_WITHIN(value_of(measures, "safety_margin"), margin, kRounding);
  EXPECT_LE(value_of(measures, "friction_utilisation"), 100.0 * most);
  EXPECT_GT(value_of(measures, "friction_utilisation"), 90.0 * most);
}

TEST(ScoreGrasp, SidewaysForcesThatShareALoadCorrelateWhollyAndTheGripHasItsImpulse) {
  const Signals signals = carried(0.0);
  const auto measures = score(tracking(), signals);
  EXPECT_WITHIN(value_of(measures, "lateral_correlation"), 1.0, kRounding);
  double impulse_Ns = 0.0;
  double squares = 0.0;
  double touched_s = 0.0;
  for (const double grip_N : signals.column("actual_force_N")) {
    if (grip_N == 0.0) continue;
    impulse_Ns += 0.01 * grip_N;
    squares += 0.01 * grip_N * grip_N;
    touched_s += 0.01;
  }
  const double mean_N = impulse_Ns / touched_s;
  EXPECT_WITHIN(value_of(measures, "impulse"), impulse_Ns, 1e-6);
  EXPECT_WITHIN(value_of(measures, "grip_variation"),
                100.0 * std::sqrt(squares / touched_s - mean_N * mean_N) / mean_N, 1e-6);
}

TEST(ScoreGrasp, NothingDependsOnTheUnitOfForce) {
  const auto newton = score(tracking(), carried(0.08));
  const auto other = score(tracking(), carried(0.08, 100.0, 4.0));
  for (const char* name :
       {"grip_load_correlation", "grip_load_lag", "grip_load_slope", "safety_margin",
        "friction_utilisation", "grip_variation", "lateral_correlation"})
    EXPECT_WITHIN(value_of(newton, name), value_of(other, name), kRounding) << name;
}

TEST(ScoreGrasp, WithoutOppositionFrictionOrColumnsThereIsAReason) {
  const Signals whole = carried(0.0);
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(whole.names().begin(), whole.names().end(), name) -
                                    whole.names().begin());
  };
  const auto thumb_alone = score(tracking(), edited(whole, [&](std::size_t, auto& row) {
                                   row[column("contact_index")] = 0.0;
                                   row[column("contact_middle")] = 0.0;
                                 }));
  EXPECT_EQ(find(thumb_alone, "grip_load_correlation")->reason,
            "thumb and fingers did not hold the object together");
  EXPECT_EQ(find(thumb_alone, "safety_margin")->reason, "there was no grip");
  EXPECT_TRUE(find(thumb_alone, "friction_utilisation")->value);
  const auto smooth = score(tracking(), edited(whole, [&](std::size_t, auto& row) {
                              for (const char* finger : {"thumb", "index", "middle"})
                                row[column(("utilisation_" + std::string(finger)).c_str())] = 0.0;
                            }));
  EXPECT_EQ(find(smooth, "safety_margin")->reason, "no finger touched with friction");
  EXPECT_EQ(find(smooth, "friction_utilisation")->reason, "no finger touched with friction");
  Signals bare({"t_s", "phase"});
  for (const double t_s : test::times(500)) bare.append_row(std::vector{t_s, 1.0});
  EXPECT_EQ(find(score(tracking(), bare), "safety_margin")->reason,
            "forces, contacts or utilisation of the fingers are missing");
}

TEST(ScoreGrasp, ARowWithAnEmptyForceContactOrShareIsExcludedAsOneWithAFlag) {
  Signals whole = carried(0.05);
  whole.add_column("sample_flags", std::vector<double>(whole.rows(), 0.0));
  const auto with = [&](std::size_t column, double value) {
    return score(tracking(), edited(whole, [&](std::size_t k, auto& row) {
                   if (k % 50 == 7) row[column] = value;
                 }));
  };
  const auto flagged = with(whole.names().size() - 1, bit(SampleFlag::held));
  EXPECT_EQ(find(flagged, "grip_variation")->excluded, 40);
  constexpr std::size_t kFirstOfFingers = 3;  // after time, phase and the grip itself
  for (std::size_t column = kFirstOfFingers; column + 1 < whole.names().size(); ++column) {
    const auto empty = with(column, std::nan(""));
    for (const char* name :
         {"grip_load_correlation", "grip_load_lag", "grip_load_slope", "safety_margin", "impulse",
          "friction_utilisation", "grip_variation", "lateral_correlation"}) {
      EXPECT_EQ(value_of(empty, name), value_of(flagged, name))
          << name << " without " << whole.names()[column];
      EXPECT_EQ(find(empty, name)->excluded, 40) << name;
    }
  }
}

TEST(ScoreGrasp, AFingerThatTheSceneLacksExcludesNoRow) {
  const Signals whole = carried(0.0);
  const auto index = whole.find("contact_middle").value();
  const auto measures =
      score(tracking(), edited(whole, [&](std::size_t, auto& row) { row[index] = std::nan(""); }));
  EXPECT_EQ(find(measures, "grip_variation")->samples, 2000);
  EXPECT_GT(value_of(measures, "impulse"), 0.0);
}

TEST(ScoreGrasp, ForcesThatAreTooSmallToComputeWithAreNotHiddenByAContactOfOne) {
  const auto measures = score(tracking(), carried(0.0, 100.0, 1e-100));
  for (const char* name : {"grip_load_slope", "safety_margin", "impulse", "lateral_correlation"}) {
    EXPECT_EQ(find(measures, name)->reason, "the values are too small to compute with") << name;
    EXPECT_EQ(find(measures, name)->samples, 0) << name;
  }
}

TEST(ScoreGrasp, EveryTaskInWhichAnObjectIsMovedGivesTheMeasuresOfTheGrasp) {
  PoseTargetsSpec targets;
  targets.targets.resize(1);
  PickPlaceSpec items;
  items.items.resize(1);
  TaskSpec reach, place;
  reach.kind = targets;
  place.kind = items;
  const Signals moving = edited(
      carried(0.0), [](std::size_t, auto& row) { row[1] = static_cast<double>(Phase::transport); });
  const double margin = value_of(score(tracking(), carried(0.0)), "safety_margin");
  for (const TaskSpec& spec : {reach, place})
    EXPECT_EQ(value_of(score(spec, moving), "safety_margin"), margin);
}

}  // namespace
}  // namespace isograsp::tasks::grasp_score_test
