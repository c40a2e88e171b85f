// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/device_check.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::device_check_test {
namespace {

constexpr double kPeriod_s = 0.01;
constexpr double kPush_N = 8.0;

/// Derived anew from where things stand: the wrist is toward the viewer, +Z of the world, "up" is
/// +Y. The right thumb presses to the right, its fingers to the left; a left hand is the mirror
/// image.
double toward_wrist(Finger finger, Hand hand) {
  const double into_x = (finger == Finger::thumb) == (hand == Hand::right) ? 1.0 : -1.0;
  const Vec3 z_W(into_x, 0.0, 0.0);
  const Vec3 x_W(0.0, 1.0, 0.0);
  return z_W.cross(x_W).z();
}

/// What the supports would feel if all were as it should be: three forces in contact frames.
std::array<Vec3, kFingerCount> right_forces(const CheckStep& step) {
  std::array<Vec3, kFingerCount> forces;
  forces.fill(Vec3::Zero());
  Vec3& force = forces[index_of(step.finger)];
  if (step.press == Press::up)
    force = {kPush_N, 0.5, 0.8};
  else if (step.press == Press::toward_wrist)
    force = {-0.4, toward_wrist(step.finger, step.hand) * kPush_N, 1.0};
  else
    force = {0.3, -0.2, kPush_N};
  return forces;
}

using Mistake = std::function<std::array<Vec3, kFingerCount>(std::array<Vec3, kFingerCount>)>;

/// A therapist who does as told on a device with this mistake.
std::vector<CheckResult> walk(const Mistake& mistake, std::optional<double> weight_N = {},
                              Hand hand = Hand::right) {
  DeviceCheck check(kPeriod_s, hand, weight_N);
  std::array<Vec3, kFingerCount> offset;  // before any zero
  offset.fill(Vec3(1.0, -2.0, 4.0));
  FingerFrame frame;
  const auto show = [&](const std::array<Vec3, kFingerCount>& forces) {
    for (std::size_t f = 0; f < kFingerCount; ++f)
      frame.wrench_C[f].force = offset[f] + mistake(forces)[f];
  };
  std::array<Vec3, kFingerCount> none;
  none.fill(Vec3::Zero());
  show(none);
  for (int k = 0; !check.add_empty(frame); ++k) EXPECT_LT(k, 200);
  for (int k = 0; !check.complete() && k < 100'000; ++k) {
    // Half a second of nothing, then the press until it is taken.
    show(none);
    for (int i = 0; i < 50; ++i) (void)check.add(frame);
    if (check.complete()) break;
    show(right_forces(check.step()));
    for (int i = 0; i < 4000 && !check.add(frame); ++i) {
    }
  }
  EXPECT_TRUE(check.complete());
  return check.results();
}

TEST(DeviceCheck, ADeviceThatIsAsItShouldBePasses) {
  const auto results = walk([](auto forces) { return forces; }, kPush_N);
  ASSERT_EQ(results.size(), 12u);
  for (const auto& r : test::every(results))
    EXPECT_EQ(r.verdict, CheckVerdict::good) << english(r.sentence());
}

TEST(DeviceCheck, APlatformThatStandsForTheLeftHandPassesAndNotAsOneForTheRight) {
  const auto good = walk([](auto forces) { return forces; }, {}, Hand::left);
  for (const auto& r : test::every(good))
    EXPECT_EQ(r.verdict, CheckVerdict::good) << english(r.sentence());
  const auto turned = walk(
      [](auto forces) {
        for (auto& force : forces) force.y() = -force.y();
        return forces;
      },
      {}, Hand::left);
  for (const auto& r : test::every(turned))
    EXPECT_EQ(r.verdict,
              r.step.press == Press::toward_wrist ? CheckVerdict::wrong_sign : CheckVerdict::good);
}

TEST(DeviceCheck, FindsSwappedSensors) {
  const auto results = walk([](auto forces) {
    std::swap(forces[0], forces[2]);
    return forces;
  });
  for (const auto& r : test::every(results)) {
    EXPECT_EQ(r.verdict,
              r.step.finger == Finger::index ? CheckVerdict::good : CheckVerdict::other_finger);
  }
  EXPECT_NE(english(results.front().sentence()).find("the sensors of thumb and middle are swapped"),
            std::string::npos);
}

TEST(DeviceCheck, FindsAWrongSign) {
  const auto results = walk([](auto forces) {
    forces[1] = -forces[1];
    return forces;
  });
  for (const auto& r : test::every(results))
    EXPECT_EQ(r.verdict,
              r.step.finger == Finger::index ? CheckVerdict::wrong_sign : CheckVerdict::good);
}

TEST(DeviceCheck, FindsATurnedSensor) {
  const auto results = walk([](auto forces) {
    forces[2] = Vec3(forces[2].y(), -forces[2].x(), forces[2].z());  // a quarter turn about z
    return forces;
  });
  for (const auto& r : test::every(results)) {
    if (r.step.finger == Finger::middle && r.step.press != Press::into)
      EXPECT_EQ(r.verdict, CheckVerdict::wrong_axis);
    else
      EXPECT_EQ(r.verdict, CheckVerdict::good);
  }
}

TEST(DeviceCheck, FindsAWrongScaleWithAReferenceWeight) {
  const auto results = walk(
      [](auto forces) {
        forces[0] *= 1.12;
        return forces;
      },
      kPush_N);
  for (const auto& r : test::every(results))
    EXPECT_EQ(r.verdict, r.step.finger == Finger::thumb && r.step.press == Press::weight
                             ? CheckVerdict::wrong_scale
                             : CheckVerdict::good);
}

TEST(DeviceCheck, SaysWhenNobodyPresses) {
  const auto results = walk([](auto forces) {
    forces[1].setZero();  // its cable is out
    return forces;
  });
  for (const auto& r : test::every(results))
    EXPECT_EQ(r.verdict,
              r.step.finger == Finger::index ? CheckVerdict::nothing_felt : CheckVerdict::good);
}

TEST(DeviceCheck, TellsTheTherapistWhatToDo) {
  EXPECT_EQ(english((CheckStep{Finger::thumb, Press::into}).instruction()),
            "Press the thumb's support straight in and hold.");
  EXPECT_EQ(english((CheckStep{Finger::index, Press::up}).instruction()),
            "Push the index finger's support upward and hold.");
}

}  // namespace
}  // namespace isograsp::device_check_test
