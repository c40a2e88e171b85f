// SPDX-License-Identifier: GPL-3.0-or-later
// A grasp frame by frame: laws first, then the hard cases.
#include "hand_world/assisted_grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "kinematics/attitude.hpp"
#include "tests/hand_world/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::assisted_grasp_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::hand_world;
using virtual_hand::DigitState;
using virtual_hand::HandModel;

constexpr double kFrame_s = 0.01;
constexpr double kNear_m = 0.0005;
constexpr double kPress_m = 0.003;  ///< of each side: what a hand that closes to less is inside
const std::vector<Digit> kPinch{Digit::thumb, Digit::index};
const std::vector<Digit> kTripod{Digit::thumb, Digit::index, Digit::middle};
const std::vector<Digit> kAll{Digit::thumb, Digit::index, Digit::middle, Digit::ring,
                              Digit::little};

/// A hand around an object that stands on a table just below it: each frame says how far the digits
/// press beyond its sides (negative: how far they are away) and where the hand has moved to.
class Hold {
 public:
  explicit Hold(std::vector<Digit> digits, Hand side = Hand::right, double mass_kg = 0.06)
      : digits_(std::move(digits)) {
    model_ = golden_hand("hand_default");
    grip_ = std::make_unique<Grip>(grip_of(model_, digits_, 0.0, {}, 0.02, 0.05, mass_kg));
    pose_ = half_closed();
    if (side == Hand::left) reflect();
    start_.X_WO = side == Hand::left ? mirrored(grip_->object().X_WO) : grip_->object().X_WO;
    start_.ground.table_m = lowest() - 1e-4;
    object_.body = grip_->world->object().body();
    grasp_ = std::make_unique<AssistedGrasp>(model_, kFrame_s);
  }

  [[nodiscard]] HandFrame frame_of(double press_m, const Vec3& moved) const {
    const auto joints = virtual_hand::joint_poses(virtual_hand::hand_in_space(model_, pose_));
    HandFrame frame;
    frame.side = model_.side;
    frame.tracked = true;
    for (std::size_t j = 0; j < kHandJointCount; ++j) frame.joints[j] = joints[j].p + moved;
    Vec3 across = grip_->across;
    if (model_.side == Hand::left) across = mirrored(across);
    // Those that do not grip are out of the way where the others open.
    for (const Digit digit : press_m > 0.0 ? digits_ : kAll)
      for (std::size_t end = 1; end <= kLinkCount; ++end)
        frame.joints[joint_of(digit, end)] += (digit == Digit::thumb ? press_m : -press_m) * across;
    return frame;
  }
  /// Between the digits of the hand, which nearly touch it: it stands on an edge.
  void place(AssistanceLevel level = AssistanceLevel::full) {
    run(-kNear_m, 10);
    grasp_->place(object_, start_, level);
  }
  /// Frames at one place.
  void run(double press_m, int frames, const Vec3& moved = Vec3::Zero()) {
    for (int k = 0; k < frames; ++k) grasp_->frame(frame_of(press_m, moved), false);
  }
  /// From one place to another, and from one press to another, evenly.
  void lead(double press_from_m, double press_to_m, const Vec3& from, const Vec3& to, int frames) {
    for (int k = 1; k <= frames; ++k) {
      const double share = static_cast<double>(k) / frames;
      grasp_->frame(
          frame_of(press_from_m + share * (press_to_m - press_from_m), from + share * (to - from)),
          false);
    }
  }
  /// Closes on the object on the table and lifts it by 5 cm in half a second.
  void lift() {
    lead(-kNear_m, kPress_m, Vec3::Zero(), Vec3::Zero(), 5);
    run(kPress_m, 15);
    lead(kPress_m, kPress_m, Vec3::Zero(), kUp, 50);
    run(kPress_m, 20, kUp);
  }
  [[nodiscard]] int attached() const {
    int count = 0;
    for (const DigitGrasp& digit : state().digits)
      count += digit.state == DigitState::attached ? 1 : 0;
    return count;
  }
  [[nodiscard]] double energy_J() const {
    RigidObject object(object_.body);
    object.place(state().object);
    return object.kinetic_J() + object_.body.mass_kg * 9.81 * state().object.X_WO.p.y();
  }
  /// From the thumb to the fingers, unit vector.
  [[nodiscard]] const Vec3& across() const { return grip_->across; }
  [[nodiscard]] AssistedGrasp& grasp() { return *grasp_; }
  [[nodiscard]] const GraspState& state() const { return grasp_->state(); }
  [[nodiscard]] const GraspObject& object() const { return object_; }
  [[nodiscard]] const StartPlace& start() const { return start_; }

  static const Vec3 kUp;

 private:
  void reflect() {
    model_.side = Hand::left;
    pose_.X_WP = mirrored(pose_.X_WP);
  }
  [[nodiscard]] double lowest() const {
    double lowest_m = start_.X_WO.p.y();
    const SupportPoints points = support_points(grip_->world->object().body().shape, start_.X_WO);
    for (std::size_t k = 0; k < points.count; ++k)
      lowest_m = std::min(lowest_m, points.points[k].p_W.y());
    return lowest_m;
  }

  std::vector<Digit> digits_;
  HandModel model_;
  std::unique_ptr<Grip> grip_;
  virtual_hand::HandPose pose_;
  StartPlace start_;
  GraspObject object_;
  std::unique_ptr<AssistedGrasp> grasp_;
};
const Vec3 Hold::kUp{0.0, 0.05, 0.0};

/// Everything is a number, and the object no faster than a hand throws it.
void expect_sound(const GraspState& state) {
  constexpr double kFast_m_s = 5.0;
  EXPECT_TRUE(state.object.X_WO.p.allFinite() && state.object.X_WO.q.coeffs().allFinite());
  EXPECT_LT(state.object.v_WO_W.norm(), kFast_m_s);
  for (const Vec3& joint : state.joints) EXPECT_TRUE(joint.allFinite());
}

TEST(AssistedGrasp, TheSameFramesGiveTheSameBits) {
  const auto run = [] {
    Hold hold(kTripod);
    hold.place();
    hold.lift();
    hold.lead(kPress_m, -0.03, Hold::kUp, Hold::kUp, 30);
    return hold.state();
  };
  const GraspState a = run();
  const GraspState b = run();
  EXPECT_EQ(a.object.X_WO.p, b.object.X_WO.p);
  EXPECT_EQ(a.object.X_WO.q.coeffs(), b.object.X_WO.q.coeffs());
  EXPECT_EQ(a.object.w_WO_O, b.object.w_WO_O);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.choice.G_min, b.choice.G_min);
  EXPECT_EQ(a.tracked_gap_m, b.tracked_gap_m);
}

TEST(AssistedGrasp, FramesAndPlacementsAllocateNothing) {
  Hold hold(kAll);
  std::vector<HandFrame> frames;
  for (int k = 0; k < 60; ++k) frames.push_back(hold.frame_of(-0.004 + 0.0002 * k, Vec3::Zero()));
  const auto before = allocations();
  hold.place();
  for (const HandFrame& frame : frames) hold.grasp().frame(frame, false);
  hold.grasp().frame(frames.back(), true);
  hold.grasp().release();
  hold.grasp().let_go();
  hold.grasp().reset();
  hold.grasp().clear();
  EXPECT_EQ(allocations(), before);
  AtLeast chosen(1);
  hold.place();
  for (const HandFrame& frame : frames) {
    hold.grasp().frame(frame, false);
    if (hold.state().choice.digits != 0) ++chosen;
  }
}

TEST(AssistedGrasp, AFeasibleGraspIsTiedAndCarriesTheObject) {
  for (const auto& digits : {kPinch, kTripod, kAll}) {
    Hold hold(digits);
    hold.place();
    const Pose start = hold.state().object.X_WO;
    hold.lift();
    EXPECT_GE(hold.attached(), 2) << digits.size();
    EXPECT_TRUE(hold.state().held);
    EXPECT_FALSE(hold.state().supported);
    constexpr double kGives_m = 0.006;  // ties, and springs that drag the hand
    EXPECT_WITHIN(hold.state().object.X_WO.p.y() - start.p.y(), Hold::kUp.y(), kGives_m);
  }
}

TEST(AssistedGrasp, WithoutHelpNothingIsTiedAndFrictionCarries) {
  Hold hold(kTripod);
  hold.place(AssistanceLevel::off);
  hold.lift();
  EXPECT_EQ(hold.attached(), 0);
  EXPECT_TRUE(hold.state().held);
  EXPECT_FALSE(hold.state().supported);
  EXPECT_TRUE(hold.state().choice.feasible) << "the criteria are shown without help, too";
}

TEST(AssistedGrasp, SofterTiesHaveHalfTheStiffnessAndLetGoAtHalfTheEffort) {
  Hold full(kPinch);
  full.place(AssistanceLevel::full);
  Hold softer(kPinch);
  softer.place(AssistanceLevel::softer);
  EXPECT_DOUBLE_EQ(softer.grasp().gains().stiffness_N_m, 0.5 * full.grasp().gains().stiffness_N_m);
  EXPECT_DOUBLE_EQ(softer.grasp().gains().release_N, 0.5 * full.grasp().gains().release_N);
}

TEST(AssistedGrasp, NeverHoldsLongerThanThreeTenthsAfterTheHandHasOpened) {
  constexpr double kOpen_m = 0.03;  // of each side: more than ties and springs give
  for (const auto& digits : {kPinch, kTripod, kAll})
    for (const double mass_kg : {0.002, 0.06})
      for (const int frames : {5, 20, 60}) {  // fast and slow
        Hold hold(digits, Hand::right, mass_kg);
        hold.place();
        hold.lift();
        ASSERT_TRUE(hold.state().held) << digits.size() << " " << mass_kg;
        hold.lead(kPress_m, -kOpen_m, Hold::kUp, Hold::kUp, frames);
        double held_s = 0.0;
        for (; hold.state().held && held_s < 2.0; held_s += kFrame_s)
          hold.run(-kOpen_m, 1, Hold::kUp);
        EXPECT_LE(held_s, 0.3) << digits.size() << " " << mass_kg << " " << frames;
      }
}

TEST(AssistedGrasp, FingersOfOneSideDoNotKeepWhatTheThumbHasLetGo) {
  Hold hold(kTripod);
  hold.place();
  hold.lift();
  ASSERT_EQ(hold.attached(), 3);
  // The thumb alone moves away; index and middle stay where they are.
  AtLeast alone(1);
  for (int k = 0; k < 60; ++k) {
    HandFrame frame = hold.frame_of(kPress_m, Hold::kUp);
    const HandFrame open = hold.frame_of(-0.02, Hold::kUp);
    for (std::size_t end = 1; end <= kLinkCount; ++end)
      frame.joints[joint_of(Digit::thumb, end)] = open.joints[joint_of(Digit::thumb, end)];
    hold.grasp().frame(frame, false);
    if (hold.state().digits[0].state == DigitState::attached) continue;
    ++alone;
    EXPECT_EQ(hold.attached(), 0) << k;
  }
}

TEST(AssistedGrasp, OnceAnObjectIsPlacedTheFirstDigitThatOpensTakesTheOthersWithIt) {
  for (const bool placed : {false, true}) {
    Hold hold(kTripod);
    hold.place();
    hold.lift();
    ASSERT_EQ(hold.attached(), 3);
    if (placed) hold.grasp().release();
    AtLeast opened(1);
    for (int k = 0; k < 60; ++k) {  // the middle finger alone
      HandFrame frame = hold.frame_of(kPress_m, Hold::kUp);
      const HandFrame open = hold.frame_of(-0.02, Hold::kUp);
      for (std::size_t end = 1; end <= kLinkCount; ++end)
        frame.joints[joint_of(Digit::middle, end)] = open.joints[joint_of(Digit::middle, end)];
      hold.grasp().frame(frame, false);
      if (hold.state().digits[2].state == DigitState::attached) continue;
      ++opened;
      EXPECT_EQ(hold.attached(), placed ? 0 : 2) << k;
    }
  }
}

TEST(AssistedGrasp, APlacedObjectIsLetGoWhereTheHandOpensByLittle) {
  for (const bool placed : {false, true}) {
    Hold hold(kPinch);
    hold.place();
    hold.lift();
    const double whole_N = hold.grasp().gains().release_N;
    if (placed) hold.grasp().release();
    EXPECT_DOUBLE_EQ(hold.grasp().gains().release_N,
                     (placed ? AssistedGrasp::kPlacedPull : 1.0) * whole_N);
    hold.lead(kPress_m, -0.005, Hold::kUp, Hold::kUp, 30);
    EXPECT_EQ(hold.state().held, !placed) << "5 mm of either digit: less than the tie of a carry";
    hold.grasp().reset();
    EXPECT_DOUBLE_EQ(hold.grasp().gains().release_N, whole_N) << "of the next one";
  }
}

TEST(AssistedGrasp, WhoPressesDoesNotLetGoHoweverTheTrackerShakesAndTheTipsRollApart) {
  constexpr double kShake_m = 0.001;  // SD of each joint, twice that of a tracker
  constexpr double kApart_m = 0.01;   // of the tips, along the object
  constexpr double kAside_m = 0.03;   // of the other fingers
  Hold hold(kPinch, Hand::right, 0.002);
  const auto aside = [&](HandFrame frame) {
    for (const Digit digit : {Digit::middle, Digit::ring, Digit::little})
      for (std::size_t end = 1; end <= kLinkCount; ++end)
        frame.joints[joint_of(digit, end)] += kAside_m * hold.across();
    return frame;
  };
  hold.place();
  for (int k = 0; k < 20; ++k)
    hold.grasp().frame(aside(hold.frame_of(kPress_m, Vec3::Zero())), false);
  for (int k = 0; k < 50; ++k)
    hold.grasp().frame(aside(hold.frame_of(kPress_m, k / 50.0 * Hold::kUp)), false);
  ASSERT_EQ(hold.attached(), 2);
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    HandFrame frame = aside(hold.frame_of(kPress_m, Hold::kUp));
    const Vec3 along = hold.state().object.X_WO.q * Vec3::UnitZ();
    for (std::size_t end = 1; end <= kLinkCount; ++end)
      frame.joints[joint_of(Digit::thumb, end)] += std::min(1.0, k / 100.0) * kApart_m * along;
    for (Vec3& joint : frame.joints)
      joint += kShake_m * Vec3(random.gaussian(), random.gaussian(), random.gaussian());
    hold.grasp().frame(frame, false);
    ASSERT_EQ(hold.attached(), 2) << k;
    for (const DigitGrasp& digit : hold.state().digits) EXPECT_GE(digit.pull_N, 0.0);
  }
}

TEST(AssistedGrasp, AnObjectThatHopsOnTheTableIsNotLiftedYet) {
  for (const double height_m : {0.003, 0.02}) {
    Hold hold(kPinch);
    hold.place();
    hold.lead(-kNear_m, kPress_m, Vec3::Zero(), Vec3::Zero(), 5);
    hold.run(kPress_m, 15);
    const double from_m = hold.state().object.X_WO.p.y();
    const Vec3 up(0.0, height_m, 0.0);
    hold.lead(kPress_m, kPress_m, Vec3::Zero(), up, 30);
    hold.run(kPress_m, 20, up);
    EXPECT_GT(hold.state().object.X_WO.p.y(), from_m + 0.5 * height_m);
    EXPECT_EQ(hold.state().supported, height_m < World::kMargin_m);
  }
}

TEST(AssistedGrasp, FingersThatOpenTogetherAreFreeInOneFrame) {
  Hold hold(kTripod);
  hold.place();
  hold.lift();
  const int before = hold.attached();
  ASSERT_GE(before, 2);
  AtLeast let_go(1);
  for (int k = 0; k < 100 && hold.attached() > 0; ++k) {
    hold.run(-0.03, 1, Hold::kUp);
    if (hold.attached() != before) {
      EXPECT_EQ(hold.attached(), 0);
      ++let_go;
    }
  }
}

TEST(AssistedGrasp, AnObjectThatIsLetGoGainsNoEnergy) {
  for (const auto& digits : {kPinch, kAll}) {
    Hold hold(digits);
    hold.place();
    hold.lift();
    hold.lead(kPress_m, -0.03, Hold::kUp, Hold::kUp, 15);
    for (int k = 0; k < 100 && hold.state().held; ++k) hold.run(-0.03, 1, Hold::kUp);
    ASSERT_FALSE(hold.state().held);
    // What pads that still touch it store at 1 N: F^2 / 2k, k = 20 kN/m.
    constexpr double kPads_J = 2.5e-5;
    const double before_J = hold.energy_J();
    for (int k = 0; k < 60; ++k) {
      hold.run(-0.03, 1, Hold::kUp);
      EXPECT_LE(hold.energy_J(), before_J + kPads_J) << k;
    }
  }
}

TEST(AssistedGrasp, AHandThatIsLostNeverDropsTheObject) {
  for (const auto level : {AssistanceLevel::full, AssistanceLevel::off})
    for (const double moved_m : {0.0, 0.05, 0.2}) {
      Hold hold(kTripod);
      hold.place(level);
      hold.lift();
      const Pose there = hold.state().object.X_WO;
      const int attached = hold.attached();
      const Vec3 back = Hold::kUp + Vec3(moved_m, 0.5 * moved_m, 0.0);
      for (int k = 0; k < 20; ++k) {
        hold.grasp().frame(hold.frame_of(kPress_m, back), true);
        EXPECT_TRUE(hold.state().frozen);
        EXPECT_EQ(hold.state().object.X_WO.p, there.p);
        EXPECT_TRUE(hold.state().held);
      }
      for (int k = 0; k < 150; ++k) {
        hold.run(kPress_m, 1, back);
        ASSERT_TRUE(hold.state().held) << moved_m << " " << k;
      }
      EXPECT_EQ(hold.attached(), attached);
      constexpr double kGives_m = 0.01;
      EXPECT_WITHIN((hold.state().object.X_WO.p - there.p - (back - Hold::kUp)).norm(), 0.0,
                    kGives_m);
    }
}

TEST(AssistedGrasp, AFrameWithoutAJointIsOneInWhichTheHandIsLost) {
  Hold hold(kPinch);
  hold.place();
  hold.lift();
  const GraspState before = hold.state();
  HandFrame broken = hold.frame_of(kPress_m, Vec3(1.0, 0.0, 0.0));
  broken.joints[joint_of(Digit::middle, 2)].x() = std::numeric_limits<double>::quiet_NaN();
  hold.grasp().frame(broken, false);
  EXPECT_TRUE(hold.state().frozen);
  EXPECT_EQ(hold.state().object.X_WO.p, before.object.X_WO.p);
  EXPECT_EQ(hold.state().joints, before.joints);
}

TEST(AssistedGrasp, LettingGoForThePersonDropsTheObjectThroughAClosedHand) {
  Hold hold(kAll);
  hold.place();
  hold.lift();
  hold.grasp().let_go();
  EXPECT_TRUE(hold.state().helped);
  hold.run(kPress_m, 40, Hold::kUp);
  EXPECT_FALSE(hold.state().held);
  EXPECT_TRUE(hold.state().supported) << "it lies on the table again";
}

TEST(AssistedGrasp, AfterTheObjectIsPlacedNothingNewIsTied) {
  Hold hold(kPinch);
  hold.place();
  hold.grasp().release();
  hold.lift();
  EXPECT_EQ(hold.attached(), 0);
}

TEST(AssistedGrasp, ADropPutsTheObjectBackWhereItStood) {
  Hold hold(kPinch);
  hold.place();
  const Pose start = hold.state().object.X_WO;
  hold.lift();
  hold.grasp().reset();
  EXPECT_EQ(hold.state().object.X_WO.p, start.p);
  EXPECT_EQ(hold.state().object.v_WO_W, Vec3::Zero());
  EXPECT_EQ(hold.attached(), 0);
  EXPECT_EQ(hold.state().level, AssistanceLevel::full);
}

TEST(AssistedGrasp, AHandThatIsInTheObjectAtFirstPushesItOutGently) {
  for (const double depth_m : {0.005, 0.015}) {
    Hold hold(kAll);
    hold.run(depth_m, 20);
    hold.place();
    for (int k = 0; k < 100; ++k) {
      hold.run(depth_m, 1);
      expect_sound(hold.state());
      EXPECT_LT(hold.state().object.v_WO_W.norm(), 2.0);
    }
  }
}

TEST(AssistedGrasp, AJumpOfAMetreIsCaughtUpWithoutAThrow) {
  Hold hold(kTripod);
  hold.place();
  hold.lift();
  const Vec3 there = Hold::kUp + Vec3(1.0, 0.0, 0.0);
  const double before_m = hold.state().tracked_gap_m;
  double fastest_m_s = 0.0;
  for (int k = 0; k < 200; ++k) {
    hold.run(kPress_m, 1, there);
    expect_sound(hold.state());
    fastest_m_s = std::max(fastest_m_s, hold.state().object.v_WO_W.norm());
  }
  // A way of least jerk of 1 m with 5 m/s2 at most is at 1.75 m/s in its middle.
  EXPECT_LT(fastest_m_s, 2.0);
  constexpr double kThere_m = 0.001;
  EXPECT_WITHIN(hold.state().tracked_gap_m, before_m, kThere_m);
  EXPECT_TRUE(hold.state().held);
}

TEST(AssistedGrasp, ALeftHandIsTheReflectionOfARightOne) {
  Hold right(kTripod, Hand::right);
  Hold left(kTripod, Hand::left);
  const auto lifted = [](Hold& hold) {
    hold.place();
    hold.lift();
    return hold.state();
  };
  const GraspState a = lifted(right);
  const GraspState b = lifted(left);
  EXPECT_EQ(right.attached(), left.attached());
  constexpr double kSame_m = 1e-5;  // contacts that slip first settle to 1 um/s
  EXPECT_WITHIN((mirrored(a.object.X_WO.p) - b.object.X_WO.p).norm(), 0.0, kSame_m);
  EXPECT_WITHIN((mirrored(a.joints[kWristJoint]) - b.joints[kWristJoint]).norm(), 0.0, kSame_m);
}

TEST(AssistedGrasp, StreamsOfAnyRateHoldAlike) {
  std::vector<Vec3> ends;
  for (const double rate_Hz : {30.0, 90.0, 120.0}) {
    Hold hold(kTripod);
    hold.place();
    hold.lead(-kNear_m, kPress_m, Vec3::Zero(), Vec3::Zero(), 5);
    hold.run(kPress_m, 15);
    // Frames of the tracker, straight between two of them as the session shows them.
    const auto row = [&](double t_s) {
      const double share = std::clamp(t_s / 0.5, 0.0, 1.0);
      return hold.frame_of(kPress_m, share * Hold::kUp);
    };
    for (int k = 1; k <= 100; ++k) {
      const double at = k * kFrame_s * rate_Hz;
      const double first = std::floor(at);
      const HandFrame from = row(first / rate_Hz);
      HandFrame frame = row((first + 1.0) / rate_Hz);
      for (std::size_t j = 0; j < kHandJointCount; ++j)
        frame.joints[j] = from.joints[j] + (at - first) * (frame.joints[j] - from.joints[j]);
      hold.grasp().frame(frame, false);
      EXPECT_TRUE(hold.state().held) << rate_Hz;
    }
    ends.push_back(hold.state().object.X_WO.p);
  }
  constexpr double kAlike_m = 2e-4;
  for (const Vec3& end : ends) EXPECT_WITHIN((end - ends.front()).norm(), 0.0, kAlike_m);
}

TEST(AssistedGrasp, ObjectsOfTheStudyStandStillWhereTheyStart) {
  const HandModel model = golden_hand("hand_default");
  Hold elsewhere(kPinch);
  for (const auto& object : every(virtual_hand::study_objects())) {
    AssistedGrasp grasp(model, kFrame_s);
    const StartPlace start = start_place(object, 0.0, 0.05, -0.03);
    grasp.place(grasp_object(object), start, AssistanceLevel::full);
    EXPECT_NEAR(grasp_object(object).body.mass_kg, object.mass_kg, 1e-15);
    for (int k = 0; k < 100; ++k)
      grasp.frame(elsewhere.frame_of(-0.01, Vec3(0.0, 0.5, 0.5)), false);
    constexpr double kStill_m = 2e-4;  // pads of the ground give under its weight
    EXPECT_WITHIN((grasp.state().object.X_WO.p - start.X_WO.p).norm(), 0.0, kStill_m)
        << object.name;
    EXPECT_TRUE(grasp.state().supported) << object.name;
    EXPECT_FALSE(grasp.state().held) << object.name;
  }
}

TEST(AssistedGrasp, WithoutAHandNothingMoves) {
  Hold hold(kPinch);
  hold.grasp().place(hold.object(), hold.start(), AssistanceLevel::full);
  const Pose start = hold.state().object.X_WO;
  for (int k = 0; k < 10; ++k) hold.grasp().frame(hold.frame_of(0.0, Vec3::Zero()), true);
  EXPECT_FALSE(hold.state().hand_there);
  EXPECT_TRUE(hold.state().frozen);
  EXPECT_EQ(hold.state().object.X_WO.p, start.p);
}

TEST(AssistanceLevel, NamesAreReadBack) {
  for (const auto level : {AssistanceLevel::full, AssistanceLevel::softer, AssistanceLevel::off})
    EXPECT_EQ(assistance_level(name_of(level)), level);
  EXPECT_FALSE(assistance_level("much").has_value());
}

}  // namespace
}  // namespace isograsp::assisted_grasp_test
