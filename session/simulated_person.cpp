// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/simulated_person.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/files.hpp"
#include "virtual_patient/course.hpp"
#include "virtual_patient/patient_file.hpp"

namespace isograsp::session {

namespace fs = std::filesystem;

namespace {

constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every integer below is a double
constexpr double kLatestDay = 10000.0;
constexpr double kLeastStrength = 0.1;  // of that of the person named
constexpr double kMostStrength = 5.0;
constexpr const char* kPeople = "patients";
constexpr const char* kCourses = "patients/courses";

/// The file of one of `names`; a name that is none of them opens no file, wherever it points.
Result<std::string> chosen(const Uri& uri, const std::string& field, Words what,
                           const std::string& name, const std::vector<std::string>& names,
                           const fs::path& folder) {
  if (std::find(names.begin(), names.end(), name) != names.end())
    return (folder / (name + ".toml")).string();
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return refused("there is no %1 '%2'"_text(what, name),
                 list.empty() ? "this library has none"_text : "use one of: %1"_text(list))
      .at(uri.text)
      .about(field);
}

Result<virtual_patient::PatientTraits> named(const Uri& uri, const std::string& library) {
  if (const auto traits = virtual_patient::patient_traits(uri.target)) return *traits;
  const auto path = chosen(uri, "", "simulated patient"_text, uri.target, simulated_people(library),
                           fs::path(library) / kPeople);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  const auto patient = virtual_patient::parse_patient(*text, *path);
  if (!patient) return patient.error();
  return patient->traits;
}

Result<virtual_patient::Course> course_of(const Uri& uri, const std::string& library,
                                          const std::string& name) {
  const auto path = chosen(uri, "course", "course"_text, name, simulated_courses(library),
                           fs::path(library) / kCourses);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  return virtual_patient::parse_course(*text, *path);
}

Result<double> seed_of(const Uri& uri) {
  return uri.number_or("seed", 1.0, 0.0, kLargestSeed);
}

}  // namespace

std::vector<std::string> names_in(const std::string& library, const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;  // a library without people has none
  if (!library.empty())
    for (const auto& entry : fs::directory_iterator(library / folder, unreadable))
      if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> simulated_people(const std::string& library) {
  std::vector<std::string> names{"healthy", "paretic"};
  const auto of_library = names_in(library, kPeople);
  names.insert(names.end(), of_library.begin(), of_library.end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> simulated_courses(const std::string& library) {
  return names_in(library, kCourses);
}

Result<virtual_patient::PatientTraits> simulated_traits(const Uri& uri,
                                                        const std::string& library) {
  const auto found = named(uri, library);
  if (!found) return found.error();
  const auto recovery = uri.number_or("recovery", 0.0, 0.0, 1.0);
  if (!recovery) return recovery.error();
  const auto strength = uri.number_or("strength", 1.0, kLeastStrength, kMostStrength);
  if (!strength) return strength.error();
  virtual_patient::PatientTraits traits = virtual_patient::recovered(*found, *recovery);
  traits.maximum_force_N *= *strength;
  traits = virtual_patient::clamped(traits);
  const auto seed = seed_of(uri);
  if (!seed) return seed.error();
  const std::string course_name = uri.text_or("course", "");
  if (uri.parameters.count("day") == 0) {
    if (course_name.empty()) return traits;
    return refused("a course needs a day"_text, "write for example day=0"_text)
        .at(uri.text)
        .about("day");
  }
  const auto day = uri.number_or("day", 0.0, 0.0, kLatestDay);
  if (!day) return day.error();
  if (*day != std::floor(*day))
    return refused("is not a whole number"_text, "write a whole number such as day=14"_text)
        .at(uri.text)
        .about("day");
  const auto person = static_cast<std::uint64_t>(*seed);
  const auto today = static_cast<std::uint64_t>(*day);
  if (course_name.empty())
    return virtual_patient::on_day(traits, virtual_patient::day_seed(person, today));
  const auto course = course_of(uri, library, course_name);
  if (!course) return course.error();
  return virtual_patient::course_traits(*course, traits, today, person);
}

Result<std::unique_ptr<virtual_patient::VirtualPatient>> simulated_person(
    const Uri& uri, const std::string& library) {
  if (uri.scheme != "sim") return std::unique_ptr<virtual_patient::VirtualPatient>();
  const auto traits = simulated_traits(uri, library);
  if (!traits) return traits.error();
  const auto seed = seed_of(uri);
  if (!seed) return seed.error();
  // On another day the noise is another one, too.
  const auto day = uri.number_or("day", 0.0, 0.0, kLatestDay);
  const auto person = static_cast<std::uint64_t>(*seed);
  const bool dated = uri.parameters.count("day") > 0;
  return std::make_unique<virtual_patient::VirtualPatient>(
      *traits,
      dated ? virtual_patient::day_seed(person, static_cast<std::uint64_t>(*day)) : person);
}

}  // namespace isograsp::session
