// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db init --protected, protect: where a protected database comes from.
#include <nlohmann/json.hpp>

#include "app/db/db_commands.hpp"
#include "storage/access/accounts.hpp"
#include "storage/access/protection.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

Result<storage::Secret> passphrase_of(const AccessOptions& options, const char* field) {
  if (options.login.passphrase_file.empty())
    return refused("no passphrase is given"_text,
                   "write it into a file that only you may read and give --passphrase-file"_text)
        .about(field);
  return storage::Secret::from_file(options.login.passphrase_file);
}

Result<void> protect(const AccessOptions& options) {
  const auto passphrase = passphrase_of(options, "--passphrase-file");
  if (!passphrase) return passphrase.error();
  const auto done = storage::protect_database(options.file, *passphrase);
  if (!done) return done.error();
  Json json{{"file", options.file},
            {"protected", true},
            {"swept", !done->not_swept},
            {"copy", done->copy},
            {"remains", done->remains}};
  if (done->recovery_key.empty()) {
    print_answer(options.json, json, "%1: is protected already"_text(options.file));
  } else {
    Lines text = "%1: protected; as it was, in plain text: %2"_text(options.file, done->copy);
    text.add("What still holds plain text, and is for you to lock away or remove:"_text);
    for (const auto& one : done->remains) text.add_row("  " + one);
    if (done->copy.empty())
      text = "%1: is protected already, but had no recovery key"_text(options.file);
    if (auto shown = hand_over(*done->access, options.json, json, text, done->recovery_key); !shown)
      return shown;
  }
  if (done->not_swept) return *done->not_swept;
  return {};
}

}  // namespace

Result<void> init_protected(const AccessOptions& options) {
  const auto passphrase = passphrase_of(options, "--protected");
  if (!passphrase) return passphrase.error();
  const auto made = storage::Access::create(options.file, *passphrase);
  if (!made) return made.error();
  return hand_over(
      *made->access, options.json,
      {{"file", options.file}, {"format", storage::kDatabaseFormat}, {"protected", true}},
      "%1: made, format %2, protected"_text(options.file, storage::kDatabaseFormat),
      made->recovery_key);
}

Result<void> hand_over(storage::Access& access, bool as_json, Json json, Lines text,
                       const storage::Secret& key) {
  json["recovery_key"] = std::string(key.text());
  text.add("recovery key: %1"_text(std::string(key.text())));
  text.add("Print it and lock it away: it is shown this once and opens everything."_text);
  print_answer(as_json, json, text);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return failed("the recovery key could not be shown, so there is none yet"_text,
                  "make one: isograsp db recovery-key"_text);
  return storage::accept_recovery_key(access, key);
}

void add_db_protect(Subcommand db) {
  auto options = std::make_shared<AccessOptions>();
  Subcommand command = add_access_options(
      db, "protect", "Give a database that was made without it a passphrase; seal its texts",
      "protect clinic.db --passphrase-file P", *options);
  command.runs([options] { return protect(*options); });
}

}  // namespace isograsp::app
