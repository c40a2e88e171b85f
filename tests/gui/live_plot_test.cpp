// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "gui/look/force_history.hpp"

namespace isograsp::gui::test::live_plot_test {
namespace {

constexpr double kApart_N = 0.4;
constexpr double kAxisFrom_N = -0.5;
constexpr double kRounding_N = 1e-12;  // sums of a few numbers of this size

TEST(LettersOfTheLiveForces, StandApartAndWholeAboveTheEndOfTheAxis) {
  using Forces = std::array<double, kFingerCount>;
  const double none = std::nan("");
  for (const Forces& normal_N :
       {Forces{0.0, 0.0, 0.0}, Forces{-0.1, 0.0, 0.1}, Forces{0.3, 0.0, 4.0}, Forces{8.0, 4.0, 4.0},
        Forces{-0.4, -0.4, 20.0}, Forces{none, none, none}}) {
    Forces place = label_places(normal_N, kApart_N, kAxisFrom_N);
    std::sort(place.begin(), place.end());
    EXPECT_GE(place[0], kAxisFrom_N + kApart_N / 2.0 - kRounding_N);
    for (std::size_t f = 1; f < kFingerCount; ++f)
      EXPECT_GE(place[f] - place[f - 1], kApart_N - kRounding_N);
  }
}

TEST(LettersOfTheLiveForces, StandAtTheirCurvesWhereThereIsRoom) {
  const std::array<double, kFingerCount> normal_N{8.0, 4.0, 6.0};
  EXPECT_EQ(label_places(normal_N, kApart_N, kAxisFrom_N), normal_N);
}

}  // namespace
}  // namespace isograsp::gui::test::live_plot_test
