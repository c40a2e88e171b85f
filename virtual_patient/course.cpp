// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/course.hpp"

#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"

namespace isograsp::virtual_patient {

namespace {

constexpr double kLongest_days = 10000.0;

double number_within(TomlReader& table, std::string_view key, double least, double most,
                     std::optional<double> fallback = {}) {
  const double value = table.number(key, fallback);
  if (value < least || value > most)
    table.fail(key, "is out of range"_text,
               "write a value from %1 to %2"_text(shortest(least), shortest(most)));
  return value;
}

CourseChange read_change(TomlReader& table) {
  CourseChange change;
  change.shape =
      static_cast<CourseChange::Shape>(table.choice("shape", {"approach", "linear", "during"}));
  const bool during = change.shape == CourseChange::Shape::during;
  constexpr double kShortest_days = 0.1;
  change.from_day = number_within(table, "from_day", 0.0, kLongest_days);
  if (during) change.until_day = number_within(table, "until_day", 0.0, kLongest_days);
  change.time_days =
      number_within(table, "time_days", during ? 0.0 : kShortest_days, kLongest_days);
  if (during && change.until_day <= change.from_day)
    table.fail("until_day", "is not after from_day"_text, "write a later day"_text);
  change.recovery = number_within(table, "recovery", -1.0, 1.0, 0.0);
  TomlReader factors = table.table("factor", false);
  constexpr double kLeastFactor = 0.01;
  constexpr double kMostFactor = 100.0;
  for (const TraitField& field : trait_fields())
    if (factors.has(field.key))
      change.factors.push_back(
          {field.value, number_within(factors, field.key, kLeastFactor, kMostFactor)});
  if (change.recovery == 0.0 && change.factors.empty())
    table.fail("shape", "changes nothing"_text, "write a recovery or a factor"_text);
  return change;
}

}  // namespace

double CourseChange::strength(double day) const noexcept {
  const double since_days = day - from_day;
  if (since_days < 0.0) return 0.0;
  const auto approached = [this](double days) {
    return time_days > 0.0 ? 1.0 - std::exp(-days / time_days) : 1.0;
  };
  switch (shape) {
    case Shape::approach: return approached(since_days);
    case Shape::linear: return std::min(1.0, since_days / time_days);
    case Shape::during:
      return approached(std::min(day, until_day) - from_day) *
             (day < until_day ? 1.0 : 1.0 - approached(day - until_day));
  }
  return 0.0;
}

Result<Course> parse_course(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-course-1");
  if (!root) return root.error();
  Course course;
  course.name = root->text("name");
  course.description = root->text("description");
  course.days_between_sessions = number_within(*root, "days_between_sessions", 0.25, 365.0);
  constexpr std::size_t kMostChanges = 16;  // 100^16 is still a number to compute with
  std::vector<TomlReader> tables = root->tables("change");
  if (tables.size() > kMostChanges)
    root->fail("change", "are too many"_text, "write at most %1"_text(kMostChanges));
  for (TomlReader& table : tables) course.changes.push_back(read_change(table));
  if (auto done = root->finish(); !done) return done.error();
  return course;
}

PatientTraits course_mean(const Course& course, const PatientTraits& patient, double day) {
  PatientTraits traits = patient;
  for (const CourseChange& change : course.changes) {
    const double strength = change.strength(day);
    if (strength == 0.0) continue;
    traits = recovered(traits, change.recovery * strength);
    for (const auto& [trait, factor] : change.factors) traits.*trait *= std::pow(factor, strength);
  }
  return clamped(traits);
}

PatientTraits course_traits(const Course& course, const PatientTraits& patient, std::uint64_t day,
                            std::uint64_t seed) {
  const auto days = static_cast<double>(day);
  const double sessions_before = std::floor(days / course.days_between_sessions);
  return on_day(practised(course_mean(course, patient, days), sessions_before),
                day_seed(seed, day));
}

}  // namespace isograsp::virtual_patient
