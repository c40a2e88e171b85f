// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/sine.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/tasks/samples.hpp"

namespace isograsp {
namespace {

using test::sampled;
using test::times;

TEST(Sine, GainIsTheRatioOfAmplitudesWhateverTheLagAndOffset) {
  constexpr double kRounding = 1e-12;
  const double omega = 2.0 * std::numbers::pi * 0.2;
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto t = times(static_cast<std::size_t>(17.3 * rate_Hz), rate_Hz);
    const auto target = sampled(t, [&](double s) { return 20.0 - 10.0 * std::cos(omega * s); });
    const auto actual =
        sampled(t, [&](double s) { return 18.0 - 8.343 * std::cos(omega * (s - 0.2)); });
    EXPECT_NEAR(gain(t, target, actual, 0.2).value.value(), 0.8343, kRounding);
  }
  const auto t = times(400);
  EXPECT_FALSE(gain(t, t, t, 0.2).value) << "less than one cycle";
}

}  // namespace
}  // namespace isograsp
