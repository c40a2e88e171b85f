// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db rescue: puts sessions of emergency files back into the database that had disappeared.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/db/db_commands.hpp"
#include "storage/care/emergency.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct RescueOptions {
  AccessOptions common;
  bool list = false;
};

Text line_of(const storage::EmergencyFile& file) {
  if (file.has_whole)
    return "%1: session of %2 that began %3, %4 trials, and a copy of the whole database; recorded into %5, left because: %6"_text(
        file.path, file.patient_code, file.started_utc, file.trials, file.database,
        Known{file.reason});
  return "%1: session of %2 that began %3, %4 trials; recorded into %5, left because: %6"_text(
      file.path, file.patient_code, file.started_utc, file.trials, file.database,
      Known{file.reason});
}

Json json_of(const storage::EmergencyFile& file) {
  return {{"path", file.path},
          {"database", file.database},
          {"patient", file.patient_code},
          {"started_utc", file.started_utc},
          {"trials", file.trials},
          {"whole", file.has_whole ? file.whole() : ""},
          {"reason", file.reason}};
}

Result<void> take_in(const std::string& database, const storage::EmergencyFile& file, Json& json,
                     Lines& text) {
  const auto done = storage::rescue(database, file);
  if (!done) return done.error();
  if (!done->conflicts.empty())
    return failed("nothing of %1 was taken in: %2"_text(file.path, done->conflicts.front()),
                  "make both files agree, then rescue again; the emergency file stays"_text)
        .at(database);
  Json one = json_of(file);
  one["trials_added"] = done->trials_added;
  one["trials_present"] = done->trials_present;
  json["rescued"].push_back(std::move(one));
  text.add("%1: session of %2 that began %3: %4 trials added, %5 were there already"_text(
      database, file.patient_code, file.started_utc, done->trials_added, done->trials_present));
  return {};
}

Result<void> rescue_all(const RescueOptions& options) {
  const std::string& database = options.common.file;
  const auto files = storage::emergency_files(database);
  Json json{{"file", database}};
  Lines text;
  if (options.list) {
    json["emergency_files"] = Json::array();
    for (const storage::EmergencyFile& file : files) {
      json["emergency_files"].push_back(json_of(file));
      text.add(line_of(file));
    }
  } else {
    json["rescued"] = Json::array();
    std::unique_ptr<storage::Access> access;
    for (const storage::EmergencyFile& file : files) {
      if (auto there = storage::put_back(database, file); !there) return there;
      if (access == nullptr && storage::is_protected_database(database)) {
        auto opened = log_in(database, options.common.login);
        if (!opened) return opened.error();
        access = *std::move(opened);
      }
      if (auto done = take_in(database, file, json, text); !done) return done;
    }
  }
  if (files.empty())
    text = "%1: no session of it is in %2"_text(database, storage::emergency_folder());
  print_answer(options.common.json, json, text);
  return {};
}

}  // namespace

void add_db_rescue(Subcommand db) {
  auto options = std::make_shared<RescueOptions>();
  Subcommand command = add_access_options(
      db, "rescue", "Take in sessions whose file was taken away while they were recorded",
      "rescue clinic.db", options->common);
  command.flag("--list", options->list, "Only say which there are");
  command.runs([options] { return rescue_all(*options); });
}

}  // namespace isograsp::app
