// SPDX-License-Identifier: GPL-3.0-or-later
// What is alike but for the last bits of computed numbers is alike: trials that are drawn as best
// and worst, conditions under which trials may be compared.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "kinematics/pose_task.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/task_section.hpp"

namespace isograsp::reports::alike_test {
namespace {

double next(double value) {
  return std::nextafter(value, HUGE_VAL);
}

TEST(Extremes, TrialsThatAreAlikeButForTheLastBitAreNeitherBestNorWorst) {
  const auto file =
      std::filesystem::path(ISOGRASP_SOURCE_DIR) / "library" / "tasks" / "grip_sine.toml";
  const auto text = read_text(file);
  ASSERT_TRUE(text);
  storage::SessionRecord session;
  std::vector<StoredTrial> trials(4);
  std::vector<const StoredTrial*> all;
  for (auto& one : trials) {
    one.session_record = &session;
    one.trial.task_text = *text;
    one.trial.status = storage::TrialStatus::completed;
    Measure error;
    error.name = "relative_rmse";
    error.channel = "force";
    error.value = 12.0;
    one.measures.push_back(error);
    all.push_back(&one);
  }
  TaskSection section;
  section.spec = tasks::parse_task(*text, file).value();
  MeasureSeries series;
  series.name = "relative_rmse";
  series.channel = "force";
  series.key = true;
  section.series.push_back(series);
  trials[2].measures[0].value = next(12.0);
  EXPECT_EQ(extremes_of(section, all).best, nullptr);
  trials[0].measures[0].value = next(next(12.0));
  trials[3].measures[0].value = 13.0;
  EXPECT_EQ(extremes_of(section, all).best, &trials[0]) << "the oldest of the best";
  EXPECT_EQ(extremes_of(section, all).worst, &trials[3]);
}

TEST(Conditions, DifferByMoreThanTheLastBitOfADelay) {
  Conditions one;
  one.rate_Hz = 100.0;
  one.device_delay_s = 0.1 + 0.2;
  one.display_delay_s = 0.03;
  Conditions other = one;
  other.rate_Hz = next(100.0);
  other.device_delay_s = 0.3;
  other.display_delay_s = next(0.03);
  EXPECT_EQ(english(difference(one, other)), "");
  other.display_delay_s = 0.0301;
  EXPECT_EQ(english(difference(one, other)), "other delay of the display");
  other.display_delay_s.reset();
  EXPECT_EQ(english(difference(one, other)), "other delay of the display");
  other = one;
  other.device_delay_s = 0.301;
  EXPECT_EQ(english(difference(one, other)), "other filter delay of the device");
}

/// A trial of an arm whose references, adapted to it, are those of `postures` moved by `x_m`.
StoredTrial arm_trial(const storage::SessionRecord& session, const std::string& postures,
                      double x_m) {
  StoredTrial trial;
  trial.session_record = &session;
  trial.trial.task_text =
      read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/arm_screw.toml").value();
  PoseTask task;
  task.frame = "object";
  task.postures_hash = postures;
  task.references = {{"turned", {Vec3(x_m, 0.0, 0.0), Quat::Identity()}}};
  task.targets = {0};
  task.position_tolerance_m = task.angle_tolerance_rad = 0.1;
  task.time_limit_s = 10.0;
  trial.trial.scene_text = pose_task_text(task);
  return trial;
}

TEST(Conditions, OfAnArmReferencesMayBeAdaptedToEachDayButRigAndPosturesStayTheSame) {
  storage::SessionRecord session;
  session.calibration = "format = \"isograsp-rig-1\"\n";
  const StoredTrial first = arm_trial(session, "0a1b", 0.1);
  EXPECT_EQ(english(difference(first, arm_trial(session, "0a1b", 0.2))), "");
  EXPECT_EQ(english(difference(first, arm_trial(session, "2c3d", 0.1))), "other postures");
  storage::SessionRecord other = session;
  other.calibration += "name = \"another\"\n";
  EXPECT_EQ(english(difference(first, arm_trial(other, "0a1b", 0.1))), "other rig of markers");
  EXPECT_FALSE(pool_query(first, {}).scene_text) << "the reader compares what references come from";
}

TEST(Conditions, OfATrackedHandServiceMountingAndDelayAreTheSameAndHelpIsATaskOfItsOwn) {
  storage::SessionRecord session;
  session.calibration =
      "format = \"isograsp-tracker-1\"\ntracker = \"leap\"\nservice = \"6.1\"\nmounting = "
      "\"desk\"\ndelay = 12 # ms\n";
  StoredTrial first;
  first.session_record = &session;
  first.trial.task_text =
      read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/virtual_place.toml").value();
  StoredTrial second = first;
  EXPECT_EQ(english(difference(first, second)), "");
  for (const auto& [was, is] : {std::pair{"6.1", "6.2"}, {"desk", "screen"}, {"12", "20"}}) {
    storage::SessionRecord other = session;
    other.calibration.replace(other.calibration.find(was), std::string(was).size(), is);
    second.session_record = &other;
    EXPECT_EQ(english(difference(first, second)), "other tracker, mounting or delay") << is;
  }
  second.session_record = &session;
  const auto help = second.trial.task_text.find("assistance = \"off\"");
  second.trial.task_text.replace(help, std::string("assistance = \"off\"").size(),
                                 "assistance = \"full\"");
  EXPECT_EQ(english(difference(first, second)), "other task parameters");
}

TEST(Conditions, OfForcesTheSceneDecidesAndTheCalibrationOfTheSensorsDoesNot) {
  storage::SessionRecord session;
  session.calibration = "one calibration";
  storage::SessionRecord later = session;
  later.calibration = "the next one";
  StoredTrial first = arm_trial(session, "", 0.1);
  first.trial.task_text =
      read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/free_handling.toml").value();
  StoredTrial second = first;
  second.session_record = &later;
  EXPECT_EQ(english(difference(first, second)), "");
  second.trial.scene_text += "# another object\n";
  EXPECT_EQ(english(difference(first, second)), "other object or scene");
  EXPECT_EQ(pool_query(first, {}).scene_text, first.trial.scene_text);
}

}  // namespace
}  // namespace isograsp::reports::alike_test
