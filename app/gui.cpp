// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp gui: the therapist application.
#include <memory>

#include "app/commands.hpp"
#include "app/paths.hpp"
#include "app/realtime_option.hpp"
#include "app/stop_signals.hpp"
#include "gui/application.hpp"
#include "session/open_two_platforms.hpp"

namespace isograsp::app {

namespace {

struct GuiOptions {
  std::string database;
  std::string device;
  OfHands<std::string> platforms;  ///< of both hands
  std::string operator_name;
  RealtimeOption realtime;
};

/// The device that is chosen at start; empty: none.
Result<std::string> proposed(const GuiOptions& options) {
  const auto& [left, right] = options.platforms;
  if (left.empty() && right.empty()) return options.device;
  if (left.empty() || right.empty() || !options.device.empty())
    return refused("both hands have two platforms, one hand has one device"_text,
                   "give --device-left and --device-right, or --device"_text)
        .about("device");
  return session::two_platforms_uri(options.platforms);
}

Result<void> run(const GuiOptions& options) {
  const auto device = proposed(options);
  if (!device) return device.error();
  const StopSignals signals;
  return gui::run_application({options.database.empty() ? default_database() : options.database,
                               *device, library_folder(), "isograsp " ISOGRASP_VERSION,
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
  command.option("--device-left", options->platforms.left, "platform of the left hand, proposed")
      .type("URI");
  command.option("--device-right", options->platforms.right, "platform of the right hand, proposed")
      .type("URI");
  command.option("--operator", options->operator_name,
                 "who works with it, stored with zero and resting force");
  options->realtime.add_to(command);
  command.footer("Example: isograsp gui --db clinic.db --device 'sim://healthy?seed=7'");
  command.runs([options] { return run(*options); });
}

}  // namespace isograsp::app
