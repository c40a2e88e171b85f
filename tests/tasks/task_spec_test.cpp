// SPDX-License-Identifier: GPL-3.0-or-later
// Task and protocol files: what is accepted, and what each mistake is told.
#include <numbers>

#include <gtest/gtest.h>

#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/protocol.hpp"

namespace isograsp::tasks::task_spec_test {
namespace {

std::string task_text(const std::string& rest) {
  return "format = \"isograsp-task-1\"\nname = \"n\"\ninstruction = \"i\"\n" + rest;
}

TEST(TaskSpec, DegreesInTheFileAreRadiansInside) {
  const auto task = parse_task(
      task_text("kind = \"pose_targets\"\nscene = \"s\"\nposition_tolerance_m = 0.03\n"
                "angle_tolerance_deg = 15\ntime_limit_s = 20\n"
                "[[target]]\nposition_m = [1, 2, 3]\nangle_deg = 90\nhold_s = 1\nlevel = true\n"),
      "t.toml");
  ASSERT_TRUE(task) << task.error().message();
  const auto& poses = task->kind.as<PoseTargetsSpec>();
  EXPECT_DOUBLE_EQ(poses.angle_tolerance_rad, std::numbers::pi / 12);
  EXPECT_DOUBLE_EQ(poses.targets[0].angle_rad, std::numbers::pi / 2);
  EXPECT_EQ(poses.targets[0].p_WT, Vec3(1, 2, 3));
  EXPECT_EQ(poses.targets[0].hold_s, 1.0);
  EXPECT_TRUE(poses.targets[0].level);
  EXPECT_EQ(task->scene(), "s");
  EXPECT_EQ(task->duration().worst_s, 20.0);
  EXPECT_FALSE(task->needs_maximum());
}

TEST(TaskSpec, EveryMistakeNamesLineFieldAndRemedy) {
  const std::pair<std::string, std::string> bad[] = {
      {"kind = \"juggle\"\n",
       "t.toml:4: kind: 'juggle' is not known; write one of: rest, maximum, force_tracking, "
       "pose_targets, observe, directional_maxima, steadiness, step_response, grip_release, "
       "force_sense, fatigue, individuation, force_direction, pose_tracking, pick_place, "
       "hand_opening, "
       "virtual_pick_place, bilateral_rest, bilateral_maximum, bilateral_tracking, "
       "bimanual_lift, bimanual_pick_place, mirror, "
       "active_range, pose_matching, pose_following, drinking, recorded"},
      {"kind = \"rest\"\nduration = 3\n",
       "t.toml:5: duration: unknown key; remove it or correct its spelling"},
      {"kind = \"rest\"\nduration_s = 0\n",
       "t.toml:5: duration_s: 0 is out of range; write a number above 0"},
      {"kind = \"rest\"\nduration_s = \"long\"\n",
       "t.toml:5: duration_s: is text, not a finite number; write a number"},
      {"kind = \"rest\"\nversion = 0\n",
       "t.toml:5: version: 0 is out of range; write a whole number from 1 to "
       "1000000"},
      {"kind = \"maximum\"\nsqueeze_s = 1\nwindow_s = 2\n",
       "t.toml:6: window_s: is longer than squeeze_s; make it shorter"},
      {"kind = \"force_tracking\"\nleast_fraction = 0.3\nmost_fraction = 0.3\n",
       "t.toml:6: most_fraction: is not above the least level; write a larger number"},
      {"kind = \"force_tracking\"\nfrequency_Hz = 50\n",
       "t.toml:5: frequency_Hz: 50 is out of range; write a number from 0.001 to 5"},
      {"kind = \"force_tracking\"\nforms = 0\n",
       "t.toml:5: forms: 0 is out of range; write a whole number from 1 to 100"},
      {"kind = \"force_tracking\"\nwaveform = \"swept_sine\"\nforms = 2\n",
       "t.toml:6: forms: unknown key; remove it or correct its spelling"},
      {"kind = \"force_tracking\"\nmost_fraction = 1.5\n",
       "t.toml:5: most_fraction: 1.5 is out of range; write a number from -1 to 1"},
      {"kind = \"active_range\"\nlink = \"wrist\"\nangle = 2.5\n",
       "t.toml:6: angle: is a number, not an integer; write a whole number"},
      {"kind = \"pose_matching\"\nown_range = \"forearm\"\nown_angle = 4\nsequence = [\"least\"]\n",
       "t.toml:6: own_angle: 4 is out of range; write a whole number from 1 to 3"},
      {"kind = \"pose_matching\"\nown_range = \"nose\"\nown_angle = 1\nsequence = [\"least\"]\n",
       "t.toml:5: own_range: 'nose' is not known; write one of: forearm, wrist, fingers"},
      {"kind = \"pose_matching\"\nown_range = \"wrist\"\nown_angle = 1\npostures = \"screw\"\n"
       "sequence = [\"least\"]\n",
       "t.toml:7: postures: stands beside own_range; leave one of them out"},
      {"kind = \"pose_targets\"\nscene = \"s\"\n",
       "t.toml:1: target: is missing; add at least one [[target]]"},
      {"kind = \"pose_targets\"\nscene = \"a/b\"\n[[target]]\nposition_m = [0, 0, 0]\n",
       "t.toml:5: scene: 'a/b' is not the name of a scene; write the name of its file without "
       "folder and ending, e.g. \"planar_block\""},
      {"kind = \"pose_targets\"\nscene = \"s\"\ntime_limit_s = 1\n[[target]]\n"
       "position_m = [0, 0, 0]\nhold_s = 1\n",
       "t.toml:9: target[1].hold_s: leaves no time within time_limit_s; make it shorter"},
      {"kind = \"pose_tracking\"\n[[axis]]\ndof = \"x\"\nleast_m = 0\nmost_m = 0.1\nwaveform = "
       "\"sine\"\n"
       "period_s = 2\n",
       "t.toml:1: scene: is missing; add it"},
      {"kind = \"observe\"\nscene = \"a/b\"\n",
       "t.toml:5: scene: 'a/b' is not the name of a scene; write the name of its file without "
       "folder and ending, e.g. \"planar_block\""},
  };
  for (const auto& [text, message] : bad) {
    const auto task = parse_task(task_text(text), "t.toml");
    ASSERT_FALSE(task) << text;
    EXPECT_EQ(task.error().message(), message);
    EXPECT_EQ(task.error().code, Error::Code::bad_input);
  }
}

TEST(TaskSpec, AnotherFormatIsRefused) {
  EXPECT_FALSE(parse_task("format = \"isograsp-task-2\"\nkind = \"rest\"\n", "t.toml"));
  EXPECT_FALSE(parse_protocol(task_text("kind = \"rest\"\n"), "t.toml"));
}

TEST(ProtocolSpec, StepsKeepTheirOrderAndTheirOwnSettings) {
  const auto protocol = parse_protocol(
      "format = \"isograsp-protocol-1\"\nname = \"p\"\n[[step]]\nkind = \"instrument_zero\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"a.toml\"\nrepetitions = 3\npractice = true\n"
      "rest_s = 60\n",
      "p.toml");
  ASSERT_TRUE(protocol) << protocol.error().message();
  ASSERT_EQ(protocol->steps.size(), 2u);
  EXPECT_EQ(protocol->steps[0].kind, ProtocolStep::Kind::instrument_zero);
  EXPECT_EQ(protocol->steps[1].tasks, std::vector<std::string>{"a.toml"});
  EXPECT_EQ(protocol->steps[1].repetitions, 3);
  EXPECT_TRUE(protocol->steps[1].practice);
  EXPECT_EQ(protocol->steps[1].rest_s, 60.0);
}

TEST(ProtocolSpec, ABoutIsAllOfTheWorkAndRestsAsAfterEachAttemptWhereNothingElseIsSaid) {
  const auto bouts_of = [](const std::string& keys) {
    const auto protocol = parse_protocol(
        "format = \"isograsp-protocol-1\"\nname = \"p\"\n[[step]]\nkind = \"task\"\n"
        "task = \"a.toml\"\nrest_s = 10\n" +
            keys,
        "p.toml");
    EXPECT_TRUE(protocol) << protocol.error().message();
    return protocol->steps[0].bouts;
  };
  EXPECT_FALSE(bouts_of(""));
  const auto plain = bouts_of("work_s = 900\n");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->bout_s, 900.0);
  EXPECT_EQ(plain->rest_s, 10.0);
  const auto whole = bouts_of("work_s = 900\nbout_s = 180\nbout_rest_s = 60\n");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->work_s, 900.0);
  EXPECT_EQ(whole->bout_s, 180.0);
  EXPECT_EQ(whole->rest_s, 60.0);
}

TEST(ProtocolSpec, EveryMistakeNamesLineFieldAndRemedy) {
  const std::string head = "format = \"isograsp-protocol-1\"\nname = \"p\"\n";
  const std::pair<std::string, std::string> bad[] = {
      {"", "p.toml:1: step: is missing; add at least one [[step]]"},
      {"[[step]]\nkind = \"task\"\n", "p.toml:3: step[1].task: is missing; add it"},
      {"[[step]]\nkind = \"task\"\ntask = \"../a.toml\"\n",
       "p.toml:5: step[1].task: '../a.toml' is not the name of a task file; write the file name "
       "without folder, e.g. \"grip_sine.toml\""},
      {"[[step]]\nkind = \"task\"\ntask = \"a\"\nrepetitions = 0\n",
       "p.toml:6: step[1].repetitions: 0 is out of range; write a whole number from 1 to 100"},
      {"[[step]]\nkind = \"task\"\ntask = \"a\"\nrest_s = -1\n",
       "p.toml:6: step[1].rest_s: -1 is out of range; write a number from 0 to 3600"},
      {"[[step]]\nkind = \"task\"\ntask = \"a\"\nrepetitions = 2\nagree_measure = \"x\"\nwork_s = "
       "60\n",
       "p.toml:8: step[1].work_s: stands beside agree_measure; leave out one of the two"},
      {"[[step]]\nkind = \"task\"\ntask = \"a\"\nrest_s = 10\nwork_s = 60\nbout_rest_s = 9\n",
       "p.toml:8: step[1].bout_rest_s: is below rest_s; write a larger number"},
      {"[[step]]\nkind = \"task\"\ntask = \"a\"\nbout_s = 60\n",
       "p.toml:6: step[1].bout_s: unknown key; remove it or correct its spelling"},
      {"[[step]]\nkind = \"instrument_zero\"\ntask = \"a\"\n",
       "p.toml:5: step[1].task: unknown key; remove it or correct its spelling"},
  };
  for (const auto& [text, message] : bad) {
    const auto protocol = parse_protocol(head + text, "p.toml");
    ASSERT_FALSE(protocol) << text;
    EXPECT_EQ(protocol.error().message(), message);
  }
}

}  // namespace
}  // namespace isograsp::tasks::task_spec_test
