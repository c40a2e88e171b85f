// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/spectrum.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::spectrum_test {
namespace {

using test::sampled;
using test::times;

statistics::UniformSamples signal(double rate_Hz, double length_s, double (*f)(double)) {
  const auto t = times(static_cast<std::size_t>(length_s * rate_Hz), rate_Hz);
  return {1.0 / rate_Hz, sampled(t, f)};
}
double sine(double frequency_Hz, double t) {
  return std::sin(2.0 * std::numbers::pi * frequency_Hz * t);
}
statistics::UniformSamples white(std::size_t count, double rate_Hz) {
  Random random(5);
  statistics::UniformSamples noise{1.0 / rate_Hz, {}};
  for (std::size_t k = 0; k < count; ++k) noise.values.push_back(3.0 * random.gaussian());
  return noise;
}

TEST(Spectrum, PowerOfASineIsHalfItsSquaredAmplitudeAtEitherRate) {
  const auto wave = [](double t) { return 20.0 + 0.3 * t + 0.8 * sine(5.0, t); };
  for (const double rate_Hz : {100.0, 500.0}) {
    const PowerSpectrum spectrum = welch(signal(rate_Hz, 60.0, wave));
    constexpr double kLeakage = 1e-4;  // of the window, and of the line through the sine
    EXPECT_WITHIN(band_power(spectrum, {4.0, 6.0}).value.value(), 0.5 * 0.64, kLeakage);
    EXPECT_WITHIN(band_share(spectrum, kTremorBand).value.value(), 100.0, 100.0 * kLeakage);
    EXPECT_WITHIN(band_share(spectrum, kFastTremorBand).value.value(), 0.0, 100.0 * kLeakage);
  }
}

TEST(Spectrum, AllFrequenciesTogetherAreThePowerOfTheWindowedSignal) {
  // Parseval: exact for one window.
  statistics::UniformSamples one = white(400, 100.0);
  // Symmetric about its middle, with mean 0: the line that is removed is zero.
  for (std::size_t k = 0; k < 200; ++k) one.values[399 - k] = one.values[k];
  double mean = 0.0;
  for (const double value : one.values) mean += value / 400.0;
  for (double& value : one.values) value -= mean;
  double power = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < 400; ++k) {
    const double w = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / 400.0);
    power += w * w * one.values[k] * one.values[k];
    squares += w * w;
  }
  constexpr double kRounding = 1e-10;
  EXPECT_WITHIN(band_power(welch(one), {0.0, 50.0}).value.value(), power / squares, kRounding);
}

TEST(Spectrum, WhiteNoiseHasItsVarianceSpreadEvenly) {
  const PowerSpectrum spectrum = welch(white(60000, 100.0));
  // 299 windows of which about two thirds are independent: 7 % per line, less over a band.
  EXPECT_NEAR(band_power(spectrum, {0.0, 50.0}).value.value(), 9.0, 0.15);
  EXPECT_NEAR(band_share(spectrum, kTremorBand).value.value(), 12.0, 0.6);
  EXPECT_NEAR(band_share(spectrum, kFastTremorBand).value.value(), 8.0, 0.5);
}

TEST(Spectrum, SizeAndStartDoNotMatterForSharesAndAddingBandsAddsPower) {
  statistics::UniformSamples noise = white(6000, 100.0);
  const PowerSpectrum spectrum = welch(noise);
  for (double& value : noise.values) value = 4.0 * value + 100.0;
  constexpr double kRounding = 1e-9;
  EXPECT_WITHIN(band_share(welch(noise), kSlowBand).value.value(),
                band_share(spectrum, kSlowBand).value.value(), kRounding);
  EXPECT_WITHIN(band_power(spectrum, {2.0, 8.0}).value.value() +
                    band_power(spectrum, {8.0, 12.0}).value.value(),
                band_power(spectrum, {2.0, 12.0}).value.value(), kRounding);
}

TEST(Spectrum, PeakIsFoundBetweenTheLines) {
  const PowerSpectrum spectrum =
      welch(signal(100.0, 30.0, [](double t) { return sine(6.13, t) + 2.0 * sine(9.4, t); }));
  constexpr double kParabola_Hz = 0.005;
  EXPECT_WITHIN(peak_frequency(spectrum, kTremorBand).value.value(), 6.13, kParabola_Hz);
  EXPECT_WITHIN(peak_frequency(spectrum, kFastTremorBand).value.value(), 9.4, kParabola_Hz);
  EXPECT_EQ(english(peak_frequency(spectrum, {9.6, 9.9}).reason),
            "the spectrum has no peak in the band");
}

TEST(Spectrum, WithoutAWholeWindowOrTheRateForABandThereIsAReason) {
  EXPECT_EQ(english(band_share(welch(white(399, 100.0)), kTremorBand).reason),
            "shorter than one window of 4 s");
  EXPECT_TRUE(band_share(welch(white(400, 100.0)), kTremorBand).value);
  EXPECT_EQ(english(band_share(welch(white(400, 20.0)), kFastTremorBand).reason),
            "the sampling rate is too low for the band");
  EXPECT_EQ(english(band_share(welch({0.01, std::vector<double>(800, 0.0)}), kTremorBand).reason),
            "the signal does not vary");
}

}  // namespace
}  // namespace isograsp::tasks::spectrum_test
