// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db users, passphrase, recovery-key, policy, audit.
#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/db/db_commands.hpp"
#include "storage/access/accounts.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/signing.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct AccountOptions {
  AccessOptions common;
  std::string name;
  std::string role = "therapist";
  std::string new_file;  ///< holds the new password, PIN or passphrase
  int lock_after_s = 0;
  int retention_years = -1;
};

Result<void> list_users(storage::Access& access, const AccountOptions& options) {
  const auto users = access.users();
  if (!users) return users.error();
  Json json = Json::array();
  Lines text;
  for (const storage::User& user : *users) {
    const std::string role(storage::name_of(user.role));
    json.push_back({{"name", user.name},
                    {"role", role},
                    {"pin", user.has_pin},
                    {"created_utc", user.created_utc}});
    text.add_row(user.name + "  " + role + (user.has_pin ? "  PIN" : ""));
  }
  print_answer(options.common.json, json, text.empty() ? Lines("no accounts"_text) : text);
  return {};
}

Result<void> add(storage::Access& access, const AccountOptions& options) {
  const auto role = storage::role_from_name(options.role);
  if (!role)
    return refused("'%1' is no role"_text(options.role),
                   "give therapist, researcher or administrator"_text)
        .about("--role");
  const auto password = storage::Secret::from_file(options.new_file);
  if (!password) return password.error();
  const auto user = storage::add_user(access, options.name, *role, *password);
  if (!user) return user.error();
  print_answer(options.common.json, {{"name", user->name}, {"role", options.role}},
               "%1: %2"_text(user->name, options.role));
  return {};
}

Result<void> remove(storage::Access& access, const AccountOptions& options) {
  if (auto done = storage::remove_user(access, options.name); !done) return done;
  print_answer(options.common.json, {{"removed", options.name}}, "%1: removed"_text(options.name));
  return {};
}

Result<void> password(storage::Access& access, const AccountOptions& options) {
  const auto fresh = storage::Secret::from_file(options.new_file);
  if (!fresh) return fresh.error();
  Result<void> done;
  if (options.name.empty() || options.name == options.common.login.user) {
    const auto old = storage::Secret::from_file(options.common.login.password_file);
    if (!old) return old.error();
    done = storage::change_own_password(access, *old, *fresh);
  } else {
    done = storage::reset_password(access, options.name, *fresh);
  }
  if (!done) return done;
  print_answer(options.common.json, {{"changed", true}}, "the password was changed"_text);
  return {};
}

Result<void> pin(storage::Access& access, const AccountOptions& options) {
  storage::Secret fresh;
  if (!options.new_file.empty()) {
    auto read = storage::Secret::from_file(options.new_file);
    if (!read) return read.error();
    fresh = *std::move(read);
  }
  if (auto done = storage::set_own_pin(access, fresh); !done) return done;
  print_answer(options.common.json, {{"pin", !fresh.empty()}},
               fresh.empty() ? "there is no PIN any more"_text : "the PIN was set"_text);
  return {};
}

Result<void> passphrase(storage::Access& access, const AccountOptions& options) {
  const auto fresh = storage::Secret::from_file(options.new_file);
  if (!fresh) return fresh.error();
  if (auto done = storage::change_passphrase(access, *fresh); !done) return done;
  print_answer(options.common.json, {{"changed", true}},
               "the passphrase was changed; backups made before keep the one they had"_text);
  return {};
}

Result<void> recovery_key(storage::Access& access, const AccountOptions& options) {
  const auto key = storage::new_recovery_key(access);
  if (!key) return key.error();
  return hand_over(access, options.common.json, {},
                   "the recovery key of before opens nothing any more"_text, *key);
}

Result<void> policy(storage::Access& access, const AccountOptions& options) {
  auto now = access.policy();
  if (!now) return now.error();
  if (options.lock_after_s > 0 || options.retention_years >= 0) {
    if (options.lock_after_s > 0) now->lock_after_s = options.lock_after_s;
    if (options.retention_years >= 0) now->retention_years = options.retention_years;
    if (auto done = storage::set_policy(access, *now); !done) return done;
  }
  print_answer(
      options.common.json,
      {{"lock_after_s", now->lock_after_s}, {"retention_years", now->retention_years}},
      "lock after %1 s, keep records %2 years"_text(now->lock_after_s, now->retention_years));
  return {};
}

struct AuditOptions {
  AccessOptions common;
  storage::AuditFilter filter;
  std::string contains;
};

/// COUNT:HASH
Result<storage::AuditHead> head_in(const std::string& text) {
  const std::size_t colon = text.find(':');
  char* end = nullptr;
  storage::AuditHead head;
  head.count = std::strtoll(text.c_str(), &end, 10);
  constexpr std::size_t kDigits = 64;
  if (colon == std::string::npos || end != text.c_str() + colon || head.count < 1 ||
      text.size() - colon - 1 != kDigits)
    return refused("is no head of an audit log"_text,
                   "give COUNT:HASH as isograsp db audit printed it"_text)
        .about("--contains");
  head.hash = text.substr(colon + 1);
  return head;
}

Result<void> audit(storage::Access& access, const AuditOptions& options) {
  const auto entries = storage::read_audit(access, options.filter);
  if (!entries) return entries.error();
  const auto problems = storage::check_audit(access);
  if (!problems) return problems.error();
  const auto head = storage::audit_head(access);
  if (!head) return head.error();
  const auto key = storage::public_key_of(options.common.file);
  if (!key) return key.error();
  const std::string head_text = std::to_string(head->count) + ":" + head->hash;
  Json json{{"file", options.common.file},
            {"head", head_text},
            {"key", *key},
            {"problems", english_list(*problems)}};
  Lines text;
  Json list = Json::array();
  for (const storage::AuditEntry& entry : *entries) {
    list.push_back({{"number", entry.number},
                    {"at_utc", entry.at_utc},
                    {"actor", entry.actor},
                    {"role", entry.role},
                    {"act", entry.act},
                    {"object", entry.object},
                    {"result", entry.result},
                    {"detail", entry.detail},
                    {"hash", entry.hash}});
    text.add_row(std::to_string(entry.number) + "  " + entry.at_utc + "  " +
                 (entry.actor.empty() ? "-" : entry.actor) + "  " + entry.act +
                 (entry.object.empty() ? "" : " " + entry.object) + "  " + entry.result +
                 (entry.detail.empty() ? "" : "  (" + entry.detail + ")"));
  }
  json["entries"] = list;
  for (const auto& problem : *problems) text.add(problem);
  text.add("head %1"_text(head_text));
  if (!key->empty()) text.add("backups and exports are signed with the key %1"_text(*key));
  bool contained = true;
  if (!options.contains.empty()) {
    const auto noted = head_in(options.contains);
    if (!noted) return noted.error();
    const auto found = storage::audit_contains(access, *noted);
    if (!found) return found.error();
    contained = *found;
    json["contains"] = contained;
  }
  print_answer(options.common.json, json, text);
  if (problems->empty() && contained) return {};
  return failed(
             contained ? problems->front() : "the log does not hold the head that was noted"_text,
             "compare with the backups: isograsp db audit on each"_text)
      .at(options.common.file);
}

}  // namespace

Json english_list(const std::vector<Text>& texts) {
  Json list = Json::array();
  for (const Text& text : texts) list.push_back(english(text));
  return list;
}

void print_answer(bool as_json, const Json& json, const Lines& text) {
  if (as_json)
    print_json(json);
  else
    print_lines(text);
}

Subcommand add_access_options(Subcommand parent, const char* name, const char* description,
                              const char* example, AccessOptions& options) {
  Subcommand command = parent.subcommand(name, description);
  command.option("FILE", options.file, "Database file").required();
  command.flag("--json", options.json, "Print one JSON document");
  options.login.add_to(command);
  command.footer(std::string("Example:\n  isograsp db ") + example);
  return command;
}

void add_db_access(Subcommand db) {
  auto options = std::make_shared<AccountOptions>();
  Subcommand users = db.subcommand("users", "Accounts of a protected database");
  users.requires_subcommand();
  const auto add_one = [&](Subcommand parent, const char* name, const char* description,
                           const char* example, auto work) {
    return add_access_command<AccountOptions>(parent, name, description, example, options, work);
  };
  add_one(users, "list", "Who has an account", "users list clinic.db --passphrase-file P",
          list_users);
  Subcommand made = add_one(users, "add", "A new account",
                            "users add clinic.db --name Ada --role therapist "
                            "--new-password-file ADA --passphrase-file P",
                            add);
  made.option("--name", options->name, "As the audit log shall name the person").required();
  made.option("--role", options->role, "therapist, researcher or administrator").shows_default();
  made.option("--new-password-file", options->new_file, "File with the password").required();
  add_one(users, "remove", "Remove an account; its name is not given again",
          "users remove clinic.db --name Ada --passphrase-file P", remove)
      .option("--name", options->name, "Account")
      .required();
  Subcommand changed = add_one(users, "password", "A new password, one's own or another's",
                               "users password clinic.db --user Ada --password-file OLD "
                               "--new-password-file NEW",
                               password);
  changed.option("--name", options->name, "Account; without it, one's own");
  changed.option("--new-password-file", options->new_file, "File with it").required();
  add_one(users, "pin", "One's own PIN, for changing the user in the windows",
          "users pin clinic.db --user Ada --password-file ADA --new-pin-file PIN", pin)
      .option("--new-pin-file", options->new_file, "File with 4 to 12 digits; without: none");
  add_one(db, "passphrase", "Change the clinic's passphrase",
          "passphrase clinic.db --passphrase-file OLD --new-passphrase-file NEW", passphrase)
      .option("--new-passphrase-file", options->new_file, "File with it")
      .required();
  add_one(db, "recovery-key", "A new recovery key in place of the one before",
          "recovery-key clinic.db --passphrase-file P", recovery_key);
  Subcommand decided = add_one(db, "policy", "Time of the lock, years that records are kept",
                               "policy clinic.db --retention-years 10 --passphrase-file P", policy);
  decided.option("--lock-after", options->lock_after_s, "Seconds without a touch [s]")
      .range(30, 86400);
  decided.option("--retention-years", options->retention_years, "After the last record")
      .range(0, 100);

  auto audit_options = std::make_shared<AuditOptions>();
  Subcommand printed =
      add_access_command<AuditOptions>(db, "audit", "Print and prove the audit log",
                                       "audit clinic.db --passphrase-file P", audit_options, audit);
  printed.option("--act", audit_options->filter.act, "Only this act, e.g. 'read identity'");
  printed.option("--object", audit_options->filter.object, "Only of this code or name");
  printed.option("--contains", audit_options->contains,
                 "COUNT:HASH, a head that was printed earlier: is it part of this log?");
}

}  // namespace isograsp::app
