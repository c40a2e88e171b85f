// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp run: a session without a window.
#include "app/run.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/login_options.hpp"
#include "app/paths.hpp"
#include "app/realtime_option.hpp"
#include "session/protocol_run.hpp"
#include "session/session.hpp"

namespace isograsp {

Result<Hand> hand_option(const std::string& text) {
  if (const auto hand = hand_from_name(text)) return *hand;
  return Error{Error::Code::bad_input,
               "'" + text + "' is not a hand",
               "write right or left",
               "",
               0,
               "--hand"};
}

void print_measure(const Measure& measure) {
  std::string label = measure.name;
  if (!measure.channel.empty()) label += " (" + measure.channel + ")";
  if (measure.value)
    std::printf("    %-44s %12.4g %s\n", label.c_str(), *measure.value, measure.unit.c_str());
  else
    std::printf("    %-44s %12s %s\n", label.c_str(), "-", measure.reason.c_str());
}

namespace {

void print_trial(const TrialOutcome& outcome) {
  const TrialRecord& trial = outcome.trial;
  std::printf("\n  Trial %d  %s%s  [%s]\n", trial.number, trial.task_name.c_str(),
              trial.practice ? ", practice" : "", std::string(name_of(trial.status)).c_str());
  if (outcome.rest) std::printf("    %s\n", outcome.rest->words.c_str());
  for (const auto& measure : outcome.measures) print_measure(measure);
}

/// One task and nothing else: nobody can be asked to relax or to take the hand out.
Result<ReadyProtocol> protocol_of(const RunOptions& options) {
  if (options.task_file.empty()) return read_protocol(options.protocol_file, library_folder());
  const std::filesystem::path task = options.task_file;
  return read_protocol(
      "format = \"isograsp-protocol-1\"\nname = \"Imported forces\"\n\n[[step]]\n"
      "kind = \"task\"\ntask = '" +
          task.filename().string() + "'\n",
      task, library_folder());
}

}  // namespace

Result<void> run_session(const RunOptions& options) {
  const auto hand = hand_option(options.hand);
  if (!hand) return hand.error();
  const auto allowed = effort_from_name(options.allowed);
  if (!allowed && !options.allowed.empty())
    return Error{Error::Code::bad_input,
                 "'" + options.allowed + "' is no outcome of a screening",
                 "write maximum, comfortable or none",
                 "",
                 0,
                 "--allowed"};
  const auto protocol = protocol_of(options);
  if (!protocol) return protocol.error();
  SessionConfig config;
  config.database = options.database;
  config.create_database = true;
  config.scratch_database = options.scratch;
  config.patient_code = options.patient;
  config.hand = *hand;
  config.device_uri = options.device;
  config.library = library_folder();
  config.protocol_name = protocol->spec.name;
  config.protocol_text = protocol->spec.text;
  config.software_version = ISOGRASP_VERSION;
  config.virtual_time = options.fast;
  config.started_utc = options.started_utc;
  config.operator_name = options.operator_name;
  config.realtime = options.realtime;
  config.allowed = allowed;
  config.ceiling_N = options.ceiling_N;
  config.resume = options.resume;
  auto session = Session::open(config);
  if (!session) return session.error();

  if (!options.quiet) {
    if ((*session)->patient_is_new())
      print_note("patient " + options.patient + " is new and was created");
    if (const auto got = describe((*session)->realtime()); !got.empty())
      print_note("acquisition with " + got);
    std::printf("Patient %s, %s hand, %s\n", options.patient.c_str(), options.hand.c_str(),
                (*session)->device().description.c_str());
    std::fflush(stdout);
  }
  if (!options.quiet) {
    const Duration duration = protocol->duration();
    constexpr double kSecondsPerMinute = 60.0;
    std::printf("%s: %.1f min as a rule, %.1f min at most\n", protocol->spec.name.c_str(),
                duration.nominal_s / kSecondsPerMinute, duration.worst_s / kSecondsPerMinute);
    std::fflush(stdout);
  }
  ProgressBar bar("Session");
  const auto result = run_protocol(
      **session, *protocol,
      [&](const ProtocolProgress& at) {
        if (!options.quiet)
          bar.show(static_cast<double>(at.step) / std::max(1, at.steps), at.doing);
      },
      options.serviced);
  (*session)->close();
  bar.end();
  if (!result) return result.error();
  if (options.quiet) return {};
  for (const auto& outcome : result->trials) print_trial(outcome);
  for (const auto& left_out : result->left_out) print_note("left out: " + left_out);
  return {};
}

void add_run(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  auto realtime = std::make_shared<RealtimeOption>();
  auto login = std::make_shared<LoginOptions>();
  auto* command = app.add_subcommand("run", "A session without a window");
  command->add_option("--protocol-file", options->protocol_file, "Protocol (TOML)")->required();
  command->add_option("--device", options->device, "Device URI, e.g. sim://healthy?seed=7")
      ->required();
  command->add_option("--db", options->database, "Database; made if it does not exist")->required();
  command->add_option("--patient", options->patient, "Patient code; created if new")->required();
  command->add_option("--hand", options->hand, "right or left")->capture_default_str();
  command->add_option("--operator", options->operator_name,
                      "Who runs it, stored with zero and resting force");
  command->add_option(
      "--allowed", options->allowed,
      "What the screening allows this hand: maximum, comfortable or none; without it "
      "nothing is kept and maximum is allowed");
  command->add_option("--ceiling", options->ceiling_N, "No target may exceed this force [N]")
      ->check(CLI::PositiveNumber);
  command->add_flag("--fast", options->fast, "Simulated and replayed devices in virtual time");
  command->add_flag("--resume", options->resume,
                    "Go on with the protocol that the last session of this hand has not finished");
  command->add_flag("--serviced", options->serviced,
                    "The device was serviced or remounted: its zero may differ from the last one");
  realtime->add_to(*command);
  login->add_to(*command);
  command->footer(
      "Example:\n  isograsp run --protocol-file library/protocols/demonstration.toml \\\n"
      "    --device 'sim://healthy?seed=7' --db clinic.db --patient DEMO-01 --fast");
  command->callback([options, realtime, login, &action] {
    options->realtime = realtime->wish();
    action = [options, login]() -> Result<void> {
      const auto access = log_in(options->database, *login);
      if (!access) return access.error();
      return run_session(*options);
    };
  });
}

}  // namespace isograsp
