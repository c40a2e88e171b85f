// SPDX-License-Identifier: GPL-3.0-or-later
// Every measure that a task can give is called by words, and research stays out of the report.
#include "tasks/facts/measure_words.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tasks/kinds/force/grip_release.hpp"
#include "tests/reports/emitted_measures.hpp"
#include "tests/support/every.hpp"

namespace isograsp::reports::measure_words_test {
namespace {

using test::Emitted;
using test::emitted;
using test::own_name;
using test::spec_of;

TEST(MeasureWords, EveryMeasureOfEveryKindOfTaskHasWords) {
  std::set<std::string_view> kinds;
  std::set<std::string> names;
  for (const Emitted& task : test::every(emitted())) {
    kinds.insert(task.spec.kind->name);
    for (const Measure& measure : test::every(task.measures)) {
      names.insert(measure.name);
      EXPECT_NE(english(tasks::words_of(measure.name, "").title), own_name(measure.name))
          << "kind " << task.spec.kind->name;
    }
  }
  EXPECT_EQ(kinds.size(), tasks::all_kinds().size());
  for (const char* name :
       {"release_time_share", "power_2_8_Hz", "enslaving", "coflexion", "pauses", "direction_error",
        "early_rate", "opening_force", "endurance", "throughput", "median_completion_time"})
    EXPECT_TRUE(names.contains(name)) << name << " was not emitted, so nothing was proved of it";
}

TEST(MeasureWords, EveryMeasureWithoutATaskHasWords) {
  const auto measures = tasks::score_pairs(
      Signals({"t_s", "target_force_N", "actual_force_N", "actual_x_m", "actual_y_m"}));
  ASSERT_FALSE(measures.empty());
  for (const Measure& measure : test::every(measures))
    EXPECT_NE(english(tasks::words_of(measure.name, "").title), own_name(measure.name));
}

TEST(MeasureWords, NoTwoMeasuresOfATaskHaveTheSameTitle) {
  for (const Emitted& task : test::every(emitted())) {
    std::set<std::string> titles;
    for (const Measure& measure : test::every(task.measures)) {
      const std::string title = english(tasks::words_of(measure.name, measure.channel).title);
      EXPECT_TRUE(titles.insert(title).second)
          << title << ", kind " << task.spec.kind->name << ", channel " << measure.channel;
    }
  }
}

TEST(MeasureWords, NoResearchMeasureHasAPlaceInTheReport) {
  for (const Emitted& task : test::every(emitted()))
    for (const Measure& measure : test::every(task.measures)) {
      const tasks::Place place = tasks::place_of(task.spec, measure.name, measure.channel);
      EXPECT_TRUE(place.prominence == tasks::Prominence::none ||
                  tasks::words_of(measure.name, measure.channel).clinical)
          << measure.name;
    }
  for (const char* name : {"sample_entropy", "power_0.1_0.3_Hz", "throughput", "ldlj", "t63"})
    EXPECT_FALSE(tasks::words_of(name, "").clinical) << name;
  EXPECT_FALSE(tasks::words_of("a_measure_of_tomorrow", "").clinical);
}

TEST(MeasureWords, EveryForceTaskThatIsScoredShowsATrend) {
  for (const Emitted& task : test::every(emitted())) {
    if (task.measures.empty() || task.spec.kind->research) continue;
    bool shown = false;
    for (const Measure& measure : task.measures)
      shown = shown || tasks::place_of(task.spec, measure.name, measure.channel).prominence !=
                           tasks::Prominence::none;
    EXPECT_TRUE(shown) << "kind " << task.spec.kind->name;
  }
}

TEST(MeasureWords, TimesThatMayBeLongerThanTheLimitAreCensored) {
  for (const char* name : {"reaction_time", "settling_time", "release_time", "endurance",
                           "release_initiation", "completion_time"})
    EXPECT_TRUE(tasks::words_of(name, "").censored) << name;
  // These have a value whatever happens: nothing is hidden in them.
  for (const char* name : {"release_time_share", "release_time_restricted", "residual_force"})
    EXPECT_FALSE(tasks::words_of(name, "").censored) << name;
}

TEST(MeasureWords, ReleasesCompletedAreReadBeforeTheirTime) {
  const tasks::TaskSpec spec = spec_of(tasks::GripReleaseSpec{});
  const tasks::Place share = tasks::place_of(spec, "release_time_share", "grip");
  const tasks::Place time = tasks::place_of(spec, "release_time", "grip");
  EXPECT_EQ(share.prominence, tasks::Prominence::key);
  EXPECT_EQ(time.prominence, tasks::Prominence::key);
  EXPECT_LT(share.rank, time.rank);
}

TEST(MeasureWords, ATitleSaysTheChannel) {
  const auto title = [](const char* name, const char* channel) {
    return english(tasks::words_of(name, channel).title);
  };
  EXPECT_EQ(title("maximum_force", "grip"), "Maximum grip above rest");
  EXPECT_EQ(title("maximum_force", "thumb"), "Maximum force above rest, thumb");
  EXPECT_EQ(title("maximum_force", "pinch"), "Maximum force above rest, thumb and index");
  EXPECT_EQ(title("maximum_force", "opening"), "Maximum force above rest, opening");
  EXPECT_EQ(title("maximum_force", "index_opening"), "Maximum force above rest, index opening");
  EXPECT_EQ(title("maximum_force", "thumb_-x"), "Maximum force above rest, thumb toward -x");
  EXPECT_EQ(title("opening_force", "opening"), "Opening force");
  EXPECT_EQ(title("cv", "force_25_percent"), "Unsteadiness (CV) at 25 %");
  EXPECT_EQ(title("cv", "force_2.5_N"), "Unsteadiness (CV) at 2.5 N");
  EXPECT_EQ(title("gain", "force_0.2_Hz"), "Gain at 0.2 Hz");
  EXPECT_EQ(title("gain", "force"), "Gain");
  EXPECT_EQ(title("rmse", "force_fall"), "Tracking error (RMS), letting down");
  EXPECT_EQ(title("enslaving", "thumb_to_index"),
            "Force of a digit that was not asked, index while thumb presses");
  EXPECT_EQ(title("completion_time", "target_5"), "Time to reach target 5");
  EXPECT_EQ(title("resting_force", "thumb_fz"), "Resting force, thumb fz");
  EXPECT_EQ(title("rmse", "x"), "Tracking error (RMS), x");
  EXPECT_EQ(title("rmse", "rz"), "Tracking error (RMS), turn about z");
}

TEST(MeasureWords, ErrorsOfSizesGrowWithTheirMeanThoseOfSharesAndSignedOnesDoNot) {
  for (const char* size : {"maximum_force", "rmse", "relative_rmse", "cv", "release_time"})
    EXPECT_TRUE(tasks::words_of(size, "grip").error_grows) << size;
  for (const char* steady : {"time_in_range", "release_time_share", "targets_reached", "lag",
                             "constant_error", "individuation_index", "sparc", "resting_force",
                             "pauses", "anticipations", "drops", "net_push_time", "slip"})
    EXPECT_FALSE(tasks::words_of(steady, "grip").error_grows) << steady;
}

}  // namespace
}  // namespace isograsp::reports::measure_words_test
