// SPDX-License-Identifier: GPL-3.0-or-later
// What a report says of an arm beside its measures: postures that were not reached are counted, not
// left out of the median, and a body that helps is said.
#include "reports/findings/arm_findings.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "hand/arm_columns.hpp"
#include "tasks/task_progress.hpp"
#include "tests/support/must.hpp"

namespace isograsp::reports::arm_findings_test {
namespace {

TaskSection matching_section() {
  TaskSection section;
  section.spec = test::must(tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Turn\"\ninstruction = \"Turn it.\"\n"
      "kind = \"pose_matching\"\npostures = \"screw\"\nsequence = [\"screw\", \"initial\"]\n"
      "repeats = 2\nhold_s = 0.3\ntime_limit_s = 15\n",
      "turn.toml"));
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

TEST(PostureLines, CountWhatWasNotReachedAndPutItBehindTheLimit) {
  const StoredTrial one = trial_with({2.0, 4.0, -1.0, 4.0});
  const StoredTrial two = trial_with({3.0, -1.0, 7.0, -1.0});
  const auto lines = said(posture_lines(matching_section(), {&one, &two}));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "Tolerance 15 mm and 10°, held for 0.3 s");
  // 2, 3, 7 and one beyond the limit: the middle is between 3 and 7.
  EXPECT_EQ(lines[1], "screw: reached 3 of 4, median 5.0 s");
  EXPECT_EQ(lines[2], "initial: reached 2 of 4, median longer than 15 s")
      << "half of them never came: the median of the others would hide that";
}

TEST(PostureLines, AreOfTasksWithPosturesOnly) {
  TaskSection section;
  EXPECT_TRUE(posture_lines(section, {}).empty());
  EXPECT_TRUE(compensation_lines(section).empty());
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

constexpr int kRows = 200;
constexpr double kStep_s = 0.01;

/// One movement of two seconds in which the elbow goes so far beside a brace that stands still.
TaskSection section_with(double elbow_m, double brace_m, bool trunk) {
  TaskSection section = matching_section();
  DrawnTrial drawn;
  std::vector<double> t_s, phase, index, matched, way;
  for (int row = 0; row < kRows; ++row) {
    t_s.push_back(kStep_s * row);
    phase.push_back(
        static_cast<double>(row < kRows - 1 ? tasks::Phase::transport : tasks::Phase::active));
    index.push_back(0.0);
    matched.push_back(row < kRows - 1 ? 0.0 : 1.0);
    way.push_back(0.5 - 0.5 * std::cos(3.141592653589793 * row / (kRows - 1)));
  }
  drawn.curves.add_column(columns::t_s, t_s);
  drawn.curves.add_column(columns::phase, phase);
  drawn.curves.add_column(columns::target_index, index);
  drawn.curves.add_column(columns::matched, matched);
  for (std::size_t s = 0; s < kArmSegmentCount; ++s) {
    const auto segment = static_cast<ArmSegment>(s);
    if (segment == ArmSegment::trunk && !trunk) continue;
    const columns::OfSegment& names = columns::segment_pose[s];
    const double far_m = segment == ArmSegment::elbow   ? elbow_m
                         : segment == ArmSegment::brace ? brace_m
                                                        : 0.0;
    std::vector<double> x = way;
    for (double& value : x) value *= far_m;
    drawn.curves.add_column(names.position[0], x);
    for (std::size_t a = 1; a < 3; ++a)
      drawn.curves.add_column(names.position[a], std::vector<double>(kRows, 0.0));
    for (std::size_t i = 0; i < 4; ++i)
      drawn.curves.add_column(names.attitude[i], std::vector<double>(kRows, i == 0 ? 1.0 : 0.0));
  }
  section.last = std::move(drawn);
  return section;
}

TEST(CompensationLines, SayThatTheUpperArmOrTheDeviceMovedAndThatNoTrunkWasMeasured) {
  EXPECT_TRUE(compensation_lines(section_with(0.01, 0.0, true)).empty());
  EXPECT_EQ(said(compensation_lines(section_with(0.01, 0.0, false))),
            std::vector<std::string>{"Trunk not measured"});
  EXPECT_EQ(said(compensation_lines(section_with(0.03, 0.0, true))),
            std::vector<std::string>{"Upper arm moved in 1 of 1 movements of the last trial: the "
                                     "turn of the forearm contains its own"});
  EXPECT_EQ(said(compensation_lines(section_with(0.01, 0.01, true))),
            std::vector<std::string>{"The brace moved in the last trial: set it up anew, these "
                                     "results are in doubt"});
}

}  // namespace
}  // namespace isograsp::reports::arm_findings_test
