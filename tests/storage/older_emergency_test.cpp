// SPDX-License-Identifier: GPL-3.0-or-later
// An emergency file that a program left before sealed texts were bound to their rows: its notes are
// read once it is taken in.
#include <filesystem>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/sealed_text.hpp"
#include "storage/care/emergency.hpp"
#include "storage/care/migration.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::storage::older_emergency_test {
namespace {

constexpr int kOlder = kBoundToRowFormat - 1;
const std::string kCorrection = "Rating corrected: effort 3 instead of 5";

struct OlderEmergency : ProtectedClinic {
  test::Variable state{"XDG_STATE_HOME", folder.file("state")};
  SessionRecord session;
  TrialRecord trial;

  OlderEmergency() {
    as("Theo");
    const auto store = opened(path);
    const PatientRecord patient = must(store->add_patient("P-1"));
    session = example_session(patient.id);
    session.uuid = "7c1e3c52-0d1f-4c3a-9d5e-3a5b7f9c1d20";
    trial = example_trial(0);
    trial.uuid = "7c1e3c52-0d1f-4c3a-9d5e-3a5b7f9c1d21";
  }
  /// As a program of that format sealed it.
  [[nodiscard]] std::string sealed(const std::string& text, const EventPlace& place,
                                   const EventRecord& event) const {
    const LoginState& state_of_login = *access->parts().login;
    return seal(state_of_login.login().keys->text,
                bound_to(state_of_login,
                         {sealed_column::kEventText, "P-1", row_words(place, event)}, kOlder),
                text);
  }
  /// A session of which the clinic's file knows nothing, with a note of its own, one of its trial,
  /// and a correction as programs of before wrote it.
  void make_file() {
    const auto made = must(make_emergency_file(
        {"", path, access->parts().login->database_id(), "was taken away", "", "", 0}));
    {
      const auto store = opened(made.path, OpenMode::existing);
      const auto known = must(opened(path, OpenMode::read_only)->find_patient("P-1"));
      session.patient_id = must(store->add_patient("P-1", known->created_utc, known->uuid)).id;
      trial.session_id = must(store->begin_session(session));
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
      TrialRecord ended = trial;
      ended.status = TrialStatus::completed;
      must(store->end_trial(ended, {}));
      const EventRecord of_session{{}, 1.0, std::string(kSealedEvent), ""};
      const EventRecord of_trial{trial.id, 2.0, std::string(kSealedEvent), ""};
      for (auto [event, trial_uuid, text] :
           {std::tuple{of_session, std::string(), "tired"}, {of_trial, trial.uuid, "slipped"}}) {
        event.text = sealed(text, {"P-1", session.uuid, trial_uuid}, event);
        must(store->add_event(trial.session_id, event));
      }
      must(store->add_event(trial.session_id, {{}, 3.0, std::string(kSealedEvent), kCorrection}));
      must(store->end_session(trial.session_id, "2026-03-01T10:00:00Z"));
    }
    soci::session sql(soci::sqlite3, "db=\"" + made.path + "\"");
    sql << "PRAGMA user_version=" + std::to_string(kOlder);
  }
  [[nodiscard]] EmergencyFile the_file() const { return emergency_files(path).at(0); }
  /// Kind and text.
  [[nodiscard]] std::vector<std::string> notes() const {
    const auto store = opened(path, OpenMode::read_only);
    std::vector<std::string> all;
    for (const EventRecord& event : must(store->events(must(store->recent_sessions(1)).at(0).id)))
      all.push_back(event.kind + ": " + event.text);
    return all;
  }
};

TEST_F(OlderEmergency, ItsNotesAreBoundToTheirRowsWhenItIsTakenIn) {
  const std::vector<std::string> wanted{"note: tired", "note: slipped",
                                        std::string(kCorrectionEvent) + ": " + kCorrection};
  for (int time = 0; time < 2; ++time) {  // a note that is there already is not added again
    make_file();
    EXPECT_FALSE(rescue(path, the_file()).ok()) << "it has to be migrated first";
    static_cast<void>(must(migrate_database(the_file().path)));
    const auto report = must(rescue(path, the_file()));
    for (const Text& conflict : report.conflicts) ADD_FAILURE() << english(conflict);
    EXPECT_EQ(notes(), wanted) << time;
    EXPECT_TRUE(must(opened(path, OpenMode::existing)->check()).empty()) << time;
    EXPECT_TRUE(emergency_files(path).empty());
  }
}

/// A file that says of itself that it was made by this program has no such notes.
TEST_F(OlderEmergency, TextsOfBeforeAreNotTakenFromAFileOfThisFormat) {
  make_file();
  {
    soci::session sql(soci::sqlite3, "db=\"" + the_file().path + "\"");
    sql << "PRAGMA user_version=" + std::to_string(kDatabaseFormat);
  }
  must(rescue(path, the_file()));
  const auto store = opened(path, OpenMode::read_only);
  EXPECT_NE(refusal(store->events(must(store->recent_sessions(1)).at(0).id)).find("events.text"),
            std::string::npos);
}

}  // namespace
}  // namespace isograsp::storage::older_emergency_test
