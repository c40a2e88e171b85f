// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp run: a session without a window.
#include "app/run.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "app/login_options.hpp"
#include "app/paths.hpp"
#include "app/realtime_option.hpp"
#include "app/stop_signals.hpp"
#include "session/arm/passive_range.hpp"
#include "session/open_two_platforms.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::app {

Result<Hand> hand_option(const std::string& text) {
  if (const auto hand = hand_from_name(text)) return *hand;
  return refused("'%1' is not a hand"_text(text), "write right or left"_text).about("--hand");
}

void print_measure(const Measure& measure) {
  std::string label = measure.name;
  if (!measure.channel.empty()) label += " (" + measure.channel + ")";
  if (measure.value)
    print("    %-44s %12.4g %s\n", printable(label).c_str(), *measure.value, measure.unit.c_str());
  else
    print("    %-44s %12s %s\n", printable(label).c_str(), "-",
          printable(spoken(tasks::reason_words(measure.reason))).c_str());
}

namespace {

void print_trial(const session::TrialOutcome& outcome) {
  const storage::TrialRecord& trial = outcome.trial;
  Text task = Known{trial.task_name};
  if (trial.practice) task = "%1, practice"_text(std::move(task));
  const Known status{std::string(storage::name_of(trial.status))};
  print("\n");
  print_line("  Trial %1  %2  [%3]"_text(trial.number, std::move(task), status));
  if (outcome.rest) print_line("    %1"_text(outcome.rest->words));
  for (const auto& measure : outcome.measures) print_measure(measure);
}

/// The protocol of the options. A task alone becomes a protocol without other steps, because nobody
/// can be asked to relax or to take the hand out.
Result<session::ReadyProtocol> protocol_of(const RunOptions& options) {
  if (!options.protocol_text.empty())
    return session::read_protocol(options.protocol_text, options.protocol_file, library_folder());
  if (options.task_file.empty())
    return session::read_protocol(options.protocol_file, library_folder());
  const std::filesystem::path task = options.task_file;
  return session::read_protocol(
      "format = \"isograsp-protocol-1\"\nname = \"Imported forces\"\n\n[[step]]\n"
      "kind = \"task\"\ntask = '" +
          task.filename().string() + "'\n",
      task, library_folder());
}

/// The first steps of a protocol; negative: all.
session::ReadyProtocol beginning_of(session::ReadyProtocol protocol, int steps) {
  if (steps < 0) return protocol;
  const auto kept = std::min(protocol.tasks.size(), static_cast<std::size_t>(steps));
  protocol.spec.steps.resize(kept);
  protocol.tasks.resize(kept);
  return protocol;
}

/// The passive ranges, as the session stores them.
Result<std::vector<storage::SessionAnswer>> screening_answers(const RunOptions& options) {
  std::vector<PassiveLimit> limits;
  for (const std::string& text : options.passive) {
    const auto limit = session::passive_limit_from(text);
    if (!limit) return Error(limit.error()).about("--passive");
    if (std::any_of(limits.begin(), limits.end(),
                    [&](const PassiveLimit& known) { return known.angle == limit->angle; }))
      return refused("'%1' is the second range of this angle"_text(text), "give each once"_text)
          .about("--passive");
    limits.push_back(*limit);
  }
  return session::stored(limits);
}

/// What is measured, and with which device.
struct WhoAndWhat {
  std::optional<Hand> hand;  ///< nothing: both
  std::string device_uri;
};

Result<WhoAndWhat> who_and_what(const RunOptions& options) {
  const bool left = !options.device_left.empty();
  const bool right = !options.device_right.empty();
  if (!left && !right) {
    if (options.device.empty())
      return refused("no device is named"_text,
                     "give --device, or --device-left and --device-right"_text)
          .about("--device");
    const auto hand = hand_option(options.hand.empty() ? "right" : options.hand);
    if (!hand) return hand.error();
    return WhoAndWhat{*hand, options.device};
  }
  if (!options.device.empty() || !options.hand.empty())
    return refused("two platforms measure both hands"_text,
                   "leave out --device and --hand, or both --device-left and --device-right"_text)
        .about(options.device.empty() ? "--hand" : "--device");
  if (!left || !right)
    return refused("one of two platforms is named alone"_text,
                   "give both --device-left and --device-right"_text)
        .about(left ? "--device-right" : "--device-left");
  auto both = session::two_platforms_uri({options.device_left, options.device_right});
  if (!both) return both.error();
  return WhoAndWhat{std::nullopt, *both};
}

/// What is said of each hand, or of which is affected, is said of a session of both.
Result<void> take_options_of_both_hands(const RunOptions& options, session::SessionConfig& config) {
  const bool each = options.ceilings_N.left || options.ceilings_N.right;
  if (config.hand && (each || !options.affected.empty()))
    return refused("one hand is measured"_text,
                   "leave it out, or give --device-left and --device-right"_text)
        .about(options.affected.empty() ? "--ceiling-left, --ceiling-right" : "--affected");
  config.ceilings_N = options.ceilings_N;
  if (options.affected.empty()) return {};
  config.affected = hand_from_name(options.affected);
  if (config.affected) return {};
  return refused("'%1' is not a side"_text(options.affected), "write left or right"_text)
      .about("--affected");
}

Text words_of_hand(std::optional<Hand> hand, const std::string& patient, const Text& device) {
  if (!hand) return "Patient %1, both hands, %2"_text(patient, device);
  return *hand == Hand::right ? "Patient %1, right hand, %2"_text(patient, device)
                              : "Patient %1, left hand, %2"_text(patient, device);
}

/// Begins the first task of a step and ends the session in it.
Result<void> break_off(session::Session& session, const session::ReadyProtocol& protocol,
                       int step) {
  const auto& tasks = protocol.tasks.at(static_cast<std::size_t>(step));
  if (tasks.empty()) return {};
  if (auto started = session.start_trial(tasks.front(), false, storage::TrialPlace{step, 0});
      !started)
    return started;
  constexpr double kBegun_s = 2.0;
  session.let_pass(kBegun_s);
  session.note("Broken off: called to another examination.");
  session.abort();
  (void)session.wait_for_news();  // the trial is stored
  return {};
}

}  // namespace

Result<void> run_session(const RunOptions& options) {
  const auto measured = who_and_what(options);
  if (!measured) return measured.error();
  const auto allowed = tasks::effort_from_name(options.allowed);
  if (!allowed && !options.allowed.empty())
    return refused("'%1' is no outcome of a screening"_text(options.allowed),
                   "write maximum, comfortable or none"_text)
        .about("--allowed");
  auto answers = screening_answers(options);
  if (!answers) return answers.error();
  const auto protocol = protocol_of(options);
  if (!protocol) return protocol.error();
  session::SessionConfig config;
  config.database = options.database;
  config.create_database = true;
  config.scratch_database = options.scratch;
  config.patient_code = options.patient;
  config.hand = measured->hand;
  config.device_uri = measured->device_uri;
  config.apparatus = protocol->apparatus();
  config.library = library_folder();
  config.protocol_name = protocol->spec.name;
  config.protocol_text = protocol->spec.text;
  config.software_version = ISOGRASP_VERSION;
  config.virtual_time = options.fast;
  config.started_utc = options.started_utc;
  config.operator_name = options.operator_name;
  config.realtime = options.realtime;
  config.allowed = allowed;
  if (auto both = take_options_of_both_hands(options, config); !both) return both;
  config.ceiling_N = options.ceiling_N;
  config.answers = *std::move(answers);
  config.resume = options.resume;
  config.clock_is_right = options.clock_is_right;
  config.stop = options.stop;
  auto session = session::Session::open(config);
  if (!session) {
    Error error = session.error();
    if (error.field == "clock") error.remedy = "set the clock, or say --clock-is-right"_text;
    return error;
  }

  if (!options.quiet) {
    if ((*session)->known().patient_is_new)
      print_note("patient %1 is new and was created"_text(options.patient));
    if (const auto got = session::words_of((*session)->known().realtime); !got.empty())
      print_note("acquisition with %1"_text(got));
    const Text& device = (*session)->known().device.description;
    print_line(words_of_hand(measured->hand, options.patient, device));
    std::fflush(stdout);
  }
  if (!options.quiet) {
    const tasks::Duration duration = protocol->duration();
    constexpr double kSecondsPerMinute = 60.0;
    print_line("%1: %2 min as a rule, %3 min at most"_text(
        Known{protocol->spec.name}, fixed(duration.nominal_s / kSecondsPerMinute, 1),
        fixed(duration.worst_s / kSecondsPerMinute, 1)));
    std::fflush(stdout);
  }
  ProgressBar bar("Session"_text);
  const auto result = session::run_protocol(
      **session, beginning_of(*protocol, options.broken_off_in),
      [&](const session::ProtocolProgress& at) {
        if (!options.quiet)
          bar.show(static_cast<double>(at.step) / std::max(1, at.steps), at.doing);
      },
      options.serviced);
  Result<void> ended;
  if (result && options.broken_off_in >= 0)
    ended = break_off(**session, *protocol, options.broken_off_in);
  if (options.rating) (void)(*session)->rate(options.rating->effort, options.rating->pain);
  (*session)->close();
  bar.end();
  if (const auto lost = (*session)->failure()) return *lost;
  if (const auto signal = StopSignals::name(); !signal.empty() && !result)
    return failed("the session was ended by %1; what was measured is stored"_text(signal),
                  "run it again with --resume to go on"_text)
        .at(options.database);
  if (!result) return result.error();
  if (!ended) return ended;
  if (options.quiet) return {};
  for (const auto& outcome : result->trials) print_trial(outcome);
  for (const auto& left_out : result->left_out) print_note("left out: %1"_text(left_out));
  return {};
}

void add_run(CommandLine& line) {
  auto options = std::make_shared<RunOptions>();
  auto realtime = std::make_shared<RealtimeOption>();
  auto login = std::make_shared<LoginOptions>();
  Subcommand command = line.subcommand("run", "A session without a window");
  command.option("--protocol-file", options->protocol_file, "Protocol (TOML)").required();
  command.option("--device", options->device, "Device URI, e.g. sim://healthy?seed=7");
  command.option("--device-left", options->device_left,
                 "Platform of the left hand, for a session of both hands; with --device-right, "
                 "without --device and --hand; sim://pair?file=paretic_left on both is a person in "
                 "software");
  command.option("--device-right", options->device_right, "Platform of the right hand");
  command.option("--db", options->database, "Database; made if it does not exist").required();
  command.option("--patient", options->patient, "Patient code; created if new").required();
  command.option("--hand", options->hand, "right or left; without it the right one");
  command.option("--operator", options->operator_name,
                 "Who runs it, stored with zero and resting force");
  command.option("--allowed", options->allowed,
                 "What the screening allows this hand: maximum, comfortable or none; without it "
                 "nothing is kept and maximum is allowed");
  command.option("--ceiling", options->ceiling_N, "No target may exceed this force [N]").positive();
  command.option(
      "--affected", options->affected,
      "Of both hands: the affected side, left or right, where the database does not say it");
  command
      .option("--ceiling-left", options->ceilings_N.left,
              "Of both hands: no target may ask the left one for more [N]")
      .positive();
  command
      .option("--ceiling-right", options->ceilings_N.right,
              "Of both hands: no target may ask the right one for more [N]")
      .positive();
  command.option(
      "--passive", options->passive,
      "Passive range of an arm's angle [degrees], e.g. forearm_a3=-40:60; no target goes "
      "beyond it; may be given more than once");
  command.flag("--fast", options->fast, "Simulated and replayed devices in virtual time");
  command.flag("--resume", options->resume,
               "Go on with the protocol that the last session of this hand has not finished");
  command.flag("--serviced", options->serviced,
               "The device was serviced or remounted: its zero may differ from the last one");
  command.flag("--clock-is-right", options->clock_is_right,
               "Record although the newest session of the file lies ahead of the clock");
  realtime->add_to(command);
  login->add_to(command);
  command.footer(
      "Example:\n  isograsp run --protocol-file library/protocols/demonstration.toml \\\n"
      "    --device 'sim://healthy?seed=7' --db clinic.db --patient DEMO-01 --fast");
  command.runs([options, realtime, login]() -> Result<void> {
    options->realtime = realtime->wish();
    const auto access = log_in(options->database, *login);
    if (!access) return access.error();
    const StopSignals signals;
    options->stop = &StopSignals::stop();
    return run_session(*options);
  });
}

}  // namespace isograsp::app
