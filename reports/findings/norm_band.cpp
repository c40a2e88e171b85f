// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/norm_band.hpp"

#include <algorithm>
#include <map>

#include "core/date.hpp"
#include "core/mean.hpp"
#include "reports/findings/comparable.hpp"
#include "statistics/percentile.hpp"

namespace isograsp::reports {

namespace {

constexpr int kDecade = 10;
constexpr double kLowPercent = 5.0;
constexpr double kHighPercent = 95.0;

Text people_words(storage::Sex sex, int decade, bool dominant) {
  const int last = decade + kDecade - 1;
  switch (sex) {
    case storage::Sex::female:
      return (dominant ? "women of %1 to %2, dominant hand"_text
                       : "women of %1 to %2, other than the dominant hand"_text)(decade, last);
    case storage::Sex::male:
      return (dominant ? "men of %1 to %2, dominant hand"_text
                       : "men of %1 to %2, other than the dominant hand"_text)(decade, last);
    case storage::Sex::other: break;
  }
  return (dominant ? "people of another sex of %1 to %2, dominant hand"_text
                   : "people of another sex of %1 to %2, other than the dominant hand"_text)(decade,
                                                                                             last);
}

/// The values of one person, day by day.
struct Person {
  DayCounter counter;
  std::map<double, std::vector<double>> days;
  bool failed = false;
};

double mean_over_days(const Person& person) {
  std::vector<double> means;
  for (const auto& [day, trials] : person.days) means.push_back(arithmetic_mean(trials));
  return arithmetic_mean(means);
}

}  // namespace

std::optional<int> age_decade(std::optional<int> birth_year, const std::string& date) {
  constexpr std::size_t kDay = 10;
  const auto day = date_from_iso(std::string_view(date).substr(0, std::min(kDay, date.size())));
  if (!birth_year || !day || static_cast<int>(day->year()) < *birth_year) return std::nullopt;
  return (static_cast<int>(day->year()) - *birth_year) / kDecade * kDecade;
}

std::optional<NormBand> norm_band(const std::vector<storage::PooledValue>& healthy,
                                  const StoredTrial& like, const storage::PatientProfile& profile,
                                  bool censored) {
  const storage::SessionRecord& session = *like.session_record;
  const auto decade = age_decade(profile.birth_year, session.started_utc);
  if (!profile.sex || !profile.dominant || !decade) return std::nullopt;
  const bool dominant = session.hand == *profile.dominant;
  const Conditions conditions = conditions_of(like);
  std::map<storage::RowId, Person> people;
  for (const storage::PooledValue& value : healthy) {
    if (value.patient_id == session.patient_id || value.sex != profile.sex || !value.dominant ||
        value.hand.has_value() != session.hand.has_value() ||
        (value.hand == *value.dominant) != dominant ||
        age_decade(value.birth_year, value.started_utc) != decade ||
        !difference(conditions, conditions_of(value)).empty())
      continue;
    Person& person = people[value.patient_id];
    if (value.value)
      person.days[person.counter.day_of(value.started_utc)].push_back(*value.value);
    else
      person.failed = person.failed || censored;
  }
  NormBand band;
  for (const auto& [id, person] : people)
    if (!person.failed && !person.days.empty()) band.values.push_back(mean_over_days(person));
  if (band.values.empty()) return std::nullopt;
  std::sort(band.values.begin(), band.values.end());
  band.people = people_words(*profile.sex, *decade, dominant);
  if (band.values.size() >= kLeastNormPeople) {
    band.low = statistics::percentile(band.values, kLowPercent).value;
    band.high = statistics::percentile(band.values, kHighPercent).value;
  }
  return band;
}

}  // namespace isograsp::reports
