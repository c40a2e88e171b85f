// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/accounts.hpp"

#include <algorithm>

#include <soci/soci.h>
#include <sodium.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/proof.hpp"
#include "storage/access/user_rows.hpp"

namespace isograsp::storage {

namespace {

Result<void> check_user_name(const std::string& name) {
  constexpr std::size_t kMost = 64;
  const bool printable = std::none_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
  });
  if (name.empty() || name.size() > kMost || !printable || name.front() == ' ' ||
      name.back() == ' ')
    return refused("is no name of an account"_text,
                   "give 1 to 64 characters on one line, no blank at either end"_text)
        .about("name");
  return {};
}

Result<void> check_pin(const Secret& pin) {
  if (pin.empty()) return {};
  const std::string_view digits = pin.text();
  const bool good =
      digits.size() >= kLeastPin && digits.size() <= kMostPin &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!good) return refused("is not 4 to 12 digits"_text, "choose another one"_text).about("pin");
  for (const int step : {-1, 0, 1}) {
    bool easy = true;
    for (std::size_t i = 1; i < digits.size(); ++i) easy &= digits[i] - digits[i - 1] == step;
    if (easy) return refused("is too easy to guess"_text, "choose another one"_text).about("pin");
  }
  return {};
}

/// With all that the PIN makes somebody: a role that is changed in the file opens nothing.
std::string pin_place(const std::string& database_id, const User& user) {
  return "pin 2\n" + database_id + "\n" + std::to_string(user.id) + "\n" +
         std::string(name_of(user.role)) + "\n" + user.name;
}

User required_user(soci::session& sql, const std::string& name) {
  auto user = find_user(sql, name);
  if (!user)
    throw Refusal{
        refused("nobody has an account of this name"_text, "see isograsp db users list"_text)
            .about("name")};
  return *user;
}

SlotOwner slot_of(const Access::Parts& parts, const User& user) {
  return {parts.login->database_id(), SlotKind::user, user};
}

Result<void> manage(Access& access, const std::string& act, const std::string& object) {
  if (!access.is_protected())
    return refused("is not protected: it has no accounts"_text,
                   "protect it: isograsp db protect FILE"_text)
        .at(access.path());
  return access.require(Right::manage, act, object);
}

}  // namespace

std::vector<User> read_users(soci::session& sql) {
  std::vector<User> all;
  User one;
  std::string role;
  int has_pin = 0;
  soci::statement select =
      (sql.prepare << "SELECT id, name, role, pin <> '', created_utc FROM users "
                      "WHERE removed_utc = '' ORDER BY name",
       soci::into(one.id), soci::into(one.name), soci::into(role), soci::into(has_pin),
       soci::into(one.created_utc));
  select.execute();
  while (select.fetch()) {
    one.role = role_from_name(role).value_or(Role::researcher);
    one.has_pin = has_pin != 0;
    all.push_back(one);
  }
  return all;
}

std::optional<User> find_user(soci::session& sql, const std::string& name) {
  RowId id = 0;
  sql << "SELECT id FROM users WHERE name = :name AND removed_utc = ''", soci::use(name),
      soci::into(id);
  if (!sql.got_data()) return std::nullopt;
  for (const User& user : read_users(sql))
    if (user.id == id) return user;
  return std::nullopt;
}

Result<void> check_password(const Secret& password, const std::string& field) {
  if (password.size() < kLeastPassword)
    return refused("has fewer than %1 characters"_text(kLeastPassword),
                   "choose a longer one; several words are easy to keep in mind"_text)
        .about(field);
  return {};
}

Result<User> add_user(Access& access, const std::string& name, Role role, const Secret& password,
                      const KeyCost& cost) {
  if (const auto good = check_user_name(name); !good) return good.error();
  if (const auto allowed = manage(access, "add user", name); !allowed) return allowed.error();
  if (const auto good = check_password(password, "password"); !good) return good.error();
  User user{0, name, role, false, utc_text(std::time(nullptr))};
  Access::Parts& parts = access.parts();
  const auto keys = parts.login->login().keys;
  const auto done = audited(
      access, "adding an account"_text, entry_of("add user", name, std::string(name_of(role))),
      [&](AuditEntry&) {
        soci::session& sql = parts.database.sql();
        int there = 0;
        sql << "SELECT count(*) FROM users WHERE name = :name", soci::use(name), soci::into(there);
        if (there > 0)
          throw Refusal{refused("is or was the name of an account"_text,
                                "choose another one: the audit log names people"_text)
                            .about("name")};
        const std::string role_name(name_of(role));
        sql << "INSERT INTO users (name, role, created_utc) VALUES (:name, :role, :utc)",
            soci::use(name), soci::use(role_name), soci::use(user.created_utc);
        sql << "SELECT max(id) FROM users", soci::into(user.id);
        write_slot(sql, slot_of(parts, user), password, cost, *keys);
      });
  if (!done) return done.error();
  return user;
}

Result<void> remove_user(Access& access, const std::string& name) {
  if (auto allowed = manage(access, "remove user", name); !allowed) return allowed;
  return audited(access, "removing an account"_text, entry_of("remove user", name),
                 [&](AuditEntry&) {
                   soci::session& sql = access.parts().database.sql();
                   const User user = required_user(sql, name);
                   const std::string now = utc_text(std::time(nullptr));
                   sql << "DELETE FROM key_slots WHERE user_id = :id", soci::use(user.id);
                   sql << "UPDATE users SET removed_utc = :utc, pin = '' WHERE id = :id",
                       soci::use(now), soci::use(user.id);
                 });
}

Result<void> reset_password(Access& access, const std::string& name, const Secret& password,
                            const KeyCost& cost) {
  if (auto allowed = manage(access, "reset password", name); !allowed) return allowed;
  if (auto good = check_password(password, "password"); !good) return good;
  return audited(
      access, "storing a password"_text, entry_of("reset password", name), [&](AuditEntry&) {
        soci::session& sql = access.parts().database.sql();
        const User user = required_user(sql, name);
        write_slot(sql, slot_of(access.parts(), user), password, cost,
                   *access.parts().login->login().keys);
        sql << "UPDATE users SET pin_failed_count = 0 WHERE id = :id", soci::use(user.id);
      });
}

Result<void> set_policy(Access& access, const AccessPolicy& policy) {
  if (auto allowed = access.require(Right::manage, "set policy", ""); !allowed) return allowed;
  return audited(access, "storing the policy"_text,
                 entry_of("set policy", "",
                          "lock after " + std::to_string(policy.lock_after_s) + " s, keep " +
                              std::to_string(policy.retention_years) + " years"),
                 [&](AuditEntry&) {
                   access.parts().database.sql()
                       << "UPDATE access_settings SET lock_after_s = :lock, "
                          "retention_years = :years",
                       soci::use(policy.lock_after_s), soci::use(policy.retention_years);
                 });
}

Result<void> change_passphrase(Access& access, const Secret& passphrase, const KeyCost& cost) {
  if (auto allowed = manage(access, "change passphrase", ""); !allowed) return allowed;
  if (auto good = check_password(passphrase, "passphrase"); !good) return good;
  return audited(access, "storing the passphrase"_text, entry_of("change passphrase", ""),
                 [&](AuditEntry&) {
                   write_slot(access.parts().database.sql(),
                              holder_of(access.parts().login->database_id(), SlotKind::passphrase),
                              passphrase, cost, *access.parts().login->login().keys);
                 });
}

Result<Secret> new_recovery_key(Access& access) {
  if (const auto allowed = manage(access, "new recovery key", ""); !allowed) return allowed.error();
  return make_recovery_key();
}

Result<void> accept_recovery_key(Access& access, const Secret& key) {
  if (auto allowed = manage(access, "new recovery key", ""); !allowed) return allowed;
  if (!read_recovery_key(key))
    return refused("is no recovery key"_text, "take the one that was made"_text)
        .about("recovery key");
  return audited(
      access, "storing a recovery key"_text, entry_of("new recovery key", ""), [&](AuditEntry&) {
        write_recovery_slot(access.parts().database.sql(), access.parts().login->database_id(), key,
                            *access.parts().login->login().keys);
      });
}

Result<void> change_own_password(Access& access, const Secret& old_password, const Secret& password,
                                 const KeyCost& cost) {
  const auto user = access.user();
  if (!user || user->id == 0)
    return refused("nobody is logged in with an account"_text, "log in with a name"_text)
        .about("password");
  if (auto good = check_password(password, "password"); !good) return good;
  // Counts a wrong one as every login does.
  if (auto theirs = access.log_in(user->name, old_password); !theirs) return theirs;
  return audited(access, "storing a password"_text, entry_of("change password", user->name),
                 [&](AuditEntry&) {
                   write_slot(access.parts().database.sql(), slot_of(access.parts(), *user),
                              password, cost, *access.parts().login->login().keys);
                 });
}

Result<void> set_own_pin(Access& access, const Secret& pin) {
  const auto user = access.user();
  const Login login = access.parts().login->login();
  if (!user || user->id == 0 || login.locked)
    return refused("nobody is logged in with an account"_text, "log in with a name"_text)
        .about("pin");
  if (!login.keys || login.keys->pin.empty())
    return refused("the role %1 has no PIN"_text(Known{std::string(name_of(user->role))}),
                   "log in with the password"_text)
        .about("pin");
  if (auto good = check_pin(pin); !good) return good;
  std::string sealed;
  if (!pin.empty()) {
    Secret check(crypto_pwhash_STRBYTES);
    if (crypto_pwhash_str(reinterpret_cast<char*>(check.data()), pin.text().data(), pin.size(),
                          crypto_pwhash_OPSLIMIT_INTERACTIVE,
                          crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0)
      return failed("not enough memory"_text, "close other programs"_text);
    sealed =
        seal(login.keys->pin, pin_place(access.parts().login->database_id(), *user), check.text());
  }
  return audited(access, "storing a PIN"_text,
                 entry_of(pin.empty() ? "remove PIN" : "set PIN", user->name), [&](AuditEntry&) {
                   access.parts().database.sql()
                       << "UPDATE users SET pin = :pin, pin_failed_count = 0 WHERE id = :id",
                       soci::use(sealed), soci::use(user->id);
                 });
}

Result<void> Access::switch_user(const std::string& name, const Secret& pin) {
  const std::lock_guard lock(parts_->mutex);
  const Login before = parts_->login->login();
  if (!before.keys || before.keys->pin.empty())
    return refused("nobody has opened the database with a password yet"_text,
                   "log in with the password"_text)
        .about("pin");
  std::optional<User> user;
  std::string sealed;
  int failed_count = 0;
  const auto read = parts_->database.guard("changing the user"_text, [&] {
    soci::session& sql = parts_->database.sql();
    user = find_user(sql, name);
    if (user)
      sql << "SELECT pin, pin_failed_count FROM users WHERE id = :id", soci::use(user->id),
          soci::into(sealed), soci::into(failed_count);
  });
  if (!read) return read.error();
  // In memory too: what stands in the file can be put back.
  if (user) failed_count = std::max(failed_count, parts_->login->wrong_pins(user->id));
  if (!user || sealed.empty() || failed_count >= kMostWrongPins)
    return refused("the PIN cannot be used now"_text, "log in with the password"_text).about("pin");
  if (!before.keys->suffice_for(user->role))
    return refused("whoever opened the database has fewer rights than this account"_text,
                   "log in with the password"_text)
        .about("pin");
  const auto check =
      unseal(before.keys->pin, pin_place(parts_->login->database_id(), *user), sealed);
  if (!check)
    return refused("the PIN was set for another name or role, or by an older program"_text,
                   "log in with the password and set it again"_text)
        .about("pin");
  const bool right = check->size() == crypto_pwhash_STRBYTES &&
                     check->data()[check->size() - 1] == 0 &&
                     crypto_pwhash_str_verify(reinterpret_cast<const char*>(check->data()),
                                              pin.text().data(), pin.size()) == 0;
  std::optional<ProvedSeals> to_keep;
  if (right) {
    const auto proved = prove_accounts(parts_->database, before.keys->audit);
    if (!proved) return proved.error();
    to_keep = proved->to_keep;
  }
  parts_->login->count_pin(user->id, right);
  AuditEntry entry = entry_of("switch user", user->name);
  if (!right) entry.result = "refused";
  if (right) parts_->login->set({before.keys, user, false});
  auto logged = audited(parts_->database, *parts_->login, entry, [&] {
    return parts_->database.transact("changing the user"_text, [&] {
      if (to_keep) parts_->database.seals()->keep_summary(*to_keep);
      const int count = right ? 0 : failed_count + 1;
      parts_->database.sql() << "UPDATE users SET pin_failed_count = :count WHERE id = :id",
          soci::use(count), soci::use(user->id);
    });
  });
  if (!logged) {
    parts_->login->set(before);
    return logged;
  }
  if (right) return {};
  const int left = kMostWrongPins - failed_count - 1;
  return refused("the PIN is wrong"_text,
                 left > 0 ? "try again; %1 left"_text(left) : "log in with the password"_text)
      .about("pin");
}

}  // namespace isograsp::storage
