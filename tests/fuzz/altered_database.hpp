// SPDX-License-Identifier: GPL-3.0-or-later
// A sound database that another program alters, for the targets that do it: what it says
// afterwards is what it said before, or the program names what was done, or refuses the file.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/fuzz/support.hpp"
#include "tests/support/database_content.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::fuzz {

class AlteredDatabase {
 public:
  AlteredDatabase() {
    using test::must;
    {
      const auto store = must(storage::open_store(path_, storage::OpenMode::create));
      const storage::RowId patient = must(store->add_patient("P-1")).id;
      must(store->set_profile(patient, {storage::Side::left, {}, "", "note", "goal"}));
      must(store->add_treatment_mark(patient, {0, "2026-01-20", "drug", "text"}));
      storage::SessionRecord session;
      session.patient_id = patient;
      session.rate_Hz = 20.0;
      session.sensors = {{"thumb", "A-1"}};
      session.id = must(store->begin_session(session));
      storage::TrialRecord trial;
      trial.session_id = session.id;
      trial.number = 1;
      trial.task_name = "fuzz";
      trial.groups = {{"force", {"t_s", "thumb_fz_N"}}};
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0,
                                std::vector<std::vector<double>>{{0.0, 1.0, 2.0, 3.0}}));
      trial.status = storage::TrialStatus::completed;
      must(store->end_trial(trial,
                            std::vector<Measure>{{"rmse", "force", 0.25, "N", 1, 100, 0, ""}}));
      must(store->add_event(session.id, {trial.id, 1.0, "note", "tired"}));
      must(store->end_session(session.id));
    }
    std::ifstream in(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    content_ = test::content_of_database(path_);
  }

  /// `alter` throws as SOCI does where SQLite refuses it: then nothing is asked.
  void prove(const std::function<void(soci::session&)>& alter) const {
    std::error_code ignored;
    for (const char* suffix : {"-wal", "-shm", "-journal"})
      std::filesystem::remove(path_ + suffix, ignored);
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes_;
    try {
      soci::session sql(soci::sqlite3, "db=\"" + path_ + "\"");
      sql << "PRAGMA foreign_keys=OFF";
      sql << "PRAGMA synchronous=OFF";
      sql << "PRAGMA ignore_check_constraints=ON";
      sql << "PRAGMA writable_schema=ON";
      alter(sql);
    } catch (const soci::soci_error&) {
      return;
    }
    const bool same = says_the_same();
    const auto store = storage::open_store(path_, storage::OpenMode::read_only);
    if (!store) {
      require(!store.error().what.empty() && !store.error().remedy.empty(),
              "an error says what and what to do");
      return;
    }
    const auto problems = (*store)->check();
    require(same || !problems || !problems->empty(), "what another program has altered is named");
    if (const auto patients = (*store)->patients())
      for (const storage::PatientRecord& patient : *patients) {
        static_cast<void>((*store)->progress(patient.id).ok());
        static_cast<void>((*store)->profile(patient.id).ok());
      }
  }

 private:
  [[nodiscard]] bool says_the_same() const {
    try {
      return test::content_of_database(path_) == content_;
    } catch (const soci::soci_error&) {
      return false;
    }
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("clinic.db");
  std::string bytes_;
  std::string content_;
};

}  // namespace isograsp::fuzz
