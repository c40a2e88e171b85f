// SPDX-License-Identifier: GPL-3.0-or-later
// Who is logged in to a database in this process, and with which keys: one for all connections to
// the file and to its copies. Inside storage/ only.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "storage/access/access.hpp"
#include "storage/access/vault.hpp"
#include "storage/file/database.hpp"

namespace isograsp::storage {

/// A copy of the state at one moment. Keys are wiped when nobody uses them any more.
struct Login {
  std::shared_ptr<const Keys> keys;  ///< empty: nobody is logged in
  std::optional<User> user;
  bool locked = false;
};

/// Thread-safe.
class LoginState {
 public:
  LoginState(std::string database_id, bool is_protected)
      : database_id_(std::move(database_id)), protected_(is_protected) {}
  /// The one that this process has of a database, or a new one. Not protected: always a new one.
  [[nodiscard]] static std::shared_ptr<LoginState> of(const std::string& database_id,
                                                      bool is_protected);

  [[nodiscard]] const std::string& database_id() const noexcept { return database_id_; }
  [[nodiscard]] bool is_protected() const noexcept { return protected_; }
  [[nodiscard]] Login login() const;
  void set(Login login);
  void lock();
  [[nodiscard]] bool allows(Right right) const;
  /// PINs that were wrong in a row in this process.
  [[nodiscard]] int wrong_pins(RowId user) const;
  void count_pin(RowId user, bool right);  ///< a password counts as right

 private:
  const std::string database_id_;
  const bool protected_;
  mutable std::mutex mutex_;
  Login login_;
  std::map<RowId, int> wrong_pins_;
};

/// Reads the identity of the file, whose rows are then sealed with its keys; in a guard of the
/// caller. Files of older formats: not protected.
[[nodiscard]] std::shared_ptr<LoginState> login_state_of(Database& database);

/// Rows that are written through `database` are sealed with the key of whoever is logged in then.
void seal_with_keys_of(const std::shared_ptr<LoginState>& state, Database& database);

/// Why `right` is not there now, and what to do.
[[nodiscard]] Error refusal_of(const LoginState& state, Right right, const std::string& path);

struct Access::Parts {
  Parts(Database opened, std::shared_ptr<LoginState> state, UtcClock utc, bool may_write)
      : database(std::move(opened)),
        login(std::move(state)),
        clock(std::move(utc)),
        writable(may_write) {}
  std::recursive_mutex mutex;  ///< of the connection
  Database database;
  std::shared_ptr<LoginState> login;
  UtcClock clock;
  bool writable;
  std::vector<Text> notices;  ///< of the last login
};

/// A database that was protected by a program that was ended has none, until one was shown.
[[nodiscard]] bool has_recovery_key(Access::Parts& parts);

}  // namespace isograsp::storage
