// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/histogram.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace isograsp::histogram_test {
namespace {

std::uint64_t in_ns(double duration_s) {
  return static_cast<std::uint64_t>(duration_s * 1e9 + 0.5);
}

TEST(Histogram, EveryDurationLiesInItsBinAndEdgesGrowByAtMostAnEighth) {
  for (std::size_t bin = 0; bin + 1 < Histogram::kBins; ++bin) {
    const auto low = Histogram::lower_edge_ns(bin);
    const auto high = Histogram::lower_edge_ns(bin + 1);
    ASSERT_LT(low, high);
    EXPECT_EQ(Histogram::bin_of(low), bin);
    EXPECT_EQ(Histogram::bin_of(high - 1), bin);
    if (low >= 8) {
      EXPECT_LE(high - low, low / 8);
    }
  }
  EXPECT_EQ(Histogram::bin_of(std::numeric_limits<std::uint64_t>::max()), Histogram::kBins - 1);
}

TEST(Histogram, QuantilesAgreeWithSortedDataWithinOneBin) {
  Random random(7);
  for (const double scale_s : {1e-7, 1e-4, 1e-2, 1.0}) {
    Histogram histogram;
    std::vector<double> sorted;
    for (int i = 0; i < 5000; ++i) {
      const double u = random.uniform();
      const double duration_s = scale_s * (0.5 + u * u * u * u * 20.0);
      histogram.add(duration_s);
      sorted.push_back(duration_s);
    }
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.0, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
      const auto place = static_cast<std::size_t>(
          std::max(1.0, std::ceil(share * static_cast<double>(sorted.size()))));
      const std::uint64_t exact_ns = in_ns(sorted[place - 1]);
      const std::uint64_t told_ns = in_ns(histogram.quantile_s(share));
      EXPECT_GE(told_ns, exact_ns) << "never too good";
      EXPECT_LE(told_ns, Histogram::lower_edge_ns(Histogram::bin_of(exact_ns) + 1)) << share;
    }
    EXPECT_EQ(in_ns(histogram.largest_s()), in_ns(sorted.back())) << "the largest is exact";
    EXPECT_EQ(histogram.count(), 5000u);
  }
}

TEST(Histogram, TheOrderDoesNotMatterAndCountsAddUp) {
  Histogram up;
  Histogram down;
  for (int i = 1; i <= 300; ++i) {
    up.add(1e-5 * i);
    down.add(1e-5 * (301 - i));
  }
  std::uint64_t sum = 0;
  for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
    EXPECT_EQ(up.count(bin), down.count(bin));
    sum += up.count(bin);
  }
  EXPECT_EQ(sum, 300u);
}

TEST(Histogram, WhatIsNoDurationCountsAsZeroAndEmptyIsZero) {
  Histogram histogram;
  EXPECT_EQ(histogram.quantile_s(0.5), 0.0);
  histogram.add(-1.0);
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(histogram.count(0), 2u);
  histogram.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(histogram.count(Histogram::kBins - 1), 1u);
}

}  // namespace
}  // namespace isograsp::histogram_test
