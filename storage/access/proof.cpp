// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/proof.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "storage/access/audit_chain.hpp"
#include "storage/access/audit_check.hpp"
#include "storage/file/schema_access.hpp"
#include "storage/file/schema_check.hpp"

namespace isograsp::storage {

Result<std::vector<Text>> changes_by_others(Database& database, const LoginState& state) {
  std::vector<Text> problems;
  if (database.format() < schema::kAccessFormat) return problems;
  auto of_log = audit_problems(database, state);
  if (!of_log || database.format() < schema::kSealFormat) return of_log;
  problems = *std::move(of_log);
  const Login login = state.login();
  const auto of_rows = seal_problems(database, audit_key(login));
  if (!of_rows) return of_rows.error();
  for (const SealProblem& one : *of_rows) problems.push_back(one.what);
  return problems;
}

Result<void> prove(Database& database, const LoginState& state) {
  std::vector<Text> problems;
  const auto read = database.guard(
      "checking"_text, [&] { problems = schema_problems(database.sql(), database.format()); });
  if (!read) return read;
  const auto changes = changes_by_others(database, state);
  if (!changes) return changes.error();
  problems.insert(problems.end(), changes->begin(), changes->end());
  if (problems.empty()) return {};
  return failed("was changed by another program: %1"_text(problems.front()),
                "run isograsp db check, then restore the last backup"_text)
      .at(database.path());
}

Result<std::vector<Text>> prove_accounts(Database& database, const Secret& key) {
  std::vector<Text> of_texts;
  if (database.format() < schema::kSealFormat) return of_texts;
  // Of events nothing older can be put back: they are neither changed nor removed.
  constexpr std::array<std::string_view, 7> kOfTexts{
      "clinical_scores",  "consents",       "identities",     "patient_profiles",
      "primary_measures", "stable_periods", "treatment_marks"};
  std::vector<std::string_view> tables{"key_slots", "users"};
  tables.insert(tables.end(), kOfTexts.begin(), kOfTexts.end());
  const auto problems = seal_problems(database, &key, tables);
  if (!problems) return problems.error();
  for (const SealProblem& one : *problems) {
    if (std::ranges::find(kOfTexts, one.table) == kOfTexts.end())
      return failed("accounts or seals were changed by another program: %1"_text(one.what),
                    "put back the last backup: isograsp db restore"_text)
          .at(database.path());
    of_texts.push_back(one.what);
  }
  return of_texts;
}

Result<void> prove_file(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  std::shared_ptr<LoginState> state;
  const auto read = database->guard("opening"_text, [&] { state = login_state_of(*database); });
  if (!read) return read;
  return prove(*database, *state);
}

}  // namespace isograsp::storage
