// SPDX-License-Identifier: GPL-3.0-or-later
// Adding to the audit log: the hash of an entry, the anchor by which a shortened log is noticed,
// and acts that are stored together with their entry or not at all. Inside storage/ only.
#pragma once

#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/login.hpp"

namespace isograsp::storage {

/// The act with which the chain goes on under a key.
inline constexpr const char* kProtectAct = "protect";

/// Key of the chain; nothing: not protected.
[[nodiscard]] const Secret* audit_key(const Login& login);
/// What stands before the first entry.
[[nodiscard]] std::string first_hash(const Secret* key, const std::string& database_id);
/// `seal_chain`: of the last seal that the entry holds (SealHead).
[[nodiscard]] std::string entry_hash(const Secret* key, const std::string& before,
                                     const AuditEntry& entry, const std::string& seal_chain);
/// States how far the log had come; only a holder of the key can make it.
[[nodiscard]] std::string head_proof(const Secret* key, const std::string& database_id,
                                     const AuditHead& head);

/// Adds an entry by who is logged in, which holds the seals of all rows that were changed so far;
/// number, time (if empty), seals and hash are set here. Inside a transaction; throws as SOCI does.
AuditHead append_audit(Database& database, const LoginState& state, AuditEntry entry);
/// Beside the file (FILE-audit), where protected: a file put back to an earlier state is noticed by
/// it. A file that does not fit the log is left as it is: it is evidence. Problems are ignored (the
/// entry itself is stored).
void note_head(Database& database, const LoginState& state, const AuditHead& head);

/// Does the log fit FILE-audit? Nothing: it does, or there is none.
[[nodiscard]] std::vector<Text> notices_of_head(Database& database, const LoginState& state);

/// Runs `work`, which does one transaction of `database`, and stores `entry` in that transaction.
/// If it fails, an entry that says so is stored alone. `complete` may add at the end of the
/// transaction what was not known before; so may `work`.
template <class Work>
auto audited(Database& database, const LoginState& state, AuditEntry& entry, Work work,
             const std::function<void(AuditEntry&)>& complete = {}) -> decltype(work()) {
  AuditHead head;
  auto done = [&] {
    const AlsoBeforeCommit also(database, [&] {
      if (complete) complete(entry);
      head = append_audit(database, state, entry);
    });
    return work();
  }();
  if (!done) {
    entry.result = done.error().code == Error::Code::bad_input ? "refused" : "failed";
    const auto logged = database.transact("writing the audit log"_text,
                                          [&] { head = append_audit(database, state, entry); });
    if (!logged) return done;
  }
  note_head(database, state, head);
  return done;
}

/// The same with a transaction made of `work`, for Access.
[[nodiscard]] Result<void> audited(Access& access, const Text& doing, AuditEntry entry,
                                   const std::function<void(AuditEntry&)>& work);
/// For acts that change nothing: the entry alone.
[[nodiscard]] Result<void> log_entry(Access& access, AuditEntry entry);

/// An entry that says "done" unless told otherwise.
[[nodiscard]] AuditEntry entry_of(std::string act, std::string object, std::string detail = "");

}  // namespace isograsp::storage
