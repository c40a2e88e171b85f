// SPDX-License-Identifier: GPL-3.0-or-later
// Has a person changed by more than measurement error? Pure statistics: day means against the
// day-to-day variation of people judged stable. Rules, formulas and their proof: docs/change.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

/// One assessment: the trials of one day that count, in one series. Unit of the measure.
struct AssessmentDay {
  double day = 0.0;            ///< when its first session began [d], from any origin
  std::vector<double> trials;  ///< values, in order
  bool failed = false;         ///< a censored time did not come: the day has no mean
};
/// Mean of the trials; nothing if the day failed or has none.
[[nodiscard]] std::optional<double> day_mean(const AssessmentDay& day);
/// Mean of the means of days. @pre not empty, all have one
[[nodiscard]] double mean_of(std::span<const AssessmentDay> days);
/// a - b; nothing where that is too large for a number.
[[nodiscard]] std::optional<double> difference_of(double a, double b);

/// The days of one hand of a person during one time over which a clinician judges the person
/// stable. Several of one person carry the same number.
struct StableDays {
  std::int64_t person = 0;
  std::vector<AssessmentDay> days;  ///< oldest first
};

// A pool of pairs of such days, 1 to 7 days apart.
inline constexpr int kLeastPairGap_days = 1;
inline constexpr int kMostPairGap_days = 7;
inline constexpr int kLeastPeople = 10;
inline constexpr double kMostWithoutLogarithm = 0.1;

/// Where the error grows with the mean it is measured on logarithms. What is usual for a measure
/// says measure_words.hpp.
enum class ErrorScale : std::uint8_t { linear, logarithmic };

/// Within-person error of one measure.
struct MeasurementError {
  ErrorScale scale = ErrorScale::linear;
  double day_sd = 0.0;    ///< between days; unit of the measure, or of its natural logarithm
  double trial_sd = 0.0;  ///< between the trials of a day; the same unit
  double df = 0.0;        ///< degrees of freedom for a person who is not in the pool
  double t975 = 0.0;      ///< quantile 0.975 of Student's t with df
};
struct StablePool {
  int people = 0;  ///< with one pair at least
  int pairs = 0;
  /// Nothing: fewer than kLeastPeople, or no variation at all.
  std::optional<MeasurementError> error;
  int left_out = 0;  ///< pairs that lie too far from the others (robust_variance.hpp)
};
/// Days that failed make no pair. Each person weighs the same, however many pairs they have; pairs
/// that lie far outside of the others count for the number of people, not for the error. The scale
/// is `usual` unless the values clearly fit the other one better; linear where values of more than
/// kMostWithoutLogarithm of the pairs are not positive, such pairs lie far outside otherwise.
[[nodiscard]] StablePool pool_of(std::span<const StableDays> stable, ErrorScale usual);

/// What a mean was taken over: days, and trials in all (docs/change.md for unequal days).
struct Averaged {
  int days = 1;
  double trials = 1.0;
};
/// Smallest change beyond measurement error with 95 % confidence, on the scale of `error`.
[[nodiscard]] double mdc95(const MeasurementError& error, Averaged before, Averaged after);

enum class Verdict : std::uint8_t { cannot_be_judged, within_error, improved, worsened };
enum class WhyNotJudged : std::uint8_t {
  judged,
  no_direction,        ///< more of it is neither better nor worse
  baseline_too_short,  ///< fewer than two days
  baseline_failed,     ///< fewer than two days have a mean, others failed
  nothing_after,       ///< no day after the baseline
  last_failed,         ///< the last day has no mean
  too_few_people,      ///< in the pool
  no_variation,        ///< in the pool: no error can be known
  not_positive         ///< the baseline has no logarithm, on a logarithmic scale
};

inline constexpr std::size_t kBaselineDays = 2;

/// The first days that have a mean, kBaselineDays at most. Days before or between them on which a
/// censored time did not come are passed over.
struct Baseline {
  std::vector<AssessmentDay> days;
  std::size_t end = 0;  ///< index of the day that follows the last of them
};
[[nodiscard]] Baseline baseline_of(std::span<const AssessmentDay> days);

/// The last day against the baseline. Values in the unit of the measure.
struct ChangeJudgement {
  Verdict verdict = Verdict::cannot_be_judged;
  bool confirmed = false;  ///< else improved and worsened are possible only
  WhyNotJudged why = WhyNotJudged::judged;
  std::optional<double> baseline;  ///< mean of the means of its two days
  std::optional<double> last;      ///< mean of the last day
  /// last - baseline; of measures that are best near zero: of their distances from zero. Nothing,
  /// too, where it is too large for a number.
  std::optional<double> change;
  /// The changes, down (negative) and up, that are not larger than measurement error. None: the
  /// pool has no error.
  std::optional<double> mdc_down;
  std::optional<double> mdc_up;
  /// The whole way from the baseline down to zero is not larger than measurement error: where
  /// nothing can be less than zero, no fall can be told.
  bool none_to_zero = false;
};
/// @param days  one series, oldest first, one element per day
[[nodiscard]] ChangeJudgement judge_change(std::span<const AssessmentDay> days,
                                           const StablePool& pool, tasks::Better better);

}  // namespace isograsp::reports
