// SPDX-License-Identifier: GPL-3.0-or-later
// Each trouble shows in the forces, by as much as the person's file says.
#include <numbers>

#include "device/config/platform.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/people.hpp"
#include "virtual_patient/force_skill.hpp"

namespace isograsp::virtual_patient::trouble_test {
namespace {

using test::following;
using test::Played;
using test::screen_of;
using test::shipped;

constexpr int kSeeds = 10;
constexpr ForceChannel kGrip{};

double angle_rad(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Largest grip [N] of a squeeze.
double squeezed_N(Played& play, double duration_s = 3.0) {
  double peak = 0.0;
  play.show(Cue::squeeze, kGrip, duration_s, [&](double, const FingerWrenches& wrench_C) {
    peak = std::max(peak, force_of(wrench_C, kGrip));
  });
  return peak;
}

/// From the instruction to let go until a tenth of the way from peak to rest is left [s].
double release_time_s(const PatientTraits& traits, std::uint64_t seed) {
  Played play(traits, seed);
  const double rest_N = play.mean_N(screen_of(Cue::relax), 8.0, 4.0);
  play.show(Cue::squeeze, kGrip, 4.0);
  const double peak_N = force_of(play.pressed, kGrip);
  double last_above_s = 0.0;
  play.show(Cue::let_go, kGrip, 15.0, [&](double t_s, const FingerWrenches& wrench_C) {
    if (force_of(wrench_C, kGrip) > rest_N + 0.1 * (peak_N - rest_N)) last_above_s = t_s;
  });
  return last_above_s;
}

TEST(Trouble, ThreeDegreesOfWeakness) {
  for (const auto& [name, most_N] : {std::pair{"mild", 30.0}, {"moderate", 12.0}, {"severe", 2.0}})
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Played play(shipped(name), seed);
      const double peak_N = squeezed_N(play);
      EXPECT_LE(peak_N, most_N * (1.0 + 1e-12)) << name;
      EXPECT_GT(peak_N, 0.6 * most_N) << name;
    }
}

TEST(Trouble, ASpasticHandLetsGoWithinTwoToEightSecondsAndAHealthyOneWithinOne) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double spastic_s = release_time_s(shipped("spastic"), seed);
    EXPECT_GT(spastic_s, 2.0);
    EXPECT_LT(spastic_s, 8.0);
    EXPECT_LT(release_time_s(shipped("healthy"), seed), 1.0);
  }
}

TEST(Trouble, SpasticToneIsOneToFiveNewtonsAndHigherWithEffort) {
  PatientTraits traits = shipped("spastic");
  traits.fatigue_per_s = 0.0;
  const ForceChannel middle = channel_of(Finger::middle);
  double before_N = 0.0;
  double during_N = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Played play(traits, seed);
    const double rest_N = play.mean_N(screen_of(Cue::relax, middle), 10.0, 6.0);
    EXPECT_GT(rest_N, 1.0);
    EXPECT_LT(rest_N, 5.0);
    before_N += rest_N / kSeeds;
    play.show(Cue::squeeze, channel_of(Finger::thumb), 18.0);
    play.show(Cue::squeeze, channel_of(Finger::thumb), 4.0,
              [&](double, const FingerWrenches& wrench_C) {
                during_N += force_of(wrench_C, middle) / (4000.0 * kSeeds);
              });
  }
  // The middle finger was not asked; 16 s are four time constants of tone.
  EXPECT_WITHIN(during_N / before_N, 1.0 + traits.tone_rise, 0.1);
}

TEST(Trouble, SpasticForceSpreadsMoreTheHarderTheEffort) {
  PatientTraits traits = shipped("spastic");
  traits.resting_force_N = 0.0;
  const auto spread = [&](double share) {
    const ForceChannel index = channel_of(Finger::index);
    Played play(traits, 2);
    play.show(following(index, share * traits.maximum_force_N), 6.0);
    double index_N = 0.0;
    double middle_N = 0.0;
    play.show(following(index, share * traits.maximum_force_N), 4.0,
              [&](double, const FingerWrenches& wrench_C) {
                index_N += wrench_C[1].force.z();
                middle_N += wrench_C[2].force.z();
              });
    return middle_N / index_N;
  };
  const double gently = spread(0.1);
  const double hard = spread(0.6);
  EXPECT_GT(gently, traits.enslaving);
  EXPECT_GT(hard, gently + 0.1);
}

TEST(Trouble, MisdirectedForcesKeepTheirSizeAndTurnByTheAngle) {
  const Vec3 drift = Vec3(1.0, 0.0, 1.0).normalized();
  for (const Vec3& force :
       {Vec3(0, 0, 5), Vec3(0, 0, -5), Vec3(-3, 0, 0), Vec3(0, 4, 0), Vec3(1, -2, 2)})
    for (const double angle : {0.0, 0.1, 0.5}) {
      const Vec3 turned = misdirected(force, angle);
      EXPECT_WITHIN(turned.norm(), force.norm(), 1e-12);
      EXPECT_WITHIN(angle_rad(turned, force), angle, 1e-12);
      EXPECT_LE(angle_rad(turned, drift), angle_rad(force, drift) + 1e-12);
    }
  EXPECT_EQ(misdirected(5.0 * drift, 0.5), 5.0 * drift) << "nothing to drift to";
  EXPECT_LT(angle_rad(misdirected(drift + Vec3(0, 0.1, 0), 0.5), drift), 1e-7) << "not beyond";
}

TEST(Trouble, DirectionErrorsShowInTheForces) {
  PatientTraits traits = shipped("direction_error");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const double said_rad = traits.direction_error_rad[f];
    EXPECT_GE(said_rad, 10.0 * kDegree_rad - 1e-9);
    EXPECT_LE(said_rad, 30.0 * kDegree_rad + 1e-9);
    const ForceChannel digit = channel_of(kFingers[f]);
    Played play(traits, 3);
    play.show(following(digit, 8.0), 5.0);
    Vec3 sum = Vec3::Zero();
    play.show(following(digit, 8.0), 5.0,
              [&](double, const FingerWrenches& wrench_C) { sum += wrench_C[f].force; });
    // The thumb's z is shared with the fingers, not its x: that costs at most this.
    constexpr double kCoupling_rad = 1.0 * kDegree_rad;
    EXPECT_WITHIN(angle_rad(sum, Vec3::UnitZ()), said_rad, kCoupling_rad) << f;
  }
}

TEST(Trouble, TheArmPushesByItsShareOfTheGrip) {
  const PatientTraits traits = shipped("arm_push");
  Played play(traits, 3);
  play.show(following(kGrip, 10.0), 5.0);
  Vec3 net = Vec3::Zero();
  double grip = 0.0;
  play.show(following(kGrip, 10.0), 10.0, [&](double, const FingerWrenches& wrench_C) {
    net += net_wrench(Platform(), wrench_C).force;
    grip += 0.5 * (wrench_C[0].force.z() + wrench_C[1].force.z() + wrench_C[2].force.z());
  });
  const Vec3 share = net / grip;
  const Vec3 said(traits.arm_push[0], traits.arm_push[1], traits.arm_push[2]);
  // Noise of 4 % per digit does not cancel in full over 10 s.
  EXPECT_LT((share - said).norm(), 0.05);
  EXPECT_GT(share.norm(), 0.2) << "what a report flags";
}

/// Mean over people of |force - target| / target after the own force was hidden.
double unseen_error(const char* name) {
  const PatientTraits traits = shipped(name);
  const double target_N = 0.3 * traits.maximum_force_N;
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Played play(traits, seed);
    play.show(following(kGrip, target_N), 6.0);
    sum += std::abs(play.mean_N(following(kGrip, target_N, false), 10.0, 2.0) / target_N - 1.0);
  }
  return sum / kSeeds;
}

TEST(Trouble, LossOfForceSenseShowsOnlyWithoutTheForceOnTheScreen) {
  const PatientTraits traits = shipped("sensory_loss");
  const double target_N = 0.3 * traits.maximum_force_N;
  double seen = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Played play(traits, seed);
    seen += std::abs(play.mean_N(following(kGrip, target_N), 10.0, 2.0) / target_N - 1.0) / kSeeds;
  }
  EXPECT_LT(seen, 0.05);
  EXPECT_GT(unseen_error("sensory_loss"), 5.0 * seen);
  EXPECT_GT(unseen_error("sensory_loss"), 2.0 * unseen_error("mild"));
  EXPECT_LT(unseen_error("healthy"), 0.05);
}

TEST(Trouble, MissedInstructionsAreCountedAndAsManyAsSaid) {
  const PatientTraits traits = shipped("inattention");
  Played play(traits, 3);
  constexpr int kPairs = 200;
  for (int pair = 0; pair < kPairs; ++pair) {
    play.show(Cue::squeeze, kGrip, 1.0);
    play.show(Cue::relax, kGrip, 1.0);
  }
  // Binomial: 3.5 SD.
  const double p = traits.missed_cue_probability;
  const double n = 2.0 * kPairs;
  EXPECT_WITHIN(play.person.missed_cues(), n * p, 3.5 * std::sqrt(n * p * (1.0 - p)));

  Played attentive(shipped("mild"), 3);
  attentive.show(Cue::squeeze, kGrip, 1.0);
  EXPECT_EQ(attentive.person.missed_cues(), 0);
}

TEST(Trouble, AMissedInstructionIsFollowedLate) {
  PatientTraits traits = shipped("mild");
  traits.missed_cue_probability = 1.0;
  Played play(traits, 3);
  play.show(Cue::relax, kGrip, 6.0);
  double first_s = 0.0;
  play.show(Cue::squeeze, kGrip, 8.0, [&](double t_s, const FingerWrenches& wrench_C) {
    if (first_s == 0.0 && force_of(wrench_C, kGrip) > 3.0) first_s = t_s;
  });
  EXPECT_GT(first_s, traits.lapse_s);
  EXPECT_LT(first_s, traits.lapse_s + 2.0);
  EXPECT_EQ(play.person.missed_cues(), 2);
}

TEST(Trouble, FatigueLowersTheForceOfThirtySecondsAndRestReturnsIt) {
  const PatientTraits traits = shipped("fatiguing");
  Played play(traits, 3);
  const double target_N = 0.5 * traits.maximum_force_N;
  const double first_N = play.mean_N(following(kGrip, target_N), 5.0, 2.0);
  const double last_N = play.mean_N(following(kGrip, target_N), 27.0, 2.0);
  EXPECT_LT(last_N, 0.9 * first_N);
  const double tired_N = squeezed_N(play);
  play.show(Cue::relax, kGrip, 3.0 * traits.recovery_s);
  const double rested_N = squeezed_N(play);
  EXPECT_GT(rested_N, 1.3 * tired_N);
  EXPECT_LE(rested_N, traits.maximum_force_N * (1.0 + 1e-12));
}

TEST(Trouble, FatigueOfASustainedMaximumFollowsItsEquation) {
  PatientTraits traits;
  traits.force_cv = traits.tremor_fraction = 0.0;
  traits.fatigue_per_s = 0.03;
  traits.recovery_s = 100.0;
  Played play(traits, 3);
  play.show(Cue::squeeze, kGrip, 3.0);
  // At a maximum the effort is what is left, a: a' = -k a^2 + (1 - a) / r, by Runge-Kutta.
  double left = force_of(play.pressed, kGrip) / traits.maximum_force_N;
  const auto slope = [&](double a) {
    return -traits.fatigue_per_s * a * a + (1.0 - a) / traits.recovery_s;
  };
  constexpr double kStep_s = 0.1;
  for (int step = 0; step < 300; ++step) {
    const double k1 = slope(left);
    const double k2 = slope(left + 0.5 * kStep_s * k1);
    left += kStep_s * k2;
  }
  play.show(Cue::squeeze, kGrip, 30.0);
  // The lags of 80 ms carry on an older, larger strength.
  EXPECT_WITHIN(force_of(play.pressed, kGrip) / traits.maximum_force_N, left, 0.003);
}

TEST(Trouble, SubmaximalEffortStaysBelowWhatTheHandCan) {
  const PatientTraits traits = shipped("submaximal");
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Played play(traits, seed);
    const double peak_N = squeezed_N(play);
    EXPECT_LT(peak_N, 0.75 * traits.maximum_force_N);
    // Asked to follow, they go higher than their "maximum".
    EXPECT_GT(play.mean_N(following(kGrip, 0.8 * traits.maximum_force_N), 10.0, 2.0), peak_N);
  }
}

TEST(Trouble, PainEndsAnEffortAndIsCounted) {
  const PatientTraits traits = shipped("pain_stop");
  Played play(traits, 3);
  EXPECT_GT(squeezed_N(play, 6.0), traits.pain_at * traits.maximum_force_N);
  EXPECT_EQ(play.person.pain_stops(), 1);
  EXPECT_LT(force_of(play.pressed, kGrip), 0.1 * traits.maximum_force_N) << "gave up";
  play.show(Cue::relax, kGrip, 3.0);
  play.show(following(kGrip, 0.3 * traits.maximum_force_N), 5.0);
  EXPECT_GT(force_of(play.pressed, kGrip), 0.2 * traits.maximum_force_N) << "below the pain";
  EXPECT_EQ(play.person.pain_stops(), 1);
}

TEST(Trouble, SlowWanderIsSlow) {
  // Force every half second: neighbours of an Ornstein-Uhlenbeck process of time constant T are
  // correlated by exp(-0.5 s / T).
  const auto correlation = [](const PatientTraits& traits) {
    constexpr int kValues = 600;
    Played play(traits, 3);
    play.show(screen_of(Cue::press, channel_of(Finger::index)), 4.0);
    std::vector<double> force_N;
    double mean_N = 0.0;
    for (int k = 0; k < kValues; ++k) {
      play.show(screen_of(Cue::press, channel_of(Finger::index)), 0.5);
      force_N.push_back(play.pressed[1].force.z());
      mean_N += force_N.back() / kValues;
    }
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t k = 1; k < force_N.size(); ++k) {
      products += (force_N[k] - mean_N) * (force_N[k - 1] - mean_N);
      squares += std::pow(force_N[k] - mean_N, 2);
    }
    return products / squares;
  };
  PatientTraits traits = shipped("slow_wander");
  traits.fatigue_per_s = traits.tone_rise = 0.0;
  EXPECT_EQ(traits.tremor_fraction, 0.0);
  EXPECT_LT(1.0 / (2.0 * std::numbers::pi * traits.wander_s), 0.5) << "below half a hertz";
  constexpr double kError = 0.12;  // three standard errors of 600 values
  EXPECT_WITHIN(correlation(traits), std::exp(-0.5 / traits.wander_s), kError);
  traits.wander_s = 0.05;
  EXPECT_WITHIN(correlation(traits), 0.0, kError);
}

}  // namespace
}  // namespace isograsp::virtual_patient::trouble_test
