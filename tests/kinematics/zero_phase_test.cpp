// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/measures/zero_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::zero_phase_test {
namespace {

constexpr double kPi = std::numbers::pi;
/// Two passes over some hundred rows: rounding times the numbers of a second.
constexpr double kExact = 1e-12;

std::vector<double> times(double rate_Hz, int rows) {
  std::vector<double> t_s;
  for (int k = 0; k < rows; ++k) t_s.push_back(k / rate_Hz);
  return t_s;
}

template <class Value, class Motion>
std::vector<Value> sampled(const std::vector<double>& t_s, const Motion& motion) {
  std::vector<Value> all;
  for (const double when_s : t_s) all.push_back(motion(when_s));
  return all;
}

Quat turned(const Vec3& phi) {
  return phi.norm() > 0.0 ? Quat(Eigen::AngleAxisd(phi.norm(), phi.normalized()))
                          : Quat::Identity();
}

/// Of random sines below 3 Hz.
struct RandomMotion {
  explicit RandomMotion(Random& random) {
    for (int k = 0; k < 4; ++k)
      parts.push_back(
          {3.0 * random.uniform(), 6.0 * random.uniform(), test::random_vector(random, 0.1)});
  }
  Vec3 operator()(double t_s) const {
    Vec3 p = Vec3::Zero();
    for (const Part& part : parts)
      p += std::sin(2.0 * kPi * part.rate_Hz * t_s + part.phase) * part.size;
    return p;
  }
  struct Part {
    double rate_Hz, phase;
    Vec3 size;
  };
  std::vector<Part> parts;
};

TEST(ZeroPhase, StandingStillAndEvenMotionStayWhatTheyAre) {
  Random random(1);
  for (const double rate_Hz : {50.0, 100.0, 120.0, 500.0})
    for (const int rows : {2, 3, 7, 60, 700}) {
      const auto t_s = times(rate_Hz, rows);
      const Vec3 p_0 = test::random_vector(random, 2.0);
      const Vec3 v = rows == 7 ? Vec3(Vec3::Zero()) : test::random_vector(random, 1.0);
      const auto p = sampled<Vec3>(t_s, [&](double when_s) { return Vec3(p_0 + when_s * v); });
      const auto smooth = zero_phase(t_s, p);
      const auto speed = velocities(t_s, smooth);
      for (std::size_t k = 0; k < p.size(); ++k) {
        EXPECT_WITHIN((smooth[k] - p[k]).norm(), 0.0, kExact) << rate_Hz << " Hz, " << rows;
        EXPECT_WITHIN((speed[k] - v).norm(), 0.0, kExact * rate_Hz);
      }
    }
}

TEST(ZeroPhase, ATurnAtConstantRateStaysWhatItIs) {
  Random random(2);
  for (const int rows : {2, 5, 60, 700}) {
    const auto t_s = times(100.0, rows);
    const Quat start = test::random_attitude(random);
    const Vec3 w = test::random_vector(random, 8.0);  // several whole turns in seven seconds
    const auto q = sampled<Quat>(t_s, [&](double when_s) { return turned(when_s * w) * start; });
    const auto smooth = zero_phase(t_s, q);
    const auto rate = angular_velocities(t_s, smooth);
    for (std::size_t k = 0; k < q.size(); ++k) {
      EXPECT_WITHIN(angle_between(smooth[k], q[k]), 0.0, kExact) << rows;
      EXPECT_WITHIN((rate[k] - w).norm(), 0.0, 100.0 * kExact);
    }
  }
}

/// Amplitude of what is left of a sine of 1, by least squares in the middle of a long record.
template <class Left>
double gain_of(double rate_Hz, double sine_Hz, const Left& left) {
  const auto t_s = times(rate_Hz, static_cast<int>(8.0 * rate_Hz));
  const std::vector<double> y = left(t_s);
  double sines = 0.0, cosines = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    if (t_s[k] < 3.0 || t_s[k] >= 5.0) continue;  // whole periods
    sines += 2.0 * y[k] * std::sin(2.0 * kPi * sine_Hz * t_s[k]);
    cosines += 2.0 * y[k] * std::cos(2.0 * kPi * sine_Hz * t_s[k]);
    ++count;
  }
  EXPECT_WITHIN(cosines / count, 0.0, 1e-11) << "no phase";
  return sines / count;
}

TEST(ZeroPhase, AtTheCutOffBothPassesTogetherLeaveMinus3DecibelsAndNoPhase) {
  for (const double rate_Hz : {50.0, 100.0, 200.0, 500.0})
    for (const double cutoff_Hz : {kMotionCutoff_Hz, 10.0}) {
      const double of_position = gain_of(rate_Hz, cutoff_Hz, [&](const auto& t_s) {
        const auto p = sampled<Vec3>(t_s, [&](double when_s) {
          return Vec3(std::sin(2.0 * kPi * cutoff_Hz * when_s), 0.0, 0.0);
        });
        std::vector<double> y;
        for (const Vec3& left : zero_phase(t_s, p, cutoff_Hz)) y.push_back(left.x());
        return y;
      });
      EXPECT_WITHIN(of_position, 1.0 / std::numbers::sqrt2, kExact) << rate_Hz;
      constexpr double kSmall_rad = 1e-4;  // turns so small are vectors, up to their square
      const double of_attitude = gain_of(rate_Hz, cutoff_Hz, [&](const auto& t_s) {
        const auto q = sampled<Quat>(t_s, [&](double when_s) {
          return turned(Vec3(0.0, kSmall_rad * std::sin(2.0 * kPi * cutoff_Hz * when_s), 0.0));
        });
        std::vector<double> y;
        for (const Quat& left : zero_phase(t_s, q, cutoff_Hz))
          y.push_back(rotation_vector(left).y() / kSmall_rad);
        return y;
      });
      EXPECT_WITHIN(of_attitude, 1.0 / std::numbers::sqrt2, kSmall_rad * kSmall_rad) << rate_Hz;
    }
}

TEST(ZeroPhase, FarBelowTheCutOffNothingIsLostAndFarAboveNothingIsLeft) {
  const auto gain = [](double sine_Hz) {
    return gain_of(200.0, sine_Hz, [&](const auto& t_s) {
      const auto p = sampled<Vec3>(t_s, [&](double when_s) {
        return Vec3(std::sin(2.0 * kPi * sine_Hz * when_s), 0.0, 0.0);
      });
      std::vector<double> y;
      for (const Vec3& left : zero_phase(t_s, p)) y.push_back(left.x());
      return y;
    });
  };
  EXPECT_WITHIN(gain(1.0), 1.0, 4e-4) << "(1/6)^4 (sqrt 2 - 1)";
  EXPECT_LT(gain(30.0), 0.004) << "fourth order: above 1 / (5^4 (sqrt 2 - 1)) nothing";
}

TEST(ZeroPhase, ARecordPlayedBackwardGivesTheSameBackward) {
  Random random(3);
  const RandomMotion motion(random);
  const auto t_s = times(100.0, 90);
  auto p = sampled<Vec3>(t_s, motion);
  auto q = sampled<Quat>(t_s, [&](double when_s) { return turned(8.0 * motion(when_s)); });
  const auto forward_p = zero_phase(t_s, p);
  const auto forward_q = zero_phase(t_s, q);
  std::reverse(p.begin(), p.end());
  std::reverse(q.begin(), q.end());
  auto backward_p = zero_phase(t_s, p);
  auto backward_q = zero_phase(t_s, q);
  std::reverse(backward_p.begin(), backward_p.end());
  std::reverse(backward_q.begin(), backward_q.end());
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    EXPECT_WITHIN((forward_p[k] - backward_p[k]).norm(), 0.0, kExact);
    EXPECT_WITHIN(angle_between(forward_q[k], backward_q[k]), 0.0, kExact);
  }
}

TEST(ZeroPhase, AttitudesDoNotDependOnTheFramesThatAreGluedOn) {
  Random random(4);
  const RandomMotion motion(random);
  const auto t_s = times(100.0, 150);
  const Quat left = test::random_attitude(random), right = test::random_attitude(random);
  const auto q = sampled<Quat>(t_s, [&](double when_s) { return turned(8.0 * motion(when_s)); });
  std::vector<Quat> glued;
  for (const Quat& one : q) glued.push_back(left * one * right);
  for (std::size_t k = 0; k < glued.size(); k += 3)
    glued[k] = Quat(-glued[k].w(), -glued[k].x(), -glued[k].y(), -glued[k].z());
  const auto plain = zero_phase(t_s, q);
  const auto other = zero_phase(t_s, glued);
  const auto rate = angular_velocities(t_s, plain);
  const auto other_rate = angular_velocities(t_s, other);
  for (std::size_t k = 0; k < q.size(); ++k) {
    EXPECT_WITHIN(angle_between(left * plain[k] * right, other[k]), 0.0, kExact);
    EXPECT_WITHIN((left * rate[k] - other_rate[k]).norm(), 0.0, 100.0 * kExact);
    if (k > 0) {
      EXPECT_GT(other[k].dot(other[k - 1]), 0.0) << "continuous sign";
    }
  }
}

TEST(ZeroPhase, TheRateOfTheCamerasDoesNotMatter) {
  Random random(5);
  const RandomMotion motion(random);
  // The axis of frequencies is bent by tan(pi f / rate): below 3 Hz at 50 Hz by 2.4 % of f, hence
  // of a loss of 2.5 % by a tenth of it.
  constexpr double kBent = 4e-3;
  const auto at = [&](double rate_Hz) {
    const auto t_s = times(rate_Hz, static_cast<int>(4.0 * rate_Hz) + 1);
    const auto p = zero_phase(t_s, sampled<Vec3>(t_s, motion));
    std::vector<Vec3> tenths;
    for (int k = 10; k <= 30; ++k)
      tenths.push_back(p[static_cast<std::size_t>(k * rate_Hz / 10.0)]);
    return tenths;
  };
  const auto reference = at(500.0);
  for (const double rate_Hz : {50.0, 100.0, 200.0, 250.0}) {
    const auto same = at(rate_Hz);
    for (std::size_t k = 0; k < reference.size(); ++k)
      EXPECT_WITHIN((same[k] - reference[k]).norm(), 0.0, 0.4 * kBent) << rate_Hz;
  }
}

TEST(ZeroPhase, AHoleSplitsTheSeriesAndNothingPassesIt) {
  Random random(6);
  const RandomMotion motion(random);
  auto t_s = times(100.0, 200);
  auto p = sampled<Vec3>(t_s, motion);
  p[80] = missing_pose().p;                                       // lost
  for (std::size_t k = 150; k < t_s.size(); ++k) t_s[k] += 0.01;  // a row that never came
  const auto smooth = zero_phase(t_s, p);
  EXPECT_TRUE(is_missing(smooth[80]));
  const auto runs = motion_runs(t_s, p);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].end, 80U);
  EXPECT_EQ(runs[1].first, 81U);
  EXPECT_EQ(runs[1].end, 150U);
  EXPECT_EQ(runs[2].first, 150U);
  for (const MotionRun& run : test::every(runs)) {
    const auto first = static_cast<std::ptrdiff_t>(run.first);
    const auto end = static_cast<std::ptrdiff_t>(run.end);
    const std::vector<double> own_s(t_s.begin() + first, t_s.begin() + end);
    const std::vector<Vec3> own(p.begin() + first, p.begin() + end);
    const auto alone = zero_phase(own_s, own);
    for (std::size_t k = 0; k < alone.size(); ++k)
      EXPECT_WITHIN((alone[k] - smooth[run.first + k]).norm(), 0.0, kExact);
    EXPECT_WITHIN((smooth[run.first] - p[run.first]).norm(), 0.0, kExact) << "an end stays";
    EXPECT_WITHIN((smooth[run.end - 1] - p[run.end - 1]).norm(), 0.0, kExact);
  }
  std::vector<Vec3> lonely(5, missing_pose().p);
  lonely[2] = Vec3(1, 2, 3);
  EXPECT_EQ(zero_phase(times(100.0, 5), lonely)[2], lonely[2]);
  EXPECT_TRUE(is_missing(velocities(times(100.0, 5), lonely)[2]));
}

TEST(ZeroPhase, NoiseBecomesLess) {
  Random random(7);
  const auto t_s = times(100.0, 2000);
  const auto noise = sampled<Vec3>(t_s, [&](double) { return test::random_vector(random, 1e-3); });
  const auto smooth = zero_phase(t_s, noise);
  double before = 0.0, after = 0.0;
  for (std::size_t k = 0; k < noise.size(); ++k) {
    before += noise[k].squaredNorm();
    after += smooth[k].squaredNorm();
  }
  // Of white noise the share below the cut-off is left: 6 of 50 Hz, a little more for the slope.
  EXPECT_GT(after / before, 0.08);
  EXPECT_LT(after / before, 0.18);
}

TEST(ZeroPhase, RatesThatAreNotThoseOfCamerasAreRefused) {
  for (const double rate_Hz : {50.0, 49.6, 119.88, 500.0})
    EXPECT_TRUE(objection_to_rate(times(rate_Hz, 20)).empty()) << rate_Hz;
  for (const double rate_Hz : {30.0, 49.0, 1000.0}) {
    const auto t_s = times(rate_Hz, 20);
    EXPECT_EQ(english(objection_to_rate(t_s)), "the rate is not 50 to 500 Hz") << rate_Hz;
    EXPECT_TRUE(is_missing(zero_phase(t_s, std::vector<Vec3>(20, Vec3::Zero()))[3]));
  }
  EXPECT_EQ(english(objection_to_rate(std::vector<double>{1.0})), "fewer than two samples");
  std::vector<double> rounded;  // as a file with three decimals has them
  for (int k = 0; k < 50; ++k) rounded.push_back(std::round(1000.0 * k / 120.0) / 1000.0);
  EXPECT_WITHIN(1.0 / *usual_step_s(rounded), 120.0, 0.5);
}

}  // namespace
}  // namespace isograsp::zero_phase_test
