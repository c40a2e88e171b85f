// SPDX-License-Identifier: GPL-3.0-or-later
// What cameras send is judged before it becomes a pose.
#include "kinematics/seen_markers.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "kinematics/arm_frames.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::seen_markers_test {
namespace {

using namespace isograsp::test;

const std::string kRig = R"(format = "isograsp-rig-1"
[[frame]]
name = "body"
method = "cluster"
markers = ["A", "B", "C", "D"]
template_m = [[0, 0, 0], [0.1, 0, 0], [0, 0.07, 0], [0.03, 0.02, 0.05]]
max_residual_m = 0.01
)";
const std::vector<Vec3> kTemplate{{0, 0, 0}, {0.1, 0, 0}, {0, 0.07, 0}, {0.03, 0.02, 0.05}};
const std::vector<std::string> kLabels{"A", "B", "C", "D"};

Rig rig_with(const std::string& more) {
  return must(parse_rig(kRig + more, "r.toml"));
}
std::vector<Vec3> placed(const Pose& X_WB) {
  std::vector<Vec3> p_W;
  for (const Vec3& p : kTemplate) p_W.push_back(X_WB.p + X_WB.q * p);
  return p_W;
}
FramePose solve(ArmFrames& frames, const std::vector<Vec3>& p_W) {
  std::vector<FramePose> solved(frames.frames());
  frames.solve(p_W, solved);
  return solved[0];
}

TEST(Alias, CamerasMayCallMarkersWhatTheyLike) {
  const Rig rig = rig_with("[alias]\n\"hand 1\" = \"A\"\nB = \"C\"\nC = \"B\"\n");
  EXPECT_EQ(must(aliased(rig, std::vector<std::string>{"hand 1", "B", "C", "D", "X"})),
            (std::vector<std::string>{"A", "C", "B", "D", "X"}));
  EXPECT_EQ(rig_text(must(parse_rig(rig_text(rig), "s.toml"))), rig_text(rig));

  Random random(1);
  const Pose X_WB = random_pose(random);
  auto p_W = placed(X_WB);
  std::swap(p_W[1], p_W[2]);
  auto frames = must(ArmFrames::compile(rig, std::vector<std::string>{"hand 1", "B", "C", "D"}));
  const FramePose pose = solve(frames, p_W);
  ASSERT_EQ(pose.state, FrameState::ok);
  EXPECT_WITHIN((pose.X_W.p - X_WB.p).norm(), 0.0, kGoldenPosition_m);
}

TEST(Alias, WhatIsNotClearIsRefused) {
  const auto problem = [](const std::string& more) {
    const auto rig = parse_rig(kRig + more, "r.toml");
    return rig ? std::string() : rig.error().message();
  };
  EXPECT_NE(problem("[alias]\nX = \"Q\"\n").find("alias.X: 'Q' is no marker of this file"),
            std::string::npos)
      << problem("[alias]\nX = \"Q\"\n");
  EXPECT_NE(problem("[alias]\nX = 3\n").find("alias.X"), std::string::npos);
  const auto two = aliased(rig_with("[alias]\nX = \"A\"\n"), std::vector<std::string>{"A", "X"});
  ASSERT_FALSE(two);
  EXPECT_NE(two.error().message().find("two markers 'A'"), std::string::npos);
}

TEST(FrozenMarker, IsMissingOnceItsBodyHasMovedWithoutIt) {
  auto frames = must(ArmFrames::compile(rig_with(""), kLabels));
  const Vec3 stuck = placed({})[3];
  constexpr double kStep_m = 0.001;  // a row
  int frozen_at = -1;
  for (int row = 0; row < 40; ++row) {
    auto p_W = placed({Vec3(kStep_m * row, 0, 0), Quat::Identity()});
    p_W[3] = stuck;
    const FramePose pose = solve(frames, p_W);
    if (pose.used == 3 && frozen_at < 0) frozen_at = row;
    if (frozen_at >= 0) {
      ASSERT_EQ(pose.state, FrameState::ok) << row;
      EXPECT_EQ(pose.used, 3);
      EXPECT_WITHIN(pose.X_W.p.x(), kStep_m * row, 1e-9);
    }
  }
  EXPECT_EQ(frozen_at, FrozenRule::kRows - 1) << "ten rows, and 8 mm by then";
  // It is seen again as soon as it moves.
  EXPECT_EQ(solve(frames, placed({Vec3(0.1, 0, 0), Quat::Identity()})).used, 4);
}

TEST(FrozenMarker, ABodyThatRestsOrMovesTooLittleIsNotFrozen) {
  for (const double moved_m : {0.0, 0.0049}) {
    auto frames = must(ArmFrames::compile(rig_with(""), kLabels));
    auto p_W = placed({});
    for (int row = 0; row < 50; ++row) {
      if (row == 20)
        for (std::size_t k = 0; k < 3; ++k) p_W[k].y() += moved_m;
      EXPECT_EQ(solve(frames, p_W).used, 4);
    }
  }
}

TEST(FrozenMarker, NineEqualRowsAreNoProof) {
  auto frames = must(ArmFrames::compile(rig_with(""), kLabels));
  const Vec3 stuck = placed({})[0];
  for (int row = 0; row < FrozenRule::kRows - 1; ++row) {
    auto p_W = placed({Vec3(0.01 * row, 0, 0), Quat::Identity()});
    p_W[0] = stuck;
    EXPECT_EQ(solve(frames, p_W).used, 4);
  }
}

TEST(FrozenMarker, AJointMayRestWhileOthersTurnAboutIt) {
  const Rig rig = must(parse_rig(R"(format = "isograsp-rig-1"
[[frame]]
name = "forearm"
method = "points"
origin = ["F1", "F2"]
primary = { axis = "y", from = ["F1", "F2"], to = "EL" }
secondary = { axis = "z", from = "F2", to = "F1" }
)",
                                 "r.toml"));
  const std::vector<std::string> labels{"EL", "F1", "F2"};
  for (const bool turns : {true, false}) {
    SeenMarkers seen = must(SeenMarkers::compile(rig, labels));
    bool lost = false;
    for (int row = 0; row < 60; ++row) {
      const double angle = turns ? 0.02 * row : 0.0;
      const Quat q(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
      const Vec3 away = turns ? Vec3::Zero() : Vec3(0.001 * row, 0, 0);
      const std::vector<Vec3> p_W{Vec3(0, 0, 0), q * Vec3(0.25, 0.02, 0) + away,
                                  q * Vec3(0.25, -0.02, 0) + away};
      lost = lost || is_missing(seen.see(p_W)[0]);
    }
    EXPECT_EQ(lost, !turns);
  }
}

/// The body at a pose among other points, in a random order.
std::vector<Vec3> cloud_of(const Pose& X_WB, std::size_t others, Random& random,
                           std::vector<std::size_t>& order) {
  auto p_W = placed(X_WB);
  while (p_W.size() < kTemplate.size() + others) p_W.push_back(X_WB.p + random_vector(random, 0.5));
  order.resize(p_W.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1],
              order[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  std::vector<Vec3> mixed;
  for (const std::size_t k : order) mixed.push_back(p_W[k]);
  return mixed;
}

TEST(CloudMatch, FindsABodyAmongOthersWhateverTheirOrder) {
  Random random(7);
  CloudMatch match(kTemplate);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<std::size_t> order, places(kTemplate.size());
    auto cloud = cloud_of(random_pose(random), 20, random, order);
    for (Vec3& p : cloud) p += random_vector(random, 0.001);
    if (!match.find(cloud, places)) continue;  // another point happens to fit as well
    ++found;
    for (std::size_t k = 0; k < places.size(); ++k) EXPECT_EQ(order[places[k]], k);
  }
  EXPECT_GT(found, 280);
}

TEST(CloudMatch, GivesNoAnswerWhereThereAreTwoOrNone) {
  Random random(8);
  CloudMatch match(kTemplate);
  std::vector<std::size_t> places(kTemplate.size());
  const auto body = placed(random_pose(random));
  auto two = body;
  for (const Vec3& p : placed(random_pose(random))) two.push_back(p);
  EXPECT_TRUE(match.find(body, places));
  EXPECT_FALSE(match.find(two, places)) << "two bodies";
  auto hidden = body;
  hidden[2] = Vec3::Constant(kMissing);
  EXPECT_FALSE(match.find(hidden, places)) << "not all of it";
  auto far = body;
  far[2] += 0.006 * (far[2] - far[0]).normalized();
  EXPECT_FALSE(match.find(far, places)) << "more than 5 mm";
  EXPECT_FALSE(match.find(std::vector<Vec3>(), places));
  CloudMatch symmetric({{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.0866, 0}});
  std::vector<std::size_t> three(3);
  EXPECT_FALSE(symmetric.find(std::vector<Vec3>{{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.0866, 0}}, three))
      << "its markers can change places";
}

TEST(CloudMatch, GivesUpOnACloudThatWouldTakeTooLong) {
  // All points within the tolerance of each other: every choice fits but for the last marker.
  std::vector<Vec3> heap(12, Vec3::Zero());
  heap.back() = Vec3(1.0, 0.0, 0.0);
  CloudMatch match(heap);
  std::vector<std::size_t> places(12);
  EXPECT_FALSE(match.find(std::vector<Vec3>(500, Vec3::Zero()), places));
}

TEST(UnlabelledCluster, IsFoundByItsDistancesAndOtherwiseMissing) {
  const Rig rig = must(parse_rig(kRig + "unlabelled = true\n", "r.toml"));
  EXPECT_NE(rig_text(rig).find("unlabelled = true"), std::string::npos);
  Random random(9);
  std::vector<std::string> labels;
  for (int k = 0; k < 10; ++k) labels.push_back("U" + std::to_string(k));
  auto frames = must(ArmFrames::compile(rig, labels));
  EXPECT_TRUE(frames.absent().empty());
  std::vector<FramePose> solved(1);
  int poses = 0;
  for (int trial = 0; trial < 50; ++trial) {
    const Pose X_WB = random_pose(random);
    std::vector<std::size_t> order;
    const auto cloud = cloud_of(X_WB, labels.size() - kTemplate.size(), random, order);
    const auto before = allocations();
    frames.solve(cloud, solved);
    EXPECT_EQ(allocations(), before);
    if (!has_pose(solved[0].state)) continue;
    ++poses;
    EXPECT_WITHIN((solved[0].X_W.p - X_WB.p).norm(), 0.0, kGoldenPosition_m);
  }
  EXPECT_GT(poses, 45);
  frames.solve(std::vector<Vec3>(labels.size(), Vec3::Zero()), solved);
  EXPECT_EQ(solved[0].state, FrameState::few);
}

TEST(UnlabelledCluster, IsNotLookedForUnlessTheRigSaysSo) {
  EXPECT_FALSE(ArmFrames::compile(rig_with(""), std::vector<std::string>{"U1", "U2", "U3", "U4"}));
}

}  // namespace
}  // namespace isograsp::seen_markers_test
