// SPDX-License-Identifier: GPL-3.0-or-later
// The one executable: parses the command line, runs the chosen subcommand, reports its error.
#include <sys/stat.h>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/stop_signals.hpp"

int main(int argc, char** argv) {
  // What it makes, files and folders alike, holds people's records: for their owner only.
  umask(S_IRWXG | S_IRWXO);
  isograsp::let_writes_fail();
  isograsp::CommandLine line(
      "IsoGrasp: assessment and training of hand dexterity with isometric finger forces",
      "isograsp " ISOGRASP_VERSION);
  isograsp::add_convert(line);
  isograsp::add_db(line);
  isograsp::add_decode(line);
  isograsp::add_demo(line);
  isograsp::add_devices(line);
  isograsp::add_emulate(line);
  isograsp::add_export(line);
  isograsp::add_grasp(line);
  isograsp::add_gui(line);
  isograsp::add_import(line);
  isograsp::add_monitor(line);
  isograsp::add_record(line);
  isograsp::add_report(line);
  isograsp::add_run(line);
  isograsp::add_score(line);
  isograsp::add_simulate(line);
  isograsp::add_study(line);
  isograsp::add_target(line);

  const auto action = line.parse(argc, argv);
  if (!action) return isograsp::print_error(action.error());
  try {
    const auto done = *action ? (*action)() : isograsp::run_gui("", "");
    return done ? 0 : isograsp::print_error(done.error());
  } catch (const std::exception& unforeseen) {  // such as no memory
    return isograsp::print_error({isograsp::Error::Code::failed,
                                  std::string("unexpected: ") + unforeseen.what(),
                                  "report it (SECURITY.md if a file caused it)", "", 0, ""});
  }
}
