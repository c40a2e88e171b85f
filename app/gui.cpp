// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp gui: the therapist application.
#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/paths.hpp"
#include "app/realtime_option.hpp"
#include "gui/application.hpp"

namespace isograsp {

namespace {

struct GuiOptions {
  std::string database;
  std::string device;
  std::string operator_name;
  RealtimeOption realtime;
};

Result<void> run(const GuiOptions& options) {
  return run_application({options.database.empty() ? default_database() : options.database,
                          options.device, library_folder(), "isograsp " ISOGRASP_VERSION,
                          options.operator_name, options.realtime.wish(), make_small_clinic});
}

}  // namespace

Result<void> run_gui(const std::string& database, const std::string& device) {
  GuiOptions options;
  options.database = database;
  options.device = device;
  return run(options);
}

void add_gui(CLI::App& app, Action& action) {
  auto options = std::make_shared<GuiOptions>();
  auto* command = app.add_subcommand("gui", "the therapist application");
  command->add_option("--db", options->database, "database; made if absent (default: the clinic's)")
      ->type_name("FILE");
  command->add_option("--device", options->device, "device that is chosen at start")
      ->type_name("URI");
  command->add_option("--operator", options->operator_name,
                      "who works with it, stored with zero and resting force");
  options->realtime.add_to(*command);
  command->footer("Example: isograsp gui --db clinic.db --device 'sim://healthy?seed=7'");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace isograsp
