// SPDX-License-Identifier: GPL-3.0-or-later
// Over all pairs of points i < j:
//   Theil-Sen slope = median of (y_j - y_i) / (x_j - x_i)
//   tau-b = (pairs in the same order - pairs in opposite order) /
//           sqrt(pairs that differ in x * pairs that differ in y)
// Both with 95 % intervals from resampled points.
#include "statistics/robust_trend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/random.hpp"
#include "core/ties.hpp"

namespace isograsp::statistics {

namespace {

/// How often each point was drawn; a pair of points counts as the product of both numbers.
using Counts = std::span<const std::uint16_t>;

/// The draws of all resamples of so many points. They depend on nothing else, so trends over the
/// same number of days share them.
struct Resamples {
  std::size_t points;
  Bootstrap bootstrap;
  std::vector<std::uint16_t> counts;  ///< one resample after the other
};

std::shared_ptr<const Resamples> resamples_of(std::size_t n, const Bootstrap& bootstrap) {
  thread_local std::shared_ptr<const Resamples> last;
  if (last && last->points == n && last->bootstrap == bootstrap) return last;
  auto made = std::make_shared<Resamples>(Resamples{n, bootstrap, {}});
  made->counts.resize(n * static_cast<std::size_t>(bootstrap.resamples));
  Random random(bootstrap.seed);
  for (std::size_t first = 0; first < made->counts.size(); first += n)
    for (std::size_t draw = 0; draw < n; ++draw)
      ++made->counts[first + std::min(n - 1, static_cast<std::size_t>(random.uniform() *
                                                                      static_cast<double>(n)))];
  constexpr std::size_t kMostKept = 4'000'000;  // bytes: 200 days
  if (sizeof(std::uint16_t) * made->counts.size() <= kMostKept) last = made;
  return made;
}

/// `estimate` of points that each count as often as they were drawn; nothing where it has no value.
template <class F>
std::optional<Estimate> with_interval(std::size_t n, const Bootstrap& bootstrap, F estimate) {
  const std::vector<std::uint16_t> once(n, 1);
  const std::optional<double> value = estimate(Counts(once));
  if (!value) return std::nullopt;
  const auto resamples = resamples_of(n, bootstrap);
  std::vector<double> all;
  all.reserve(static_cast<std::size_t>(bootstrap.resamples));
  for (std::size_t first = 0; first < resamples->counts.size(); first += n)
    if (const auto one = estimate(Counts(resamples->counts).subspan(first, n))) all.push_back(*one);
  if (all.empty()) return std::nullopt;
  constexpr double kTail = 0.025;
  const auto tail = static_cast<std::ptrdiff_t>(kTail * static_cast<double>(all.size()));
  const auto low = all.begin() + tail;
  const auto high = all.end() - 1 - tail;
  std::nth_element(all.begin(), low, all.end());
  const double lower_end = *low;
  std::nth_element(low, high, all.end());
  return Estimate{*value, lower_end, *high};
}

/// Two points each, as columns: a resample goes through them from the first to the last.
struct Pairs {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> second;

  void add(std::size_t i, std::size_t j) {
    first.push_back(static_cast<std::uint32_t>(i));
    second.push_back(static_cast<std::uint32_t>(j));
  }
  [[nodiscard]] std::size_t size() const { return first.size(); }
  [[nodiscard]] std::int64_t times(std::size_t pair, Counts drawn) const {
    return std::int64_t{drawn[first[pair]]} * drawn[second[pair]];
  }
};

/// Pairs of points in the order of their slopes.
struct Slopes {
  Pairs pairs;
  std::vector<double> slope;
};

/// How many pairs of drawn points `pairs` stand for.
std::int64_t count_of(const Pairs& pairs, Counts drawn) {
  const auto n = static_cast<std::int64_t>(drawn.size());
  std::int64_t all = 0;
  if (static_cast<std::int64_t>(pairs.size()) == n * (n - 1) / 2) {  // all x differ: a formula
    for (const std::int64_t times : drawn) all += times * times;
    return (n * n - all) / 2;
  }
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) all += pairs.times(pair, drawn);
  return all;
}

/// Median of the slopes, each counted as often as its two points were drawn together.
std::optional<double> median_of(const Slopes& slopes, Counts drawn) {
  const std::int64_t all = count_of(slopes.pairs, drawn);
  if (all == 0) return std::nullopt;
  std::int64_t passed = 0;
  std::size_t at = 0;
  const auto slope_at = [&](std::int64_t place) {  // counted from 0
    constexpr std::size_t kAtOnce = 16;            // added without a branch between them
    while (at + kAtOnce <= slopes.pairs.size()) {
      std::int64_t of_block = 0;
      for (std::size_t i = 0; i < kAtOnce; ++i) of_block += slopes.pairs.times(at + i, drawn);
      if (passed + of_block > place) break;
      passed += of_block;
      at += kAtOnce;
    }
    for (; passed + slopes.pairs.times(at, drawn) <= place; ++at)
      passed += slopes.pairs.times(at, drawn);
    return at;
  };
  const std::size_t lower = slope_at((all - 1) / 2);
  const std::size_t upper = slope_at(all / 2);
  if (lower == upper) return slopes.slope[lower];
  return 0.5 * (slopes.slope[lower] + slopes.slope[upper]);
}

/// -1, 0, 1: a comes after b, they are tied, a comes before b.
int order_of(double a, double b, double width) {
  if (are_tied(a, b, width)) return 0;
  return a < b ? 1 : -1;
}

/// For each pair: the product of the order of its days and of its times, and which of both are
/// untied.
struct Orders {
  Pairs pairs;
  std::vector<std::int8_t> agreement;
  std::vector<std::int8_t> untied_x;
  std::vector<std::int8_t> untied_y;
};

/// Kendall's tau-b.
std::optional<double> tau_b(const Orders& orders, Counts drawn) {
  std::int64_t sum = 0;
  std::int64_t untied_x = 0;
  std::int64_t untied_y = 0;
  for (std::size_t pair = 0; pair < orders.pairs.size(); ++pair) {
    const std::int64_t times = orders.pairs.times(pair, drawn);
    sum += times * orders.agreement[pair];
    untied_x += times * orders.untied_x[pair];
    untied_y += times * orders.untied_y[pair];
  }
  if (untied_x == 0 || untied_y == 0) return std::nullopt;
  return static_cast<double>(sum) /
         std::sqrt(static_cast<double>(untied_x) * static_cast<double>(untied_y));
}

}  // namespace

std::optional<Estimate> theil_sen(std::span<const double> x, std::span<const double> y,
                                  const Bootstrap& bootstrap) {
  const std::size_t n = x.size();
  if (n < kLeastTrendDays) return std::nullopt;
  const double same_x = tie_width(x);
  struct Slope {
    double slope;
    std::size_t first;
    std::size_t second;
  };
  std::vector<Slope> all;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (are_tied(x[i], x[j], same_x)) continue;
      all.push_back({(y[j] - y[i]) / (x[j] - x[i]), i, j});
      if (!std::isfinite(all.back().slope)) return std::nullopt;
    }
  std::sort(all.begin(), all.end(),
            [](const Slope& a, const Slope& b) { return a.slope < b.slope; });
  Slopes slopes;
  for (const Slope& one : all) {
    slopes.slope.push_back(one.slope);
    slopes.pairs.add(one.first, one.second);
  }
  return with_interval(n, bootstrap, [&](Counts drawn) { return median_of(slopes, drawn); });
}

std::optional<RankTrend> rank_trend(std::span<const CensoredDay> days, const Bootstrap& bootstrap) {
  const std::size_t n = days.size();
  if (n < kLeastTrendDays) return std::nullopt;
  RankTrend trend;
  std::vector<double> x;
  std::vector<double> time;
  for (const auto& day : days) {
    trend.reached += day.reached;
    trend.tried += day.tried;
    x.push_back(day.x);
    time.push_back(day.value.value_or(std::numeric_limits<double>::infinity()));
  }
  const double same_x = tie_width(x);
  const double same_time = tie_width(time);
  Orders orders;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const int of_x = order_of(x[i], x[j], same_x);
      const int of_time = order_of(time[i], time[j], same_time);
      orders.pairs.add(i, j);
      orders.agreement.push_back(static_cast<std::int8_t>(of_x * of_time));
      orders.untied_x.push_back(static_cast<std::int8_t>(of_x * of_x));
      orders.untied_y.push_back(static_cast<std::int8_t>(of_time * of_time));
    }
  const auto tau = with_interval(n, bootstrap, [&](Counts drawn) { return tau_b(orders, drawn); });
  if (!tau) return std::nullopt;
  trend.tau = *tau;
  return trend;
}

}  // namespace isograsp::statistics
