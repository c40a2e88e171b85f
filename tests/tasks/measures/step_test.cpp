// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/step.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp {
namespace {

using test::sampled;
using test::times;

TEST(StepResponse, StepResponsesMatchTheIndependentOracle) {
  constexpr double kOracleTolerance = 1e-13;  // what a correct double program reaches
  struct Case {
    const char* name;
    double (*y)(double);
  };
  const Case cases[] = {
      {"first_order_tau0.3_n401", [](double t) { return 1.0 - std::exp(-t / 0.3); }},
      {"second_order_wn6_z0.4_n601",
       [](double t) {
         const double wd = 6.0 * std::sqrt(1.0 - 0.16);
         return 1.0 - std::exp(-2.4 * t) * (std::cos(wd * t) + 2.4 / wd * std::sin(wd * t));
       }},
      {"min_jerk_T1.2_n201",
       [](double t) {
         const double s = std::min(t / 1.2, 1.0);
         return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
       }},
      {"ramp_2s_n301", [](double t) { return std::min(t / 2.0, 1.0); }}};
  const auto text = read_text(ISOGRASP_SOURCE_DIR "/tests/data/golden/metrics_step.csv");
  ASSERT_TRUE(text) << text.error().message();
  for (const Case& c : cases) {
    const auto at = text->find(c.name);
    ASSERT_NE(at, std::string::npos);
    std::string_view line(*text);
    line = line.substr(at, line.find('\n', at) - at);
    std::vector<double> fields;
    for (auto comma = line.find(','); comma != std::string_view::npos;) {
      line.remove_prefix(comma + 1);
      comma = line.find(',');
      double value = 0.0;
      ASSERT_TRUE(parse_number(line.substr(0, comma), value)) << line;
      fields.push_back(value);
    }
    ASSERT_EQ(fields.size(), 9u);
    const auto t = times(static_cast<std::size_t>(fields[0]));
    const auto y = sampled(t, c.y);
    const StepResponse response = step_response(t, y, 1.0);
    EXPECT_NEAR(response.t10_s.value(), fields[1], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.t63_s.value(), fields[2], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.t90_s.value(), fields[3], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.rise10_90_s.value(), fields[4], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.overshoot, fields[5], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.settle2pct_s.value(), fields[8], kOracleTolerance) << c.name;
  }
}

TEST(StepResponse, AStepInEitherDirectionAndSizeHasTheSameResponse) {
  const auto t = times(500);
  const auto up = sampled(t, [](double s) { return 1.0 - std::exp(-s / 0.2); });
  auto down = up;
  for (double& value : down) value *= -3.0;
  const StepResponse a = step_response(t, up, 1.0);
  const StepResponse b = step_response(t, down, -3.0);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(a.rise10_90_s.value(), b.rise10_90_s.value(), kRounding);
  EXPECT_EQ(a.settle2pct_s, b.settle2pct_s);
  constexpr double kLinearCrossing_s = 1e-3;  // straight lines through a curve sampled at 100 Hz
  EXPECT_NEAR(a.rise10_90_s.value(), 0.4394, kLinearCrossing_s);
}

TEST(StepResponse, ALevelThatIsNeverReachedHasNoTime) {
  const StepResponse response = step_response(times(3), std::vector<double>{0.0, 0.3, 0.5}, 1.0);
  EXPECT_TRUE(response.t10_s);
  EXPECT_FALSE(response.t63_s);
  EXPECT_FALSE(response.rise10_90_s);
  EXPECT_FALSE(response.settle2pct_s);
}

}  // namespace
}  // namespace isograsp
