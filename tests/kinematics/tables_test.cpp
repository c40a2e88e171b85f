// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <gtest/gtest.h>

#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::tables_test {
namespace {

using namespace isograsp::test;

Rig one_frame() {
  Rig rig;
  rig.frames = {{"b", PointsFrame()}};
  return rig;
}
const std::string kHeader =
    "t_s,b_x_m,b_y_m,b_z_m,b_qw,b_qx,b_qy,b_qz,b_residual_m,b_used,b_state\n";

TEST(PoseTable, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const Rig rig = one_frame();
  auto writer = must(PoseWriter::create(folder.path("p.csv"), rig, Hand::left));
  const FramePose pose{FrameState::ok, 3, std::nullopt, 0.0, {Vec3(1, 2, 3), Quat(0.6, 0, 0.8, 0)}};
  writer.write(0.0, std::array{pose});
  writer.write(0.01, std::array{FramePose()});
  must(writer.commit());
  EXPECT_EQ(read_file(folder.path("p.csv")), "# hand: left\n" + kHeader +
                                                 "0,1,2,3,0.6,0,0.8,0,0,3,ok\n"
                                                 "0.01,,,,,,,,,0,missing\n");
  const PoseSeries series = must(read_poses(folder.path("p.csv")));
  EXPECT_EQ(series.t_s, (std::vector<double>{0.0, 0.01}));
  EXPECT_EQ(series.X_W[0][0].p, pose.X_W.p);
  EXPECT_TRUE(is_missing(series.X_W[0][1]));
}

TEST(PoseTable, WithoutCommitNothingIsLeft) {
  const TemporaryFolder folder;
  const Rig rig = one_frame();
  {
    auto writer = must(PoseWriter::create(folder.path("p.csv"), rig, Hand::right));
    writer.write(0.0, std::array{FramePose()});
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(PoseTable, BadRowsAreRefusedWithFileLineAndColumn) {
  const TemporaryFolder folder;
  const auto message = [&folder](const std::string& text) {
    const auto read = read_poses(folder.write("p.csv", text));
    return read ? std::string("was read") : read.error().message();
  };
  const std::string good = "0,1,2,3,1,0,0,0,0,3,ok\n";
  for (const auto& [text, expected] :
       {std::pair(kHeader + good + "0.01,1,,3,1,0,0,0,0,3,ok\n", ":3: b_x_m: a part of the pose"),
        {kHeader + good + "0.01,1,2,3,0,0,0,0,0,3,ok\n", ":3: b_qw: is no attitude"},
        {kHeader + good + "0.01,1,two,3,1,0,0,0,0,3,ok\n", ":3: b_y_m: 'two' is not"},
        {kHeader + good + "0.01,1,nan,3,1,0,0,0,0,3,ok\n", ":3: b_y_m: 'nan' is not"},
        {kHeader + good + good, ":3: t_s: time does not increase"},
        {kHeader + good + "0.01,1\n", ":3: the line has 2 fields"},
        {"t_s,b_x_m,b_y_m\n0,1,2\n", ":1: b_x_m: column 'b_z_m'"},
        {"t_s,other\n0,1\n", ":1: other: begins no pose"},
        {"time,b_x_m\n0,1\n", ":1: time: the first column"},
        {kHeader, ": holds no row"}})
    EXPECT_NE(message(text).find(expected), std::string::npos) << message(text);
}

TEST(TargetTable, IsReadWithEmptyMatchesAsNotReached) {
  const TemporaryFolder folder;
  const std::string header =
      "posture,cue_s,matched_s,ref_x_m,ref_y_m,ref_z_m,ref_qw,ref_qx,ref_qy,ref_qz\n";
  const auto targets = must(read_pose_targets(
      folder.write("e.csv", header + "screw,1,2.5,1,2,3,2,0,0,0\nscrew,4,,1,2,3,1,0,0,0\n")));
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(*targets[0].matched_s, 2.5);
  EXPECT_EQ(targets[0].X_WR.q.w(), 1.0);
  EXPECT_FALSE(targets[1].matched_s);
  const auto backwards =
      read_pose_targets(folder.write("e.csv", header + "screw,3,2.5,1,2,3,2,0,0,0\n"));
  ASSERT_FALSE(backwards);
  EXPECT_NE(backwards.error().message().find(":2: matched_s"), std::string::npos);
  EXPECT_FALSE(read_pose_targets(folder.write("e.csv", "posture,cue_s\n")));
}

}  // namespace
}  // namespace isograsp::tables_test
