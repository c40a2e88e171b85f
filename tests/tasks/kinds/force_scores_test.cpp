// SPDX-License-Identifier: GPL-3.0-or-later
// Force tasks played with forces whose measures are known.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_direction.hpp"
#include "tasks/kinds/force/force_sense.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/grip_release.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/force/steadiness.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/force_play.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::force_scores_test {
namespace {

using test::Answer;
using test::find;
using test::grip_of;
using test::kPeriod_s;
using test::pressing;
using test::spec_of;
using test::value_of;

Signals played(const TaskSpec& spec, const Answer& answer) {
  return test::play_force(spec, answer);
}

/// Follows the last value `delay_s` late.
class Late {
 public:
  explicit Late(double delay_s)
      : frames_(static_cast<std::size_t>(std::lround(delay_s / kPeriod_s))) {}
  double operator()(double value) {
    seen_.push_back(value);
    return seen_[seen_.size() > frames_ ? seen_.size() - 1 - frames_ : 0];
  }

 private:
  std::size_t frames_;
  std::vector<double> seen_;
};

constexpr double kRounding = 1e-9;

TEST(ForceScores, AMaximumOfOneDigitIsItsBestHalfSecondAboveRestInItsChannel) {
  MaximumSpec spec;
  spec.channel = channel_of(Finger::index);
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [](const TaskView& view, double) {
              return view.cue == Cue::squeeze ? pressing(3, 25, 4) : pressing(0, 0, 0);
            }));
  EXPECT_WITHIN(value_of(measures, "maximum_force", "index"), 25.0, kRounding);
  EXPECT_EQ(find(measures, "maximum_force", "grip"), nullptr);
  EXPECT_EQ(find(measures, "net_push"), nullptr) << "one digit always pushes the platform";
}

TEST(ForceScores, OpeningIsPositiveAndThePressOfOtherDigitsBesideItIsCoflexion) {
  MaximumSpec spec;
  spec.channel.direction = Direction::minus_z;
  const double tone_N = 2.0;
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
              const bool opens = view.cue == Cue::squeeze;
              return opens ? pressing(-10, -12, tone_N + 1.1) : pressing(0, 0, tone_N);
            }));
  EXPECT_WITHIN(value_of(measures, "maximum_force", "opening"), 8.9, kRounding);
  EXPECT_WITHIN(value_of(measures, "coflexion", "opening"), 100.0 * 1.1 / 22.0, kRounding)
      << "the tone of the middle finger is none";
  EXPECT_EQ(find(measures, "coflexion")->version, 3);
}

TEST(ForceScores, ReactionsOfStepsAreTheDelayAndAnticipationsAreCountedApart) {
  StepResponseSpec spec;
  spec.to = {0.3};
  spec.repetitions = 4;
  Late late(0.25);
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
              return grip_of(late(view.force().target_force_N));
            }));
  constexpr double kOneFrame_s = kPeriod_s + kRounding;
  EXPECT_WITHIN(value_of(measures, "reaction_time"), 0.25, kOneFrame_s);
  EXPECT_WITHIN(value_of(measures, "reaction_time_corrected"),
                value_of(measures, "reaction_time") - 0.03, kRounding);
  EXPECT_WITHIN(value_of(measures, "settling_time"), 0.25, kOneFrame_s);
  EXPECT_WITHIN(value_of(measures, "overshoot"), 0.0, kRounding);
  EXPECT_EQ(value_of(measures, "reaction_time_share"), 100.0);
  EXPECT_EQ(value_of(measures, "anticipations"), 0.0);
  Late early(0.05);
  const auto hasty = score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
                             return grip_of(early(view.force().target_force_N));
                           }));
  EXPECT_EQ(value_of(hasty, "anticipations"), 4.0);
  EXPECT_FALSE(find(hasty, "reaction_time")->value);
}

TEST(ForceScores, AHandThatNeverLetsGoHasNoReleaseTimeButAShareOfZero) {
  GripReleaseSpec spec;
  spec.repetitions = 3;
  const auto stuck = score(
      spec_of(spec), played(spec_of(spec), [](const TaskView&, double) { return grip_of(10.0); }));
  EXPECT_FALSE(find(stuck, "release_time")->value);
  EXPECT_EQ(value_of(stuck, "release_time_share"), 0.0);
  EXPECT_WITHIN(value_of(stuck, "release_time_restricted"), spec.after_s, kRounding);
  EXPECT_WITHIN(value_of(stuck, "residual_force"), 10.0, kRounding);
}

TEST(ForceScores, AnExponentialReleaseReachesTenPercentAfterItsTimeConstantTimesLnTen) {
  GripReleaseSpec spec;
  spec.repetitions = 3;
  constexpr double kTime_s = 0.5;
  constexpr double kReaction_s = 0.2;
  double since_s = 0.0;
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
              since_s = view.cue == Cue::let_go ? since_s + kPeriod_s : -kPeriod_s;
              const double fading_s = std::max(0.0, since_s - kReaction_s);
              return grip_of(10.0 * std::exp(-fading_s / kTime_s));
            }));
  constexpr double kFrames_s = 2.0 * kPeriod_s;
  EXPECT_WITHIN(value_of(measures, "release_time"), kReaction_s + kTime_s * std::numbers::ln10,
                kFrames_s);
  EXPECT_WITHIN(value_of(measures, "release_initiation"), kReaction_s, kFrames_s);
}

TEST(ForceScores, ARepetitionWithoutAGripIsNeitherAReleaseNorAFailedOne) {
  GripReleaseSpec spec;  // 25 % of 40 N: 10 N are asked
  spec.repetitions = 8;
  constexpr int kReaction_rows = 30;
  for (const double noise_N : {0.0, 0.1, 0.3}) {
    int repetition = -1;
    int since_cue = 0;
    Cue before = Cue::relax;
    double sign = 1.0;
    const auto measures =
        score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
                if (view.cue == Cue::follow && before != Cue::follow) ++repetition;
                before = view.cue;
                sign = -sign;
                since_cue = view.cue == Cue::let_go ? since_cue + 1 : 0;
                const bool grips = repetition < 5 && since_cue <= kReaction_rows;
                return grip_of((grips ? 10.0 : 0.2) + sign * noise_N);
              }));
    EXPECT_EQ(value_of(measures, "grips_missed"), 3.0) << noise_N;
    EXPECT_EQ(value_of(measures, "release_time_share"), 100.0) << "of the five that were made";
    EXPECT_EQ(value_of(measures, "release_initiation_share"), 100.0);
    EXPECT_WITHIN(value_of(measures, "release_initiation"), 0.3, 1e-9);
    EXPECT_WITHIN(value_of(measures, "residual_force"), 0.2, 1e-6);
  }
}

TEST(ForceScores, AForceMadeAgainTooWeakHasThatConstantError) {
  const auto measures =
      score(spec_of(ForceSenseSpec{}),
            played(spec_of(ForceSenseSpec{}), [](const TaskView& view, double) {
              return grip_of(view.cue == Cue::reproduce ? 6.5 : view.force().target_force_N);
            }));
  EXPECT_WITHIN(value_of(measures, "constant_error"), -1.5, kRounding);  // 20 % of 40 N is 8 N
  EXPECT_WITHIN(value_of(measures, "absolute_error"), 1.5, kRounding);
  EXPECT_WITHIN(value_of(measures, "variable_error"), 0.0, kRounding);
}

TEST(ForceScores, DigitsThatDragTheirNeighbourAlongHaveThatEnslaving) {
  constexpr double kShare = 0.2;
  const auto measures =
      score(spec_of(IndividuationSpec{}),
            played(spec_of(IndividuationSpec{}), [&](const TaskView& view, double) {
              if (!view.force().has_force_target)
                return pressing(0.3, 0.3, 0.3);  // tone is no enslaving
              std::array<double, 3> force_N{0.3, 0.3, 0.3};
              const std::size_t j = index_of(*single_digit(view.force().channel));
              force_N[j] += view.force().target_force_N;
              if (j == 1) force_N[2] += kShare * view.force().target_force_N;
              return pressing(force_N[0], force_N[1], force_N[2]);
            }));
  EXPECT_WITHIN(value_of(measures, "enslaving", "index_to_middle"), kShare, kRounding);
  EXPECT_WITHIN(value_of(measures, "enslaving", "middle_to_index"), 0.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "enslaving_of_maximum", "index_to_middle"), kShare * 0.2,
                kRounding);
}

TEST(ForceScores, AForceTurnedFromItsTargetHasThatDirectionError) {
  ForceDirectionSpec spec;
  ForceDirectionTarget target;
  target.asked[0] = true;
  target.direction_C[0] = Vec3::UnitZ();
  spec.targets = {target};
  constexpr double kAngle_rad = 0.3;
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
              FingerWrenches wrench_C = grip_of(0.0);
              wrench_C[0].force = Eigen::AngleAxisd(kAngle_rad, Vec3::UnitX()) *
                                  Vec3(view.force().digit_targets.force_C[0]);
              return wrench_C;
            }));
  EXPECT_WITHIN(value_of(measures, "direction_error", "thumb"), kAngle_rad, kRounding);
  EXPECT_WITHIN(value_of(measures, "projection_ratio", "thumb"), std::cos(kAngle_rad), kRounding);
  EXPECT_EQ(find(measures, "direction_error", "index"), nullptr);
}

TEST(ForceScores, ASteadyHandHasTheSpreadThatItWasGiven) {
  SteadinessSpec spec;
  spec.levels = {0.25};
  constexpr double kAmplitude_N = 0.4;
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double t_s) {
              const double wave_N = kAmplitude_N * std::sin(2.0 * std::numbers::pi * 4.0 * t_s);
              return grip_of(view.force().target_force_N + wave_N);
            }));
  constexpr double kShortRecord =
      0.01;  // of a whole number of cycles the SD is exact but for n - 1
  EXPECT_WITHIN(value_of(measures, "force_sd", "force_25_percent"), kAmplitude_N / std::sqrt(2.0),
                kShortRecord * kAmplitude_N);
  EXPECT_GT(value_of(measures, "power_2_8_Hz", "force_25_percent"), 99.0);
}

TEST(ForceScores, LevelsOfOneNameAreToldApart) {
  SteadinessSpec spec;
  spec.levels = {0.1231, 0.25, 0.1234, 0.25};
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [](const TaskView& view, double) {
              return grip_of(view.force().target_force_N);
            }));
  std::vector<std::string> channels;
  for (const Measure& measure : measures)
    if (measure.name == "cv") channels.push_back(measure.channel);
  EXPECT_EQ(channels, (std::vector<std::string>{"force_12.3_percent", "force_25_percent",
                                                "force_12.3_percent_2", "force_25_percent_2"}));
}

TEST(ForceScores, TheDigitsShareTheGripAsTheyPress) {
  // Thumb 5, index 3, middle 2 of ten parts, in every task about a grip that lasts.
  const auto pressed = [](double grip_N) { return pressing(grip_N, 0.6 * grip_N, 0.4 * grip_N); };
  for (const TaskSpec& spec :
       {spec_of(ForceTrackingSpec{}), spec_of(SteadinessSpec{}), spec_of(MaximumSpec{})}) {
    const auto measures =
        score(spec, played(spec, [&](const TaskView& view, double) {
                return pressed(view.cue == Cue::squeeze        ? 30.0
                               : view.force().has_force_target ? view.force().target_force_N
                                                               : 0.0);
              }));
    EXPECT_WITHIN(value_of(measures, "sharing", "thumb"), 50.0, kRounding);
    EXPECT_WITHIN(value_of(measures, "sharing", "index"), 30.0, kRounding);
    EXPECT_WITHIN(value_of(measures, "sharing", "middle"), 20.0, kRounding);
    EXPECT_WITHIN(value_of(measures, "thumb_opposition"), 1.0, kRounding);
  }
  ForceTrackingSpec one;
  one.aim.channel = channel_of(Finger::index);
  const auto alone = score(spec_of(one), played(spec_of(one), [](const TaskView& view, double) {
                             return pressing(0, view.force().target_force_N, 0);
                           }));
  EXPECT_EQ(find(alone, "sharing"), nullptr) << "one digit shares nothing";
}

TEST(ForceScores, RisingAndFallingHalvesOfASineAreScoredApart) {
  const TaskSpec spec = spec_of(ForceTrackingSpec{});  // 0.2 Hz, begins at the least
  constexpr double kCycle_s = 5.0;
  const auto measures = score(spec, played(spec, [](const TaskView& view, double t_s) {
                                const double phase = std::fmod(t_s - 2.0 + kCycle_s, kCycle_s);
                                const bool rises = phase < 0.5 * kCycle_s - 0.5 * kPeriod_s;
                                return grip_of(view.force().target_force_N + (rises ? 0.0 : 1.5));
                              }));
  EXPECT_WITHIN(value_of(measures, "rmse", "force_rise"), 0.0, kRounding);
  EXPECT_EQ(value_of(measures, "time_in_range", "force_rise"), 100.0);
  EXPECT_WITHIN(value_of(measures, "rmse", "force_fall"), 1.5, kRounding);
  EXPECT_EQ(value_of(measures, "time_in_range", "force_fall"), 0.0);
  EXPECT_WITHIN(value_of(measures, "rmse", "force"), 1.5 / std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(static_cast<double>(find(measures, "rmse", "force_rise")->samples), 1500.0, 6.0)
      << "half of the rows, but for the turns";
}

TEST(ForceScores, EachPartOfATrapezoidHasItsOwnErrorAndTimeInRange) {
  ForceTrackingSpec trapezoid;
  trapezoid.waveform.shape = Waveform::Shape::trapezoid;
  const auto measures =
      score(spec_of(trapezoid), played(spec_of(trapezoid), [](const TaskView& view, double t_s) {
              const double since_s = t_s - 2.0;
              return grip_of(view.force().target_force_N + (since_s < 5.0    ? 1.0
                                                            : since_s < 20.0 ? 0.0
                                                                             : -2.0));
            }));
  EXPECT_WITHIN(value_of(measures, "rmse", "force_rise"), 1.0, 1e-2);
  EXPECT_WITHIN(value_of(measures, "rmse", "force_hold"), 0.0, kRounding);
  EXPECT_EQ(value_of(measures, "time_in_range", "force_hold"), 100.0);
  EXPECT_WITHIN(value_of(measures, "rmse", "force_fall"), 2.0, 1e-2);
}

TEST(ForceScores, AForceBeyondTheMaximumOfTheSessionShowsThatItWasNone) {
  FatigueSpec spec;
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [](const TaskView& view, double t_s) {
              const bool burst = t_s > 10.0 && t_s < 10.6;
              return grip_of(burst ? 48.0 : view.force().target_force_N);
            }));
  EXPECT_WITHIN(value_of(measures, "force_of_maximum"), 120.0, kRounding) << "of 40 N, above rest";
}

TEST(ForceScores, LetGoTimesWithoutTheDeviceAreEarlierByItsDelay) {
  GripReleaseSpec spec;
  spec.repetitions = 3;
  Late late(0.3);
  const auto measures =
      score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double) {
              return grip_of(late(view.cue == Cue::let_go ? 0.0 : 10.0));
            }));
  for (const std::string name : {"release_initiation", "release_time"})
    EXPECT_WITHIN(value_of(measures, name + "_corrected"), value_of(measures, name) - 0.03,
                  kRounding)
        << name;
}

TEST(ForceScores, DigitsThatCorrectEachOtherOverTheCyclesAreASynergy) {
  ForceTrackingSpec spec;
  spec.aim.channel.digits = Digits::sum;
  spec.waveform.frequency_Hz = 0.8;
  spec.duration_s = 20.0;  // sixteen cycles, of which the first is left out
  const auto with = [&](double between_N, double together_N) {
    return score(spec_of(spec), played(spec_of(spec), [&](const TaskView& view, double t_s) {
                   const double cycle = std::floor((t_s - 2.0 + 0.5 * kPeriod_s) * 0.8);
                   const double other = std::sin(2.4 * cycle);
                   const double each_N = view.force().target_force_N / 3.0 + together_N * other;
                   return pressing(each_N + between_N * other, each_N - between_N * other, each_N);
                 }));
  };
  constexpr double kAtTheSeams = 0.05;  // between two cycles forces are interpolated
  EXPECT_WITHIN(value_of(with(1.0, 0.0), "synergy_index"), 1.5, kAtTheSeams);
  EXPECT_WITHIN(value_of(with(0.0, 1.0), "synergy_index"), -3.0, kAtTheSeams);
  spec.duration_s = 18.0;
  EXPECT_EQ(find(with(1.0, 0.0), "synergy_index"), nullptr) << "fifteen cycles, one left out";
  spec.duration_s = 20.0;
  spec.aim.channel.digits = Digits::grip;
  EXPECT_EQ(find(with(1.0, 0.0), "synergy_index"), nullptr) << "a minimum has no gradient";
}

TEST(ForceScores, EveryTaskSaysWhyItHasNoValuesOfAnEmptyRecord) {
  test::AtLeast measures(20);
  DirectionalMaximaSpec directions;
  directions.digits = {Finger::thumb};
  directions.directions = {Direction::plus_x};
  for (const TaskSpec& spec :
       {spec_of(RestSpec{}), spec_of(MaximumSpec{}), spec_of(ForceTrackingSpec{}),
        spec_of(SteadinessSpec{}), spec_of(StepResponseSpec{}), spec_of(GripReleaseSpec{}),
        spec_of(ForceSenseSpec{}), spec_of(FatigueSpec{}), spec_of(IndividuationSpec{}),
        spec_of(ForceDirectionSpec{}), spec_of(directions)})
    for (const Measure& measure : score(spec, Signals({"t_s"}))) {
      EXPECT_FALSE(measure.value) << measure.name;
      EXPECT_FALSE(measure.reason.empty()) << measure.name;
      ++measures;
    }
}

}  // namespace
}  // namespace isograsp::tasks::force_scores_test
