// SPDX-License-Identifier: GPL-3.0-or-later
// Who works with a database, and what they may do: login, fast change of user, lock. Of a database
// without protection everybody may do all, nobody logs in, and no identity is stored. How the keys
// depend on each other: docs/storage.md, "Protected databases". A protected database is opened for
// the whole process: while an Access is logged in, open_store() works on the file and its copies.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "storage/crypto/secret.hpp"
#include "storage/records/records.hpp"

namespace isograsp::storage {

class Database;
struct KeyCost;

enum class Role : std::uint8_t { therapist, researcher, administrator };
[[nodiscard]] std::string_view name_of(Role role) noexcept;
[[nodiscard]] std::optional<Role> role_from_name(std::string_view name) noexcept;

/// What a role may do: researcher: read_records; therapist: all but manage; administrator: all.
enum class Right : std::uint8_t {
  read_records,   ///< codes, sessions, signals, measures; research export; reports
  write_records,  ///< patients, sessions, what is known of a person; consent
  read_texts,     ///< notes, goals and other free text
  identities,     ///< names, birth dates, contacts: read and set; export of one person
  manage          ///< accounts, policy, audit log, erasure
};
[[nodiscard]] bool may(Role role, Right right) noexcept;

struct User {
  RowId id = 0;  ///< 0: nobody's account (the clinic's passphrase, the recovery key)
  std::string name;
  Role role = Role::therapist;
  bool has_pin = false;
  std::string created_utc;
};

/// What the clinic decided. Kept in the database.
struct AccessPolicy {
  int lock_after_s = 600;    ///< without a press or a touch; 30 to 86400
  int retention_years = 10;  ///< that the law asks for after the last record; 0 to 100
};
/// Nobody's trial is stopped by a lock.
[[nodiscard]] bool is_lock_due(const AccessPolicy& policy, double idle_s, bool trial_runs) noexcept;

/// Seconds that must pass after the n-th wrong password in a row: none up to the second, then 2, 4,
/// 8 … up to 300.
[[nodiscard]] std::int64_t delay_after(int wrong_passwords) noexcept;
inline constexpr int kMostWrongPins = 3;  ///< in a row; then only the password helps

/// Seconds since 1970, UTC.
using UtcClock = std::function<std::int64_t()>;

/// All calls are thread-safe; logins take the time of Argon2id (docs/storage.md). What a user does
/// through several Access objects or stores of one database in one process is done by one login.
class Access {
 public:
  /// Any database of this program; the format must be current. `clock`: of delays; default: the
  /// system's. A file that may not be written can be opened, but no identity can be read then:
  /// what cannot be logged is not shown.
  [[nodiscard]] static Result<std::unique_ptr<Access>> open(const std::string& database,
                                                            UtcClock clock = {});
  /// For the login before a migration: a file of an older format, which is only read.
  [[nodiscard]] static Result<std::unique_ptr<Access>> open_to_migrate(const std::string& database);
  struct Protected {
    std::unique_ptr<Access> access;  ///< logged in as the clinic's passphrase
    /// To be printed once; kept nowhere. Opens nothing before accept_recovery_key().
    Secret recovery_key;
  };
  /// Makes a new protected database: there is a whole one or none. Refused: a file that exists, a
  /// passphrase of fewer than kLeastPassword characters.
  [[nodiscard]] static Result<Protected> create(const std::string& database,
                                                const Secret& passphrase,
                                                const KeyCost* cost = nullptr);
  ~Access();  ///< the last one of a database wipes its keys
  Access(const Access&) = delete;
  Access& operator=(const Access&) = delete;

  [[nodiscard]] const std::string& path() const noexcept;
  [[nodiscard]] bool is_protected() const noexcept;
  /// False: the file may not be written.
  [[nodiscard]] bool can_log() const noexcept;
  /// For the login screen: who has an account, by name. Needs no login.
  [[nodiscard]] Result<std::vector<User>> users();
  [[nodiscard]] Result<AccessPolicy> policy();

  // Login. Wrong ones are counted in the file and logged, before they are tried; the error says how
  // long to wait. Refused too: accounts, slots or seals that another program has changed. A login
  // replaces the one before and ends a lock.
  [[nodiscard]] Result<void> log_in(const std::string& user, const Secret& password);
  [[nodiscard]] Result<void> log_in_with_passphrase(const Secret& passphrase);
  /// Blanks, '-' and capital letters are ignored.
  [[nodiscard]] Result<void> log_in_with_recovery_key(const Secret& key);
  /// What the last login found strange though it opened: an older file that was put back, no
  /// FILE-audit beside it. To be said to who logged in.
  [[nodiscard]] std::vector<Text> notices() const;
  /// Names another person (or the same one again, after a lock) without a password: only in a
  /// process that somebody with keys for as much has opened. Three wrong ones: the password.
  [[nodiscard]] Result<void> switch_user(const std::string& user, const Secret& pin);
  /// Identities, free text and accounts are closed until the next login or PIN; a recording goes
  /// on.
  void lock();
  void log_out();  ///< wipes the keys
  /// While it is kept the login stays, even without an Access. For a process that forks: no
  /// connection may be open then.
  [[nodiscard]] std::shared_ptr<const void> keep_login() const;

  /// Nothing: nobody is logged in, or the database is not protected.
  [[nodiscard]] std::optional<User> user() const;
  [[nodiscard]] bool is_locked() const;
  /// Of the user who is logged in; false while locked.
  [[nodiscard]] bool allows(Right right) const;
  /// An error that says who is needed; it is logged with `act`.
  [[nodiscard]] Result<void> require(Right right, const std::string& act,
                                     const std::string& object);

  struct Parts;  ///< internal to this folder
  [[nodiscard]] Parts& parts() noexcept { return *parts_; }

 private:
  Access();
  [[nodiscard]] static Result<std::unique_ptr<Access>> with(Database opened, UtcClock clock,
                                                            bool writable);
  std::unique_ptr<Parts> parts_;
};

/// True for a file that needs a login; false too where the file cannot be read.
[[nodiscard]] bool is_protected_database(const std::string& database);

}  // namespace isograsp::storage
