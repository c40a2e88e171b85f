// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp target: what was done in a stored trial becomes the target of a new task.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/login_options.hpp"
#include "core/files.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/recorded_target.hpp"

namespace isograsp::app {

namespace {

struct TargetOptions {
  std::string database;
  std::string patient;
  int session = 1;
  int trial = 1;
  std::string out;
  LoginOptions login;
  tasks::RecordedTarget wanted{"Recorded target"};
};

Result<storage::TrialRecord> find_trial(storage::SessionStore& store,
                                        const TargetOptions& options) {
  const auto patient = store.find_patient(options.patient);
  if (!patient) return patient.error();
  if (!*patient)
    return refused("there is no patient '%1'"_text(options.patient), "check the code"_text)
        .about("--patient");
  const auto sessions = store.sessions((*patient)->id);
  if (!sessions) return sessions.error();
  if (options.session > static_cast<int>(sessions->size()))
    return refused("this patient has %1 sessions"_text(sessions->size()),
                   "give one of them, from 1"_text)
        .about("--session");
  const auto trials = store.trials((*sessions)[static_cast<std::size_t>(options.session) - 1].id);
  if (!trials) return trials.error();
  for (const storage::TrialRecord& trial : *trials)
    if (trial.number == options.trial) return trial;
  return refused("this session has %1 trials"_text(trials->size()), "give one of them, from 1"_text)
      .about("--trial");
}

Result<void> make_target(const TargetOptions& options) {
  std::error_code ignored;
  if (std::filesystem::exists(options.out, ignored))
    return refused("%1 exists already"_text(options.out), "choose another name"_text)
        .about("--out");
  const auto access = log_in(options.database, options.login);
  if (!access) return access.error();
  const auto store = storage::open_store_to_read(options.database);
  if (!store) return store.error();
  const auto trial = find_trial(**store, options);
  if (!trial) return trial.error();
  const auto spec = tasks::parse_task(trial->task_text, trial->task_name);
  if (!spec) return spec.error();
  const auto signals = (*store)->signals(*trial);
  if (!signals) return signals.error();
  const auto text = tasks::target_by_doing(*spec, *signals, options.wanted);
  if (!text) return text.error();
  if (const auto written = write_text(options.out, *text); !written) return written;
  print_line(
      "%1: target of '%2', trial %3"_text(options.out, Known{trial->task_name}, trial->number));
  return {};
}

}  // namespace

void add_target(CommandLine& line) {
  auto options = std::make_shared<TargetOptions>();
  Subcommand command =
      line.subcommand("target", "A task whose target is what was done in a stored trial");
  command.option("--db", options->database, "Database file").required();
  command.option("--patient", options->patient, "Patient code").required();
  command.option("--session", options->session, "Session number of the patient, from 1")
      .positive()
      .shows_default();
  command.option("--trial", options->trial, "Trial number in the session, from 1")
      .positive()
      .shows_default();
  command.option("--out", options->out, "Task file to be made").required();
  command.option("--name", options->wanted.name, "Name of the task").shows_default();
  command.option("--slower", options->wanted.slower, "Stretches the time")
      .range(0.1, 10.0)
      .shows_default();
  command.flag("--force", options->wanted.force,
               "The force as the target, also where an object was moved");
  options->login.add_to(command);
  command.footer(
      "Example: guide the hand in a trial of free handling, then\n"
      "  isograsp target --db clinic.db --patient P-0427 --session 3 --trial 2 --out turn.toml");
  command.runs([options] { return make_target(*options); });
}

}  // namespace isograsp::app
