// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resting.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/platform_columns.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::resting_test {
namespace {

/// A rest trial as it is recorded; `change` alters row k.
template <class Change>
Signals rest_trial(int rows, Change change) {
  Signals signals(test::platform_columns(false));
  for (int k = 0; k < rows; ++k) {
    test::StillFrame still;
    tasks::Phase phase = tasks::Phase::active;
    change(k, still.forces, phase);
    TrialRow row;
    write_row({0.01 * k, phase, {}, 0.0, 0.0}, still.seen(false), row);
    signals.append_row(row.values());
  }
  return signals;
}

TEST(RestingForce, MeanIsTheStoredMeasureAndSdIsThatOfTheSamples) {
  const auto trial = rest_trial(100, [](int k, FingerFrame& forces, tasks::Phase&) {
    forces.wrench_C[1].force.z() = 2.0 + (k % 2 == 0 ? 0.1 : -0.1);
    forces.wrench_C[2].torque.x() = 0.01 * k;
  });
  const auto rest = resting_force(trial);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->samples, 100);
  constexpr double kRounding = 1e-12;  // both are sums of a hundred numbers, in another order
  EXPECT_WITHIN(rest->sd[1][2], 0.1 * std::sqrt(100.0 / 99.0), kRounding);
  EXPECT_WITHIN(rest->sd[2][3], 0.01 * std::sqrt(100.0 * 101.0 / 12.0), kRounding);
  const auto spec = tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"R\"\ninstruction = \"R\"\nkind = \"rest\"\n", "r");
  test::AtLeast compared(2);
  for (const auto& measure : test::every(tasks::score(*spec, trial))) {
    if (measure.channel == "index_fz") {
      EXPECT_WITHIN(*measure.value, rest->mean[1][2], kRounding);
      ++compared;
    }
    if (measure.channel == "middle_tx") {
      EXPECT_WITHIN(*measure.value, rest->mean[2][3], kRounding);
      ++compared;
    }
  }
}

TEST(RestingForce, RowsThatDoNotCountAreLeftOut) {
  const auto trial = rest_trial(100, [](int k, FingerFrame& forces, tasks::Phase& phase) {
    forces.wrench_C[0].force.z() = 1.0;
    if (k % 10 == 3) {
      forces.flags[0] = bit(SampleFlag::held);
      forces.wrench_C[0].force.z() = 500.0;
    }
    if (k % 10 == 4) phase = tasks::Phase::paused;
  });
  const auto rest = resting_force(trial);
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->samples, 80);
  EXPECT_EQ(rest->mean[0][2], 1.0);
  EXPECT_EQ(rest->sd[0][2], 0.0);
}

TEST(RestingForce, WithoutSamplesThereIsNone) {
  EXPECT_FALSE(resting_force(rest_trial(100, [](int, FingerFrame& forces, tasks::Phase&) {
    forces.flags[1] = bit(SampleFlag::missing);
  })));
}

TEST(RestingForce, SpasticToneIsDataNotAnError) {
  RestingForce rest;
  for (auto& mean : rest.mean) mean.setZero();
  for (auto& sd : rest.sd) sd.setZero();
  EXPECT_EQ(english(words_of(rest)), "At rest thumb 0.0, index 0.0, middle 0.0 N.");
  rest.mean[2][2] = 4.0;
  EXPECT_NE(english(words_of(rest)).find("(middle): muscle tone"), std::string::npos)
      << english(words_of(rest));
  EXPECT_NE(english(words_of(rest)).find("never subtracted"), std::string::npos);
  rest.mean[0][2] = -1.5;
  EXPECT_NE(english(words_of(rest)).find("Pulling though relaxed (thumb)"), std::string::npos);
  rest.sd[1][2] = 0.9;
  EXPECT_NE(english(words_of(rest)).find("not still"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::session::resting_test
