// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the force tasks and of free handling, on records played through the state machines.
#include "tasks/score.hpp"

#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/object/observe.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/task.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::score_test {
namespace {

using test::edited;
using test::find;
using test::spec_of;
using test::value_of;

constexpr double kPeriod_s = 0.01;
constexpr double kRounding = 1e-12;

/// Plays a force task; `grip` is the thumb's and the fingers' force [N] over record time.
Signals play_force(const TaskSpec& spec, const std::function<double(const TaskView&)>& grip,
                   double maximum_N = 40.0, double resting_N = 0.5) {
  TaskContext context;
  context.period_s = kPeriod_s;
  context.references.maximum_N[{}] = maximum_N;
  const auto task = make_task(spec, context);
  EXPECT_TRUE(task);
  Signals signals({"t_s", "phase", "sample_flags", "target_force_N", "actual_force_N",
                   "resting_force_N", "maximum_force_N"});
  for (int k = 0;; ++k) {
    const TaskView view = (*task)->step({});
    if (view.phase == Phase::done) return signals;
    const double row[] = {k * kPeriod_s, static_cast<double>(view.phase),
                          0.0,           view.force().target_force_N,
                          grip(view),    resting_N,
                          maximum_N};
    signals.append_row(row);
  }
}
TEST(Score, RestIsTheMeanOfEveryAxisAndOfTheGrip) {
  std::vector<std::string> names{"t_s", "phase", "actual_force_N"};
  for (const Finger finger : kFingers)
    for (const char* axis : {"fx_N", "fy_N", "fz_N", "tx_Nm", "ty_Nm", "tz_Nm"})
      names.push_back(std::string(name_of(finger)) + "_" + axis);
  Signals signals(names);
  for (int k = 0; k < 100; ++k) {
    std::vector<double> row{k * kPeriod_s, 1.0, 0.25};
    for (int axis = 0; axis < 18; ++axis) row.push_back(axis + (k % 2 == 0 ? 0.5 : -0.5));
    signals.append_row(row);
  }
  const auto measures = score(spec_of(RestSpec{1.0}), signals);
  ASSERT_EQ(measures.size(), 19u);
  EXPECT_DOUBLE_EQ(value_of(measures, "resting_force", "grip"), 0.25);
  EXPECT_WITHIN(value_of(measures, "resting_force", "thumb_fz"), 2.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "resting_force", "middle_tz"), 17.0, kRounding);
  EXPECT_EQ(find(measures, "resting_force", "middle_tz")->unit, "Nm");
}

TEST(Score, MaximumIsTheBestHalfSecondAboveRestAndIgnoresASpike) {
  const TaskSpec spec = spec_of(MaximumSpec{});
  int active = 0;
  const Signals signals = play_force(spec, [&](const TaskView& view) {
    if (view.phase != Phase::active) return 60.0;  // the lead-in is not scored
    ++active;
    if (active == 20) return 50.0;                       // one frame
    return active > 100 && active <= 200 ? 30.0 : 10.0;  // one second of effort
  });
  const auto measures = score(spec, signals);
  EXPECT_WITHIN(value_of(measures, "maximum_force"), 29.5, kRounding);
  EXPECT_WITHIN(value_of(measures, "maximum_force_total"), 30.0, kRounding);
  EXPECT_EQ(value_of(measures, "peak_force"), 50.0);
  EXPECT_EQ(find(measures, "maximum_force")->samples, 300);
}

TEST(Score, MaximumWithoutARestingForceHasNoValueAboveIt) {
  const TaskSpec spec = spec_of(MaximumSpec{});
  Signals signals({"t_s", "phase", "actual_force_N"});
  for (int k = 0; k < 300; ++k) {
    const double row[] = {k * kPeriod_s, 1.0, 20.0};
    signals.append_row(row);
  }
  const auto measures = score(spec, signals);
  EXPECT_FALSE(find(measures, "maximum_force")->value);
  EXPECT_EQ(find(measures, "maximum_force")->reason, "the resting force was not measured");
  EXPECT_WITHIN(value_of(measures, "maximum_force_total"), 20.0, kRounding);
}

constexpr double kGain = 0.8343;
constexpr double kLag_s = 0.15;

double late_sine(const TaskView& view) {
  const double s = std::max(0.0, view.task_time_s - 2.0);
  return 8.0 - kGain * 4.0 * std::cos(2.0 * std::numbers::pi * 0.2 * (s - kLag_s));
}

TEST(Score, ForceTrackingFindsGainLagAndErrorOfTheActivePhaseOnly) {
  const TaskSpec spec = spec_of(ForceTrackingSpec{});  // 4 to 12 N of 40 N
  const Signals signals = play_force(spec, [](const TaskView& view) {
    return view.phase == Phase::lead_in ? 100.0 : late_sine(view);
  });
  const auto measures = score(spec, signals);
  const double closed = 4.0 / std::sqrt(2.0) *
                        std::sqrt(1.0 + kGain * kGain -
                                  2.0 * kGain * std::cos(2.0 * std::numbers::pi * 0.2 * kLag_s));
  constexpr double kParabola_s = 1e-3;
  EXPECT_WITHIN(value_of(measures, "rmse"), closed, kRounding);
  EXPECT_WITHIN(value_of(measures, "relative_rmse"), 100.0 * closed / 12.0, 1e-10);
  EXPECT_WITHIN(value_of(measures, "constant_error"), 0.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "gain"), kGain, kRounding);
  EXPECT_WITHIN(value_of(measures, "lag"), kLag_s, kParabola_s);
  EXPECT_EQ(find(measures, "rmse")->samples, 3000);
}

TEST(Score, APauseIsCutOutOfTaskTimeAndChangesNoTrackingMeasure) {
  const TaskSpec spec = spec_of(ForceTrackingSpec{});
  const Signals whole = play_force(spec, late_sine);
  Signals paused(whole.names());
  int extra = 0;
  for (std::size_t k = 0; k < whole.rows(); ++k) {
    std::vector<double> row;
    for (std::size_t c = 0; c < whole.names().size(); ++c) row.push_back(whole.column(c)[k]);
    row[0] = (static_cast<double>(k) + extra) * kPeriod_s;
    paused.append_row(row);
    if (k != 1000) continue;
    for (; extra < 700; ++extra) {  // 7 s of fault: frozen target, nonsense force
      auto frozen = row;
      frozen[0] = (static_cast<double>(k) + extra + 1) * kPeriod_s;
      frozen[1] = static_cast<double>(Phase::paused);
      frozen[2] = bit(SampleFlag::missing);
      frozen[4] = -500.0;
      paused.append_row(frozen);
    }
  }
  const auto before = score(spec, whole);
  const auto after = score(spec, paused);
  for (std::size_t i = 0; i < before.size(); ++i) {
    ASSERT_EQ(before[i].value.has_value(), after[i].value.has_value()) << before[i].name;
    EXPECT_EQ(before[i].reason, after[i].reason);
    if (!before[i].value) continue;
    EXPECT_WITHIN(*after[i].value, *before[i].value, kRounding) << before[i].name;
    EXPECT_EQ(after[i].excluded, 700);
  }
}

TEST(Score, FlaggedSamplesAreExcludedAndCounted) {
  const TaskSpec spec = spec_of(ForceTrackingSpec{});
  const Signals clean =
      play_force(spec, [](const TaskView& view) { return view.force().target_force_N + 1.0; });
  const Signals spoiled = edited(clean, [](std::size_t k, std::vector<double>& row) {
    if (k % 10 != 0) return;
    row[2] = bit(SampleFlag::saturated);
    row[4] = 300.0;
  });
  const auto measures = score(spec, spoiled);
  EXPECT_WITHIN(value_of(measures, "rmse"), 1.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "constant_error"), 1.0, kRounding);
  EXPECT_EQ(find(measures, "rmse")->excluded, 300);
  EXPECT_EQ(find(measures, "rmse")->samples, 2700);
  EXPECT_WITHIN(value_of(measures, "lag"), 0.0, 1e-9);
}

TEST(Score, TheRangeWidensToTheStoredNoise) {
  const TaskSpec spec = spec_of(ForceTrackingSpec{});
  Signals signals =
      play_force(spec, [](const TaskView& view) { return view.force().target_force_N + 0.7; });
  EXPECT_EQ(value_of(score(spec, signals), "time_in_range"), 0.0);  // 5 % of at most 12 N
  signals.add_column("noise_sd_N", std::vector<double>(signals.rows(), 0.25));
  EXPECT_EQ(value_of(score(spec, signals), "time_in_range"), 100.0);
}

TEST(Score, AMissingColumnIsNamedAndNothingElseFails) {
  Signals signals;
  signals.add_column("t_s", test::times(100));
  for (const TaskSpec& spec :
       {spec_of(RestSpec{}), spec_of(MaximumSpec{}), spec_of(ForceTrackingSpec{}),
        spec_of(ObserveSpec{}), spec_of(PoseTargetsSpec{"s", 0.02, 0.26, 30.0, {PoseTarget{}}})})
    for (const Measure& measure : test::every(score(spec, signals))) {
      EXPECT_FALSE(measure.value) << measure.name;
      EXPECT_NE(measure.reason.find("missing"), std::string::npos)
          << measure.name << ": " << measure.reason;
    }
}

TEST(Score, ARecordThatHasJustBegunHasReasonsNotNumbersFromNothing) {
  for (const std::size_t rows : {0u, 1u}) {
    Signals signals({"t_s", "phase", "sample_flags", "target_force_N", "actual_force_N"});
    for (std::size_t k = 0; k < rows; ++k) {
      const double row[] = {0.0, 0.0, 0.0, 4.0, 0.0};
      signals.append_row(row);
    }
    for (const TaskSpec& spec : {spec_of(RestSpec{}), spec_of(MaximumSpec{}),
                                 spec_of(ForceTrackingSpec{}), spec_of(ObserveSpec{})})
      for (const Measure& measure : test::every(score(spec, signals))) EXPECT_FALSE(measure.value);
  }
}

TEST(Score, ObserveMeasuresGripPathAndContact) {
  Signals signals({"t_s", "phase", "actual_force_N", "actual_x_m", "actual_y_m", "contact_thumb",
                   "contact_index"});
  for (int k = 0; k < 100; ++k) {
    const double row[] = {k * kPeriod_s,
                          1.0,
                          k < 50 ? 2.0 : 4.0,
                          0.001 * k,
                          0.0,
                          k < 30 ? 1.0 : 0.0,
                          k >= 20 && k < 40 ? 1.0 : 0.0};
    signals.append_row(row);
  }
  const auto measures = score(spec_of(ObserveSpec{}), signals);
  EXPECT_WITHIN(value_of(measures, "mean_grip"), 3.0, kRounding);
  EXPECT_EQ(value_of(measures, "peak_force"), 4.0);
  EXPECT_WITHIN(value_of(measures, "path_length"), 0.099, kRounding);
  EXPECT_WITHIN(value_of(measures, "contact_time"), 0.4, kRounding);
}

}  // namespace
}  // namespace isograsp::tasks::score_test
