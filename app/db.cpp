// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db: care of the database. Nothing here but `init`, `backup` and `migrate` writes a file.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/verification.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

namespace {

using Json = nlohmann::ordered_json;

struct DbOptions {
  std::string file;
  std::string to;
  bool protected_file = false;
  bool json = false;
  int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

void print(const DbOptions& options, const Json& json, const std::string& text) {
  std::fputs(((options.json ? json.dump(2) : text) + "\n").c_str(), stdout);
}

Result<std::unique_ptr<SessionStore>> read_store(const std::string& file) {
  return SessionStore::open_to_read(file);
}

Result<void> init(const DbOptions& options) {
  if (options.protected_file)
    return Error{Error::Code::bad_input,
                 "protected databases are not available in this version",
                 "make one without --protected and keep it on an encrypted disk",
                 "",
                 0,
                 "--protected"};
  std::error_code ignored;
  if (std::filesystem::exists(options.file, ignored))
    return Error{Error::Code::bad_input, "exists already", "name a new file", options.file, 0, ""};
  const auto store = SessionStore::open(options.file, SessionStore::Open::create);
  if (!store) return store.error();
  print(options, {{"file", options.file}, {"format", kDatabaseFormat}},
        options.file + ": made, format " + std::to_string(kDatabaseFormat));
  return {};
}

Result<void> check(const DbOptions& options) {
  const auto store = read_store(options.file);
  if (!store) return store.error();
  const auto problems = (*store)->check();
  if (!problems) return problems.error();
  std::string text = problems->empty() ? options.file + ": sound" : "";
  for (const auto& problem : *problems) text += (text.empty() ? "" : "\n") + problem;
  print(options, {{"file", options.file}, {"problems", *problems}}, text);
  if (problems->empty()) return {};
  return Error{Error::Code::failed,
               "the check found " + std::to_string(problems->size()) +
                   (problems->size() == 1 ? " problem" : " problems"),
               "restore the last backup, or export what can still be read",
               options.file,
               0,
               ""};
}

Result<void> verify(const DbOptions& options) {
  const auto verified = verify_database(options.file, options.threads);
  if (!verified) return verified.error();
  const Verification& result = *verified;
  char largest[32];
  std::snprintf(largest, sizeof largest, "%.3g", result.largest_relative_difference);
  std::string text = options.file + ": " + std::to_string(result.trials) + " trials, " +
                     std::to_string(result.measures) + " measures, " +
                     std::to_string(result.identical) + " identical to the bit; " +
                     "largest relative difference " + largest;
  if (!result.largest_at.empty()) text += " (" + result.largest_at + ")";
  if (result.other_version > 0)
    text += "\n" + std::to_string(result.other_version) +
            " measures were made by another version of their definition and are not compared";
  for (const auto& problem : result.problems) text += "\n" + problem;
  print(options,
        {{"file", options.file},
         {"trials", result.trials},
         {"measures", result.measures},
         {"identical", result.identical},
         {"other_version", result.other_version},
         {"largest_relative_difference", result.largest_relative_difference},
         {"problems", result.problems}},
        text);
  if (result.problems.empty()) return {};
  return Error{Error::Code::failed,
               std::to_string(result.problems.size()) +
                   " stored results are not those that the stored signals give (first: " +
                   result.problems.front() + ")",
               "run isograsp db check; compare the software versions of the sessions",
               options.file,
               0,
               ""};
}

Result<void> backup(const DbOptions& options) {
  const auto store = read_store(options.file);
  if (!store) return store.error();
  if (const auto done = (*store)->backup(options.to); !done) return done.error();
  print(options, {{"file", options.file}, {"backup", options.to}},
        options.to + ": copied from " + options.file + " and checked");
  return {};
}

Result<void> migrate(const DbOptions& options) {
  const auto done = SessionStore::migrate(options.file);
  if (!done) return done.error();
  const bool migrated = !done->copy.empty();
  const std::string format = "format " + std::to_string(kDatabaseFormat);
  Json json{{"file", options.file}, {"format", kDatabaseFormat}, {"migrated", migrated}};
  if (migrated) json["copy"] = done->copy;
  print(options, json,
        migrated ? options.file + ": brought from format " + std::to_string(done->from) + " to " +
                       format + "; as it was: " + done->copy
                 : options.file + ": " + format + " is current; nothing to migrate");
  return {};
}

}  // namespace

void add_db(CLI::App& app, Action& action) {
  auto options = std::make_shared<DbOptions>();
  CLI::App* db = app.add_subcommand("db", "Care of the database");
  db->require_subcommand(1);
  db->footer("Example:\n  isograsp db backup clinic.db --to clinic-monday.db");
  const auto add = [&](const char* name, const char* description, const char* example,
                       Result<void> (*work)(const DbOptions&)) {
    CLI::App* command = db->add_subcommand(name, description);
    command->add_option("FILE", options->file, "Database file")->required();
    command->add_flag("--json", options->json, "Print one JSON document");
    command->footer(std::string("Example:\n  isograsp db ") + example);
    command->callback(
        [options, work, &action] { action = [options, work] { return work(*options); }; });
    return command;
  };
  add("init", "Make an empty database", "init clinic.db", init)
      ->add_flag("--protected", options->protected_file, "With a passphrase");
  add("check", "Is the file sound, every block readable", "check clinic.db", check);
  add("verify", "Recompute every measure from the stored signals and compare", "verify clinic.db",
      verify)
      ->add_option("--threads", options->threads, "How many; the result is the same")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  add("backup", "Copy to a new file while others work, and check the copy",
      "backup clinic.db --to clinic-monday.db", backup)
      ->add_option("--to", options->to, "File to make")
      ->required();
  add("migrate", "Bring the file to the format of this program", "migrate clinic.db", migrate);
}

}  // namespace isograsp
