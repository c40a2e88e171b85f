// SPDX-License-Identifier: GPL-3.0-or-later
// SQL in every text that a user can give: stored and read back as text, and nothing else happens.
#include <algorithm>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::injection_test {
namespace {

const std::vector<std::string> kInjections{
    "'; DROP TABLE patients; --",
    "' OR '1'='1",
    "\"; DELETE FROM audit_log; --",
    "x'); INSERT INTO patients (code, created_utc) VALUES ('P-9', 'now'); --",
    ":id, :code, ?1, $1, @x",
    "%s%n{}\\",
    "'||(SELECT hex(wrapped) FROM key_slots)||'"};

int tables_in(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  int count = 0;
  sql << "SELECT count(*) FROM sqlite_schema", soci::into(count);
  return count;
}

TEST_F(ProtectedClinic, SqlInAnyTextStaysText) {
  const int tables = tables_in(path);
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  for (const std::string& text : kInjections) {
    must(store->set_profile(patient, {{}, {}, "", text, text}));
    EXPECT_EQ(must(store->profile(patient)).notes, text);
    must(store->add_treatment_mark(patient, {0, "2026-03-01", "drug", text}));
    EXPECT_EQ(must(store->treatment_marks(patient)).back().text, text);
    must(store->add_clinical_score(patient, {0, "2026-03-01", "ARAT", 31.0, text}));
    EXPECT_EQ(must(store->clinical_scores(patient)).back().text, text);
    const RowId primary =
        must(store->add_primary_measure(patient, {0, text, Hand::left, text, text, text, text}));
    EXPECT_EQ(must(store->primary_measures(patient)).at(0).task_name, text);
    must(store->remove_primary_measure(primary));
    const RowId period =
        must(store->add_stable_period(patient, {0, "2026-01-01", "2026-01-31", text, text, text}));
    EXPECT_EQ(must(store->stable_periods(patient)).at(0).judged_by, text);
    must(store->remove_stable_period(period));
    SessionRecord session = example_session(patient);
    for (std::string* field :
         {&session.device_uri, &session.device_description, &session.provenance,
          &session.protocol_name, &session.protocol_text, &session.software_version,
          &session.cpu_features, &session.operator_name, &session.realtime, &session.started_utc})
      *field = text;
    session.sensors = {{text, text}, {text, text}};
    session.references = {{text, 1.0}};
    const RowId session_id =
        must(store->begin_session(session, std::vector<SessionAnswer>{{text, text, text}}));
    EXPECT_EQ(must(store->answers(session_id)).at(0).value, text);
    const auto sessions = must(store->sessions(patient));
    const auto begun = std::find_if(sessions.begin(), sessions.end(),
                                    [&](const auto& one) { return one.id == session_id; });
    ASSERT_NE(begun, sessions.end());
    EXPECT_EQ(begun->operator_name, text);
    must(store->last_preparation(session, text));
    PreparationRecord preparation = example_preparation(session_id);
    preparation.kind = preparation.operator_name = preparation.recorded_utc = text;
    preparation.references = {{text, 1.0}};
    must(store->add_preparation(preparation));
    EXPECT_EQ(must(store->preparations(session_id)).at(0).kind, text);
    TrialRecord trial = example_trial(session_id);
    trial.task_name = trial.task_text = trial.scene_text = text;
    trial.groups = {{text, {text}}};
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, std::vector<std::vector<double>>{{1.0, 2.0}}));
    trial.health_json = trial.timing_json = text;
    trial.status = TrialStatus::completed;
    Measure measure;
    measure.name = measure.channel = measure.unit = measure.reason = text;
    must(store->end_trial(trial, std::vector<Measure>{measure}));
    EXPECT_EQ(must(store->trials(session_id)).at(0).task_text, text);
    EXPECT_EQ(must(store->measures(trial.id)).at(0).reason, text);
    must(store->add_event(session_id, {trial.id, 0.0, text, text}));
    must(store->add_event(session_id, {trial.id, 0.0, "note", text}));
    EXPECT_EQ(must(store->events(session_id)).back().text, text);
    PoolQuery query;
    query.scene_text = text;
    query.task_name = query.task_text = query.measure = text;
    query.channel = query.unit = text;
    must(store->stable_values(query));
    must(store->end_session(session_id, text));
    const Identity identity{text, "", text};
    must(set_identity(*access, "P-1", identity));
    EXPECT_EQ(must(read_identity(*access, "P-1")), identity);
    must(add_consent(*access, "P-1",
                     {0, "2026-03-05", "research", "consent", "given", text, "", ""}));
    EXPECT_EQ(must(consents(*access, "P-1")).back().text, text);
    const std::string name = text.substr(0, 60);
    must(add_user(*access, name, Role::researcher, secret("long enough"), kCheapKeyCost));
    EXPECT_FALSE(access->log_in(name, secret("another one")).ok());
    must(remove_user(*access, name));
    must(log_act(*access, text, text, true, text));
    EXPECT_EQ(must(read_audit(*access, {text, text})).size(), 1u);
    EXPECT_FALSE(must(audit_contains(*access, {1, text})));
  }
  EXPECT_EQ(must(store->patients()).size(), 1u);
  EXPECT_EQ(tables_in(path), tables);
  const auto problems = must(check_audit(*access));
  EXPECT_TRUE(problems.empty()) << english(problems.at(0));
}

TEST_F(ProtectedClinic, WhatIsNoCodeIsRefusedBeforeItReachesTheDatabase) {
  const auto store = opened(path);
  std::vector<std::string> bad = kInjections;
  bad.insert(bad.end(), {"../../etc/passwd1", "a/b1", "..", "P-1/..", "P-1\n",
                         std::string("P-1\0x", 5), "/tmp/1", "-", "", "P_1", "P 1", "Ä-1",
                         std::string(33, '1'), std::string(10'000'000, 'P')});
  const auto before = must(audit_head(*access)).count;
  for (const std::string& code : test::every(bad)) {
    const auto refused = store->add_patient(code);
    ASSERT_FALSE(refused.ok()) << code.substr(0, 40);
    EXPECT_EQ(refused.error().field, "patient code");
    EXPECT_LT(refused.error().message().size(), 300u);
    EXPECT_FALSE(set_identity(*access, code, {"Vera", "", ""}).ok());
    EXPECT_FALSE(read_identity(*access, code).ok());
    EXPECT_FALSE(must(store->find_patient(code)).has_value());
  }
  EXPECT_EQ(must(audit_head(*access)).count, before) << "a name typed as a code is in the log";
}

TEST_F(ProtectedClinic, OversizedOrBinaryIdentitiesAreRefused) {
  must(opened(path)->add_patient("P-1"));
  const std::string huge(kMostIdentityText + 1, 'x');
  for (const Identity& bad :
       {Identity{"", "", ""}, Identity{huge, "", ""}, Identity{"Vera", "", huge},
        Identity{std::string("Ve\0ra", 5), "", ""}, Identity{"Ve\nra", "", ""},
        Identity{"Vera", "1950-02-30", ""}, Identity{"Vera", "", "\x1b[2J"}}) {
    const auto refused = set_identity(*access, "P-1", bad);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message().find("Vera"), std::string::npos) << "tells the name";
  }
}

}  // namespace
}  // namespace isograsp::storage::injection_test
