// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `isograsp`. Each add_… puts one on the command line; its action returns what
// went wrong, and main() turns that into a line on standard error and an exit status.
#pragma once

#include <functional>
#include <string>

#include "core/result.hpp"

namespace CLI {
class App;
}

namespace isograsp {

/// What the chosen subcommand does; set by its callback, run by main() after parsing.
using Action = std::function<Result<void>()>;

// Each is defined in app/<name>.cpp.
void add_convert(CLI::App& app, Action& action);
void add_db(CLI::App& app, Action& action);
void add_decode(CLI::App& app, Action& action);
void add_demo(CLI::App& app, Action& action);
void add_devices(CLI::App& app, Action& action);
void add_emulate(CLI::App& app, Action& action);
void add_export(CLI::App& app, Action& action);
void add_grasp(CLI::App& app, Action& action);
void add_gui(CLI::App& app, Action& action);
void add_import(CLI::App& app, Action& action);
void add_monitor(CLI::App& app, Action& action);
void add_record(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_score(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_study(CLI::App& app, Action& action);
void add_target(CLI::App& app, Action& action);

/// A few simulated patients with a few sessions each, in a file of its own that replaces an older
/// one; its path (app/demo.cpp).
[[nodiscard]] Result<std::string> make_small_clinic();

/// Opens the therapist application; empty: the default database, no device chosen (app/gui.cpp).
[[nodiscard]] Result<void> run_gui(const std::string& database, const std::string& device);

}  // namespace isograsp
