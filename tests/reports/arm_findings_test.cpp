// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says of an arm beside its measures: postures that were not reached are counted, not
// left out of the median, and a body that helps is said.
#include "reports/findings/arm_findings.hpp"

#include <gtest/gtest.h>

#include "hand/arm_columns.hpp"
#include "kinematics/bands.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"
#include "tests/reports/arm_trial.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"

namespace isograsp::reports::arm_findings_test {
namespace {

TaskSection matching_section() {
  TaskSection section;
  section.spec = test::must(tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Turn\"\ninstruction = \"Turn it.\"\n"
      "kind = \"pose_matching\"\npostures = \"screw\"\nsequence = [\"screw\", \"initial\"]\n"
      "repeats = 3\nhold_s = 0.3\ntime_limit_s = 15\n",
      "turn.toml"));
  return section;
}

/// A trial of it as the report reads it.
TaskSection section_of(const test::ArmTrial& trial) {
  TaskSection section = matching_section();
  add_poses(section, test::signals_of(trial));
  return section;
}

/// Times of the four targets; negative: not reached.
StoredTrial trial_with(const std::vector<double>& times_s) {
  StoredTrial trial;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    Measure measure;
    measure.name = "completion_time";
    measure.channel = "target_" + std::to_string(i + 1);
    if (times_s[i] >= 0.0) measure.value = times_s[i];
    trial.measures.push_back(measure);
  }
  return trial;
}

std::vector<std::string> said(const std::vector<Text>& lines) {
  std::vector<std::string> all;
  for (const Text& line : lines) all.push_back(english(line));
  return all;
}

TEST(PostureResults, CountWhatWasNotReachedAndPutItBehindTheLimit) {
  const StoredTrial one = trial_with({2.0, 4.0, -1.0, 4.0});
  const StoredTrial two = trial_with({3.0, -1.0, 7.0, -1.0});
  const auto results = posture_results(matching_section(), {&one, &two});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].name, "screw");
  EXPECT_EQ(results[0].reached, 3);
  EXPECT_EQ(results[0].asked, 4);
  // 2, 3, 7 and one beyond the limit: the middle is between 3 and 7.
  EXPECT_EQ(results[0].median_s, 5.0);
  EXPECT_EQ(results[1].name, "initial");
  EXPECT_EQ(results[1].reached, 2);
  EXPECT_FALSE(results[1].median_s)
      << "half of them never came: the median of the others would hide that";
}

TEST(PostureResults, AreOfTasksWithPosturesOnly) {
  TaskSection section;
  EXPECT_TRUE(posture_results(section, {}).empty());
  EXPECT_TRUE(tolerance_words(section).empty());
  EXPECT_TRUE(compensation_lines(section).empty());
}

TEST(ToleranceWords, SayWithinWhatAPostureCountsAsReached) {
  EXPECT_EQ(english(tolerance_words(matching_section())),
            "Tolerance 15 mm and 10°, held for 0.3 s");
}

TEST(SharingLines, NameTheLinksInTheOrderInWhichTheyBeganAndKeepRecognitionApart) {
  StoredTrial trial;
  const auto add = [&](const char* name, const char* channel, double value) {
    Measure measure;
    measure.name = name;
    measure.channel = channel;
    measure.value = value;
    trial.measures.push_back(measure);
  };
  add("recognition_time", "object", 0.61);
  add("movement_time", "object", 1.42);
  add("rotation_t10", "forearm", 0.75);
  add("rotation_t10", "fingers", 0.5);
  add("relative_rotation", "forearm", 0.63);
  add("relative_rotation", "fingers", 0.2);
  EXPECT_EQ(
      said(sharing_lines(matching_section(), {&trial})),
      (std::vector<std::string>{
          "Last trial: recognition 0.6 s, then movement 1.4 s",
          "Turned first to last (a tenth of the turn after the cue): fingers 0.50 s, forearm "
          "0.75 s",
          "Share of the turn when the forearm had 63 % of its own: forearm 63\u00a0%, fingers "
          "20\u00a0%"}));
}

TEST(LastPoses, GiveEachPostureItsErrorItsTurnAndHowLongTheObjectWasNotSeen) {
  test::ArmTrial trial;
  trial.off_m = 0.004;
  trial.unseen_s = 0.08;  // longer than what a pose may stand in for, shorter than a gap
  TaskSection section = section_of(trial);
  section.postures = {{"screw", 3, 3, 1.0, {}, {}, {}, {}}, {"initial", 3, 3, 1.0, {}, {}, {}, {}}};
  finish_postures(section);
  constexpr double kRounding = 1e-9;
  for (const PostureResult& posture : test::every(section.postures)) {
    ASSERT_TRUE(posture.position_error_m && posture.rotation_rad && posture.unseen);
    EXPECT_NEAR(*posture.position_error_m, trial.off_m, kRounding);
    EXPECT_NEAR(*posture.angle_error_rad, 0.0,
                0.001);  // it is shown as reached while it still turns
    // The entry is where the object is within 10 degrees.
    EXPECT_NEAR(*posture.rotation_rad, trial.turn_rad - 0.17453292519943295, 0.01);
    EXPECT_GT(*posture.unseen, 0.03) << "of some two seconds";
    EXPECT_LT(*posture.unseen, 0.06);
  }
}

TEST(LastPoses, OfATrialWithoutReferencesAreNoMovements) {
  TaskSection section = matching_section();
  Signals nothing;
  nothing.add_column(columns::t_s, {0.0, 0.01});
  add_poses(section, nothing);
  section.postures = {{"screw", 1, 0, {}, {}, {}, {}, {}}};
  finish_postures(section);
  EXPECT_FALSE(section.postures[0].unseen);
  EXPECT_TRUE(compensation_lines(section).empty());
}

TEST(CompensationLines, SayThatTheUpperArmOrTheDeviceMovedAndThatNoTrunkWasMeasured) {
  const auto lines = [](double elbow_m, double brace_m, bool trunk) {
    test::ArmTrial trial;
    trial.elbow_m = elbow_m;
    trial.brace_m = brace_m;
    trial.trunk = trunk;
    TaskSection section = section_of(trial);
    return said(compensation_lines(section));
  };
  EXPECT_TRUE(lines(0.01, 0.0, true).empty());
  EXPECT_EQ(lines(0.01, 0.0, false), std::vector<std::string>{"Trunk not measured"});
  EXPECT_EQ(lines(0.03, 0.0, true),
            std::vector<std::string>{"Upper arm moved in 6 of 6 movements of the last session: the "
                                     "turn of the forearm contains its own"});
  EXPECT_EQ(lines(0.01, 0.01, true),
            std::vector<std::string>{"The brace moved in the last session: set it up anew, these "
                                     "results are in doubt"});
}

TEST(PosturesPanel, HasARowForEachPostureAndTheTurnsOfThoseWithThreeMovements) {
  TaskSection section = section_of(test::ArmTrial{});
  section.postures = {{"screw", 3, 3, 1.3, {}, {}, {}, {}}, {"initial", 3, 1, {}, {}, {}, {}, {}}};
  finish_postures(section);
  const auto panel = postures_panel(section, kEnglish);
  ASSERT_TRUE(panel && panel->table);
  ASSERT_EQ(panel->table->rows.size(), 2u);
  EXPECT_EQ(panel->table->rows[0][1], "3 of 3");
  EXPECT_EQ(panel->table->rows[0][2], "1.3 s");
  EXPECT_EQ(panel->table->rows[1][2], "longer than 15 s");
  EXPECT_EQ(panel->plots.size(), 3u) << "two postures and the dots";
  EXPECT_EQ(postures_with_band(section), (std::vector<std::string>{"screw", "initial"}));

  test::ArmTrial short_one;
  short_one.targets = 5;
  TaskSection shorter = section_of(short_one);
  EXPECT_EQ(postures_with_band(shorter), std::vector<std::string>{"screw"})
      << "two movements have no spread worth a band";
}

TEST(PosturesPanel, TakesTheTrialsOfASessionTogether) {
  test::ArmTrial pair;
  pair.targets = 2;
  TaskSection section = section_of(pair);
  EXPECT_TRUE(postures_with_band(section).empty());
  add_poses(section, test::signals_of(pair));
  add_poses(section, test::signals_of(pair));
  EXPECT_EQ(postures_with_band(section), (std::vector<std::string>{"screw", "initial"}));
  // Three times the same movement: all of its curves lie on each other.
  const auto bands =
      movement_bands(section.poses->rig, section.poses->series, section.poses->movements);
  ASSERT_TRUE(bands);
  constexpr double kRounding = 1e-9;
  int compared = 0;
  for (const BandPoint& point : *bands) {
    if (point.n < 3) continue;
    EXPECT_NEAR(*point.sd, 0.0, kRounding) << point.channel << " " << point.tau;
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(PosturesPanel, IsNotThereForOtherTasks) {
  EXPECT_FALSE(postures_panel(TaskSection{}, kEnglish));
}

}  // namespace
}  // namespace isograsp::reports::arm_findings_test
