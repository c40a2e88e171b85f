// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/audit_log.hpp"

#include <algorithm>

#include <soci/soci.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/audit_check.hpp"
#include "storage/access/audit_head_file.hpp"
#include "storage/file/schema_access.hpp"
#include "storage/records/patient_code.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::storage {

namespace {

/// `chains`: of the seals that the entries hold, one an entry.
std::vector<AuditEntry> read_entries(soci::session& sql, bool with_seals,
                                     std::vector<std::string>* chains = nullptr) {
  std::vector<AuditEntry> all;
  AuditEntry one;
  std::string chain;
  const std::string query =
      std::string("SELECT a.id, at_utc, actor, role, act, object, result, detail, a.hash, ") +
      (with_seals ? "seals, coalesce(lower(hex(s.chain)), '') FROM audit_log a "
                    "LEFT JOIN row_seals s ON s.id = a.seals"
                  : "0, '' FROM audit_log a") +
      " ORDER BY a.id";
  soci::statement select =
      (sql.prepare << query, soci::into(one.number), soci::into(one.at_utc), soci::into(one.actor),
       soci::into(one.role), soci::into(one.act), soci::into(one.object), soci::into(one.result),
       soci::into(one.detail), soci::into(one.hash), soci::into(one.seals), soci::into(chain));
  select.execute();
  while (select.fetch()) {
    all.push_back(one);
    if (chains != nullptr) chains->push_back(chain);
  }
  return all;
}

/// A database that was protected later: what stands before that act is chained without a key. Its
/// entry is chained to it with the key, so nobody else can change what stands there.
std::size_t first_keyed(const std::vector<AuditEntry>& entries) {
  const auto protection = std::find_if(entries.begin(), entries.end(), [](const AuditEntry& one) {
    return one.act == kProtectAct && one.result == "done";
  });
  return protection == entries.end() ? 0 : static_cast<std::size_t>(protection - entries.begin());
}

}  // namespace

Result<std::vector<Text>> audit_problems(Database& database, const LoginState& state) {
  const Login login = state.login();
  const Secret* const key = audit_key(login);
  // First: a log that grows meanwhile is longer than this file says, never shorter.
  const HeadFile file = read_head_file(database.real_path(), key, state.database_id());
  std::vector<AuditEntry> entries;
  std::vector<std::string> chains;
  AuditHead anchor;
  std::string proof;
  bool anchored = false;
  int others = 0;
  const auto read = database.snapshot("checking the audit log"_text, [&] {
    entries = read_entries(database.sql(), database.format() >= schema::kSealFormat, &chains);
    long long count = 0;
    database.sql() << "SELECT count(*) FROM audit_anchor WHERE id <> 1", soci::into(others);
    database.sql() << "SELECT count, hash, proof FROM audit_anchor WHERE id = 1", soci::into(count),
        soci::into(anchor.hash), soci::into(proof);
    anchored = database.sql().got_data();
    anchor.count = count;
  });
  if (!read) return read.error();
  std::vector<Text> problems;
  const std::size_t keyed = first_keyed(entries);
  std::string before = first_hash(keyed > 0 ? nullptr : key, state.database_id());
  std::int64_t expected = 1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const AuditEntry& entry = entries[i];
    const Secret* const key_then = i < keyed ? nullptr : key;
    if (entry.number != expected)
      problems.push_back(
          "audit log: entries %1 to %2 are missing"_text(expected, entry.number - 1));
    else if (entry_hash(key_then, before, entry, chains[i]) != entry.hash)
      problems.push_back(
          "audit log: entry %1 or what stood before it was changed"_text(entry.number));
    before = entry.hash;
    expected = entry.number + 1;
  }
  const std::int64_t last = entries.empty() ? 0 : entries.back().number;
  if (!anchored && !entries.empty()) problems.push_back("audit log: its anchor is missing"_text);
  if (others > 0) problems.push_back("audit log: its anchor is there more than once"_text);
  if (anchored && proof != head_proof(key, state.database_id(), anchor))
    problems.push_back("audit log: its anchor was changed"_text);
  else if (anchored && (anchor.count != last || anchor.hash != before))
    problems.push_back(
        "audit log: it ends with entry %1, its anchor says %2"_text(last, anchor.count));
  if (!state.is_protected()) return problems;
  if (!anchored) problems.push_back("audit log: it is empty, though the database was made"_text);
  if (file.present && !file.head)
    problems.push_back("audit log: the file -audit beside the database was changed"_text);
  if (file.head) {
    const auto at = static_cast<std::size_t>(file.head->count);
    if (file.head->count > last)
      problems.push_back(
          "audit log: it ends with entry %1, the file -audit beside it says %2: the database was put back or cut"_text(
              last, file.head->count));
    else if (at == 0 || at > entries.size() || entries[at - 1].hash != file.head->hash)
      problems.push_back(
          "audit log: entry %1 is not the one that the file -audit beside it tells of"_text(
              file.head->count));
  }
  return problems;
}

Result<std::vector<AuditEntry>> read_audit(Access& access, const AuditFilter& filter) {
  if (access.is_protected())
    if (const auto allowed = access.require(Right::manage, "read audit log", ""); !allowed)
      return allowed.error();
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  std::vector<AuditEntry> all;
  const auto done = parts.database.guard("reading the audit log"_text, [&] {
    for (AuditEntry& entry : read_entries(parts.database.sql(), true))
      if ((filter.act.empty() || entry.act == filter.act) &&
          (filter.object.empty() || entry.object == filter.object))
        all.push_back(std::move(entry));
  });
  if (!done) return done.error();
  return all;
}

Result<AuditHead> audit_head(Access& access) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  AuditHead head;
  const auto done = parts.database.guard("reading the audit log"_text, [&] {
    long long count = 0;
    parts.database.sql() << "SELECT count, hash FROM audit_anchor", soci::into(count),
        soci::into(head.hash);
    head.count = count;
  });
  if (!done) return done.error();
  return head;
}

Result<void> log_act(Access& access, const std::string& act, const std::string& object, bool done,
                     const std::string& detail) {
  AuditEntry entry = entry_of(act, object, detail);
  if (!done) entry.result = "failed";
  return log_entry(access, entry);
}

Result<void> log_act_of(const std::string& database, Access* access, const std::string& act,
                        const std::string& object, bool done, const std::string& detail) {
  std::unique_ptr<Access> open;
  if (access == nullptr) {
    auto opened = Access::open(database);
    if (!opened) return {};
    open = *std::move(opened);
    access = open.get();
  }
  if (!access->can_log()) return {};
  return log_act(*access, act, check_patient_code(object) ? object : "", done, detail);
}

Result<std::vector<Text>> check_audit(Access& access) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  if (access.is_protected() && !parts.login->login().keys)
    return refusal_of(*parts.login, Right::read_records, access.path());
  return audit_problems(parts.database, *parts.login);
}

Result<bool> audit_contains(Access& access, const AuditHead& head) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  bool same = false;
  const auto done = parts.database.guard("reading the audit log"_text, [&] {
    std::string hash;
    parts.database.sql() << "SELECT hash FROM audit_log WHERE id = :id", soci::use(head.count),
        soci::into(hash);
    same = parts.database.sql().got_data() && hash == head.hash;
  });
  if (!done) return done.error();
  return same;
}

}  // namespace isograsp::storage
