// SPDX-License-Identifier: GPL-3.0-or-later
// The person and a virtual object: the block in the vertical plane with two targets.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "grasp_model/plan.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/virtual_patient/closed_loop.hpp"

namespace isograsp::virtual_patient::object_test {
namespace {

using test::kFrame_s;
using test::SensedPatient;

constexpr int kSeeds = 20;
constexpr double kPositionTolerance_m = 0.02;
constexpr double kAngleTolerance_rad = 15.0 * std::numbers::pi / 180.0;
constexpr double kTimeLimit_s = 60.0;

Scene shipped(const char* name) {
  const std::string path = ISOGRASP_SOURCE_DIR "/library/scenes/" + std::string(name) + ".toml";
  const auto text = read_text(path);
  EXPECT_TRUE(text) << text.error().message();
  const auto scene = parse_scene(*text, path);
  EXPECT_TRUE(scene) << scene.error().message();
  return *scene;
}
Scene block() {
  return shipped("planar_block");
}

Pose planar(double x_m, double y_m, double angle_rad) {
  Pose pose;
  pose.p = {x_m, y_m, 0.0};
  pose.q = Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()));
  return pose;
}

struct Target {
  Pose X_WT;
  double hold_s;
};
/// Lower left, turned there and back, upper right, turned there.
std::vector<Target> two_targets() {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  return {{planar(-0.08, -0.06, 0.0), 0.0},
          {planar(-0.08, -0.06, kQuarter), 1.0},
          {planar(-0.08, -0.06, 0.0), 0.0},
          {planar(0.08, 0.06, 0.0), 0.0},
          {planar(0.08, 0.06, kQuarter), 1.0}};
}

struct Outcome {
  std::vector<double> times_s;  ///< of each target; the limit if it was not reached
  int reached = 0;
  std::vector<double> tilts_rad;  ///< largest, on the way to each target
  double largest_force_N = 0.0;   ///< normal
  double largest_slip = 0.0;      ///< share of the friction limit that was asked for
  double total_s = 0.0;
};

Outcome play(const char* name, std::uint64_t seed, const Scene& scene,
             const std::vector<Target>& targets = two_targets()) {
  SensedPatient person(*patient_traits(name), seed);
  person.patient.meet_object(scene);
  const auto plan = Plan::compile(scene, kFrame_s);
  EXPECT_TRUE(plan) << plan.error().message();
  ObjectState state = plan->initial_state();
  Outcome outcome;
  for (const Target& target : test::every(targets)) {
    double inside_s = 0.0;
    bool reached = false;
    double tilt_rad = 0.0;
    const double begin_s = outcome.total_s;
    while (!reached && outcome.total_s - begin_s < kTimeLimit_s) {
      const FingerWrenches wrench_C = person.next_frame();
      const GraspWrench wrench = plan->grasp(wrench_C, state);
      Stimulus stimulus;
      stimulus.t_s = person.t_s();
      stimulus.cue = Cue::move;
      stimulus.object_shown = true;
      stimulus.X_WO = state.X_WO;
      stimulus.X_WT = target.X_WT;
      stimulus.contact = wrench.contact;
      person.patient.see(stimulus);
      const bool inside = (state.X_WO.p - target.X_WT.p).norm() <= kPositionTolerance_m &&
                          angle_between(state.X_WO.q, target.X_WT.q) <= kAngleTolerance_rad;
      inside_s = inside ? inside_s + kFrame_s : 0.0;
      reached = inside && inside_s > target.hold_s;
      tilt_rad = std::max(tilt_rad, angle_between(state.X_WO.q, Quat::Identity()));
      for (std::size_t f = 0; f < kFingerCount; ++f) {
        outcome.largest_force_N = std::max(outcome.largest_force_N, wrench_C[f].force.z());
        EXPECT_GE(person.pressed[f].force.z(), 0.0) << "fingers push and never pull";
        if (outcome.total_s > 2.0)
          outcome.largest_slip = std::max(outcome.largest_slip, wrench.utilisation[f]);
      }
      plan->move(wrench, state);
      outcome.total_s += kFrame_s;
    }
    if (reached) ++outcome.reached;
    outcome.times_s.push_back(outcome.total_s - begin_s);
    outcome.tilts_rad.push_back(tilt_rad);
  }
  return outcome;
}

double worst(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

TEST(VirtualPatientObject, EveryHealthyPersonReachesEveryTargetWithinTenSeconds) {
  constexpr double kTenSeconds = 10.0;
  const Scene scene = block();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Outcome outcome = play("healthy", seed, scene);
    EXPECT_EQ(outcome.reached, 5) << "seed " << seed;
    EXPECT_LT(worst(outcome.times_s), kTenSeconds) << "seed " << seed;
  }
}

TEST(VirtualPatientObject, TheBlockStaysNearlyLevelInTransport) {
  constexpr double kModerate_rad = 5.0 * std::numbers::pi / 180.0;
  const Scene scene = block();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    EXPECT_LT(play("healthy", seed, scene).tilts_rad[0], kModerate_rad);
}

TEST(VirtualPatientObject, PareticPeopleAreSlowerThanHealthyOnes) {
  const Scene scene = block();
  double healthy_s = 0.0;
  double paretic_s = 0.0;
  int paretic_reached = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    healthy_s += play("healthy", seed, scene).total_s;
    const Outcome outcome = play("paretic", seed, scene);
    paretic_s += outcome.total_s;
    paretic_reached += outcome.reached;
  }
  RecordProperty("healthy_mean_s", std::to_string(healthy_s / kSeeds));
  RecordProperty("paretic_mean_s", std::to_string(paretic_s / kSeeds));
  RecordProperty("paretic_reached", paretic_reached);
  EXPECT_GT(paretic_s, 1.5 * healthy_s);
  EXPECT_GT(paretic_reached, 3 * kSeeds) << "weak, not unable";
}

TEST(VirtualPatientObject, FingersHoldTheBlockWithoutSlipAndWithModestForce) {
  const Scene scene = block();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Outcome outcome = play("healthy", seed, scene);
    EXPECT_LT(outcome.largest_slip, 1.0) << "they use 60 % of the friction limit";
    EXPECT_LT(outcome.largest_force_N, 6.0);
  }
}

TEST(VirtualPatientObject, TheLeftHandMovesTheSameBlockAsWell) {
  const Outcome outcome = play("healthy", 4, for_hand(block(), Hand::left));
  EXPECT_EQ(outcome.reached, 5);
}

TEST(VirtualPatientObject, ABlockThatCarriesItsForcesAlongIsMovedAsWell) {
  Scene scene = block();
  scene.wrench_frame = WrenchFrame::object;
  const Outcome outcome = play("healthy", 4, scene);
  EXPECT_EQ(outcome.reached, 5);
}

/// RMS distance of the block's centre to a target on a sine, after `settle_s`.
double pursuit_error_m(const char* name, double frequency_Hz, double amplitude_m) {
  constexpr double kSettle_s = 10.0;
  constexpr double kEnd_s = 40.0;
  const Scene scene = block();
  SensedPatient person(*patient_traits(name), 5);
  person.patient.meet_object(scene);
  const auto plan = Plan::compile(scene, kFrame_s);
  ObjectState state = plan->initial_state();
  double squares = 0.0;
  int count = 0;
  for (double t_s = 0.0; t_s < kEnd_s; t_s += kFrame_s) {
    const GraspWrench wrench = plan->grasp(person.next_frame(), state);
    Stimulus stimulus;
    stimulus.t_s = person.t_s();
    stimulus.cue = Cue::move;
    stimulus.object_shown = true;
    stimulus.X_WO = state.X_WO;
    const double turn = 2.0 * std::numbers::pi * frequency_Hz * t_s;
    stimulus.X_WT = planar(amplitude_m * std::sin(turn), 0.0, 0.0);
    stimulus.contact = wrench.contact;
    person.patient.see(stimulus);
    plan->move(wrench, state);
    if (t_s < kSettle_s) continue;
    squares += (state.X_WO.p - stimulus.X_WT.p).squaredNorm();
    ++count;
  }
  return std::sqrt(squares / count);
}

TEST(VirtualPatientObject, ATargetThatMovesIsPursuedAndAFasterOneLess) {
  constexpr double kAmplitude_m = 0.08;
  const double slow_m = pursuit_error_m("healthy", 0.1, kAmplitude_m);
  EXPECT_LT(slow_m, 0.2 * kAmplitude_m / std::numbers::sqrt2) << "a fifth of who stays at rest";
  EXPECT_GT(pursuit_error_m("healthy", 0.4, kAmplitude_m), 1.5 * slow_m);
  EXPECT_GT(pursuit_error_m("paretic", 0.1, kAmplitude_m), 1.2 * slow_m);
}

TEST(VirtualPatientObject, AKnobIsTurnedAndAFreeBlockIsTiltedInSpace) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Outcome knob =
        play("healthy", seed, shipped("knob"), {{planar(0.0, 0.0, 1.0), 1.0}, {Pose{}, 1.0}});
    EXPECT_EQ(knob.reached, 2);
    Pose tilted;
    tilted.p = {0.03, -0.02, 0.03};
    tilted.q = Quat(Eigen::AngleAxisd(0.4, Vec3(1.0, 2.0, -1.0).normalized()));
    const Outcome block =
        play("healthy", seed, shipped("free_block"), {{tilted, 1.0}, {Pose{}, 1.0}});
    EXPECT_EQ(block.reached, 2);
  }
}

TEST(VirtualPatientObject, ChangingTheTargetIsTheOnlyWayToMoveThem) {
  // Before anything is visible of a new target, forces are those of a person who has none.
  const Scene scene = block();
  SensedPatient a(*patient_traits("healthy"), 2);
  SensedPatient b(*patient_traits("healthy"), 2);
  a.patient.meet_object(scene);
  b.patient.meet_object(scene);
  const auto picture = [](double t_s, const Pose& target) {
    Stimulus stimulus;
    stimulus.t_s = t_s;
    stimulus.cue = Cue::move;
    stimulus.object_shown = true;
    stimulus.X_WT = target;
    stimulus.contact = {true, true, true};
    return stimulus;
  };
  const PatientTraits traits = *patient_traits("healthy");
  constexpr double kChange_s = 3.0;
  double differs_s = -1.0;
  for (int k = 0; k < 600; ++k) {
    (void)a.next_frame();
    (void)b.next_frame();
    if (differs_s < 0.0 && a.pressed[0].force != b.pressed[0].force) differs_s = a.t_s();
    a.patient.see(picture(a.t_s(), Pose{}));
    b.patient.see(picture(b.t_s(), a.t_s() < kChange_s ? Pose{} : planar(0.08, 0.0, 0.0)));
  }
  EXPECT_GE(differs_s, kChange_s + traits.visual_delay_s + traits.reaction_s);
  EXPECT_LT(differs_s, kChange_s + traits.visual_delay_s + traits.reaction_s + 0.1);
}

TEST(VirtualPatientObject, WithoutAnObjectTheHandOnlyRests) {
  SensedPatient person(*patient_traits("healthy"), 2);
  Stimulus stimulus;
  stimulus.cue = Cue::move;
  for (int k = 0; k < 300; ++k) {
    (void)person.next_frame();
    stimulus.t_s = person.t_s();
    person.patient.see(stimulus);
    for (const Wrench& wrench_C : test::every(person.pressed))
      EXPECT_LT(wrench_C.force.norm(), 0.2);
  }
}

TEST(VirtualPatientObject, MovingAnObjectAllocatesNothing) {
  VirtualPatient person(*patient_traits("paretic"), 2);
  person.meet_object(block());
  const auto before = test::allocations();
  Stimulus stimulus;
  stimulus.cue = Cue::move;
  stimulus.object_shown = true;
  stimulus.X_WT = planar(0.05, 0.02, 0.4);
  for (int ms = 0; ms < 3000; ++ms) {
    stimulus.t_s = 0.001 * ms;
    if (ms % 10 == 0) person.see(stimulus);
    (void)person.press(0.001 * ms);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::virtual_patient::object_test
