// SPDX-License-Identifier: GPL-3.0-or-later
// The person and a force on the screen: squeeze, relax, follow, hand out.
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/closed_loop.hpp"

namespace isograsp::virtual_patient::force_test {
namespace {

using test::grip_N;
using test::kFrame_s;
using test::SensedPatient;

constexpr int kSeeds = 20;

PatientTraits traits(const char* name) {
  return *patient_traits(name);
}

Stimulus picture(double t_s, Cue cue) {
  Stimulus stimulus;
  stimulus.t_s = t_s;
  stimulus.cue = cue;
  return stimulus;
}

/// Grip of every frame while the cue stays the same.
std::vector<double> grips(SensedPatient& person, Cue cue, double duration_s) {
  std::vector<double> result;
  for (int k = 0; k < std::lround(duration_s / kFrame_s); ++k) {
    result.push_back(grip_N(person.next_frame()));
    person.patient.see(picture(person.t_s(), cue));
  }
  return result;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Root mean square tracking error [N] of a sine between 10 and 30 % of the maximum, 0.2 Hz, after
/// 4 s of its first value: 25 s are scored.
double tracking_rmse_N(const PatientTraits& person_traits, std::uint64_t seed) {
  SensedPatient person(person_traits, seed);
  constexpr double kLeadIn_s = 4.0;
  double square_sum = 0.0;
  int scored = 0;
  for (int k = 0; k < 2900; ++k) {
    const FingerWrenches wrench_C = person.next_frame();
    const double since_s = std::max(0.0, person.t_s() - kLeadIn_s);
    Stimulus stimulus = picture(person.t_s(), Cue::follow);
    stimulus.force_target_shown = true;
    stimulus.target_force_N =
        person_traits.maximum_force_N * (0.2 - 0.1 * std::cos(0.4 * std::numbers::pi * since_s));
    stimulus.shown_force_N = grip_N(wrench_C);
    person.patient.see(stimulus);
    if (since_s == 0.0) continue;
    square_sum += std::pow(stimulus.shown_force_N - stimulus.target_force_N, 2);
    ++scored;
  }
  return std::sqrt(square_sum / scored);
}

TEST(VirtualPatientForce, UnknownPeopleAreUnknown) {
  EXPECT_TRUE(patient_traits("healthy"));
  EXPECT_TRUE(patient_traits("paretic"));
  EXPECT_FALSE(patient_traits("sleepy"));
}

TEST(VirtualPatientForce, AHandOutOfTheDeviceLeavesExactlyNoForce) {
  VirtualPatient person(traits("paretic"), 3);
  const auto empty = [&](int from_ms, int to_ms) {
    bool all_zero = true;
    for (int ms = from_ms; ms < to_ms; ++ms)
      for (const Wrench& wrench_C : person.press(0.001 * ms))
        all_zero &= wrench_C.force == Vec3::Zero() && wrench_C.torque == Vec3::Zero();
    return all_zero;
  };
  EXPECT_TRUE(empty(0, 1000)) << "nobody has put a hand in yet";
  person.see(picture(1.0, Cue::squeeze));
  EXPECT_FALSE(empty(1000, 4000));
  person.see(picture(4.0, Cue::hand_out));
  EXPECT_FALSE(empty(4000, 5000)) << "taking the hand out takes a reaction time";
  EXPECT_TRUE(empty(5000, 6000));
}

TEST(VirtualPatientForce, NothingHappensBeforeDelayAndReaction) {
  for (const char* name : {"healthy", "paretic"}) {
    const PatientTraits person_traits = traits(name);
    VirtualPatient person(person_traits, 1);
    person.see(picture(0.0, Cue::squeeze));
    const double earliest_s = person_traits.visual_delay_s + person_traits.reaction_s;
    double first_s = -1.0;
    for (int ms = 0; ms < 3000 && first_s < 0.0; ++ms)
      if (person.press(0.001 * ms)[0].force.z() > 0.0) first_s = 0.001 * ms;
    EXPECT_GE(first_s, earliest_s) << name;
    EXPECT_LT(first_s, earliest_s + 0.01) << name;
  }
}

TEST(VirtualPatientForce, ASqueezeReachesAboutTheMaximumAndNoTwoAreEqual) {
  for (const char* name : {"healthy", "paretic"}) {
    const double maximum_N = traits(name).maximum_force_N;
    SensedPatient person(traits(name), 5);
    const double first = largest(grips(person, Cue::squeeze, 4.0));
    (void)grips(person, Cue::relax, 6.0);
    const double second = largest(grips(person, Cue::squeeze, 4.0));
    EXPECT_NE(first, second);
    for (const double peak_N : {first, second}) {
      EXPECT_GT(peak_N, 0.80 * maximum_N) << name;
      EXPECT_LT(peak_N, 1.10 * maximum_N) << name;
    }
  }
}

TEST(VirtualPatientForce, RelaxedFingersKeepTheirToneAndNoMore) {
  for (const char* name : {"healthy", "paretic"}) {
    const PatientTraits person_traits = traits(name);
    SensedPatient person(person_traits, 5);
    (void)grips(person, Cue::squeeze, 4.0);
    (void)grips(person, Cue::relax, 6.0);
    double sum_N = 0.0;
    for (int k = 0; k < 1000; ++k) {
      sum_N += person.next_frame()[1].force.z();
      person.patient.see(picture(person.t_s(), Cue::relax));
    }
    // The mean of 1000 readings of half a count each, and of slow noise of 5 %.
    EXPECT_WITHIN(sum_N / 1000, person_traits.resting_force_N,
                  0.02 + 0.1 * person_traits.resting_force_N);
  }
}

TEST(VirtualPatientForce, AHealthyPersonTracksASineWithinAFewPercentOfTheirMaximum) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double percent = 100.0 * tracking_rmse_N(traits("healthy"), seed) / 60.0;
    EXPECT_LT(percent, 3.0);
    EXPECT_GT(percent, 0.3) << "no person is that good";
  }
}

TEST(VirtualPatientForce, EveryPareticPersonTracksClearlyWorseThanEveryHealthyOne) {
  double worst_healthy = 0.0;
  double best_paretic = 1.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    worst_healthy = std::max(worst_healthy, tracking_rmse_N(traits("healthy"), seed) / 60.0);
    best_paretic = std::min(best_paretic, tracking_rmse_N(traits("paretic"), seed) / 12.0);
  }
  RecordProperty("worst_healthy_percent", std::to_string(100.0 * worst_healthy));
  RecordProperty("best_paretic_percent", std::to_string(100.0 * best_paretic));
  EXPECT_GT(best_paretic, 2.0 * worst_healthy);
}

TEST(VirtualPatientForce, TheThumbOpposesTheTwoFingersInEquilibrium) {
  SensedPatient person(traits("healthy"), 9);
  double difference_N = 0.0;
  double sum_N = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const FingerWrenches wrench_C = person.next_frame();
    Stimulus stimulus = picture(person.t_s(), Cue::follow);
    stimulus.force_target_shown = true;
    stimulus.target_force_N = 12.0;
    stimulus.shown_force_N = grip_N(wrench_C);
    person.patient.see(stimulus);
    if (k < 300) continue;
    difference_N += wrench_C[0].force.z() - wrench_C[1].force.z() - wrench_C[2].force.z();
    sum_N += wrench_C[0].force.z();
  }
  constexpr double kNetPush = 0.05;  // of the grip: slow noise of 3 % of each digit
  EXPECT_LT(std::abs(difference_N), kNetPush * sum_N);
}

TEST(VirtualPatientForce, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot) {
  const auto bytes = [](std::uint64_t seed) {
    VirtualPatient person(traits("paretic"), seed);
    std::string all;
    for (int ms = 0; ms < 5000; ++ms) {
      if (ms % 10 == 0) person.see(picture(0.001 * ms, ms < 2000 ? Cue::squeeze : Cue::relax));
      for (const Wrench& wrench_C : person.press(0.001 * ms)) {
        char raw[3 * sizeof(double)];
        std::memcpy(raw, wrench_C.force.data(), sizeof raw);
        all.append(raw, sizeof raw);
      }
    }
    return all;
  };
  EXPECT_EQ(bytes(7), bytes(7));
  EXPECT_NE(bytes(7), bytes(8));
}

TEST(VirtualPatientForce, SeeingAndPressingAllocateNothing) {
  VirtualPatient person(traits("healthy"), 1);
  const auto before = test::allocations();
  for (int ms = 0; ms < 5000; ++ms) {
    if (ms % 10 == 0) {
      Stimulus stimulus = picture(0.001 * ms, ms < 3000 ? Cue::follow : Cue::squeeze);
      stimulus.force_target_shown = true;
      stimulus.target_force_N = 5.0;
      person.see(stimulus);
    }
    (void)person.press(0.001 * ms);
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(VirtualPatientForce, ASessionThatBeginsAgainIsPlayedAgain) {
  VirtualPatient person(traits("healthy"), 1);
  const auto peak_N = [&] {
    double peak = 0.0;
    for (int ms = 0; ms < 4000; ++ms) {
      if (ms % 10 == 0) person.see(picture(0.001 * ms, Cue::squeeze));
      peak = std::max(peak, person.press(0.001 * ms)[0].force.z());
    }
    return peak;
  };
  EXPECT_GT(peak_N(), 50.0);
  EXPECT_GT(peak_N(), 50.0);
}

}  // namespace
}  // namespace isograsp::virtual_patient::force_test
