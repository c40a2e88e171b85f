// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/release.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::release_test {
namespace {

using test::sampled;
using test::times;

constexpr double kLsb_N = 0.04;
constexpr double kCue_s = 3.0;
constexpr double kAsked_N = 20.0;
const AskedGrip kGrip{kAsked_N, 1.0, 0.01, kLsb_N};

/// Holds 21 N (20 above rest) until `start_s`, then falls with `slope` to `left_N` above rest.
std::vector<double> let_go(const std::vector<double>& t_s, double start_s, double slope_N_per_s,
                           double left_N = 0.0) {
  return sampled(t_s, [&](double s) {
    return 1.0 + std::max(left_N, 20.0 - slope_N_per_s * std::max(0.0, s - start_s));
  });
}

TEST(Release, AStraightFallHasItsClosedFormAtAnyRateOriginAndUnit) {
  for (const double rate_Hz : {100.0, 500.0})
    for (const double shift_s : {0.0, 500.0})
      for (const double unit : {1.0, 1000.0}) {
        const auto t = times(static_cast<std::size_t>(10.0 * rate_Hz), rate_Hz, shift_s);
        auto x = let_go(t, shift_s + kCue_s + 0.3, 10.0);
        for (double& value : x) value *= unit;
        const Release found = release(t, x, shift_s + kCue_s,
                                      {unit * kAsked_N, unit * 1.0, unit * 0.01, unit * kLsb_N});
        constexpr double kRounding_s = 1e-9;
        EXPECT_WITHIN(found.release.time_s.value.value(), 0.3 + 18.0 / 10.0, kRounding_s);
        EXPECT_GE(found.initiation.time.time_s.value.value(), 0.308 - kRounding_s);  // 2 LSB
        EXPECT_LE(found.initiation.time.time_s.value.value(), 0.308 + 1.0 / rate_Hz + kRounding_s);
        EXPECT_WITHIN(found.residual_N.value.value() / unit, 0.0, kRounding_s);
        const double fastest = found.fastest_N_per_s.value.value() / unit;
        constexpr double kOvershoot = 1.1;  // of the low-pass where the slope begins and ends
        EXPECT_GE(fastest, 10.0);
        EXPECT_LE(fastest, 10.0 * kOvershoot);
      }
}

TEST(Release, ForceThatStaysIsResidualAndTheReleaseIsCensored) {
  const auto t = times(1001);
  const Release found = release(t, let_go(t, kCue_s + 0.3, 10.0, 4.0), kCue_s, kGrip);
  EXPECT_FALSE(found.release.time_s.value);
  EXPECT_EQ(english(found.release.time_s.reason), "not released");
  EXPECT_WITHIN(found.release.longer_than_s.value(), 7.0, 1e-12);
  EXPECT_WITHIN(found.residual_N.value.value(), 4.0, 1e-9);
  EXPECT_TRUE(found.initiation.time.time_s.value);
}

TEST(Release, ResidualForceIsTheMeanOf200MillisecondsAroundTheFifthSecond) {
  const auto t = times(1000);
  auto x = let_go(t, kCue_s + 0.3, 100.0);
  for (std::size_t k = 790; k < 800; ++k) x[k] += 3.0;  // 7.9 to 8.0 s
  EXPECT_WITHIN(release(t, x, kCue_s, kGrip).residual_N.value.value(), 1.5, 1e-9);
  const auto short_t = times(780);
  const auto short_x = let_go(short_t, kCue_s + 0.3, 100.0);
  const Release cut = release(short_t, short_x, kCue_s, kGrip);
  EXPECT_FALSE(cut.residual_N.value);
  EXPECT_TRUE(cut.release.time_s.value);
}

TEST(Release, ARecordThatEndsInTheMiddleOfThatWindowHasItsMeanWhereverItsTimeBegins) {
  for (const double shift_s : {0.0, 0.003, 0.1, 0.3, 0.7, 17.013, 1234.5})
    for (const std::size_t cue_row : {300U, 317U, 345U, 402U}) {
      const auto t = times(cue_row + 500, 100.0, shift_s);  // half of the 200 ms are recorded
      const auto x = let_go(t, t[cue_row] + 0.3, 10.0, 4.0);
      const Release found = release(t, x, t[cue_row], kGrip);
      ASSERT_TRUE(found.residual_N.value) << shift_s << " s, row " << cue_row;
      EXPECT_WITHIN(*found.residual_N.value, 4.0, 1e-9);
    }
}

TEST(Release, ADipThatDoesNotLastIsNoRelease) {
  const auto t = times(1000);
  auto x = let_go(t, kCue_s + 1.0, 1000.0);
  for (std::size_t k = 350; k < 353; ++k) x[k] = 1.0;  // 30 ms
  const Release found = release(t, x, kCue_s, kGrip);
  EXPECT_GT(found.release.time_s.value.value(), 1.0);
  EXPECT_GE(found.initiation.time.time_s.value.value(), 1.0);
}

TEST(Release, LettingGoBeforeTheCueIsAnticipationAndNoTime) {
  const auto t = times(1000);
  const Release found = release(t, let_go(t, kCue_s - 0.2, 1000.0), kCue_s, kGrip);
  EXPECT_EQ(english(found.release.time_s.reason), "let go before the cue");
  EXPECT_FALSE(found.release.longer_than_s);
}

TEST(Release, WithoutAGripOrACueThereIsNothingToRelease) {
  const auto t = times(1000);
  const Release empty = release(t, std::vector<double>(1000, 1.0), kCue_s, kGrip);
  EXPECT_EQ(english(empty.release.time_s.reason), "no grip was made");
  EXPECT_FALSE(empty.release.longer_than_s);
  EXPECT_FALSE(empty.residual_N.value);
  EXPECT_FALSE(*empty.grip_made);
  const auto x = let_go(t, kCue_s + 0.3, 10.0);
  EXPECT_EQ(english(release(t, x, 20.0, kGrip).release.time_s.reason),
            "no force held before the cue");
  EXPECT_EQ(english(release(t, x, 0.0, kGrip).release.time_s.reason),
            "no force held before the cue");
}

TEST(Release, AGripWasMadeFromHalfOfWhatWasAskedOnWhateverTheNoise) {
  const auto t = times(1000);
  for (const double noise_N : {0.0, 0.05, 0.2}) {
    const auto gripped = [&](double held_N) {
      auto x = sampled(t, [&](double s) { return 1.0 + (s < kCue_s + 0.3 ? held_N : 0.0); });
      for (std::size_t k = 0; k < x.size(); ++k) x[k] += k % 2 == 0 ? noise_N : -noise_N;
      return release(t, x, kCue_s, kGrip).grip_made.value();
    };
    EXPECT_TRUE(gripped(9.6)) << "half of 19 N above rest, and a little";
    EXPECT_FALSE(gripped(9.4)) << noise_N;
    EXPECT_FALSE(gripped(0.17)) << noise_N;
  }
}

TEST(Release, ToneAsHighAsWhatIsAskedIsNoGripUnlessMoreCanBeToldFromIt) {
  const auto t = times(1000);
  const AskedGrip weak{1.0, 1.5, 0.1, 0.02};
  EXPECT_WITHIN(weak.least_N(), 0.3, 1e-12);
  const auto held = [&](double held_N) { return std::vector<double>(t.size(), held_N); };
  EXPECT_FALSE(release(t, held(1.7), kCue_s, weak).grip_made.value());
  EXPECT_TRUE(release(t, held(1.9), kCue_s, weak).grip_made.value());
}

}  // namespace
}  // namespace isograsp::tasks::release_test
