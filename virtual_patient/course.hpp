// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to a person over weeks, format "isograsp-course-1" (library/patients/courses): a
// list of changes, each of which fades in and out. Assumed courses for testing reports and
// verdicts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// One change. Its strength on a day is between 0 and 1:
///   approach  1 - exp(-(day - from) / time), from its first day on (exponential recovery)
///   linear    (day - from) / time, at most 1
///   during    rises as approach until its last day and fades with the same time constant; time 0:
///             all or nothing
struct CourseChange {
  enum class Shape : std::uint8_t { approach, linear, during };
  struct Factor {
    double PatientTraits::*trait;
    double factor;
  };
  Shape shape = Shape::approach;
  double from_day = 0.0;
  double until_day = 0.0;  ///< of `during`
  double time_days = 0.0;
  double recovery = 0.0;        ///< share of the way to healthy at strength 1
  std::vector<Factor> factors;  ///< traits are multiplied by factor ^ strength

  [[nodiscard]] double strength(double day) const noexcept;
};

struct Course {
  std::string name;
  std::string description;
  double days_between_sessions = 0.0;
  std::vector<CourseChange> changes;
};

/// Unknown keys, shapes and traits, and values out of range are errors with their line.
[[nodiscard]] Result<Course> parse_course(std::string_view text, const std::string& file);

/// The person on a day (0: the first), without the ups and downs of days and without practice.
[[nodiscard]] PatientTraits course_mean(const Course& course, const PatientTraits& patient,
                                        double day);
/// The person who comes on that day: with the practice of the sessions before and the day's form.
/// The same arguments give the same person.
[[nodiscard]] PatientTraits course_traits(const Course& course, const PatientTraits& patient,
                                          std::uint64_t day, std::uint64_t seed);

}  // namespace isograsp::virtual_patient
