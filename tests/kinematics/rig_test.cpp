// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/rig.hpp"

#include <gtest/gtest.h>

#include "kinematics/arm_frames.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"

namespace isograsp::rig_test {
namespace {

using namespace isograsp::test;

const std::string kHead = "format = \"isograsp-rig-1\"\n";
const std::string kBody = kHead + R"(
[[frame]]
name = "body"
method = "cluster"
markers = ["A", "B", "C"]
template_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
calibration = { origin = "A", primary = { axis = "x", from = "A", to = "B" }, secondary = { axis = "-y", from = "A", to = ["C", "B"] } }
[[frame]]
name = "tip"
method = "point"
origin = "T"
orientation = "body"
[[landmark]]
name = "L"
frame = "body"
position_m = [0.1, 0.2, 0.3]
[[frame]]
name = "hand"
method = "points"
origin = ["L", "A"]
primary = { axis = "z", from = "A", to = "B" }
secondary = { axis = "x", from = "A", to = "L" }
[[link]]
name = "wrist"
parent = "body"
child = "hand"
sequence = "zxy"
zero_quaternion_wxyz = [2, 0, 0, 0]
[score]
forearm = "wrist"
sync = "wrist"
object = "hand"
[view]
right = "-z"
up = "y"
)";

TEST(Rig, MayHaveMarkersOfNoFrameAndNothingElse) {
  const Rig rig = must(parse_rig(kHead + "markers = [\"A\", \"B\"]\n", "a.toml"));
  EXPECT_EQ(markers_of(rig), (std::vector<std::string>{"A", "B"}));
  const std::string text = rig_text(rig);
  EXPECT_EQ(rig_text(must(parse_rig(text, "b.toml"))), text);
  const std::vector<std::string> seen{"B", "C"}, others{"C"};
  EXPECT_EQ(must(ArmFrames::compile(rig, seen)).frames(), 0U);
  EXPECT_FALSE(ArmFrames::compile(rig, others)) << "none of its markers";
  const auto twice = parse_rig(kHead + "markers = [\"A\", \"A\"]\n", "a.toml");
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().field, "markers");
  EXPECT_FALSE(parse_rig(kHead, "a.toml"));
}

TEST(Rig, IsWrittenAsItWasRead) {
  const Rig rig = must(parse_rig(kBody, "a.toml"));
  ASSERT_EQ(rig.frames.size(), 3U);
  EXPECT_EQ(rig.links[0].zero->w(), 1.0) << "quaternions are normalised";
  EXPECT_EQ(rig.view->right, "-z");
  const std::string text = rig_text(rig);
  EXPECT_EQ(rig_text(must(parse_rig(text, "b.toml"))), text);
  const auto& cluster = std::get<ClusterFrame>(rig.frames[0].method);
  ASSERT_TRUE(cluster.calibration);
  EXPECT_TRUE(cluster.calibration->secondary.negative);
  EXPECT_EQ(cluster.calibration->secondary.to, (RigPoint{"C", "B"}));
  EXPECT_EQ(rig_text(golden_rig("kurillo15.toml")),
            rig_text(must(parse_rig(rig_text(golden_rig("kurillo15.toml")), "c.toml"))));
}

TEST(Rig, NamesTheRestOfTheBodyIfItIsSeen) {
  const Rig plain = must(parse_rig(kBody, "a.toml"));
  EXPECT_FALSE(plain.score->trunk || plain.score->brace || plain.score->elbow);
  std::string text = kBody;
  text.replace(text.find("[view]"), 0, "trunk = \"body\"\nelbow = \"tip\"\nbrace = \"body\"\n");
  const Rig rig = must(parse_rig(text, "a.toml"));
  EXPECT_EQ(rig.score->trunk, "body");
  EXPECT_EQ(rig.score->brace, "body");
  EXPECT_EQ(rig.score->elbow, "tip");
  EXPECT_EQ(must(parse_rig(rig_text(rig), "b.toml")).score->elbow, "tip");
  EXPECT_EQ(rig_text(must(parse_rig(rig_text(rig), "b.toml"))), rig_text(rig));
}

TEST(Rig, WhatIsWrongIsNamedWithItsLineAndARemedy) {
  const auto without = [](const std::string& part, const std::string& instead) {
    std::string text = kBody;
    text.replace(text.find(part), part.size(), instead);
    return text;
  };
  struct Case {
    std::string text;
    std::string what;
  };
  const Case cases[] = {
      {kHead, "frame: is missing"},
      {without("[0, 1, 0]]", "[0, 1]]"), "3 finite numbers"},
      {without("\"A\", \"B\", \"C\"", "\"A\", \"B\""), "template_m: has 3 points for 2 markers"},
      {without("\"A\", \"B\", \"C\"", "\"A\", \"B\", \"B\""), "'B' appears twice"},
      {without("orientation = \"body\"", "orientation = \"hand\""), "is no frame before this one"},
      {without("frame = \"body\"", "frame = \"hand\""), "does not stand before this one"},
      {without("frame = \"body\"", "frame = \"foot\""), "does not stand before"},
      {without("name = \"tip\"", "name = \"body\""), "'body' appears twice"},
      {without("name = \"tip\"", "name = \"a,b\""), "cannot be a name"},
      {without("axis = \"x\", from = \"A\", to = \"L\"", "axis = \"z\", from = \"A\", to = \"L\""),
       "has the same axis"},
      {without("parent = \"body\"", "parent = \"trunk\""), "'trunk' is no frame"},
      {without("child = \"hand\"", "child = \"world\""), "'world' is no frame"},
      {without("[2, 0, 0, 0]", "[0, 0, 0, 0]"), "is no attitude"},
      {without("sync = \"wrist\"", "sync = \"body\""), "'body' is no link"},
      {without("[view]", "elbow = \"arm\"\n[view]"), "elbow: 'arm' is no frame"},
      {without("up = \"y\"", "up = \"z\""), "points to the right"},
      {without("method = \"point\"\n", "method = \"dot\"\n"), "'dot' is not known"},
      {kBody + "more = 1\n", "unknown key"}};
  for (const Case& one : cases) {
    const auto rig = parse_rig(one.text, "a.toml");
    ASSERT_FALSE(rig) << one.what;
    const std::string message = rig.error().message();
    EXPECT_NE(message.find(one.what), std::string::npos) << message;
    EXPECT_EQ(message.rfind("a.toml:", 0), 0U) << message;
    EXPECT_FALSE(rig.error().remedy.empty()) << message;
  }
}

TEST(Rig, OfALeftArmIsReflectedButForItsZeros) {
  const Rig rig = must(parse_rig(kBody, "a.toml"));
  const Rig left = mirrored(rig);
  EXPECT_EQ(std::get<ClusterFrame>(left.frames[0].method).template_m[1], Vec3(-1, 0, 0));
  EXPECT_EQ(left.landmarks[0].position_m, Vec3(-0.1, 0.2, 0.3));
  EXPECT_EQ(left.links[0].zero->coeffs(), rig.links[0].zero->coeffs());
  EXPECT_EQ(rig_text(mirrored(left)), rig_text(rig));
}

}  // namespace
}  // namespace isograsp::rig_test
