// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/regularity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isograsp {

namespace {

constexpr std::size_t kTemplate = 2;  ///< m

double tolerance_of(std::span<const double> x) {
  constexpr double kShareOfSd = 0.2;
  const double n = static_cast<double>(x.size());
  double mean = 0.0;
  for (const double value : x) mean += value;
  mean /= n;
  double squares = 0.0;
  for (const double value : x) squares += (value - mean) * (value - mean);
  return kShareOfSd * std::sqrt(squares / n);
}

using Word = std::uint64_t;
constexpr std::size_t kBits = 64;

/// The bits that are set, as std::popcount, which is a call where the processor is not known.
std::int64_t count_bits(Word v) {
  v -= (v >> 1) & 0x5555555555555555U;
  v = (v & 0x3333333333333333U) + ((v >> 2) & 0x3333333333333333U);
  v = (v + (v >> 4)) & 0x0F0F0F0F0F0F0F0FU;
  return static_cast<std::int64_t>((v * 0x0101010101010101U) >> 56);
}

/// Ranks [low, high) of samples.
struct Range {
  std::size_t low = 0;
  std::size_t high = 0;
};

/// The samples by size, and for each sample the range of those at most r away: rounding keeps the
/// order of differences, so the range is exactly what comparing with every sample would give.
struct Ranking {
  Ranking(std::span<const double> x, double r) : sample(x.size()), rank(x.size()), near(x.size()) {
    std::iota(sample.begin(), sample.end(), std::size_t{0});
    std::sort(sample.begin(), sample.end(),
              [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    Range range;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double here = x[sample[k]];
      rank[sample[k]] = k;
      while (here - x[sample[range.low]] > r) ++range.low;
      while (range.high < x.size() && x[sample[range.high]] - here <= r) ++range.high;
      near[sample[k]] = range;
    }
  }
  std::vector<std::size_t> sample;  ///< by rank
  std::vector<std::size_t> rank;    ///< by sample
  std::vector<Range> near;          ///< by sample
};

/// Counts matches of templates (x_j, x_j+1, x_j+2) with sets of templates, one bit each. The bit of
/// template j is the rank of x_j, so those with a similar first sample are neighbours. Those with a
/// similar second sample are kept up to date while the second samples are visited by size. Those
/// with a similar third sample are the difference of two stored sets.
class MatchCounter {
 public:
  MatchCounter(std::span<const double> x, double r)
      : templates_(x.size() - kTemplate),
        ranking_(x, r),
        words_(x.size() / kBits + 1),
        second_(words_, 0),
        spacing_(std::max(kBits, x.size() / kMostSets)) {
    std::vector<Word> set(words_, 0);
    for (std::size_t k = 0; k <= x.size(); ++k) {
      if (k % spacing_ == 0) lowest_third_.insert(lowest_third_.end(), set.begin(), set.end());
      if (k == x.size()) break;
      flip(set, k, 2);
      const std::size_t sample = ranking_.sample[k];
      third_bit_.push_back(static_cast<std::uint32_t>(
          has_template(sample, 2) ? ranking_.rank[sample - 2] : x.size()));
    }
  }

  [[nodiscard]] TemplateMatches count() {
    TemplateMatches ordered;  // both ways round, and each template with itself
    Range kept;
    for (const std::size_t second : ranking_.sample) {
      if (!has_template(second, 1)) continue;
      const Range wanted = ranking_.near[second];
      for (; kept.high < wanted.high; ++kept.high) flip(second_, kept.high, 1);
      for (; kept.low < wanted.low; ++kept.low) flip(second_, kept.low, 1);
      add_matches(second - 1, ordered);
    }
    const auto self = static_cast<std::int64_t>(templates_);
    return {(ordered.longer - self) / 2, (ordered.shorter - self) / 2};
  }

 private:
  static constexpr std::size_t kMostSets = 512;  ///< keeps them in the cache

  /// Whether the sample is the one at `offset` of a template.
  [[nodiscard]] bool has_template(std::size_t sample, std::size_t offset) const {
    return sample >= offset && sample - offset < templates_;
  }

  /// Adds to or takes from the set the template whose sample at `offset` has rank k.
  void flip(std::vector<Word>& set, std::size_t k, std::size_t offset) const {
    const std::size_t sample = ranking_.sample[k];
    if (!has_template(sample, offset)) return;
    const std::size_t bit = ranking_.rank[sample - offset];
    set[bit / kBits] ^= Word{1} << (bit % kBits);
  }

  void add_matches(std::size_t i, TemplateMatches& matches) const {
    const Range first = ranking_.near[i];
    const Range third = ranking_.near[i + 2];
    const std::size_t low_set = nearest_set(third.low);
    const std::size_t high_set = nearest_set(third.high);
    const Word* const below = lowest_third_.data() + low_set * words_;
    const Word* const up_to = lowest_third_.data() + high_set * words_;
    const std::size_t last = (first.high - 1) / kBits;
    Word mask = ~Word{0} << (first.low % kBits);
    for (std::size_t w = first.low / kBits; w <= last; ++w) {
      if (w == last) mask &= ~Word{0} >> (kBits - 1 - (first.high - 1) % kBits);
      const Word both = second_[w] & mask;
      matches.shorter += count_bits(both);
      matches.longer += count_bits(both & (below[w] ^ up_to[w]));
      mask = ~Word{0};
    }
    matches.longer += matches_between(third.low, low_set * spacing_, first);
    matches.longer += matches_between(high_set * spacing_, third.high, first);
  }

  [[nodiscard]] std::size_t nearest_set(std::size_t rank) const {
    return std::min((rank + spacing_ / 2) / spacing_, lowest_third_.size() / words_ - 1);
  }

  /// How many more matches end at rank `to` of the third sample than at `from`; negative backwards.
  [[nodiscard]] std::int64_t matches_between(std::size_t from, std::size_t to, Range first) const {
    std::int64_t count = 0;
    for (std::size_t k = std::min(from, to); k < std::max(from, to); ++k) {
      const std::size_t bit = third_bit_[k];
      const Word is_second = (second_[bit / kBits] >> (bit % kBits)) & 1U;
      const bool is_first = bit - first.low < first.high - first.low;
      count += static_cast<std::int64_t>(is_second & static_cast<Word>(is_first));
    }
    return from <= to ? count : -count;
  }

  std::size_t templates_;
  Ranking ranking_;
  std::size_t words_;                     ///< of one set
  std::vector<Word> second_;              ///< templates with a similar second sample
  std::size_t spacing_;                   ///< ranks between stored sets
  std::vector<std::uint32_t> third_bit_;  ///< by rank of the third sample; none: never set
  std::vector<Word> lowest_third_;  ///< set k: templates of the k spacing_ lowest third samples
};

}  // namespace

TemplateMatches template_matches(std::span<const double> x) {
  if (x.size() <= kTemplate) return {};
  return MatchCounter(x, tolerance_of(x)).count();
}

Computed sample_entropy(std::span<const double> x) {
  if (x.size() <= kTemplate + 1) return "fewer than four samples";
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  if (*least == *most) return "the signal does not vary";
  const TemplateMatches matches = template_matches(x);
  if (matches.shorter == 0 || matches.longer == 0) return "no templates match";
  return -std::log(static_cast<double>(matches.longer) / static_cast<double>(matches.shorter));
}

}  // namespace isograsp
