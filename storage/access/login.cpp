// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/login.hpp"

#include <array>
#include <filesystem>
#include <map>

#include <soci/soci.h>

#include "storage/access/audit_head_file.hpp"
#include "storage/file/schema_access.hpp"

namespace isograsp::storage {

namespace {

constexpr std::array<std::string_view, 3> kRoleNames{"therapist", "researcher", "administrator"};

}  // namespace

std::string_view name_of(Role role) noexcept {
  return kRoleNames[static_cast<std::size_t>(role)];
}

std::optional<Role> role_from_name(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kRoleNames.size(); ++i)
    if (kRoleNames[i] == name) return static_cast<Role>(i);
  return std::nullopt;
}

bool may(Role role, Right right) noexcept {
  switch (role) {
    case Role::administrator: return true;
    case Role::therapist: return right != Right::manage;
    case Role::researcher: return right == Right::read_records;
  }
  return false;
}

std::shared_ptr<LoginState> LoginState::of(const std::string& database_id, bool is_protected) {
  if (!is_protected) return std::make_shared<LoginState>(database_id, false);
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<LoginState>> states;
  const std::lock_guard lock(mutex);
  auto& known = states[database_id];
  auto state = known.lock();
  if (!state) {
    state = std::make_shared<LoginState>(database_id, true);
    known = state;
  }
  return state;
}

Login LoginState::login() const {
  const std::lock_guard lock(mutex_);
  return login_;
}

void LoginState::set(Login login) {
  const std::lock_guard lock(mutex_);
  login_ = std::move(login);
}

void LoginState::lock() {
  const std::lock_guard lock(mutex_);
  login_.locked = true;
}

bool LoginState::allows(Right right) const {
  if (!protected_) return right != Right::identities;
  const std::lock_guard lock(mutex_);
  return login_.user && login_.keys && !login_.locked && may(login_.user->role, right);
}

int LoginState::wrong_pins(RowId user) const {
  const std::lock_guard lock(mutex_);
  const auto found = wrong_pins_.find(user);
  return found == wrong_pins_.end() ? 0 : found->second;
}

void LoginState::count_pin(RowId user, bool right) {
  const std::lock_guard lock(mutex_);
  if (right)
    wrong_pins_.erase(user);
  else
    ++wrong_pins_[user];
}

namespace {

/// What only a protected database has is there, but no key slot: somebody has removed them, so that
/// the file would be taken for one that asks for no login.
void refuse_if_slots_were_removed(Database& database) {
  std::string query =
      "SELECT EXISTS (SELECT 1 FROM users) OR EXISTS (SELECT 1 FROM identities WHERE sealed <> '') "
      "OR EXISTS (SELECT "
      "1 FROM patient_profiles WHERE notes LIKE 'sealed:_:%' OR goals LIKE 'sealed:_:%')";
  if (database.format() >= schema::kSealFormat)
    query += " OR EXISTS (SELECT 1 FROM row_seals WHERE of_table = 'key_slots')";
  int traces = 0;
  database.sql() << query, soci::into(traces);
  std::error_code ignored;
  if (traces == 0 && !std::filesystem::exists(head_file_of(database.real_path()), ignored)) return;
  throw Refusal{refused(traces != 0 ? "was protected, but its key slots are gone"_text
                                    : "has no key slots, but the file -audit of a protected "
                                      "database stands beside it"_text,
                        traces != 0 ? "put back the last backup: isograsp db restore"_text
                                    : "put back the last backup: isograsp db restore; if -audit "
                                      "is of another database, move it away"_text)
                    .at(database.path())};
}

}  // namespace

std::shared_ptr<LoginState> login_state_of(Database& database) {
  if (database.format() < schema::kAccessFormat) return LoginState::of("", false);
  std::string id;
  int slots = 0;
  database.sql() << "SELECT database_id, (SELECT count(*) FROM key_slots) FROM access_settings",
      soci::into(id), soci::into(slots);
  if (slots == 0) refuse_if_slots_were_removed(database);
  auto state = LoginState::of(id, slots > 0);
  seal_with_keys_of(state, database);
  return state;
}

void seal_with_keys_of(const std::shared_ptr<LoginState>& state, Database& database) {
  if (database.seals() == nullptr) return;
  // Kept for as long as the caller looks at it: another thread may log out.
  database.seals()->key_from([state, keys = std::shared_ptr<const Keys>()]() mutable {
    keys = state->login().keys;
    return keys ? &keys->audit : nullptr;
  });
}

Error refusal_of(const LoginState& state, Right right, const std::string& path) {
  if (!state.is_protected())
    return refused("identities are not stored in a database without protection"_text,
                   "protect it: isograsp db protect FILE"_text)
        .at(path);
  const Login login = state.login();
  if (!login.user)
    return refused("is protected, and nobody is logged in"_text,
                   "give --passphrase-file, or --user and --password-file"_text)
        .at(path);
  if (login.locked) return refused("is locked"_text, "log in again"_text).at(path);
  const std::string role(name_of(login.user->role));
  switch (right) {
    case Right::read_records:
    case Right::write_records:
      return refused("the role %1 may not change records"_text(role), "log in as a therapist"_text)
          .at(path);
    case Right::read_texts:
    case Right::identities:
      return refused("the role %1 may not see who people are"_text(role),
                     "log in as a therapist"_text)
          .at(path);
    case Right::manage:
      return refused("the role %1 may not do this"_text(role), "log in as an administrator"_text)
          .at(path);
  }
  return refused("is not allowed"_text, "log in as somebody else"_text).at(path);
}

}  // namespace isograsp::storage
