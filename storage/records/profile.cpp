// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/records/profile.hpp"

#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "core/date.hpp"

namespace isograsp::storage {

namespace {

constexpr std::array<std::string_view, 4> kSideNames{"right", "left", "both", "none"};
constexpr std::array<std::string_view, 3> kSexNames{"female", "male", "other"};

/// "a, b or c".
template <class Names>
Text listed(const Names& names) {
  std::string all;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    all += (i == 0 ? "" : ", ") + std::string(names[i]);
  return "%1 or %2"_text(all, names.back());
}

/// "0 to 57", "0 blocks or more", "more than 0 s".
Text range_of(const ClinicalScale& scale) {
  const std::string unit = scale.unit.empty() ? "" : " " + std::string(scale.unit);
  if (std::isinf(scale.least)) return "any number"_text;
  const Number least = shortest(scale.least);
  if (!std::isinf(scale.most)) return "%1 to %2%3"_text(least, shortest(scale.most), unit);
  return scale.above_least ? "more than %1%2"_text(least, unit) : "%1%2 or more"_text(least, unit);
}

}  // namespace

std::string_view name_of(Side side) noexcept {
  return kSideNames[static_cast<std::size_t>(side)];
}

std::optional<Side> side_from_name(std::string_view name) noexcept {
  const auto* const found = std::find(kSideNames.begin(), kSideNames.end(), name);
  if (found == kSideNames.end()) return std::nullopt;
  return static_cast<Side>(found - kSideNames.begin());
}

std::string_view name_of(Sex sex) noexcept {
  return kSexNames[static_cast<std::size_t>(sex)];
}

std::optional<Sex> sex_from_name(std::string_view name) noexcept {
  const auto* const found = std::find(kSexNames.begin(), kSexNames.end(), name);
  if (found == kSexNames.end()) return std::nullopt;
  return static_cast<Sex>(found - kSexNames.begin());
}

const ClinicalScale* clinical_scale(std::string_view name) noexcept {
  const auto* const found =
      std::find_if(kClinicalScales.begin(), kClinicalScales.end(),
                   [name](const ClinicalScale& scale) { return scale.name == name; });
  return found == kClinicalScales.end() ? nullptr : found;
}

Result<void> check_date(const std::string& iso_date, std::string_view field) {
  constexpr Words remedy = "give year, month and day, such as 2026-03-05"_text;
  const auto date = date_from_iso(iso_date);
  if (!date)
    return refused("'%1' is no day of the calendar"_text(iso_date), remedy)
        .about(std::string(field));
  const int year = static_cast<int>(date->year());
  if (year < kFirstYear || year > kLastYear)
    return refused("'%1' is not in the years %2 to %3"_text(iso_date, kFirstYear, kLastYear),
                   remedy)
        .about(std::string(field));
  return {};
}

Result<void> check_profile(const PatientProfile& profile) {
  if (profile.birth_year && (*profile.birth_year < kFirstYear || *profile.birth_year > kLastYear))
    return refused("%1 is no year of birth"_text(*profile.birth_year),
                   "give a year from %1 on"_text(kFirstYear))
        .about("birth_year");
  if (profile.onset_date.empty()) return {};
  return check_date(profile.onset_date, "onset_date");
}

Result<void> check_treatment_mark(const TreatmentMark& mark) {
  if (auto good = check_date(mark.on_date, "on_date"); !good) return good;
  if (std::find(kTreatmentKinds.begin(), kTreatmentKinds.end(), mark.kind) == kTreatmentKinds.end())
    return refused("'%1' is no kind of treatment"_text(mark.kind),
                   "give %1"_text(listed(kTreatmentKinds)))
        .about("kind");
  return {};
}

Result<void> check_clinical_score(const ClinicalScore& score) {
  if (auto good = check_date(score.on_date, "on_date"); !good) return good;
  const ClinicalScale* const scale = clinical_scale(score.scale);
  if (scale == nullptr) {
    std::array<std::string_view, kClinicalScales.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kClinicalScales[i].name;
    return refused("'%1' is no scale that is known"_text(score.scale),
                   "give %1"_text(listed(names)))
        .about("scale");
  }
  const bool above = scale->above_least ? score.value > scale->least : score.value >= scale->least;
  if (!std::isfinite(score.value) || !above || score.value > scale->most)
    return refused("%1 is no score of the %2"_text(shortest(score.value), scale->name),
                   "give %1"_text(range_of(*scale)))
        .about("value");
  return {};
}

Result<void> check_primary_measure(const PrimaryMeasure& primary) {
  if (primary.task_name.empty())
    return refused("is empty"_text, "name the task"_text).about("task_name");
  if (primary.measure.empty())
    return refused("is empty"_text, "name the measure"_text).about("measure");
  if (primary.chosen_by.empty())
    return refused("is empty"_text, "say who chose the measure"_text).about("chosen_by");
  return {};
}

Result<void> check_stable_period(const StablePeriod& period) {
  if (auto good = check_date(period.from_date, "from_date"); !good) return good;
  if (auto good = check_date(period.until_date, "until_date"); !good) return good;
  if (period.until_date < period.from_date)  // ISO 8601 sorts as text
    return refused("'%1' is before %2"_text(period.until_date, period.from_date),
                   "give the last day of that time"_text)
        .about("until_date");
  if (period.judged_by.empty())
    return refused("is empty"_text, "say which clinician judged the person stable"_text)
        .about("judged_by");
  return {};
}

Result<void> check_answer(const SessionAnswer& answer) {
  if (answer.topic.empty())
    return refused("is empty"_text, "say what was asked about"_text).about("topic");
  if (answer.item.empty()) return refused("is empty"_text, "say what was asked"_text).about("item");
  return {};
}

}  // namespace isograsp::storage
