// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp gui: the therapist application.
#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/paths.hpp"
#include "gui/application.hpp"

namespace isograsp {

Result<void> run_gui(const std::string& database, const std::string& device) {
  return run_application({database.empty() ? default_database() : database, device,
                          library_folder(), "isograsp " ISOGRASP_VERSION});
}

void add_gui(CLI::App& app, Action& action) {
  struct Options {
    std::string database;
    std::string device;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("gui", "the therapist application");
  command->add_option("--db", options->database, "database; made if absent (default: the clinic's)")
      ->type_name("FILE");
  command->add_option("--device", options->device, "device that is chosen at start")
      ->type_name("URI");
  command->footer("Example: isograsp gui --db clinic.db --device 'sim://healthy?seed=7'");
  command->callback([options, &action] {
    action = [options] { return run_gui(options->database, options->device); };
  });
}

}  // namespace isograsp
