// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `isograsp db` that stand in files of their own.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/command_line.hpp"
#include "app/console.hpp"
#include "app/login_options.hpp"

namespace isograsp::app {

/// Accounts, passphrase, policy, audit log (app/db/db_access.cpp).
void add_db_access(Subcommand db);
/// Protects a database that was made without protection (app/db/db_protect.cpp).
void add_db_protect(Subcommand db);
/// Identity, consent, erasure, export of one person (app/db/db_person.cpp).
void add_db_person(Subcommand db);

/// Sessions in emergency files (app/db/db_rescue.cpp).
void add_db_rescue(Subcommand db);

/// What every such command is given.
struct AccessOptions {
  std::string file;
  bool json = false;
  LoginOptions login;
};

/// A subcommand NAME FILE [--json] with the options of the login. `Options` has a member `common`.
template <class Options>
Subcommand add_access_command(Subcommand parent, const char* name, const char* description,
                              const char* example, const std::shared_ptr<Options>& options,
                              Result<void> (*work)(storage::Access&, const Options&)) {
  Subcommand command = add_access_options(parent, name, description, example, options->common);
  command.runs([options, work]() -> Result<void> {
    const auto access = open_access(options->common.file, options->common.login);
    if (!access) return access.error();
    return work(**access, *options);
  });
  return command;
}
[[nodiscard]] Subcommand add_access_options(Subcommand parent, const char* name,
                                            const char* description, const char* example,
                                            AccessOptions& options);

/// Makes a protected database and prints its recovery key, once (app/db/db_protect.cpp).
[[nodiscard]] Result<void> init_protected(const AccessOptions& options);
/// Prints it, then lets it open the database: a program that is ended between leaves none that
/// nobody has seen.
[[nodiscard]] Result<void> hand_over(storage::Access& access, bool as_json,
                                     nlohmann::ordered_json json, Lines text,
                                     const storage::Secret& key);

/// The texts in English, for --json.
[[nodiscard]] nlohmann::ordered_json english_list(const std::vector<Text>& texts);
/// Prints the JSON or the text.
void print_answer(bool as_json, const nlohmann::ordered_json& json, const Lines& text);

}  // namespace isograsp::app
