// SPDX-License-Identifier: GPL-3.0-or-later
// The one executable: parses the command line, runs the chosen subcommand, reports its error.
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"

int main(int argc, char** argv) {
  CLI::App app{"IsoGrasp: assessment and training of hand dexterity with isometric finger forces"};
  app.set_version_flag("--version", "isograsp " ISOGRASP_VERSION);
  isograsp::Action action;
  isograsp::add_convert(app, action);
  isograsp::add_db(app, action);
  isograsp::add_decode(app, action);
  isograsp::add_demo(app, action);
  isograsp::add_devices(app, action);
  isograsp::add_emulate(app, action);
  isograsp::add_export(app, action);
  isograsp::add_grasp(app, action);
  isograsp::add_gui(app, action);
  isograsp::add_import(app, action);
  isograsp::add_monitor(app, action);
  isograsp::add_record(app, action);
  isograsp::add_report(app, action);
  isograsp::add_run(app, action);
  isograsp::add_score(app, action);
  isograsp::add_simulate(app, action);
  isograsp::add_study(app, action);
  isograsp::add_target(app, action);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& wrong) {
    return isograsp::print_error(
        {isograsp::Error::Code::bad_input, wrong.what(), "see isograsp --help", "", 0, ""});
  }
  const auto done = action ? action() : isograsp::run_gui("", "");
  return done ? 0 : isograsp::print_error(done.error());
}
