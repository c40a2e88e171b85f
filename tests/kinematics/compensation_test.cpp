// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/measures/compensation.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::compensation_test {
namespace {

using namespace isograsp::test;

/// The ends of a filtered run and even motion are exact up to the rounding of two passes.
constexpr double kExact = 1e-12;

/// Brace, elbow and trunk over three seconds at 100 Hz; one movement from 0.5 to 2.5 s.
struct Body {
  Body() {
    rig.frames = {{"brace", PointsFrame()},
                  {"elbow", PointFrame{{"EL"}, "brace"}},
                  {"trunk", PointsFrame()},
                  {"object", PointsFrame()}};
    rig.links = {{"object", "world", "object", AngleSequence::rpy, std::nullopt}};
    rig.score = RigScore{"object", "object", "object", "trunk", "brace", "elbow"};
    series.frames = {"brace", "elbow", "trunk", "object"};
    series.X_W.resize(4);
    for (int k = 0; k <= 300; ++k) {
      series.t_s.push_back(k * 0.01);
      for (auto& frame : series.X_W) frame.push_back(Pose());
    }
    targets = {{"there", 0.5, 2.5, Pose()}};
  }
  /// From 0 at the beginning of the record to `most` at its end, evenly.
  void moves(std::size_t frame, const Vec3& most) {
    for (std::size_t k = 0; k < series.t_s.size(); ++k)
      series.X_W[frame][k].p += most * (series.t_s[k] / 3.0);
  }
  void turns(std::size_t frame, const Vec3& axis, double most_rad) {
    for (std::size_t k = 0; k < series.t_s.size(); ++k)
      series.X_W[frame][k].q =
          Quat(Eigen::AngleAxisd(most_rad * series.t_s[k] / 3.0, axis)) * series.X_W[frame][k].q;
  }
  [[nodiscard]] MovementCompensation measured() const {
    return must(movement_compensation(rig, series, targets)).at(0);
  }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> all;
    for (const Text& note : measured().notes) all.push_back(english(note));
    return all;
  }
  Rig rig;
  PoseSeries series;
  std::vector<PoseTarget> targets;
};
constexpr std::size_t kBrace = 0, kElbow = 1, kTrunk = 2;

TEST(Compensation, ABodyThatStaysIsNotInTheWay) {
  const auto of = Body().measured();
  for (const Valued* value :
       {&of.elbow_path, &of.elbow_displacement, &of.trunk_displacement, &of.trunk_lean,
        &of.trunk_rotation, &of.brace_displacement, &of.brace_rotation})
    EXPECT_WITHIN(*value->value, 0.0, kExact);
  EXPECT_EQ(Body().notes(), std::vector<std::string>{});
}

TEST(Compensation, TheElbowIsMeasuredInTheBraceFromTheFirstRowOfTheMovement) {
  Body body;
  body.moves(kElbow, Vec3(0.045, 0.0, 0.06));  // 75 mm in three seconds, 50 mm in the movement
  EXPECT_WITHIN(*body.measured().elbow_path.value, 0.050, kExact);
  EXPECT_WITHIN(*body.measured().elbow_displacement.value, 0.050, kExact);
  EXPECT_EQ(body.notes(), std::vector<std::string>{"upper arm moved"});
  body.moves(kBrace, Vec3(0.045, 0.0, 0.06));
  EXPECT_WITHIN(*body.measured().elbow_displacement.value, 0.0, kExact) << "with the brace";
  EXPECT_EQ(body.notes(), std::vector<std::string>{"device moved"});
  body.rig.score->brace.reset();
  EXPECT_WITHIN(*body.measured().elbow_displacement.value, 0.050, kExact) << "in the world";
}

TEST(Compensation, AWayThereAndBackIsLongerThanItsDisplacement) {
  Body body;
  for (std::size_t k = 0; k < body.series.t_s.size(); ++k)
    body.series.X_W[kElbow][k].p.x() =
        0.01 * std::sin(2.0 * std::numbers::pi * (body.series.t_s[k] - 0.5) / 2.0);
  constexpr double kFiltered_m = 1e-5;  // of a sine of half a hertz
  EXPECT_WITHIN(*body.measured().elbow_displacement.value, 0.01, kFiltered_m);
  EXPECT_WITHIN(*body.measured().elbow_path.value, 0.04, 4.0 * kFiltered_m);
  EXPECT_EQ(body.notes(), std::vector<std::string>{}) << "20 mm are allowed";
}

TEST(Compensation, LeaningIsOfWhatWasVerticalAndTurningAboutItIsNone) {
  Body body;
  body.turns(kTrunk, Vec3::UnitX(), 0.3);
  body.moves(kTrunk, Vec3(0.0, 0.0, 0.09));
  auto of = body.measured();
  EXPECT_WITHIN(*of.trunk_lean.value, 0.2, kExact) << "two of three seconds";
  EXPECT_WITHIN(*of.trunk_rotation.value, 0.2, kExact);
  EXPECT_WITHIN(*of.trunk_displacement.value, 0.06, kExact);
  Body twisted;
  twisted.turns(kTrunk, Vec3::UnitY(), 0.3);
  of = twisted.measured();
  EXPECT_WITHIN(*of.trunk_lean.value, 0.0, kExact);
  EXPECT_WITHIN(*of.trunk_rotation.value, 0.2, kExact);
  twisted.rig.view = RigView{"y", "-x"};
  EXPECT_WITHIN(*twisted.measured().trunk_lean.value, 0.2, kExact) << "up is where the view says";
}

TEST(Compensation, TheDeviceIsLookedAtFromTheStartOfTheRecord) {
  Body body;
  body.turns(kBrace, Vec3::UnitZ(), 0.03);  // 1.4 of 1.7 degrees by the end of the movement
  EXPECT_WITHIN(*body.measured().brace_rotation.value, 0.03 * 2.5 / 3.0, kExact);
  EXPECT_EQ(body.notes(), std::vector<std::string>{});
  body.turns(kBrace, Vec3::UnitZ(), 0.03);
  EXPECT_EQ(body.notes(), std::vector<std::string>{"device moved"});
}

TEST(Compensation, WhatTheRigDoesNotNameIsSaidToBeNotMeasured) {
  Body body;
  body.rig.score = RigScore{"object", "object", "object"};
  auto of = body.measured();
  EXPECT_EQ(english(of.trunk_displacement.reason), "trunk not measured");
  EXPECT_EQ(english(of.elbow_path.reason), "elbow not measured");
  EXPECT_EQ(english(of.brace_rotation.reason), "brace not measured");
  EXPECT_EQ(body.notes(), std::vector<std::string>{"trunk not measured"});
  Body single;
  single.rig.score->trunk = "elbow";
  of = single.measured();
  EXPECT_WITHIN(*of.trunk_displacement.value, 0.0, kExact);
  EXPECT_EQ(english(of.trunk_lean.reason), "one marker shows no attitude");
  single.targets[0].matched_s.reset();
  EXPECT_EQ(english(single.measured().elbow_path.reason), "not reached");
  single.series.frames[0] = "plate";
  EXPECT_FALSE(movement_compensation(single.rig, single.series, single.targets));
}

TEST(Compensation, EveryMeasureHasItsChannelAndUnit) {
  const Body body;
  const auto measures =
      compensation_measures(must(movement_compensation(body.rig, body.series, body.targets)));
  ASSERT_EQ(measures.size(), 7U);
  test::AtLeast named(7);
  for (const auto& [movement, measure] : test::every(measures)) {
    EXPECT_EQ(movement, 0U);
    EXPECT_EQ(measure.name.rfind(measure.channel + "_", 0), 0U) << measure.name;
    const bool angle = measure.name.ends_with("rotation") || measure.name.ends_with("lean");
    EXPECT_EQ(measure.unit, angle ? "rad" : "m") << measure.name;
    ++named;
  }
}

}  // namespace
}  // namespace isograsp::compensation_test
