// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db: care of the database. `init`, `backup`, `restore`, `migrate` and `merge` write
// files; the others only read. Protection: db_protect.cpp; accounts and the audit log:
// db_access.cpp; people: db_person.cpp.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/db/db_commands.hpp"
#include "app/db/verification.hpp"
#include "app/login_options.hpp"
#include "core/files.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/access/signing.hpp"
#include "storage/care/backups.hpp"
#include "storage/care/merge.hpp"
#include "storage/care/migration.hpp"
#include "storage/file/file_stats.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct DbOptions {
  std::string file;
  std::string to;
  std::string from;
  std::vector<std::string> same_patients;
  bool by_signature = false;
  std::string key;
  bool scheduled = false;
  bool protected_file = false;
  LoginOptions login;
  bool json = false;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

Result<std::unique_ptr<storage::SessionStore>> read_store(const std::string& file) {
  return storage::open_store_to_read(file);
}

Result<void> init(const DbOptions& options) {
  if (options.protected_file) return init_protected({options.file, options.json, options.login});
  if (options.login.given())
    return refused("a database without protection asks for no login"_text,
                   "add --protected, or leave the login out"_text)
        .about("--passphrase-file");
  std::error_code ignored;
  if (std::filesystem::exists(options.file, ignored))
    return refused("exists already"_text, "name a new file"_text).at(options.file);
  const auto store = storage::open_store(options.file, storage::OpenMode::create);
  if (!store) return store.error();
  print_answer(options.json, {{"file", options.file}, {"format", storage::kDatabaseFormat}},
               "%1: made, format %2"_text(options.file, storage::kDatabaseFormat));
  return {};
}

/// A backup by its signature alone: needs no login and opens nothing.
Result<void> check_signed(const DbOptions& options) {
  const auto proved =
      storage::check_signature(options.file, storage::SignedKind::backup, options.key);
  if (!proved) return proved.error();
  Lines text = "%1: a backup, as it was signed on %2"_text(options.file, proved->made_utc);
  text.add(words_of_key(proved->key, !options.key.empty()));
  print_answer(options.json,
               {{"file", options.file},
                {"made_utc", proved->made_utc},
                {"key", proved->key},
                {"key_was_given", !options.key.empty()}},
               text);
  return {};
}

Result<void> check(const DbOptions& options) {
  if (options.by_signature) return check_signed(options);
  const auto access = log_in(options.file, options.login);
  if (!access) return access.error();
  const auto store = read_store(options.file);
  if (!store) return store.error();
  const auto problems = (*store)->check();
  if (!problems) return problems.error();
  Lines text;
  if (problems->empty()) text.add("%1: sound"_text(options.file));
  for (const auto& problem : *problems) text.add(problem);
  print_answer(options.json, {{"file", options.file}, {"problems", english_list(*problems)}}, text);
  if (problems->empty()) return {};
  return failed(problems->size() == 1 ? Text("the check found 1 problem"_text)
                                      : "the check found %1 problems"_text(problems->size()),
                "restore the last backup, or export what can still be read"_text)
      .at(options.file);
}

Result<void> verify(const DbOptions& options) {
  const auto access = log_in(options.file, options.login);
  if (!access) return access.error();
  const auto verified = verify_database(options.file, options.threads);
  if (!verified) return verified.error();
  const Verification& result = *verified;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.3g", result.largest_relative_difference);
  const Number largest{digits};
  Lines text =
      result.largest_at.empty()
          ? "%1: %2 trials, %3 measures, %4 identical to the bit; largest relative difference %5"_text(
                options.file, result.trials, result.measures, result.identical, largest)
          : "%1: %2 trials, %3 measures, %4 identical to the bit; largest relative difference %5 (%6)"_text(
                options.file, result.trials, result.measures, result.identical, largest,
                result.largest_at);
  if (result.older_version > 0)
    text.add(
        "%1 measures were stored by an older version of their definition; reports compute them "
        "again from the signals and keep both, %2 of them have another value then"_text(
            result.older_version, result.older_changed));
  if (result.newer_version > 0)
    text.add(
        "%1 measures were stored by a newer version of their definition and are not compared; "
        "update the program"_text(result.newer_version));
  for (const auto& problem : result.problems) text.add(problem);
  print_answer(options.json,
               {{"file", options.file},
                {"trials", result.trials},
                {"measures", result.measures},
                {"identical", result.identical},
                {"older_version", result.older_version},
                {"older_changed", result.older_changed},
                {"newer_version", result.newer_version},
                {"largest_relative_difference", result.largest_relative_difference},
                {"problems", english_list(result.problems)}},
               text);
  if (result.problems.empty()) return {};
  return failed("%1 stored results are not those that the stored signals give (first: %2)"_text(
                    result.problems.size(), result.problems.front()),
                "run isograsp db check; compare the software versions of the sessions"_text)
      .at(options.file);
}

/// Of a backup that was made just now.
void add_signature_of(const std::string& backup, Json& json, Lines& text) {
  const auto signature = read_text(storage::signature_file_of(backup));
  const auto read = signature ? storage::signature_in(*signature) : std::nullopt;
  json["key"] = read ? read->key : "";
  if (read)
    text.add("signed with the key %1"_text(read->key));
  else
    text.add("not signed: no key could be made beside the database"_text);
}

Result<void> scheduled_backup(const DbOptions& options) {
  const auto made = storage::Backups(options.file).make_if_due(std::time(nullptr));
  if (!made) return made.error();
  Json json{{"file", options.file}, {"made", made->has_value()}};
  Lines text = "%1: there is a backup of today already"_text(options.file);
  if (*made) {
    json["backup"] = (*made)->backup.path;
    json["removed"] = (*made)->removed;
    text = "%1: copied from %2 and checked"_text((*made)->backup.path, options.file);
    add_signature_of((*made)->backup.path, json, text);
    for (const auto& old : (*made)->removed) text.add("%1: removed"_text(old));
  }
  print_answer(options.json, json, text);
  return {};
}

Result<void> backup(const DbOptions& options) {
  const auto access = log_in(options.file, options.login);
  if (!access) return access.error();
  if (options.scheduled) return scheduled_backup(options);
  if (options.to.empty())
    return refused("no file for the backup is given"_text,
                   "name one with --to, or let --scheduled choose it"_text)
        .about("--to");
  const auto store = read_store(options.file);
  if (!store) return store.error();
  if (const auto done = (*store)->backup(options.to); !done) return done.error();
  Json json{{"file", options.file}, {"backup", options.to}};
  Lines text = "%1: copied from %2 and checked"_text(options.to, options.file);
  add_signature_of(options.to, json, text);
  print_answer(options.json, json, text);
  return {};
}

Result<void> restore(const DbOptions& options) {
  const auto done = storage::restore_backup(
      options.from, options.file,
      [&options](const std::string& copy) { return open_access(copy, options.login, true); });
  if (!done) return done.error();
  Json json{{"file", options.file}, {"restored_from", options.from}, {"key", done->key}};
  Lines text = "%1: restored from %2 and checked"_text(options.file, options.from);
  if (!done->kept.empty()) {
    json["kept"] = done->kept;
    text = "%1: restored from %2 and checked; as it was: %3"_text(options.file, options.from,
                                                                  done->kept);
  }
  text.add(done->key.empty() ? Text("the backup was not signed"_text)
                             : "signed with the key %1"_text(done->key));
  text.add("Erase again who has been erased since that backup was made."_text);
  print_answer(options.json, json, text);
  return {};
}

Result<void> stats(const DbOptions& options) {
  const auto counted = storage::file_stats(options.file);
  if (!counted) return counted.error();
  const storage::FileStats& all = *counted;
  constexpr double kMega = 1e6;
  constexpr double kMinute_s = 60.0;
  const auto rounded = [](auto value, double unit) {
    return fixed(static_cast<double>(value) / unit, 2);
  };
  Lines text = "%1: format %2, %3 MB (%4 MB of it free, %5 MB signals)"_text(
      options.file, all.format, rounded(all.file_bytes, kMega), rounded(all.free_bytes, kMega),
      rounded(all.signal_bytes, kMega));
  text.add("%1 patients, %2 sessions, %3 trials, %4 measures, %5 events"_text(
      all.patients, all.sessions, all.trials, all.measures, all.events));
  text.add("%1 minutes recorded, %2 MB per minute"_text(rounded(all.recorded_s, kMinute_s),
                                                        rounded(all.bytes_per_minute(), kMega)));
  if (!all.first_session_utc.empty())
    text.add("first session %1, last %2"_text(all.first_session_utc, all.last_session_utc));
  if (all.trials_not_packed > 0)
    text.add("%1 trials are not packed; isograsp db migrate does it"_text(all.trials_not_packed));
  print_answer(options.json,
               {{"file", options.file},
                {"format", all.format},
                {"file_bytes", all.file_bytes},
                {"free_bytes", all.free_bytes},
                {"signal_bytes", all.signal_bytes},
                {"patients", all.patients},
                {"sessions", all.sessions},
                {"trials", all.trials},
                {"trials_not_packed", all.trials_not_packed},
                {"measures", all.measures},
                {"events", all.events},
                {"values", all.values},
                {"recorded_s", all.recorded_s},
                {"bytes_per_minute", all.bytes_per_minute()},
                {"first_session_utc", all.first_session_utc},
                {"last_session_utc", all.last_session_utc}},
               text);
  return {};
}

Result<void> merge(const DbOptions& options) {
  const auto done = storage::merge_databases(options.file, options.from, options.same_patients);
  if (!done) return done.error();
  Lines text;
  if (done->conflicts.empty())
    text.add(
        "%1: %2 patients, %3 sessions, %4 trials added from %5; %6 trials were there already"_text(
            options.file, done->patients_added, done->sessions_added, done->trials_added,
            options.from, done->trials_present));
  for (const auto& conflict : done->conflicts) text.add(conflict);
  print_answer(options.json,
               {{"file", options.file},
                {"from", options.from},
                {"patients_added", done->patients_added},
                {"sessions_added", done->sessions_added},
                {"trials_added", done->trials_added},
                {"trials_present", done->trials_present},
                {"conflicts", english_list(done->conflicts)}},
               text);
  if (done->conflicts.empty()) return {};
  return failed(done->conflicts.size() == 1
                    ? Text("nothing was merged: 1 conflict"_text)
                    : "nothing was merged: %1 conflicts"_text(done->conflicts.size()),
                "make both files agree, then merge again"_text)
      .at(options.file);
}

Result<void> migrate(const DbOptions& options) {
  const auto access = log_in_to_migrate(options.file, options.login);
  if (!access) return access.error();
  const auto done = storage::migrate_database(options.file);
  if (!done) return done.error();
  const bool migrated = !done->copy.empty();
  Json json{{"file", options.file},
            {"format", storage::kDatabaseFormat},
            {"migrated", migrated},
            {"packed", done->packed},
            {"not_packed", english_list(done->not_packed)}};
  if (migrated) json["copy"] = done->copy;
  Lines text = migrated ? "%1: brought from format %2 to format %3; as it was: %4"_text(
                              options.file, done->from, storage::kDatabaseFormat, done->copy)
                        : "%1: format %2 is current; nothing to migrate"_text(
                              options.file, storage::kDatabaseFormat);
  if (done->packed > 0) text.add("signals of %1 trials packed"_text(done->packed));
  for (const auto& problem : done->not_packed) text.add("not packed: %1"_text(problem));
  print_answer(options.json, json, text);
  return {};
}

}  // namespace

void add_db(CommandLine& line) {
  auto options = std::make_shared<DbOptions>();
  Subcommand db = line.subcommand("db", "Care of the database");
  db.requires_subcommand();
  db.footer("Example:\n  isograsp db backup clinic.db --to clinic-monday.db");
  const auto add = [&](const char* name, const char* description, const char* example,
                       Result<void> (*work)(const DbOptions&)) {
    Subcommand command = db.subcommand(name, description);
    command.option("FILE", options->file, "Database file").required();
    command.flag("--json", options->json, "Print one JSON document");
    options->login.add_to(command);
    command.footer(std::string("Example:\n  isograsp db ") + example);
    command.runs([options, work] { return work(*options); });
    return command;
  };
  add("init", "Make an empty database", "init clinic.db", init)
      .flag("--protected", options->protected_file,
            "With a passphrase (--passphrase-file), accounts and encrypted identities");
  Subcommand checked =
      add("check", "Is the file sound, every block readable", "check clinic.db", check);
  const Option by_signature =
      checked.flag("--signed", options->by_signature,
                   "Of a backup: is it what was signed (FILE.sig)? Needs no login");
  checked.option("--key", options->key, "Public key that it must be signed with (64 digits)")
      .check(objection_to_key)
      .needs(by_signature);
  add("verify", "Recompute every measure from the stored signals and compare", "verify clinic.db",
      verify)
      .option("--threads", options->threads, "How many; the result is the same")
      .range(1, 64)
      .shows_default();
  Subcommand copy = add("backup", "Copy to a new file while others work, and check the copy",
                        "backup clinic.db --to clinic-monday.db", backup);
  const Option to = copy.option("--to", options->to, "File to make");
  copy.flag("--scheduled", options->scheduled,
            "Once a day into FILE.backups; keeps 7 days, 4 weeks, 12 months")
      .excludes(to);
  add("restore", "Put a checked copy of a backup in place of the file, which is kept",
      "restore clinic.db --from clinic-monday.db", restore)
      .option("--from", options->from, "Backup")
      .required();
  add("stats", "Sizes, counts, bytes per minute", "stats clinic.db", stats);
  Subcommand merging = add("merge", "Take in what another station recorded; twice is once",
                           "merge clinic.db --from station-2.db", merge);
  merging.option("--from", options->from, "Database of the other station").required();
  merging.option("--same-patient", options->same_patients,
                 "Code that means the same person in both files, though each made it itself");
  add("migrate", "Bring the file to the format of this program", "migrate clinic.db", migrate);
  add_db_rescue(db);
  add_db_protect(db);
  add_db_access(db);
  add_db_person(db);
}

}  // namespace isograsp::app
