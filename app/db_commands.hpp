// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `isograsp db` that stand in files of their own.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/commands.hpp"
#include "app/login_options.hpp"

namespace isograsp {

/// Accounts, passphrase, policy, audit log (app/db_access.cpp).
void add_db_access(CLI::App& db, Action& action);
/// Protecting a database that was made without (app/db_protect.cpp).
void add_db_protect(CLI::App& db, Action& action);
/// Identity, consent, erasure, export of one person (app/db_person.cpp).
void add_db_person(CLI::App& db, Action& action);

/// What every such command is given.
struct AccessOptions {
  std::string file;
  bool json = false;
  LoginOptions login;
};

/// A subcommand NAME FILE [--json] with the options of the login. `Options` has a member `common`.
template <class Options>
CLI::App* add_access_command(CLI::App& parent, Action& action, const char* name,
                             const char* description, const char* example,
                             const std::shared_ptr<Options>& options,
                             Result<void> (*work)(Access&, const Options&)) {
  CLI::App* command = add_access_options(parent, name, description, example, options->common);
  set_action(*command, action, [options, work]() -> Result<void> {
    const auto access = open_access(options->common.file, options->common.login);
    if (!access) return access.error();
    return work(**access, *options);
  });
  return command;
}
[[nodiscard]] CLI::App* add_access_options(CLI::App& parent, const char* name,
                                           const char* description, const char* example,
                                           AccessOptions& options);
void set_action(CLI::App& command, Action& action, Action work);

/// Makes a protected database and prints its recovery key, once (app/db_protect.cpp).
[[nodiscard]] Result<void> init_protected(const AccessOptions& options);
void print_recovery_key(bool as_json, nlohmann::ordered_json json, const std::string& text,
                        const Secret& key);

/// Prints one or the other.
void print_answer(bool as_json, const nlohmann::ordered_json& json, const std::string& text);

}  // namespace isograsp
