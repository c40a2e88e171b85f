// SPDX-License-Identifier: GPL-3.0-or-later
// The person that a URI of a simulated device describes.
#include "session/simulated_person.hpp"

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "virtual_patient/course.hpp"

namespace isograsp::session::simulated_person_test {
namespace {

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

Result<virtual_patient::PatientTraits> traits(const std::string& text,
                                              const std::string& library = kLibrary) {
  const auto uri = Uri::parse(text);
  EXPECT_TRUE(uri) << text;
  return simulated_traits(*uri, library);
}

std::string error(const std::string& text, const std::string& library = kLibrary) {
  const auto found = traits(text, library);
  EXPECT_FALSE(found) << text;
  return found ? std::string() : found.error().message();
}

TEST(SimulatedPerson, EveryPersonAndEveryCourseOfTheLibraryCanBeNamed) {
  EXPECT_GE(simulated_people(kLibrary).size(), 15U);
  EXPECT_GE(simulated_courses(kLibrary).size(), 5U);
  for (const std::string& name : test::every(simulated_people(kLibrary)))
    for (const std::string& course : test::every(simulated_courses(kLibrary))) {
      const std::string uri = "sim://" + name + "?seed=3&day=40&course=" + course;
      EXPECT_TRUE(traits(uri)) << uri;
      EXPECT_TRUE(*simulated_person(*Uri::parse(uri), kLibrary)) << uri;
    }
}

TEST(SimulatedPerson, HealthyAndPareticNeedNoLibrary) {
  EXPECT_EQ(*traits("sim://healthy", ""), *virtual_patient::patient_traits("healthy"));
  EXPECT_EQ(*traits("sim://paretic?recovery=0.4", ""),
            virtual_patient::recovered(*virtual_patient::patient_traits("paretic"), 0.4));
  EXPECT_EQ(simulated_people(""), (std::vector<std::string>{"healthy", "paretic"}));
  EXPECT_TRUE(simulated_courses("").empty());
}

TEST(SimulatedPerson, WithoutADayThePersonIsAsNamedAndADayIsTheirForm) {
  const virtual_patient::PatientTraits severe = *traits("sim://severe?seed=5");
  EXPECT_EQ(severe.maximum_force_N, 2.0);
  EXPECT_EQ(*traits("sim://severe?seed=5&day=3"),
            virtual_patient::on_day(severe, virtual_patient::day_seed(5, 3)));
  EXPECT_NE(*traits("sim://severe?seed=5&day=3"), *traits("sim://severe?seed=5&day=4"));
  EXPECT_EQ(*traits("sim://severe?seed=5&day=3"), *traits("sim://severe?seed=5&day=3"));
}

TEST(SimulatedPerson, StrengthMultipliesTheMaximumAlone) {
  virtual_patient::PatientTraits stronger = *traits("sim://moderate?seed=5");
  stronger.maximum_force_N *= 1.5;
  EXPECT_EQ(*traits("sim://moderate?seed=5&strength=1.5"), stronger);
  EXPECT_NE(error("sim://moderate?strength=9").find("strength"), std::string::npos);
}

TEST(SimulatedPerson, ACourseMovesThem) {
  const virtual_patient::PatientTraits first = *traits("sim://moderate?day=0&course=recovery");
  const virtual_patient::PatientTraits later = *traits("sim://moderate?day=150&course=recovery");
  EXPECT_GT(later.maximum_force_N, 1.5 * first.maximum_force_N);
}

TEST(SimulatedPerson, ADeviceThatIsNotSimulatedHasNobodyInFront) {
  const auto person = simulated_person(*Uri::parse("can://can0?protocol=rft"), kLibrary);
  ASSERT_TRUE(person);
  EXPECT_EQ(*person, nullptr);
}

TEST(SimulatedPerson, ErrorsNameThoseThatExist) {
  EXPECT_EQ(error("sim://nobody", ""),
            "sim://nobody: there is no simulated patient 'nobody'; use one of: healthy, paretic");
  const std::string people = error("sim://nobody");
  EXPECT_NE(people.find("inattention, mild, moderate"), std::string::npos) << people;
  const std::string courses = error("sim://mild?day=1&course=miracle");
  EXPECT_NE(courses.find("there is no course 'miracle'; use one of: botulinum, decline"),
            std::string::npos)
      << courses;
  EXPECT_NE(error("sim://mild?course=recovery").find("a course needs a day"), std::string::npos);
  EXPECT_NE(error("sim://mild?day=1.5").find("is not a whole number"), std::string::npos);
  EXPECT_NE(error("sim://mild?day=-1").find("day"), std::string::npos);
  EXPECT_NE(error("sim://mild?recovery=2").find("recovery"), std::string::npos);
}

TEST(SimulatedPerson, ANameIsNotAPath) {
  for (const char* name : {"../tasks/grip_sine", "courses/recovery", "mild.toml", "/etc/passwd"})
    EXPECT_NE(error("sim://" + std::string(name)).find("there is no simulated patient"),
              std::string::npos)
        << name;
}

}  // namespace
}  // namespace isograsp::session::simulated_person_test
