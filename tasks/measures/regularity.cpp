// SPDX-License-Identifier: GPL-3.0-or-later
// Sample entropy = -ln(longer / shorter). shorter: pairs of templates of m = 2 samples that nowhere
// differ by more than r = 0.2 SD; longer: those whose third samples differ by no more either.
#include "tasks/measures/regularity.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <boost/sort/pdqsort/pdqsort.hpp>

namespace isograsp::tasks {

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

/// Three sets of templates: similar second samples, and the two sets whose difference are
/// the similar third samples.
struct Sets {
  const Word* second;
  const Word* below;
  const Word* up_to;
};

/// Words [first, last] of the sets, and which bits of the first and of the last one count.
struct WordRange {
  std::size_t first = 0;
  std::size_t last = 0;
  Word first_mask = 0;
  Word last_mask = 0;
};

[[gnu::always_inline]] inline TemplateMatches matches_in(const Sets& sets, const WordRange& bits) {
  TemplateMatches matches;
  const auto add = [&](std::size_t w, Word mask) {
    const Word both = sets.second[w] & mask;
    matches.shorter += std::popcount(both);
    matches.longer += std::popcount(both & (sets.below[w] ^ sets.up_to[w]));
  };
  if (bits.first == bits.last) {
    add(bits.first, bits.first_mask & bits.last_mask);
    return matches;
  }
  add(bits.first, bits.first_mask);
  for (std::size_t w = bits.first + 1; w < bits.last; ++w) add(w, ~Word{0});
  add(bits.last, bits.last_mask);
  return matches;
}

using CountMatches = TemplateMatches (*)(const Sets&, const WordRange&);

TemplateMatches count_anywhere(const Sets& sets, const WordRange& bits) {
  return matches_in(sets, bits);
}

/// The same for a processor that counts the bits of a word by itself: three times as fast.
[[gnu::target("popcnt")]] TemplateMatches count_with_popcnt(const Sets& sets,
                                                            const WordRange& bits) {
  return matches_in(sets, bits);
}

/// RowNumber of a sample by time or by size. Half the memory of std::size_t, because reading memory
/// takes most of the time.
using RowNumber = std::uint32_t;

/// Ranks [low, high) of samples.
struct Range {
  RowNumber low = 0;
  RowNumber high = 0;
};

/// The samples by size, and for each sample the range of those at most r away: rounding keeps the
/// order of differences, so the range is exactly what comparing with every sample would give.
struct Ranking {
  Ranking(std::span<const double> x, double r) : sample(x.size()), rank(x.size()), near(x.size()) {
    struct Numbered {
      double value;
      RowNumber sample;
    };
    std::vector<Numbered> sorted(x.size());
    for (RowNumber j = 0; j < x.size(); ++j) sorted[j] = {x[j], j};
    boost::sort::pdqsort_branchless(
        sorted.begin(), sorted.end(),
        [](const Numbered& a, const Numbered& b) { return a.value < b.value; });
    Range range;
    for (RowNumber k = 0; k < x.size(); ++k) {
      const auto [value, j] = sorted[k];
      sample[k] = j;
      rank[j] = k;
      while (value - sorted[range.low].value > r) ++range.low;
      while (range.high < x.size() && sorted[range.high].value - value <= r) ++range.high;
      near[j] = range;
    }
  }
  std::vector<RowNumber> sample;  ///< by rank
  std::vector<RowNumber> rank;    ///< by sample
  std::vector<Range> near;        ///< by sample
};

/// Counts matches of templates (x_j, x_j+1, x_j+2) with sets of templates, one bit each. The bit of
/// template j is the rank of x_j, so those with a similar first sample are neighbours; a pair is
/// counted at the one with the lower rank. Those with a similar second sample are kept up to date
/// while the second samples are visited by size. Those with a similar third sample are the
/// difference of two stored sets.
class MatchCounter {
 public:
  MatchCounter(std::span<const double> x, double r)
      : ranking_(x, r),
        words_(x.size() / kBits + 1),
        spacing_(std::max(kLeastSpacing, x.size() / kMostSets)),
        second_bit_(bits_of_templates(1)),
        third_bit_(bits_of_templates(2)),
        second_(words_, 0) {
    std::vector<Word> set(words_, 0);
    lowest_third_.reserve((x.size() / spacing_ + 1) * words_);
    for (std::size_t k = 0; k <= x.size(); ++k) {
      if (k % spacing_ == 0) lowest_third_.insert(lowest_third_.end(), set.begin(), set.end());
      if (k < x.size()) flip(set, third_bit_[k]);
    }
  }

  [[nodiscard]] TemplateMatches count() {
    TemplateMatches matches;
    Range kept;
    for (std::size_t k = 0; k < second_bit_.size(); ++k) {
      if (second_bit_[k] == no_template()) continue;
      const std::size_t second = ranking_.sample[k];
      const Range wanted = ranking_.near[second];
      for (; kept.high < wanted.high; ++kept.high) flip(second_, second_bit_[kept.high]);
      for (; kept.low < wanted.low; ++kept.low) flip(second_, second_bit_[kept.low]);
      const Range first{second_bit_[k] + 1, ranking_.near[second - 1].high};
      if (first.low < first.high) add_matches(first, ranking_.near[second + 1], matches);
    }
    return matches;
  }

 private:
  // Each stored set costs memory, each rank between two of them costs a look at it.
  static constexpr std::size_t kMostSets = 1024;
  static constexpr std::size_t kLeastSpacing = 32;

  /// A bit that no range of first samples holds.
  [[nodiscard]] RowNumber no_template() const {
    return static_cast<RowNumber>(ranking_.sample.size());
  }

  /// By rank of the sample at `offset` of a template: the template's bit.
  [[nodiscard]] std::vector<RowNumber> bits_of_templates(std::size_t offset) const {
    const std::size_t templates = ranking_.sample.size() - kTemplate;
    std::vector<RowNumber> bits;
    bits.reserve(ranking_.sample.size());
    for (const std::size_t sample : ranking_.sample)
      bits.push_back(sample >= offset && sample - offset < templates
                         ? ranking_.rank[sample - offset]
                         : no_template());
    return bits;
  }

  static void flip(std::vector<Word>& set, RowNumber bit) {
    set[bit / kBits] ^= Word{1} << (bit % kBits);
  }

  void add_matches(Range first, Range third, TemplateMatches& matches) const {
    const std::size_t low_set = nearest_set(third.low);
    const std::size_t high_set = nearest_set(third.high);
    const Sets sets{second_.data(), lowest_third_.data() + low_set * words_,
                    lowest_third_.data() + high_set * words_};
    const std::size_t end = first.high - 1;
    const TemplateMatches whole =
        count_matches_(sets, {first.low / kBits, end / kBits, ~Word{0} << (first.low % kBits),
                              ~Word{0} >> (kBits - 1 - end % kBits)});
    matches.shorter += whole.shorter;
    matches.longer += whole.longer;
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
      const RowNumber bit = third_bit_[k];
      const Word is_second = (second_[bit / kBits] >> (bit % kBits)) & 1U;
      const bool is_first = bit - first.low < first.high - first.low;
      count += static_cast<std::int64_t>(is_second & static_cast<Word>(is_first));
    }
    return from <= to ? count : -count;
  }

  CountMatches count_matches_ =
      __builtin_cpu_supports("popcnt") != 0 ? count_with_popcnt : count_anywhere;
  Ranking ranking_;
  std::size_t words_;                  ///< of one set
  std::size_t spacing_;                ///< ranks between stored sets
  std::vector<RowNumber> second_bit_;  ///< by rank of the second sample
  std::vector<RowNumber> third_bit_;   ///< by rank of the third sample
  std::vector<Word> second_;           ///< templates with a similar second sample
  std::vector<Word> lowest_third_;     ///< set k: templates of the k spacing_ lowest third samples
};

}  // namespace

TemplateMatches template_matches(std::span<const double> x) {
  if (x.size() <= kTemplate) return {};
  return MatchCounter(x, tolerance_of(x)).count();
}

statistics::Computed sample_entropy(std::span<const double> x) {
  if (x.size() <= kTemplate + 1) return "fewer than four samples"_text;
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  if (*least == *most) return "the signal does not vary"_text;
  const TemplateMatches matches = template_matches(x);
  if (matches.shorter == 0 || matches.longer == 0) return "no templates match"_text;
  return -std::log(static_cast<double>(matches.longer) / static_cast<double>(matches.shorter));
}

}  // namespace isograsp::tasks
