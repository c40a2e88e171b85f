// SPDX-License-Identifier: GPL-3.0-or-later
// People as files.
#include <sstream>

#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/people.hpp"

namespace isograsp::virtual_patient::file_test {
namespace {

using test::kPatients;
using test::names_in;
using test::shipped;

std::string healthy_text() {
  return *read_text(kPatients + "/healthy.toml");
}
std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(VirtualPatientFile, EveryShippedPersonIsRead) {
  const std::vector<std::string> names = names_in(kPatients);
  const std::vector<std::string> expected{
      "arm_push",     "direction_error", "fatiguing",    "healthy",   "inattention",
      "mild",         "moderate",        "opening_loss", "pain_stop", "paretic",
      "sensory_loss", "severe",          "slow_wander",  "spastic",   "submaximal"};
  EXPECT_EQ(names, expected);
  for (const std::string& name : test::every(names)) {
    const PatientTraits traits = shipped(name);
    EXPECT_EQ(traits, clamped(traits)) << name;
    EXPECT_LE(traits.resting_force_N, traits.maximum_force_N) << name;
  }
}

TEST(VirtualPatientFile, TheFilesOfHealthyAndPareticAreThePeopleOfTheProgram) {
  EXPECT_EQ(shipped("healthy"), *patient_traits("healthy"));
  EXPECT_EQ(shipped("paretic"), *patient_traits("paretic"));
}

TEST(VirtualPatientFile, EveryShippedNumberNamesItsSourceOrIsCalledAnAssumption) {
  for (const std::string& folder : {kPatients, kPatients + "/courses"})
    for (const std::string& name : test::every(names_in(folder))) {
      std::istringstream lines(*read_text(folder + "/" + name + ".toml"));
      test::AtLeast numbers(1);
      for (std::string line; std::getline(lines, line);) {
        const auto equals = line.find(" = ");
        if (equals == std::string::npos || line[equals + 3] == '"') continue;
        if (line.rfind("from_day = 0", 0) == 0 || line.rfind("time_days = 0", 0) == 0) continue;
        const auto comment = line.find('#');
        ASSERT_NE(comment, std::string::npos) << name << ": " << line;
        const std::string words = line.substr(comment);
        EXPECT_TRUE(words.find("assumption") != std::string::npos ||
                    words.find("source: ") != std::string::npos)
            << name << ": " << line;
        ++numbers;
      }
    }
}

TEST(VirtualPatientFile, EveryTraitMustBeSaid) {
  for (const TraitField& field : test::every(trait_fields())) {
    const std::string key = "\n" + std::string(field.key) + " = ";
    const auto patient = parse_patient(replaced(healthy_text(), key, "\n#"), "x.toml");
    ASSERT_FALSE(patient) << field.key;
    EXPECT_EQ(english(patient.error().what), "is missing");
    EXPECT_EQ(patient.error().field, std::string(field.table) + "." + std::string(field.key));
  }
}

TEST(VirtualPatientFile, ValuesOutsideTheirRangeAreRefused) {
  for (const TraitField& field : test::every(trait_fields()))
    for (const double value : {field.least - 0.01, field.most + 0.01}) {
      const std::string key = "\n" + std::string(field.key) + " = ";
      const auto patient = parse_patient(
          replaced(healthy_text(), key, key + std::to_string(value) + " #"), "x.toml");
      ASSERT_FALSE(patient) << field.key << " " << value;
      EXPECT_EQ(english(patient.error().what), "is out of range") << field.key;
    }
}

TEST(VirtualPatientFile, ErrorsNameLineFieldAndRemedy) {
  const std::string text = healthy_text();
  const auto error = [&](const std::string& what, const std::string& with) {
    const auto patient = parse_patient(replaced(text, what, with), "x.toml");
    EXPECT_FALSE(patient) << with;
    return patient ? std::string() : patient.error().message();
  };
  EXPECT_EQ(error("[memory]", "[memory]\ncleverness = 3"),
            "x.toml:18: memory.cleverness: unknown key; remove it or correct its spelling");
  EXPECT_EQ(error("direction_error_deg = [0, 0, 0]", "direction_error_deg = [0, 0, 91]"),
            "x.toml:36: direction.direction_error_deg: is out of range; "
            "write a value from 0 to 90");
  EXPECT_EQ(error("arm_push = [0, 0, 0]", "arm_push = [0, 0]"),
            "x.toml:37: direction.arm_push: is 2 values, not an array of 3 numbers; "
            "write 3 numbers in brackets");
  EXPECT_NE(error("isograsp-patient-1", "isograsp-patient-2").find("is not the expected format"),
            std::string::npos);
}

TEST(VirtualPatientFile, DegreesInTheFileAreRadiansInThePerson) {
  const PatientTraits traits = shipped("direction_error");
  EXPECT_WITHIN(traits.direction_error_rad[2], std::numbers::pi / 6.0, 1e-15);
}

TEST(Traits, ARecoveryOfOneIsHealthyAndOfZeroIsNobodyElse) {
  const PatientTraits healthy = *patient_traits("healthy");
  for (const std::string& name : test::every(names_in(kPatients))) {
    const PatientTraits traits = shipped(name);
    EXPECT_EQ(recovered(traits, 0.0), traits) << name;
    for (const TraitField& field : test::every(trait_fields()))
      EXPECT_WITHIN(recovered(traits, 1.0).*field.value, healthy.*field.value, 1e-12)
          << name << " " << field.key;
  }
}

}  // namespace
}  // namespace isograsp::virtual_patient::file_test
