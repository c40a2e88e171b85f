// SPDX-License-Identifier: GPL-3.0-or-later
// A file with a session, and somebody who has an SQL program and no password.
#pragma once

#include <string>
#include <vector>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "tests/storage/protected_clinic.hpp"

namespace isograsp::storage {

using Problems = std::vector<std::string>;

/// One patient, one session, two packed trials.
inline void record(const std::string& path, const char* code = "P-1") {
  const auto store = opened(path);
  SessionRecord session = example_session(must(store->add_patient(code)).id);
  session.id = must(store->begin_session(session, {}));
  for (const int number : {1, 2}) {
    TrialRecord trial = example_trial(session.id, number);
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
    trial.status = TrialStatus::completed;
    must(
        store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.25, "N", 1, 100, 0, ""}}));
  }
  must(store->end_session(session.id));
}

inline void execute_on(const std::string& path, const std::vector<std::string>& statements) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  sql << "PRAGMA foreign_keys=OFF";
  for (const std::string& statement : statements) sql << statement;
}

/// Parameter: protected.
struct ClinicUnderAttack : testing::TestWithParam<bool> {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<Access> access;

  ClinicUnderAttack() {
    if (GetParam()) access = make_protected(path).access;
    record(path);
  }
  /// By somebody without a password, while nobody works.
  void attack(const std::vector<std::string>& statements) {
    access.reset();
    execute_on(path, statements);
    log_in();
  }
  void log_in() {
    if (!GetParam()) return;
    access = must(Access::open(path));
    must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  }
  /// As the program finds them that may write, whatever it has done when it opened the file.
  [[nodiscard]] Problems problems() const {
    Problems all;
    for (const Text& one : must(opened(path, OpenMode::existing)->check()))
      all.push_back(english(one));
    return all;
  }
};

}  // namespace isograsp::storage
