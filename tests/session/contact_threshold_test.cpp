// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/contact_threshold.hpp"

#include <gtest/gtest.h>

namespace isograsp::session::contact_threshold_test {
namespace {

tasks::ForceReferences measured(const std::array<double, kFingerCount>& noise_N, double maximum_N) {
  tasks::ForceReferences references;
  references.noise_sd_N.emplace();
  for (std::size_t f = 0; f < kFingerCount; ++f)
    (*references.noise_sd_N)[f] = Vec3(9.0, 9.0, noise_N[f]);  // other axes do not matter
  references.maximum_N[{}] = maximum_N;
  return references;
}

TEST(ContactThreshold, IsTheClinicalRuleOnAGridOfNoiseAndStrength) {
  for (double noise_N = 0.0; noise_N < 0.3; noise_N += 0.01)
    for (double maximum_N = 0.5; maximum_N < 60.0; maximum_N *= 1.3) {
      const double threshold_N = contact_threshold_N(noise_N, maximum_N);
      EXPECT_GE(threshold_N, 5.0 * noise_N) << "noise must not touch";
      if (5.0 * noise_N <= 0.8) {
        EXPECT_LE(threshold_N, 0.8);
      }
      if (5.0 * noise_N <= 0.05 * maximum_N) {
        EXPECT_LE(threshold_N, 0.05 * maximum_N) << "a weak hand must reach it";
      }
      EXPECT_TRUE(threshold_N == 5.0 * noise_N || threshold_N == 0.8 ||
                  threshold_N == 0.05 * maximum_N)
          << noise_N << " " << maximum_N;
    }
}

TEST(ContactThreshold, GrowsWithNoiseAndWithStrengthAndNeverElse) {
  for (double x = 0.0; x < 40.0; x += 0.5) {
    EXPECT_LE(contact_threshold_N(0.04, x + 0.5), contact_threshold_N(0.04, x + 1.0));
    EXPECT_LE(contact_threshold_N(0.01 * x, 10.0), contact_threshold_N(0.01 * x + 0.01, 10.0));
  }
}

TEST(ContactThreshold, ExamplesOfAStrongAWeakAndANoisyHand) {
  EXPECT_EQ(contact_threshold_N(0.04, 40.0), 0.8);
  EXPECT_EQ(contact_threshold_N(0.04, 10.0), 0.5);
  EXPECT_EQ(contact_threshold_N(0.04, 2.0), 0.2) << "five times the noise";
}

TEST(ContactThreshold, EachFingerHasItsOwnByTheNoiseOfItsNormalForce) {
  const auto threshold_N = contact_thresholds(measured({0.04, 0.1, 0.2}, 2.0));
  EXPECT_EQ(threshold_N[0], 0.2);
  EXPECT_EQ(threshold_N[1], 0.5);
  EXPECT_EQ(threshold_N[2], 1.0);
}

TEST(ContactThreshold, WithoutNoiseOrMaximumTheSceneDecides) {
  Scene scene;
  scene.contacts.resize(2);
  scene.contacts[0].finger = Finger::index;
  scene.contacts[1].finger = Finger::thumb;
  scene.contacts[0].threshold_N = 0.3;
  scene.contacts[1].threshold_N = 0.7;
  auto without_noise = measured({}, 20.0);
  without_noise.noise_sd_N.reset();
  auto without_maximum = measured({0.04, 0.04, 0.04}, 0.0);
  without_maximum.maximum_N.clear();
  for (const auto& references : {without_noise, without_maximum}) {
    const auto used = thresholds_of(with_thresholds(scene, contact_thresholds(references)));
    EXPECT_EQ(used[0], 0.7);
    EXPECT_EQ(used[1], 0.3);
    EXPECT_FALSE(used[2].has_value()) << "no contact of the middle finger";
  }
  const auto used =
      thresholds_of(with_thresholds(scene, contact_thresholds(measured({0, 0, 0}, 10.0))));
  EXPECT_EQ(used[0], 0.5) << "the scene's own one is no floor";
  EXPECT_EQ(used[1], 0.5);
}

}  // namespace
}  // namespace isograsp::session::contact_threshold_test
