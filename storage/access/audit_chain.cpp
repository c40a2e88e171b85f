// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/audit_chain.hpp"

#include <algorithm>
#include <cstdio>

#include <soci/soci.h>

#include "core/files.hpp"
#include "storage/access/audit_head_file.hpp"

namespace isograsp::storage {

const Secret* audit_key(const Login& login) {
  return login.keys ? &login.keys->audit : nullptr;
}

std::string first_hash(const Secret* key, const std::string& database_id) {
  return Digest(key).add("IsoGrasp audit log 1").add(database_id).hex();
}

std::string entry_hash(const Secret* key, const std::string& before, const AuditEntry& entry,
                       const std::string& seal_chain) {
  Digest whole(key);
  whole.add(before)
      .add(entry.number)
      .add(entry.at_utc)
      .add(entry.actor)
      .add(entry.role)
      .add(entry.act)
      .add(entry.object)
      .add(entry.result)
      .add(entry.detail);
  if (entry.seals > 0) whole.add(entry.seals).add(seal_chain);  // none: older formats
  return whole.hex();
}

std::string head_proof(const Secret* key, const std::string& database_id, const AuditHead& head) {
  return Digest(key)
      .add("IsoGrasp audit head 1")
      .add(database_id)
      .add(head.count)
      .add(head.hash)
      .hex();
}

namespace {

/// Whose end was cut, the log goes on with an anchor that does not prove: `db check` says so from
/// then on. `proof`: of the anchor that is there.
bool is_proved(const LoginState& state, const AuditHead& head, const std::string& proof,
               const std::string& act) {
  const Login login = state.login();
  const std::string& id = state.database_id();
  return proof == head_proof(audit_key(login), id, head) ||
         (act == kProtectAct && proof == head_proof(nullptr, id, head));
}

/// Protected databases have a log before anything else.
bool may_be_without_log(soci::session& sql, const LoginState& state) {
  int rows = 0;
  sql << "SELECT EXISTS (SELECT 1 FROM patients) OR EXISTS (SELECT 1 FROM users)", soci::into(rows);
  return rows == 0 || !state.is_protected();
}

}  // namespace

AuditHead append_audit(Database& database, const LoginState& state, AuditEntry entry) {
  soci::session& sql = database.sql();
  const Login login = state.login();
  const Secret* const key = audit_key(login);
  if (state.is_protected() && key == nullptr)
    throw Refusal{refusal_of(state, Right::read_records, "")};
  if (entry.at_utc.empty()) entry.at_utc = utc_text(std::time(nullptr));
  if (login.user && entry.role.empty()) {
    entry.actor = login.user->name;
    entry.role = name_of(login.user->role);
  }
  // From the anchor on, so that a gap after a cut remains visible.
  AuditHead head;
  long long count = 0;
  std::string proof;
  sql << "SELECT count, hash, proof FROM audit_anchor", soci::into(count), soci::into(head.hash),
      soci::into(proof);
  const bool first = !sql.got_data();
  head.count = count;
  const bool proved =
      first ? may_be_without_log(sql, state) : is_proved(state, head, proof, entry.act);
  if (first) head.hash = first_hash(key, state.database_id());
  long long last = 0;
  sql << "SELECT coalesce(max(id), 0) FROM audit_log", soci::into(last);
  head.count = std::max(count, last) + 1;
  entry.number = head.count;
  database.seal_rows();
  const SealHead seals = seal_head(sql);
  entry.seals = seals.count;
  entry.hash = entry_hash(key, head.hash, entry, seals.chain);
  head.hash = entry.hash;
  if (proved) proof = head_proof(key, state.database_id(), head);
  sql << "INSERT INTO audit_log (id, at_utc, actor, role, act, object, result, detail, hash, "
         "seals) "
         "VALUES (:id, :at, :actor, :role, :act, :object, :result, :detail, :hash, :seals)",
      soci::use(entry.number), soci::use(entry.at_utc), soci::use(entry.actor),
      soci::use(entry.role), soci::use(entry.act), soci::use(entry.object), soci::use(entry.result),
      soci::use(entry.detail), soci::use(entry.hash), soci::use(entry.seals);
  sql << "INSERT INTO audit_anchor (id, count, hash, proof) VALUES (1, :count, :hash, :proof) "
         "ON CONFLICT (id) DO UPDATE SET count = excluded.count, hash = excluded.hash, "
         "proof = excluded.proof",
      soci::use(head.count), soci::use(head.hash), soci::use(proof);
  return head;
}

void note_head(Database& database, const LoginState& state, const AuditHead& head) {
  if (!state.is_protected() || head.count == 0) return;
  const Login login = state.login();
  const Secret* const key = audit_key(login);
  if (key == nullptr) return;
  const HeadFile there = read_head_file(database.real_path(), key, state.database_id());
  if (there.present && !there.head) return;
  if (there.head) {
    std::string hash;
    const auto read = database.guard("reading the audit log"_text, [&] {
      database.sql() << "SELECT hash FROM audit_log WHERE id = :id", soci::use(there.head->count),
          soci::into(hash);
    });
    if (!read || hash != there.head->hash || there.head->count >= head.count) return;
  }
  write_head_file(database.real_path(), key, state.database_id(), head);
}

std::vector<Text> notices_of_head(Database& database, const LoginState& state) {
  const Login login = state.login();
  const HeadFile there =
      read_head_file(database.real_path(), audit_key(login), state.database_id());
  if (there.present && !there.head)
    return {"audit log: the file -audit beside the database was changed"_text};
  int entries = 0;
  std::string hash;
  const std::int64_t at = there.head ? there.head->count : 0;
  const auto read = database.guard("reading the audit log"_text, [&] {
    soci::session& sql = database.sql();
    sql << "SELECT count(*) FROM (SELECT 1 FROM audit_log LIMIT 1)", soci::into(entries);
    sql << "SELECT hash FROM audit_log WHERE id = :id", soci::use(at), soci::into(hash);
  });
  if (!there.present) {
    if (read && entries == 0) return {};  // of a database that is being made
    return {
        "there is no file -audit beside the database; where the database was not copied or moved, somebody has removed it, and that it is older than it once was would not be noticed"_text};
  }
  if (read && hash == there.head->hash) return {};
  return {
      "the file is older than its audit log once was, or was cut: entry %1 is not there (run isograsp db check)"_text(
          there.head->count)};
}

Result<void> audited(Access& access, const Text& doing, AuditEntry entry,
                     const std::function<void(AuditEntry&)>& work) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  return audited(parts.database, *parts.login, entry,
                 [&] { return parts.database.transact(doing, [&] { work(entry); }); });
}

Result<void> log_entry(Access& access, AuditEntry entry) {
  return audited(access, "writing the audit log"_text, std::move(entry), [](AuditEntry&) {});
}

AuditEntry entry_of(std::string act, std::string object, std::string detail) {
  AuditEntry entry;
  entry.act = std::move(act);
  entry.object = std::move(object);
  entry.result = "done";
  entry.detail = std::move(detail);
  return entry;
}

}  // namespace isograsp::storage
