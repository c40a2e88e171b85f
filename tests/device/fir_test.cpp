// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/fir.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::fir_test {
namespace {

double decibel(double gain) {
  return 20.0 * std::log10(gain);
}

struct Design {
  int taps;
  double rate_Hz;
};

TEST(Fir, IsTheFilterOfThePaperAtBothRates) {
  for (const auto& [taps, rate_Hz] : {Design{33, 500.0}, Design{65, 1000.0}}) {
    const auto fir = design_fir(taps, rate_Hz, 31.25);
    ASSERT_TRUE(fir.ok());
    EXPECT_DOUBLE_EQ(fir_delay_s(fir->size(), rate_Hz), 0.032);
    constexpr double kRounding_dB = 1e-9;  // the design is solved to the last bit
    EXPECT_WITHIN(decibel(fir_gain(*fir, rate_Hz, 31.25)), decibel(std::sqrt(0.5)), kRounding_dB);
    // The attenuations of docs/devices.md, printed with two to three digits.
    constexpr double kPrinted_dB = 0.6;
    EXPECT_WITHIN(decibel(fir_gain(*fir, rate_Hz, 50.0)), -17.6, kPrinted_dB);
    EXPECT_WITHIN(decibel(fir_gain(*fir, rate_Hz, 60.0)), -37.0, kPrinted_dB);
    EXPECT_LT(decibel(fir_gain(*fir, rate_Hz, 70.0)), -58.0);
  }
}

TEST(Fir, PassesAConstantAndDelaysEveryFrequencyByTheSameTime) {
  constexpr double kRate_Hz = 500.0;
  for (const int taps : {13, 17, 33}) {
    const auto h = design_fir(taps, kRate_Hz, 31.25).value();
    for (const double frequency_Hz : {0.0, 1.0, 7.0, 20.0}) {
      FirFilter filter(h);
      const double omega = 2.0 * std::numbers::pi * frequency_Hz;
      const auto signal = [&](double t_s) { return std::cos(omega * t_s); };
      const double gain = fir_gain(h, kRate_Hz, frequency_Hz);
      double worst = 0.0;
      for (int n = 0; n < 500; ++n) {
        const double t_s = n / kRate_Hz;
        Vec6 value = Vec6::Constant(signal(t_s));
        const bool ready = filter.push(value);
        EXPECT_EQ(ready, n + 1 >= taps);
        if (!ready) continue;
        const double delayed_s = t_s - fir_delay_s(h.size(), kRate_Hz);
        worst = std::max(worst, (value.array() - gain * signal(delayed_s)).abs().maxCoeff());
      }
      constexpr double kRounding = 1e-13;  // sums of up to 33 products of numbers up to 1
      EXPECT_LT(worst, kRounding) << taps << " taps, " << frequency_Hz << " Hz";
    }
  }
}

TEST(Fir, ForgetsWhatWasBeforeAGap) {
  const auto h = design_fir(9, 500.0, 60.0).value();
  FirFilter filter(h);
  Vec6 value;
  for (int n = 0; n < 20; ++n) (void)filter.push(value = Vec6::Constant(1000.0));
  filter.restart();
  for (int n = 0; n < 8; ++n) EXPECT_FALSE(filter.push(value = Vec6::Constant(1.0)));
  ASSERT_TRUE(filter.push(value = Vec6::Constant(1.0)));
  EXPECT_WITHIN(value.maxCoeff(), 1.0, 1e-15);
}

TEST(Fir, WithoutTapsTheInputComesOut) {
  FirFilter none;
  Vec6 value = Vec6::LinSpaced(1.0, 6.0);
  EXPECT_TRUE(none.push(value));
  EXPECT_EQ(value, Vec6(Vec6::LinSpaced(1.0, 6.0)));
}

TEST(Fir, RefusesLengthsThatCannotDoIt) {
  for (const int taps : {-1, 1, 2, 34, 131}) EXPECT_FALSE(design_fir(taps, 500.0, 31.25).ok());
  EXPECT_FALSE(design_fir(33, 500.0, 5.0).ok());    // far too short for so low a cut-off
  EXPECT_FALSE(design_fir(33, 500.0, 250.0).ok());  // no low-pass at all
}

TEST(Fir, PushingAllocatesNothing) {
  FirFilter filter(design_fir(129, 1000.0, 31.25).value());
  const auto before = test::allocations();
  Vec6 value = Vec6::Ones();
  for (int n = 0; n < 1000; ++n) (void)filter.push(value);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::fir_test
