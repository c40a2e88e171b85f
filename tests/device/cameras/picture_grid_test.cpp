// SPDX-License-Identifier: GPL-3.0-or-later
// The cameras' own numbers and stamps become a strict grid on our clock.
#include "device/cameras/picture_grid.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::picture_grid_test {
namespace {

using namespace std::chrono_literals;

constexpr double kPeriod_s = 0.01;
PictureGrid begun() {
  PictureGrid grid;
  grid.begin(kPeriod_s);
  return grid;
}

TEST(PictureGrid, CountsWhatIsLostAndLeavesOutWhatComesTwice) {
  PictureGrid grid = begun();
  EXPECT_EQ(grid.place(500, 5.0, 1s)->number, 0);
  EXPECT_EQ(grid.place(501, 5.01, 1010ms)->number, 1);
  const auto after_gap = grid.place(505, 5.05, 1050ms);
  EXPECT_EQ(after_gap->number, 5);
  EXPECT_EQ(after_gap->lost, 3U);
  EXPECT_FALSE(grid.place(505, 5.05, 1051ms));
  EXPECT_FALSE(grid.place(503, 5.03, 1052ms)) << "overtaken by later ones";
  EXPECT_EQ(grid.place(506, 5.06, 1060ms)->number, 6);
}

TEST(PictureGrid, GoesOnByTheTimeThatPassedWhereNumbersBeginAnew) {
  PictureGrid grid = begun();
  static_cast<void>(grid.place(5000, 50.0, 1s));
  const auto anew = grid.place(1, 0.01, 1500ms);
  ASSERT_TRUE(anew);
  EXPECT_EQ(anew->number, 50);
  EXPECT_EQ(anew->lost, 49U);
  EXPECT_EQ(anew->stamp, 1500ms);
  EXPECT_EQ(grid.place(2, 0.02, 1510ms)->number, 51);
}

TEST(PictureGrid, DoesNotBelieveACountFromTheFuture) {
  // Another measurement, whose numbers and times are further on and agree with each other.
  PictureGrid grid = begun();
  static_cast<void>(grid.place(100, 1.0, 1s));
  EXPECT_EQ(grid.place(5100, 51.0, 1200ms)->number, 20);
}

TEST(PictureGrid, PicturesThatWaitedToBeReadKeepTheirPlacesAndTimes) {
  PictureGrid grid = begun();
  static_cast<void>(grid.place(0, 0.0, 1s));
  for (int k = 1; k <= 600; ++k) {  // all of six seconds are read at once
    const auto placed = grid.place(k, kPeriod_s * k, 7s + Timestamp{k});
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->number, k);
    EXPECT_EQ(placed->lost, 0U);
  }
  const auto now = grid.place(601, 6.01, 7010ms);
  EXPECT_EQ(now->number, 601);
  EXPECT_EQ(now->stamp, 7010ms);
}

TEST(PictureGrid, StampsAreThoseOfTheCamerasHoweverTheNetworkDelays) {
  PictureGrid grid = begun();
  Random random(4);
  constexpr double kDelay_s = 0.004;
  Timestamp last{0};
  for (int k = 0; k < 2000; ++k) {
    const double camera_s = 77.0 + kPeriod_s * k;
    const double late_s = k == 0 ? 0.0 : kDelay_s * random.uniform();
    const auto placed = grid.place(k, camera_s, 5s + from_seconds(kPeriod_s * k + late_s));
    ASSERT_TRUE(placed);
    EXPECT_GT(placed->stamp, last);
    last = placed->stamp;
    constexpr double kFollows_s = 2e-3;  // the drift that is allowed for between two quick ones
    EXPECT_WITHIN(to_seconds(placed->stamp), 5.0 + kPeriod_s * k, kFollows_s);
    EXPECT_LE(*grid.jitter_s(), kDelay_s);
  }
}

TEST(PictureGrid, ACameraClockThatStoodStillIsFollowedAgain) {
  PictureGrid grid = begun();
  static_cast<void>(grid.place(0, 0.0, 1s));
  Timestamp arrival = 11s;  // ten seconds' pause, of which the cameras know nothing
  std::optional<PlacedPicture> placed;
  for (int k = 1; k <= 400; ++k, arrival += 10ms) placed = grid.place(k, kPeriod_s * k, arrival);
  EXPECT_EQ(placed->stamp, arrival - 10ms);
}

TEST(PeriodEstimate, CountsFramesAndNotPictures) {
  PeriodEstimate seen;
  EXPECT_FALSE(seen.period_s());
  seen.add(100, 1.0);
  EXPECT_FALSE(seen.period_s());
  seen.add(107, 1.0 + 7.0 / 120.0);
  EXPECT_EQ(*seen.period_s(), 1.0 / 120.0);
  seen.add(3, 0.5);  // numbers begin anew
  EXPECT_FALSE(seen.period_s());
  seen.add(13, 0.6);
  EXPECT_EQ(*seen.period_s(), 0.01);
  PeriodEstimate odd;
  odd.add(0, 0.0);
  odd.add(100, 100.0 / 59.94);
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(*odd.period_s(), 1.0 / 59.94, kRounding);
}

}  // namespace
}  // namespace isograsp::picture_grid_test
