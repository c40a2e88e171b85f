// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of `isograsp`. Each add_… puts one on the command line; its action returns what
// went wrong, and main() turns that into a line on standard error and an exit status.
#pragma once

#include <string>

#include "app/command_line.hpp"
#include "core/result.hpp"

namespace isograsp::app {

// Each is defined in app/<name>.cpp, or in a room of that name.
void add_convert(CommandLine& line);
void add_db(CommandLine& line);
void add_decode(CommandLine& line);
void add_demo(CommandLine& line);
void add_devices(CommandLine& line);
void add_emulate(CommandLine& line);
void add_export(CommandLine& line);
void add_grasp(CommandLine& line);
void add_gui(CommandLine& line);
void add_hand(CommandLine& line);
void add_import(CommandLine& line);
void add_markers(CommandLine& line);
void add_monitor(CommandLine& line);
void add_record(CommandLine& line);
void add_report(CommandLine& line);
void add_run(CommandLine& line);
void add_score(CommandLine& line);
void add_simulate(CommandLine& line);
void add_study(CommandLine& line);
void add_target(CommandLine& line);
void add_patch(CommandLine& line);
void add_pad_bench(CommandLine& line);
void add_verify_export(CommandLine& line);

/// Whose key a signature was made with, as far as that is known.
[[nodiscard]] Text words_of_key(const std::string& key, bool was_given);
/// What is wrong with `--key`; an empty one would be none.
[[nodiscard]] std::string objection_to_key(const std::string& key);

/// The demonstration clinic of simulated people, in a file of its own that replaces an older
/// one; its path (app/demo.cpp).
[[nodiscard]] Result<std::string> make_small_clinic();

/// Opens the therapist application; empty: the default database, no device chosen (app/gui.cpp).
[[nodiscard]] Result<void> run_gui(const std::string& database, const std::string& device);

}  // namespace isograsp::app
