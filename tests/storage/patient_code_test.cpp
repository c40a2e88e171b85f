// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/records/patient_code.hpp"

#include "tests/storage/examples.hpp"

namespace isograsp::storage::patient_code_test {
namespace {

TEST(PatientCode, GeneratedCodesAreAccepted) {
  for (const char* code : {"P-0427", "A1", "7", "K7-QX-93", "0427", "P-2026-77-3", "S123456789"})
    EXPECT_EQ(check_patient_code(code).ok(), std::string(code) != "7") << code;
  EXPECT_TRUE(check_patient_code(std::string(31, 'A') + "1").ok());
}

TEST(PatientCode, NamesInitialsAndDatesAreRefused) {
  for (const char* code : {"Anna", "JK", "1980-05-12", "12-5-1980", "12-05-80", "19800512",
                           "AB-12051980", "JK120580", "JK800512x"})
    EXPECT_FALSE(check_patient_code(code).ok()) << code;
}

TEST(PatientCode, OtherCharactersAndLengthsAreRefused) {
  for (const char* code : {"", "1", "P 1", "P_1", "P1'; DROP TABLE patients;--", "../P1", "P1\n",
                           "\xC5\xBD"
                           "1"})
    EXPECT_FALSE(check_patient_code(code).ok()) << code;
  EXPECT_FALSE(check_patient_code(std::string(32, 'A') + "1").ok());
}

TEST(PatientCode, RefusalNamesTheFieldAndTheRemedy) {
  const auto message = check_patient_code("Anna").error().message();
  EXPECT_NE(message.find("patient code: 'Anna' has no digit"), std::string::npos) << message;
  EXPECT_NE(message.find("P-0427"), std::string::npos) << message;
}

}  // namespace
}  // namespace isograsp::storage::patient_code_test
