// SPDX-License-Identifier: GPL-3.0-or-later
// Courses: whatever is accepted makes people whose traits are within their ranges, on any day.
#include "virtual_patient/course.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto course = virtual_patient::parse_course(text, "course.toml");
  if (!course) {
    fuzz::require_helpful(course.error(), text);
    return 0;
  }
  for (const std::uint64_t day : {0U, 1U, 30U, 10000U}) {
    const virtual_patient::PatientTraits traits = virtual_patient::course_traits(
        *course, *virtual_patient::patient_traits("paretic"), day, 1);
    fuzz::require(virtual_patient::clamped(traits) == traits, "every trait is within its range");
  }
  return 0;
}
