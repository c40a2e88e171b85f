// SPDX-License-Identifier: GPL-3.0-or-later
// How healthy people of this clinic do in the same task, under the same conditions. A context,
// never a verdict. Rules: docs/report.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {
struct PooledValue;
}

namespace isograsp::reports {

struct StoredTrial;

/// Fewer healthy people of the same kind make no band.
inline constexpr std::size_t kLeastNormPeople = 20;

struct NormBand {
  Text people;                 ///< "women of 60 to 69, dominant hand"
  std::vector<double> values;  ///< one of each person, sorted
  std::optional<double> low;   ///< 5th percentile; nothing: fewer than kLeastNormPeople
  std::optional<double> high;  ///< 95th percentile
};

/// From the values of healthy people those of the sex, age decade and dominance of this person and
/// hand, under the conditions of `like`. A person's value is the mean over days of the means of
/// their trials. `censored`: who has a trial without value is left out. Nothing: sex, year of birth
/// or dominant hand of the person is not told, or nobody is like them.
[[nodiscard]] std::optional<NormBand> norm_band(const std::vector<storage::PooledValue>& healthy,
                                                const StoredTrial& like,
                                                const storage::PatientProfile& profile,
                                                bool censored);

/// "60 to 69 years" as 60; nothing: the year of birth is not told or lies behind the date.
[[nodiscard]] std::optional<int> age_decade(std::optional<int> birth_year, const std::string& date);

}  // namespace isograsp::reports
