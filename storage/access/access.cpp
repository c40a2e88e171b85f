// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and making protected databases; who is logged in. Accounts: accounts.cpp.
#include "storage/access/access.hpp"

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>

#include <soci/soci.h>

#include "core/staging_folder.hpp"
#include "storage/access/accounts.hpp"
#include "storage/access/audit_chain.hpp"
#include "storage/access/audit_head_file.hpp"
#include "storage/access/proof.hpp"
#include "storage/access/user_rows.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/file/schema_access.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

/// Wrong ones are counted where they can be; what the clock says is not trusted further than the
/// delay itself.
std::int64_t seconds_to_wait(const KeySlot& slot, std::int64_t now) {
  return std::clamp(slot.retry_at_unix_s - now, std::int64_t{0}, delay_after(slot.failed_count));
}

/// Login failures from before a key was there become part of the chain.
void take_in_failures(Database& database, const LoginState& state) {
  soci::session& sql = database.sql();
  std::vector<AuditEntry> failures;
  AuditEntry one = entry_of("login", "");
  one.role = "nobody";
  one.result = "refused";
  one.detail = "wrong password";
  soci::statement select = (sql.prepare << "SELECT at_utc, who FROM login_failures ORDER BY id",
                            soci::into(one.at_utc), soci::into(one.object));
  select.execute();
  while (select.fetch()) failures.push_back(one);
  for (const AuditEntry& failure : failures) (void)append_audit(database, state, failure);
  sql << "DELETE FROM login_failures";
}

/// The password was right. Inside a transaction.
void forget_wrong(soci::session& sql, RowId slot) {
  sql << "UPDATE key_slots SET failed_count = 0, retry_at_unix_s = 0 WHERE id = :id",
      soci::use(slot);
}

Result<void> open_for(Access::Parts& parts, SlotOwner owner, const Secret& password,
                      const std::string& path) {
  const std::lock_guard lock(parts.mutex);
  if (!parts.login->is_protected())
    return refused("asks for no login"_text, "leave the login out"_text).at(path);
  std::optional<KeySlot> slot;
  std::int64_t wait = 0;
  int failed_count = 0;
  const auto look = [&] {
    soci::session& sql = parts.database.sql();
    if (owner.kind == SlotKind::user)
      if (const auto user = find_user(sql, owner.user.name)) owner.user = *user;
    slot = read_slot(sql, owner);
    if (!slot) return;
    wait = seconds_to_wait(*slot, parts.clock());
    failed_count = slot->failed_count + 1;
    if (wait > 0 || !parts.writable) return;
    // Counted as a wrong one before it is tried: who tries many at once waits for each of them.
    const std::int64_t retry_at = parts.clock() + delay_after(failed_count);
    sql << "UPDATE key_slots SET failed_count = :count, retry_at_unix_s = :at WHERE id = :id",
        soci::use(failed_count), soci::use(retry_at), soci::use(slot->id);
  };
  const auto counted = parts.writable ? parts.database.transact("logging in"_text, look)
                                      : parts.database.guard("logging in"_text, look);
  if (!counted) return counted.error();
  if (wait > 0)
    return refused("too many wrong passwords, or several people log in at this moment"_text,
                   "wait %1 s, then try again"_text(wait))
        .at(path);

  auto keys = slot ? open_slot(*slot, owner, password) : std::nullopt;
  const std::string now_utc = utc_text(std::time(nullptr));
  if (!keys) {
    if (parts.writable) {
      // A name that nobody has could be a password in the wrong field: it is not written down.
      const std::string who = slot ? owner.user.name : "unknown user";
      const auto noted = parts.database.transact("logging in"_text, [&] {
        parts.database.sql() << "INSERT INTO login_failures (at_utc, who) VALUES (:at, :who)",
            soci::use(now_utc), soci::use(who);
      });
      if (!noted) return noted.error();
    }
    const std::int64_t next = delay_after(failed_count);
    return refused("name or password is wrong"_text,
                   next == 0 ? "try again"_text : "wait %1 s, then try again"_text(next))
        .at(path);
  }
  const auto proved = prove_accounts(parts.database, keys->audit);
  if (!proved) {
    // The password was right: who tries it again is told the same, not to wait.
    if (parts.writable)
      static_cast<void>(parts.database.transact(
          "logging in"_text, [&] { forget_wrong(parts.database.sql(), slot->id); }));
    return proved.error();
  }

  const Login before = parts.login->login();
  parts.login->set({std::make_shared<const Keys>(*std::move(keys)), owner.user, false});
  parts.notices = notices_of_head(parts.database, *parts.login);
  if (!proved->of_texts.empty())
    parts.notices.push_back(
        "names or notes were changed by another program: %1 (run isograsp db check)"_text(
            proved->of_texts.front()));
  if (may(owner.user.role, Right::manage) && !has_recovery_key(parts))
    parts.notices.push_back(
        "there is no recovery key: if the passphrase is lost, so is what is sealed; make one with isograsp db recovery-key"_text);
  if (!parts.writable) return {};
  AuditEntry entry = entry_of("login", owner.user.name);
  auto logged = audited(parts.database, *parts.login, entry, [&] {
    return parts.database.transact("logging in"_text, [&] {
      soci::session& sql = parts.database.sql();
      if (proved->to_keep) parts.database.seals()->keep_summary(*proved->to_keep);
      forget_wrong(sql, slot->id);
      if (owner.kind == SlotKind::user)
        sql << "UPDATE users SET pin_failed_count = 0 WHERE id = :id", soci::use(owner.user.id);
      take_in_failures(parts.database, *parts.login);
    });
  });
  if (!logged) {
    parts.login->set(before);
    return logged;
  }
  parts.login->count_pin(owner.user.id, true);
  return {};
}

}  // namespace

bool has_recovery_key(Access::Parts& parts) {
  int count = 1;
  static_cast<void>(parts.database.guard("logging in"_text, [&] {
    parts.database.sql() << "SELECT count(*) FROM key_slots WHERE kind = 'recovery'",
        soci::into(count);
  }));
  return count > 0;
}

bool is_lock_due(const AccessPolicy& policy, double idle_s, bool trial_runs) noexcept {
  return !trial_runs && idle_s >= policy.lock_after_s;
}

std::int64_t delay_after(int wrong_passwords) noexcept {
  constexpr int kFree = 2;
  constexpr int kDoublings = 8;
  constexpr std::int64_t kMost_s = 300;
  if (wrong_passwords <= kFree) return 0;
  return std::min(kMost_s, std::int64_t{1} << std::min(wrong_passwords - kFree, kDoublings + 1));
}

Access::Access() = default;
Access::~Access() = default;

Result<std::unique_ptr<Access>> Access::with(Database opened, UtcClock clock, bool writable) {
  if (!clock) clock = [] { return static_cast<std::int64_t>(std::time(nullptr)); };
  std::shared_ptr<LoginState> state;
  const auto read = opened.guard("opening"_text, [&] { state = login_state_of(opened); });
  if (!read) return read.error();
  auto access = std::unique_ptr<Access>(new Access);
  access->parts_ =
      std::make_unique<Parts>(std::move(opened), std::move(state), std::move(clock), writable);
  return access;
}

Result<std::unique_ptr<Access>> Access::open(const std::string& database, UtcClock clock) {
  auto opened = Database::open(database, OpenMode::existing);
  if (opened) return with(*std::move(opened), std::move(clock), true);
  // Another program has it locked, or it is damaged: not the same as a file that is only read.
  if (may_be_written(database)) return opened.error();
  auto reading = Database::open(database, OpenMode::read_only);
  if (!reading || reading->format() != kDatabaseFormat) return opened.error();
  return with(*std::move(reading), std::move(clock), false);
}

Result<std::unique_ptr<Access>> Access::open_to_migrate(const std::string& database) {
  auto opened = Database::open(database, OpenMode::read_only);
  if (!opened) return opened.error();
  return with(*std::move(opened), {}, false);
}

Result<Access::Protected> Access::create(const std::string& database, const Secret& passphrase,
                                         const KeyCost* cost) {
  std::error_code failure;
  const fs::path target = fs::weakly_canonical(fs::absolute(database), failure);
  if (failure || fs::exists(fs::symlink_status(target)))
    return refused("exists already"_text, "name a new file"_text).at(database);
  if (auto good = check_password(passphrase, "passphrase"); !good) return good.error();
  const auto staging = StagingFolder::beside(target);
  if (!staging) return staging.error();
  const std::string& part = staging->file();
  const auto made = [&]() -> Result<void> {
    auto file = Database::open(part, OpenMode::create);
    if (!file) return file.error();
    return file->transact("protecting the database"_text, [&] {
      const Keys keys = write_first_slot(file->sql(), login_state_of(*file)->database_id(),
                                         passphrase, cost != nullptr ? *cost : KeyCost{});
      file->seals()->key_from([&keys] { return &keys.audit; });
      file->seals()->seal_all();
    });
  }();
  if (!made) {
    Error error = made.error();
    error.file = database;
    return error;
  }
  // Not with rename: a file that appeared meanwhile is kept.
  const bool named = ::link(part.c_str(), target.c_str()) == 0;
  if (!named)
    return failed("could not be made"_text, "choose another name or folder"_text).at(database);
  (void)set_aside_head_file(target);  // of a database of this name that is gone
  auto access = open(database);
  if (!access) return access.error();
  if (auto done = (*access)->log_in_with_passphrase(passphrase); !done) return done.error();
  if (auto logged = log_entry(**access, entry_of("create", target.filename())); !logged)
    return logged.error();
  return Protected{*std::move(access), make_recovery_key()};
}

const std::string& Access::path() const noexcept {
  return parts_->database.path();
}

bool Access::is_protected() const noexcept {
  return parts_->login->is_protected();
}

bool Access::can_log() const noexcept {
  return parts_->writable;
}

Result<std::vector<User>> Access::users() {
  const std::lock_guard lock(parts_->mutex);
  std::vector<User> all;
  const auto done = parts_->database.guard("reading accounts"_text,
                                           [&] { all = read_users(parts_->database.sql()); });
  if (!done) return done.error();
  return all;
}

Result<AccessPolicy> Access::policy() {
  const std::lock_guard lock(parts_->mutex);
  AccessPolicy policy;
  const auto done = parts_->database.guard("reading the policy"_text, [&] {
    parts_->database.sql() << "SELECT lock_after_s, retention_years FROM access_settings",
        soci::into(policy.lock_after_s), soci::into(policy.retention_years);
  });
  if (!done) return done.error();
  return policy;
}

Result<void> Access::log_in(const std::string& user, const Secret& password) {
  SlotOwner owner{parts_->login->database_id(), SlotKind::user, {}};
  owner.user.id = -1;  // no account, if there is no such name
  owner.user.name = user;
  return open_for(*parts_, owner, password, path());
}

Result<void> Access::log_in_with_passphrase(const Secret& passphrase) {
  return open_for(*parts_, holder_of(parts_->login->database_id(), SlotKind::passphrase),
                  passphrase, path());
}

Result<void> Access::log_in_with_recovery_key(const Secret& key) {
  const auto digits = read_recovery_key(key);
  if (!digits)
    return refused("is no recovery key: a digit is missing or mistyped"_text,
                   "copy all 56 digits from the printed page"_text)
        .at(path());
  return open_for(*parts_, holder_of(parts_->login->database_id(), SlotKind::recovery), *digits,
                  path());
}

std::vector<Text> Access::notices() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->notices;
}

void Access::lock() {
  parts_->login->lock();
}

std::shared_ptr<const void> Access::keep_login() const {
  return parts_->login;
}

void Access::log_out() {
  if (parts_->writable && user())
    (void)log_entry(*this, entry_of("log out", user()->name));  // the keys go in any case
  parts_->login->set({});
}

std::optional<User> Access::user() const {
  return parts_->login->login().user;
}

bool Access::is_locked() const {
  return parts_->login->login().locked;
}

bool Access::allows(Right right) const {
  return parts_->login->allows(right);
}

Result<void> Access::require(Right right, const std::string& act, const std::string& object) {
  if (allows(right)) return {};
  const Error refusal = refusal_of(*parts_->login, right, path());
  if (is_protected() && parts_->login->login().keys && parts_->writable) {
    AuditEntry entry = entry_of(act, object);
    entry.result = "refused";
    if (auto logged = log_entry(*this, entry); !logged) return logged;
  }
  return refusal;
}

bool is_protected_database(const std::string& database) {
  auto opened = Database::open(database, OpenMode::read_only);
  if (!opened) return false;
  bool found = false;
  const auto read =
      opened->guard("opening"_text, [&] { found = login_state_of(*opened)->is_protected(); });
  return read && found;
}

}  // namespace isograsp::storage
