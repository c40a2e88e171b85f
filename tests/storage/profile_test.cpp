// SPDX-License-Identifier: GPL-3.0-or-later
// What the clinic knows of a person: kept as it was told, refused where it makes no sense.
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "tests/storage/one_patient.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::profile_test {
namespace {

struct Profile : OnePatient {};

TEST_F(Profile, OfAPersonOfWhomNothingWasToldIsEmpty) {
  EXPECT_EQ(must(store->profile(patient)), PatientProfile{});
  EXPECT_TRUE(must(store->treatment_marks(patient)).empty());
  EXPECT_TRUE(must(store->clinical_scores(patient)).empty());
}

TEST_F(Profile, EveryCombinationComesBackAndReplacesTheOneBefore) {
  const RowId other = must(store->add_patient("P-0428")).id;
  for (const auto affected :
       {std::optional<Side>(), std::optional(Side::right), std::optional(Side::left),
        std::optional(Side::both), std::optional(Side::none)})
    for (const auto dominant :
         {std::optional<Hand>(), std::optional(Hand::right), std::optional(Hand::left)}) {
      const PatientProfile written{affected, dominant, "2025-12-31",
                                   "'quoted' \"so\" \xC5\xBE\nline two", "; DROP TABLE x"};
      must(store->set_profile(patient, written));
      reopen();
      EXPECT_EQ(must(store->profile(patient)), written);
      EXPECT_EQ(must(store->profile(other)), PatientProfile{}) << "of another person";
    }
  must(store->set_profile(patient, {}));
  EXPECT_EQ(must(store->profile(patient)), PatientProfile{}) << "it can be taken back";
}

TEST_F(Profile, AnOnsetThatIsNoDayIsRefusedByNameAndLosesNothing) {
  const PatientProfile good{Side::left, Hand::right, "2024-02-29", "n", "g"};
  must(store->set_profile(patient, good));
  for (const char* wrong : {"2025-02-29", "31.12.2025", "2025-12", "0202-05-01", "yesterday"}) {
    PatientProfile bad = good;
    bad.onset_date = wrong;
    const auto refused = store->set_profile(patient, bad);
    ASSERT_FALSE(refused.ok()) << wrong;
    EXPECT_EQ(refused.error().field, "onset_date");
    EXPECT_NE(english(refused.error().what).find(wrong), std::string::npos);
    EXPECT_NE(english(refused.error().remedy).find("2026-03-05"), std::string::npos)
        << "an example";
  }
  EXPECT_EQ(must(store->profile(patient)), good);
}

TEST_F(Profile, TreatmentMarksComeBackByDateAndCanBeRemoved) {
  const RowId later =
      must(store->add_treatment_mark(patient, {0, "2026-03-05", "botulinum_toxin", "100 U"}));
  const RowId earlier = must(store->add_treatment_mark(patient, {0, "2026-01-05", "drug", ""}));
  reopen();
  const std::vector<TreatmentMark> both{{earlier, "2026-01-05", "drug", ""},
                                        {later, "2026-03-05", "botulinum_toxin", "100 U"}};
  EXPECT_EQ(must(store->treatment_marks(patient)), both);
  must(store->remove_treatment_mark(earlier));
  EXPECT_FALSE(store->remove_treatment_mark(earlier).ok()) << "it is gone";
  EXPECT_EQ(must(store->treatment_marks(patient)), std::vector{both[1]});
}

TEST_F(Profile, APersonOfWhomAnythingIsKnownIsNotTakenBack) {
  const RowId other = must(store->add_patient("P-77")).id;
  PatientProfile profile;
  profile.onset_date = "2026-01-05";
  must(store->set_profile(other, profile));
  EXPECT_FALSE(store->remove_patient(other).ok());
  const RowId marked = must(store->add_patient("P-78")).id;
  const RowId mark = must(store->add_treatment_mark(marked, {0, "2026-01-05", "drug", ""}));
  EXPECT_FALSE(store->remove_patient(marked).ok());
  must(store->remove_treatment_mark(mark));
  must(store->remove_patient(marked));
  EXPECT_FALSE(must(store->find_patient("P-78")).has_value());
}

TEST_F(Profile, EveryKindOfTreatmentIsTakenAndNoOther) {
  for (const auto kind : kTreatmentKinds)
    must(store->add_treatment_mark(patient, {0, "2026-03-05", std::string(kind), ""}));
  const auto refused = store->add_treatment_mark(patient, {0, "2026-03-05", "botox", ""});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().field, "kind");
  EXPECT_NE(english(refused.error().remedy).find("botulinum_toxin, drug"), std::string::npos);
  const auto undated = store->add_treatment_mark(patient, {0, "", "drug", ""});
  ASSERT_FALSE(undated.ok());
  EXPECT_EQ(undated.error().field, "on_date");
  EXPECT_EQ(must(store->treatment_marks(patient)).size(), kTreatmentKinds.size());
}

TEST_F(Profile, ClinicalScoresComeBackToTheBitByDate) {
  const RowId later =
      must(store->add_clinical_score(patient, {0, "2026-03-05", "MAS", 1.5, "FDS"}));
  const RowId earlier =
      must(store->add_clinical_score(patient, {0, "2026-01-05", "MAL", 0.1 + 0.2, ""}));
  reopen();
  const std::vector<ClinicalScore> both{{earlier, "2026-01-05", "MAL", 0.1 + 0.2, ""},
                                        {later, "2026-03-05", "MAS", 1.5, "FDS"}};
  EXPECT_EQ(must(store->clinical_scores(patient)), both);
  must(store->remove_clinical_score(later));
  EXPECT_FALSE(store->remove_clinical_score(later).ok()) << "it is gone";
  EXPECT_EQ(must(store->clinical_scores(patient)), std::vector{both[0]});
}

TEST_F(Profile, ScoresAreTakenUpToTheLimitsOfTheirScaleAndNotBeyond) {
  struct Case {
    const char* scale;
    std::vector<double> good;
    std::vector<double> bad;
  };
  for (const auto& [scale, good, bad] :
       {Case{"ARAT", {0, 57}, {-1, 58}}, Case{"FMA-UE", {0, 66}, {-0.5, 66.5}},
        Case{"BBT", {0, 150}, {-1}}, Case{"NHPT", {0.1, 300}, {0, -3}},
        Case{"MAL", {0, 2.5, 5}, {-0.1, 5.1}}, Case{"MAS", {0, 1.5, 4}, {-1, 5}},
        Case{"sensation", {-2, 0, 6.65}, {}}}) {
    for (const double value : test::every(good))
      EXPECT_TRUE(store->add_clinical_score(patient, {0, "2026-03-05", scale, value, ""}).ok())
          << scale << value;
    for (const double value : bad) {
      const auto refused = store->add_clinical_score(patient, {0, "2026-03-05", scale, value, ""});
      ASSERT_FALSE(refused.ok()) << scale << value;
      EXPECT_EQ(refused.error().field, "value");
    }
    EXPECT_FALSE(
        store->add_clinical_score(patient, {0, "2026-03-05", scale, std::nan(""), ""}).ok());
  }
  const auto arat = store->add_clinical_score(patient, {0, "2026-03-05", "ARAT", 58, ""});
  EXPECT_EQ(arat.error().message(), "value: 58 is no score of the ARAT; give 0 to 57");
  const auto pegs = store->add_clinical_score(patient, {0, "2026-03-05", "NHPT", 0, ""});
  EXPECT_EQ(english(pegs.error().remedy), "give more than 0 s");
  const auto unknown = store->add_clinical_score(patient, {0, "2026-03-05", "arat", 5, ""});
  EXPECT_EQ(unknown.error().field, "scale");
}

TEST_F(Profile, OfAPersonWhoDoesNotExistIsRefused) {
  const RowId nobody = patient + 1;
  EXPECT_FALSE(store->set_profile(nobody, {}).ok());
  EXPECT_FALSE(store->add_treatment_mark(nobody, {0, "2026-03-05", "drug", ""}).ok());
  EXPECT_FALSE(store->add_clinical_score(nobody, {0, "2026-03-05", "ARAT", 5, ""}).ok());
}

TEST_F(Profile, WhatAnotherProgramWroteWronglyIsRefusedByTheTablesOrFoundByTheCheck) {
  must(store->set_profile(patient, {}));
  must(store->add_clinical_score(patient, {0, "2026-03-05", "ARAT", 57, ""}));
  EXPECT_TRUE(must(store->check()).empty());
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  for (const char* wrong :
       {"UPDATE patient_profiles SET onset_date = '2026-02-30'",
        "UPDATE patient_profiles SET onset_date = '2026-1-1'",
        "UPDATE patient_profiles SET affected = 'middle'",
        "UPDATE clinical_scores SET on_date = ''", "UPDATE clinical_scores SET value = NULL"})
    EXPECT_THROW(sql << wrong, soci::soci_error) << wrong;
  sql << "UPDATE clinical_scores SET value = 58";
  const auto problems = must(store->check());
  ASSERT_EQ(problems.size(), 2u) << "the second: that the row is not what was written";
  EXPECT_NE(english(problems[0]).find("P-0427"), std::string::npos) << english(problems[0]);
  EXPECT_NE(english(problems[0]).find("58"), std::string::npos) << english(problems[0]);
}

}  // namespace
}  // namespace isograsp::storage::profile_test
