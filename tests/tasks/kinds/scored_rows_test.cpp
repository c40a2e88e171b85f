// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows a measure is made of: none after the end, none won or lost by the rounding of a time.
#include <gtest/gtest.h>

#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_sense.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/grip_release.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/record.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/force_play.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::scored_rows_test {
namespace {

using test::find;
using test::grip_of;
using test::kPeriod_s;
using test::play_force;
using test::pressing;
using test::spec_of;
using test::value_of;

constexpr double kRounding = 1e-9;

/// What stands in the record without its last row.
Signals without_last_row(const Signals& signals) {
  return test::edited(signals, [&](std::size_t k, std::vector<double>& row) {
    if (k + 1 == signals.rows()) row.clear();
  });
}

std::vector<TaskSpec> tasks_that_end_while_scored() {
  GripReleaseSpec open;
  open.open = true;
  MaximumSpec opening;
  opening.channel.direction = Direction::minus_z;
  return {spec_of(MaximumSpec{}),       spec_of(opening),           spec_of(ForceTrackingSpec{}),
          spec_of(StepResponseSpec{}),  spec_of(GripReleaseSpec{}), spec_of(open),
          spec_of(IndividuationSpec{}), spec_of(FatigueSpec{})};
}

TEST(ScoredRows, TheRowAfterTheEndIsScoredInNoTask) {
  for (const TaskSpec& spec : test::every(tasks_that_end_while_scored())) {
    // A hand that jumps in the row of the phase `done`.
    const Signals signals = play_force(spec, [](const TaskView& view, double t_s) {
      if (view.phase == Phase::done) return pressing(200, -150, 90);
      const double force_N = view.force().has_force_target ? view.force().target_force_N
                             : view.cue == Cue::squeeze    ? 20.0
                                                           : 0.0;
      return grip_of(force_N + 0.3 * std::sin(40.0 * t_s));
    });
    ASSERT_EQ(signals.column("phase").back(), static_cast<double>(Phase::done));
    const auto with = score(spec, signals);
    const auto without = score(spec, without_last_row(signals));
    ASSERT_EQ(with.size(), without.size());
    for (std::size_t i = 0; i < with.size(); ++i) {
      EXPECT_EQ(with[i].value, without[i].value) << with[i].name << " " << with[i].channel;
      EXPECT_EQ(with[i].samples, without[i].samples) << with[i].name;
      EXPECT_EQ(with[i].excluded, without[i].excluded) << with[i].name;
    }
  }
}

TEST(ScoredRows, AMaximumIsThatOfItsThreeHundredRows) {
  const auto measures = score(
      spec_of(MaximumSpec{}), play_force(spec_of(MaximumSpec{}), [](const TaskView& view, double) {
        return grip_of(view.phase == Phase::done ? 90.0 : view.cue == Cue::squeeze ? 10.0 : 0.0);
      }));
  EXPECT_WITHIN(value_of(measures, "maximum_force"), 10.0, kRounding);
  EXPECT_EQ(value_of(measures, "peak_force"), 10.0);
  EXPECT_EQ(find(measures, "maximum_force")->samples, 300);
}

TEST(ScoredRows, TheEndOfAReproductionIsAsManyRowsAsItsWindowHolds) {
  const ForceSenseSpec spec;  // 5 s at 100 Hz, of which the last 2 s count: 200 rows
  for (const double start_s : {0.0, 0.1, 12.3, 5e4}) {
    int row = 0;
    const Signals signals = play_force(
        spec_of(spec),
        [&](const TaskView& view, double) {
          if (view.cue != Cue::reproduce) {
            row = 0;
            return grip_of(view.force().has_force_target ? view.force().target_force_N : 0.0);
          }
          return grip_of(++row == 301 ? 8.0 + 2.0 : 8.0);  // in the first row of the window alone
        },
        start_s);
    constexpr double kClock = 1e-6;  // of a start long ago the grid is as coarse
    EXPECT_WITHIN(value_of(score(spec_of(spec), signals), "constant_error"), 2.0 / 200.0, kClock)
        << start_s;
  }
}

TEST(ScoredRows, TheFirstFiveSecondsOfAHoldAreFiveHundredRows) {
  const FatigueSpec spec;
  for (int tenths = 0; tenths < 30; ++tenths) {
    const double start_s = 0.1 * tenths;
    int row = 0;
    const Signals signals = play_force(
        spec_of(spec),
        [&](const TaskView& view, double) {
          if (view.phase != Phase::active) return grip_of(20.0);
          return grip_of(row++ < 500 ? 20.0 : 15.9);
        },
        start_s);
    // Below 80 % from row 500 on: only if no later row is in the mean.
    const auto measures = score(spec_of(spec), signals);
    EXPECT_WITHIN(value_of(measures, "endurance"), 5.0, 1e-6) << start_s;
  }
}

ForceTrackingSpec trapezoid() {
  ForceTrackingSpec spec;
  spec.waveform.shape = Waveform::Shape::trapezoid;
  spec.lead_in_s = 2.0;
  return spec;
}

TEST(ScoredRows, ThePiecesOfATrapezoidHaveTheirRowsWhenItBegins) {
  for (const double start_s : {0.0, 0.1, 0.7, 33.3}) {
    const auto measures =
        score(spec_of(trapezoid()),
              play_force(
                  spec_of(trapezoid()),
                  [](const TaskView& view, double) { return grip_of(view.force().target_force_N); },
                  start_s));
    EXPECT_EQ(find(measures, "rmse", "force_rise")->samples, 500) << start_s;
    EXPECT_EQ(find(measures, "rmse", "force_hold")->samples, 1400) << start_s;
    EXPECT_EQ(find(measures, "rmse", "force_fall")->samples, 500) << start_s;
  }
}

TEST(ScoredRows, AHeldRowAtTheStartMovesNoPieceAndIsCountedInIts) {
  const Signals whole = play_force(spec_of(trapezoid()), [](const TaskView& view, double t_s) {
    return grip_of(view.force().target_force_N + 0.2 * std::sin(3.0 * t_s));
  });
  const Signals held = test::edited(whole, [&](std::size_t k, std::vector<double>& row) {
    if (k >= 200 && k < 205) row[2] = bit(SampleFlag::held);
  });
  const auto measures = score(spec_of(trapezoid()), held);
  EXPECT_EQ(find(measures, "rmse", "force_rise")->samples, 495);
  EXPECT_EQ(find(measures, "rmse", "force_rise")->excluded, 5);
  EXPECT_EQ(find(measures, "rmse", "force_hold")->samples, 1400);
  EXPECT_EQ(find(measures, "rmse", "force_hold")->excluded, 0);
}

TEST(ScoredRows, ThePaceOfARampIsThatOfItsTargetToTheLastStep) {
  // Two paces just below and just above 40 % of the ramp's 8 N in 5 s: one pauses, one does not.
  for (const auto& [share, pauses] : {std::pair{0.3995, 1.0}, std::pair{0.4005, 0.0}}) {
    ForceTrackingSpec spec;
    spec.waveform.shape = Waveform::Shape::ramp;
    const double pace_N_per_s = share * 8.0 / 5.0;
    const auto measures =
        score(spec_of(spec), play_force(spec_of(spec), [&](const TaskView&, double t_s) {
                return grip_of(4.0 + pace_N_per_s * (t_s - 2.0));
              }));
    EXPECT_EQ(value_of(measures, "pauses"), pauses) << share;
  }
}

TEST(ScoredRows, AColumnThatWasNotSelectedReadsAsEmpty) {
  Signals signals({"t_s", "a", "b"});
  for (const double t_s : test::times(3)) signals.append_row(std::vector{t_s, 1.0, 2.0});
  const Record record(signals);
  const Section section = record.select({}, {"a"});
  EXPECT_EQ(section.values("a"), (std::vector{1.0, 1.0, 1.0}));
  for (const double value : test::every(section.values("b"))) EXPECT_TRUE(std::isnan(value));
}

TEST(ScoredRows, TheLastRowOfTheLastHalfCycleCounts) {
  for (const auto shape : {Waveform::Shape::sine, Waveform::Shape::triangle}) {
    ForceTrackingSpec spec;
    spec.waveform.shape = shape;
    const auto measures =
        score(spec_of(spec), play_force(spec_of(spec), [](const TaskView& view, double) {
                return grip_of(view.force().target_force_N + 1.0);
              }));
    EXPECT_EQ(find(measures, "rmse", "force_rise")->samples, 1500);
    EXPECT_EQ(find(measures, "rmse", "force_fall")->samples, 1500);
  }
}

}  // namespace
}  // namespace isograsp::tasks::scored_rows_test
