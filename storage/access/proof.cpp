// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/proof.hpp"

#include <algorithm>
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

Result<AccountProof> prove_accounts(Database& database, const Secret& key) {
  AccountProof proof;
  if (database.format() < schema::kSealFormat) return proof;
  const auto in_sum = are_as_sealed_in_sum(database, &key);
  if (!in_sum) return in_sum.error();
  if (*in_sum) return proof;
  std::vector<std::string_view> tables(kTablesOfAccounts.begin(), kTablesOfAccounts.end());
  tables.insert(tables.end(), kTablesOfTexts.begin(), kTablesOfTexts.end());
  const auto problems = seal_problems(database, &key, tables, &proof.to_keep);
  if (!problems) return problems.error();
  for (const SealProblem& one : *problems) {
    if (std::ranges::find(kTablesOfTexts, one.table) == kTablesOfTexts.end())
      return failed("accounts or seals were changed by another program: %1"_text(one.what),
                    "put back the last backup: isograsp db restore"_text)
          .at(database.path());
    proof.of_texts.push_back(one.what);
  }
  return proof;
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
