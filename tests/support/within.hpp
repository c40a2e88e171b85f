// SPDX-License-Identifier: GPL-3.0-or-later
// EXPECT_WITHIN and ASSERT_WITHIN are EXPECT_NEAR and ASSERT_NEAR with tolerances that one variable
// of the environment scales: ISOGRASP_TOLERANCE_SCALE=0.1 tells what would fail with a tenth of
// them; with 0 nothing fails for a tolerance, and each line prints its largest residual at the end.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace isograsp::test {

/// Of all tolerances; 1 where the environment says nothing.
[[nodiscard]] inline double tolerance_scale() {
  static const double scale = [] {
    const char* chosen = std::getenv("ISOGRASP_TOLERANCE_SCALE");
    return chosen != nullptr ? std::strtod(chosen, nullptr) : 1.0;
  }();
  return scale;
}

/// The largest residual of each line that compares, and the tolerance that it had.
class Residuals {
 public:
  ~Residuals() {
    for (const auto& [line, worst] : worst_)
      std::printf("residual %9.2e of %9.2e  %s\n", worst.first, worst.second, line.c_str());
  }
  [[nodiscard]] static Residuals& all() {
    static Residuals residuals;
    return residuals;
  }
  void note(const char* file, int line, double residual, double tolerance) {
    const auto share = [](double part, double whole) { return part == 0.0 ? 0.0 : part / whole; };
    const std::pair<double, double> now{residual, tolerance};
    auto& worst =
        worst_.try_emplace(std::string(file) + ":" + std::to_string(line), now).first->second;
    if (share(residual, tolerance) > share(worst.first, worst.second)) worst = now;
  }

 private:
  std::map<std::string, std::pair<double, double>> worst_;
};

/// The comparison behind EXPECT_WITHIN, made for one line of a test.
struct Within {
  const char* file;
  int line;

  testing::AssertionResult operator()(const char* value_text, const char* expected_text,
                                      const char* tolerance_text, double value, double expected,
                                      double tolerance) const {
    const double residual = std::abs(value - expected);
    if (tolerance_scale() == 0.0 && !std::isnan(residual)) {
      if (value != expected) Residuals::all().note(file, line, residual, tolerance);
      return testing::AssertionSuccess();
    }
    return testing::internal::DoubleNearPredFormat(value_text, expected_text, tolerance_text, value,
                                                   expected, tolerance * tolerance_scale());
  }
};

}  // namespace isograsp::test

#define EXPECT_WITHIN(value, expected, tolerance) \
  EXPECT_PRED_FORMAT3((isograsp::test::Within{__FILE__, __LINE__}), value, expected, tolerance)
#define ASSERT_WITHIN(value, expected, tolerance) \
  ASSERT_PRED_FORMAT3((isograsp::test::Within{__FILE__, __LINE__}), value, expected, tolerance)
