// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/protection.hpp"

#include <filesystem>

#include <soci/soci.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/audit_head_file.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/proof.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/access/signing.hpp"
#include "storage/access/user_rows.hpp"
#include "storage/file/remains.hpp"
#include "storage/file/statement.hpp"
#include "storage/file/sweep.hpp"

namespace isograsp::storage {

namespace {

/// No other program has the file open, and none can open it until this connection is closed: what
/// it wrote would be plain text.
Result<void> close_to_others(Database& database) {
  return database.guard("closing the file to others"_text, [&] {
    database.sql() << "PRAGMA busy_timeout=0";  // who has it open will not be gone in seconds
    pragma(database.sql(), "locking_mode=EXCLUSIVE");
    database.watch_no_more();  // without a log nothing is as it was opened
    if (pragma(database.sql(), "journal_mode=DELETE") != "delete")
      throw Refusal{
          failed("cannot be closed to other programs"_text, "close them, then protect it"_text)
              .at(database.path())};
  });
}

/// Seals a column in place; how many texts.
int seal_column(soci::session& sql, const LoginState& state, const SealedColumn& column) {
  const std::vector<StoredText> texts = stored_texts(sql, column);
  const Login login = state.login();
  for (const StoredText& plain : texts)
    replace_text(sql, plain, seal(login.keys->text, bound_to(state, plain.place), plain.text));
  return static_cast<int>(texts.size());
}

Result<RecordingLock> nobody_records(const Database& database) {
  auto recording = RecordingLock::exclusive_if_free(database.real_path());
  if (recording && !recording->held())
    return failed("another program records into the file now"_text,
                  "end that session, then protect it"_text)
        .at(database.path());
  return recording;
}

Result<std::unique_ptr<Access>> opened_with(const std::string& database, const Secret& passphrase) {
  auto access = Access::open(database);
  if (!access) return access.error();
  if (const auto done = (*access)->log_in_with_passphrase(passphrase); !done) return done.error();
  return access;
}

Result<Protection> sweep_again(const std::string& database, const Secret& passphrase) {
  auto access = opened_with(database, passphrase);
  if (!access) return access.error();
  Protection done{*std::move(access), {}, "", {}, {}};
  if (!has_recovery_key(done.access->parts())) done.recovery_key = make_recovery_key();
  Database& opened = done.access->parts().database;
  const auto recording = nobody_records(opened);
  if (!recording) return recording.error();
  if (const auto swept = sweep(opened); !swept) done.not_swept = swept.error();
  return done;
}

/// Keys, sealed texts and the entry, or nothing.
Result<AuditHead> seal_all(Database& database, const std::shared_ptr<LoginState>& shared,
                           const Secret& passphrase, const KeyCost& cost) {
  LoginState& state = *shared;
  AuditHead head;
  const auto done = database.transact("protecting the database"_text, [&] {
    soci::session& sql = database.sql();
    const std::string id = state.database_id();
    Keys keys = write_first_slot(sql, id, passphrase, cost);
    state.set({std::make_shared<const Keys>(std::move(keys)),
               holder_of(id, SlotKind::passphrase).user, false});
    seal_with_keys_of(shared, database);
    int texts = 0;
    for (const SealedColumn& column : sealed_column::kAll) texts += seal_column(sql, state, column);
    const std::string name = std::filesystem::path(database.real_path()).filename();
    database.seals()->seal_all();
    head = append_audit(database, state,
                        entry_of(kProtectAct, name, std::to_string(texts) + " texts sealed"));
  });
  if (done) return head;
  state.set({});
  return done.error();
}

}  // namespace

Result<Protection> protect_database(const std::string& database, const Secret& passphrase,
                                    const KeyCost* cost) {
  if (is_protected_database(database)) return sweep_again(database, passphrase);
  if (const auto good = check_password(passphrase, "passphrase"); !good) return good.error();
  Protection protection;
  protection.recovery_key = make_recovery_key();
  std::shared_ptr<LoginState> state;  // with the keys until somebody is logged in
  {
    auto opened = Database::open(database, OpenMode::existing);
    if (!opened) return opened.error();
    const auto recording = nobody_records(*opened);
    if (!recording) return recording.error();
    // All rows get new seals: what was changed by another hand would, too.
    // Not on this connection: when the file is closed to others it would go on with pages that it
    // read before the backup was logged.
    if (const auto proved = prove_file(database); !proved) return proved.error();
    protection.copy = free_name(opened->real_path() + ".before-protection");
    {
      const auto store = open_store(database, OpenMode::existing);
      if (!store) return store.error();
      if (const auto copied = (*store)->backup(protection.copy); !copied) return copied.error();
    }
    const auto prepared = [&]() -> Result<void> {
      if (auto alone = close_to_others(*opened); !alone) return alone;
      if (auto wiping = overwrite_what_is_removed(*opened); !wiping) return wiping;
      return opened->guard("reading the audit log"_text, [&] {
        state = LoginState::of(login_state_of(*opened)->database_id(), true);
        protection.remains = remains_of(opened->sql(), "", "", utc_text(std::time(nullptr)));
      });
    }();
    const auto head =
        prepared ? seal_all(*opened, state, passphrase, cost != nullptr ? *cost : KeyCost{})
                 : Result<AuditHead>(prepared.error());
    if (!head) {
      std::error_code ignored;
      std::filesystem::remove(protection.copy, ignored);
      std::filesystem::remove(signature_file_of(protection.copy), ignored);
      return head.error();
    }
    (void)set_aside_head_file(opened->real_path());  // of another database of this name
    note_head(*opened, *state, *head);
    std::error_code ignored;
    std::filesystem::remove(signing_key_file_of(opened->real_path()), ignored);  // of before
    if (const auto swept = sweep(*opened); !swept) protection.not_swept = swept.error();
  }
  auto access = opened_with(database, passphrase);
  if (!access) return access.error();
  protection.access = *std::move(access);
  return protection;
}

}  // namespace isograsp::storage
