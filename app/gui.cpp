// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp gui: the therapist application.
#include <memory>

#include "app/commands.hpp"
#include "app/paths.hpp"
#include "app/realtime_option.hpp"
#include "app/stop_signals.hpp"
#include "gui/application.hpp"

namespace isograsp::app {

namespace {

struct GuiOptions {
  std::string database;
  std::string device;
  std::string operator_name;
  RealtimeOption realtime;
};

Result<void> run(const GuiOptions& options) {
  const StopSignals signals;
  return gui::run_application({options.database.empty() ? default_database() : options.database,
                               options.device, library_folder(), "isograsp " ISOGRASP_VERSION,
                               options.operator_name, options.realtime.wish(), &StopSignals::stop(),
                               make_small_clinic});
}

}  // namespace

Result<void> run_gui(const std::string& database, const std::string& device) {
  GuiOptions options;
  options.database = database;
  options.device = device;
  return run(options);
}

void add_gui(CommandLine& line) {
  auto options = std::make_shared<GuiOptions>();
  Subcommand command = line.subcommand("gui", "the therapist application");
  command.option("--db", options->database, "database; made if absent (default: the clinic's)")
      .type("FILE");
  command.option("--device", options->device, "device that is chosen at start").type("URI");
  command.option("--operator", options->operator_name,
                 "who works with it, stored with zero and resting force");
  options->realtime.add_to(command);
  command.footer("Example: isograsp gui --db clinic.db --device 'sim://healthy?seed=7'");
  command.runs([options] { return run(*options); });
}

}  // namespace isograsp::app
