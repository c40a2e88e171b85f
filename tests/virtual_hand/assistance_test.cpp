// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/assistance.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::assistance_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

DigitSet set_of(const std::string& names) {
  DigitSet set = 0;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if (names.find(kDigitNames[d]) != std::string::npos) set |= 1U << d;
  return set;
}

AssistanceRow row_in(const Fields& row) {
  AssistanceRow read{
      number_in(row, "t_s"), row.at("tracked") == "1", set_of(row.at("feasible")), {}};
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const std::string name(kDigitNames[d]);
    read.digits[d] = {row.at(name + "_contact") == "1", number_in(row, name + "_pull_N"),
                      number_in(row, name + "_gap_m")};
  }
  return read;
}

TEST(Assistance, TheStatesOfEveryTraceAreThoseOfTheOracle) {
  constexpr double kRelease_N = 0.3;
  for (const std::string name : {"pinch", "three", "jitter", "sticky"}) {
    Assistance assistance(kRelease_N);
    const auto rows = golden_table(hand_data("release_" + name + ".csv"));
    const auto wanted = golden_table(hand_data("release_" + name + "_states.csv"));
    ASSERT_EQ(rows.size(), wanted.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      assistance.step(row_in(rows[k]));
      for (std::size_t d = 0; d < kDigitCount; ++d)
        ASSERT_EQ(kDigitStateNames[static_cast<std::size_t>(assistance.states()[d])],
                  wanted[k].at(std::string(kDigitNames[d])))
            << name << " at " << rows[k].at("t_s") << " s, " << kDigitNames[d];
    }
  }
}

TEST(Assistance, GainsAreThoseOfTheFormulas) {
  constexpr double kRounding = 1e-14;
  for (const Fields& row : every(golden_table(hand_data("assist_gains.csv")))) {
    const TieGains gains =
        tie_gains({number_in(row, "mass_kg"), static_cast<int>(number_in(row, "fingers")),
                   number_in(row, "deflection_m"), number_in(row, "damping_ratio"),
                   number_in(row, "gravity_m_s2"), number_in(row, "acceleration_m_s2"), 0.005});
    const auto near = [&](double value, const char* column) {
      EXPECT_WITHIN(value, number_in(row, column), kRounding * number_in(row, column)) << column;
    };
    near(gains.stiffness_N_m, "stiffness_N_m");
    near(gains.damping_N_s_m, "damping_N_s_m");
    near(gains.torsion_N_m_rad, "torsion_N_m_rad");
    near(gains.release_N, "release_N");
  }
}

AssistanceRow random_row(Random& random, double t_s) {
  AssistanceRow row{t_s, random.uniform() > 0.05, 0, {}};
  if (random.uniform() < 0.7)
    row.feasible = random.uniform() < 0.5 ? set_of("thumb+index") : set_of("thumb+index+middle");
  for (auto& digit : row.digits)
    digit = {random.uniform() < 0.8, 0.5 * random.uniform(), 0.004 * random.uniform()};
  return row;
}

TEST(Assistance, WhateverComesOneFingerAloneIsNeverTiedAndALostHandChangesNothing) {
  Random random(50);
  Assistance assistance(0.3);
  AtLeast tied(1000);
  for (int k = 0; k < 100000; ++k) {
    const auto before = assistance.states();
    const AssistanceRow row = random_row(random, 0.01 * k);
    assistance.step(row);
    const auto& states = assistance.states();
    const auto attached = std::count(states.begin(), states.end(), DigitState::attached);
    ASSERT_NE(attached, 1) << k;
    if (attached > 0) ++tied;
    ASSERT_TRUE(row.tracked || states == before) << k;
  }
}

TEST(Assistance, APullBeyondTwiceTheReleaseEffortLetsGoAtOnceAndALesserOneAfterThirtyMilliseconds) {
  const auto held = [] {
    Assistance assistance(0.3);
    for (int k = 0; k < 4; ++k) {
      AssistanceRow row{0.01 * k, true, set_of("thumb+index"), {}};
      row.digits[0].contact = row.digits[1].contact = true;
      assistance.step(row);
    }
    return assistance;
  };
  const auto pulled = [](Assistance assistance, double pull_N, int rows) {
    for (int k = 0; k < rows; ++k) {
      AssistanceRow row{0.05 + 0.01 * k, true, 0, {}};
      row.digits[0] = {true, pull_N, 0.0};
      row.digits[1] = {true, 0.0, 0.0};
      assistance.step(row);
    }
    return assistance.states()[0];
  };
  EXPECT_EQ(held().states()[0], DigitState::attached);
  EXPECT_EQ(pulled(held(), 0.29, 100), DigitState::attached);
  EXPECT_EQ(pulled(held(), 0.31, 3), DigitState::attached);
  EXPECT_EQ(pulled(held(), 0.31, 4), DigitState::blocked);
  EXPECT_EQ(pulled(held(), 0.61, 1), DigitState::blocked);
}

}  // namespace
}  // namespace isograsp::assistance_test
