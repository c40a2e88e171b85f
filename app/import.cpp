// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp import: recordings that others made into the database, as patients and trials; finger
// forces, raw logs and exported signals, as a trial of one patient.
#include "session/import/import.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/login_options.hpp"
#include "app/paths.hpp"
#include "app/run.hpp"
#include "core/csv.hpp"
#include "grasp_model/scene.hpp"
#include "session/library/library.hpp"
#include "storage/access/open_store.hpp"

namespace isograsp::app {

namespace {

struct ImportOptions {
  std::string recording;
  std::string folder;
  std::string database;
  std::string forces;  ///< finger forces (CSV), or a raw log with `protocol` or `config`
  std::string protocol;
  std::string config;
  std::string signals;
  std::string task;
  std::string scene;
  std::string patient;
  std::string hand;  ///< empty: as the sidecar says, else right
  LoginOptions login;
};

/// A path, or the bare name of a recording file that comes with the program.
std::string recording_path(const std::string& name) {
  const auto shipped = std::filesystem::path(library_folder()) / "recordings" / (name + ".toml");
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored) && std::filesystem::exists(shipped, ignored))
    return shipped;
  return name;
}

Result<void> import_recording(const ImportOptions& options) {
  const std::string path = recording_path(options.recording);
  const auto text = read_text(path);
  if (!text) return text.error();
  const auto spec = session::parse_recording(*text, path);
  if (!spec) return spec.error();
  // All of it is read before anything is written.
  const auto trials = session::read_recording(*spec, options.folder, library_folder());
  if (!trials) return trials.error();
  const auto store = storage::open_store(options.database, storage::OpenMode::create);
  if (!store) return store.error();
  ProgressBar bar("Import"_text);
  const auto imported =
      session::store_recording(*spec, *trials, **store, ISOGRASP_VERSION, [&](int done) {
        bar.show(static_cast<double>(done) / static_cast<double>(trials->size()),
                 "%1"_text((*trials)[static_cast<std::size_t>(done) - 1].patient_code));
      });
  bar.end();
  if (!imported) return imported.error();
  print_line("%1: %2 patients, %3 sessions, %4 trials, %5 samples"_text(
      spec->name, imported->patients, imported->sessions, imported->trials, imported->samples));
  std::string codes;
  for (const session::RecordedTrial& trial : *trials)
    if (!codes.ends_with(trial.patient_code))
      codes += (codes.empty() ? "" : ", ") + trial.patient_code;
  print("  %s\n", printable(codes).c_str());
  for (const auto& line : session::provenance_of(*spec)) print("  %s\n", printable(line).c_str());
  return {};
}

/// The forces are processed as in a session: object, task, signals, measures.
Result<void> import_forces(const ImportOptions& options) {
  RunOptions run;
  run.task_file = options.task;
  run.device = "replay://" + options.forces + "?speed=1";
  if (!options.protocol.empty()) run.device += "&protocol=" + options.protocol;
  if (!options.config.empty()) run.device += "&config=" + options.config;
  run.database = options.database;
  run.patient = options.patient;
  run.hand = options.hand.empty() ? "right" : options.hand;
  run.fast = true;
  return run_session(run);
}

/// What the JSON file that was exported beside the signals says of them.
struct Sidecar {
  std::string hand;  ///< empty: there is no such file
  bool simulated = false;
};
Result<Sidecar> read_sidecar(const std::string& signals) {
  constexpr std::string_view kEnd = "_signals.csv";
  std::error_code ignored;
  if (!signals.ends_with(kEnd)) return Sidecar{};
  const std::string path = signals.substr(0, signals.size() - kEnd.size()) + ".json";
  if (!std::filesystem::exists(path, ignored)) return Sidecar{};
  const auto text = read_text(path);
  if (!text) return text.error();
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  const auto wrong = [&path](const char* field, const Text& what) {
    return refused(what, "export the trial again, or move this file away"_text)
        .at(path)
        .about(field);
  };
  if (!json.is_object() || !json.contains("format") || json["format"] != "isograsp-trial-2")
    return wrong("format", "is no sidecar of an exported trial"_text);
  const auto session = json.find("session");
  if (session == json.end() || !session->is_object() || !session->contains("hand") ||
      !session->at("hand").is_string() || !session->contains("simulated") ||
      !session->at("simulated").is_boolean())
    return wrong("session", "tells no hand or not whether the forces were simulated"_text);
  return Sidecar{session->at("hand").get<std::string>(), session->at("simulated").get<bool>()};
}

Result<void> import_signals(const ImportOptions& options) {
  const auto sidecar = read_sidecar(options.signals);
  if (!sidecar) return sidecar.error();
  if (!options.hand.empty() && !sidecar->hand.empty() && options.hand != sidecar->hand)
    return refused("these signals are of the %1 hand"_text(sidecar->hand),
                   "leave --hand out, or move the JSON file beside them away"_text)
        .at(options.signals)
        .about("--hand");
  const std::string given = options.hand.empty() ? sidecar->hand : options.hand;
  const auto hand = hand_option(given.empty() ? "right" : given);
  if (!hand) return hand.error();
  session::RecordedTrial trial;
  trial.simulated = sidecar->simulated;
  trial.patient_code = options.patient;
  trial.file = std::filesystem::path(options.signals).filename();
  const auto task = session::load_task(options.task);
  if (!task) return task.error();
  trial.task = *task;
  if (!options.scene.empty()) {
    const auto scene = read_text(options.scene);
    if (!scene) return scene.error();
    if (const auto sound = parse_scene(*scene, options.scene); !sound) return sound.error();
    trial.scene_text = *scene;
  }
  auto signals = read_signals(options.signals);
  if (!signals) return signals.error();
  trial.signals = *std::move(signals);
  const auto store = storage::open_store(options.database, storage::OpenMode::create);
  if (!store) return store.error();
  const auto measures = session::store_signals_trial(trial, *hand, **store, ISOGRASP_VERSION);
  if (!measures) return measures.error();
  print_line(
      "%1: %2, %3 samples"_text(options.patient, Known{trial.task.name}, trial.signals.rows()));
  for (const auto& measure : *measures) print_measure(measure);
  return {};
}

/// Checks which options must be given together.
Result<void> check_import(const ImportOptions& options) {
  const auto wrong = [](const char* field, const Text& what, const Text& remedy) {
    return refused(what, remedy).about(field);
  };
  const bool one = !options.forces.empty() || !options.signals.empty();
  if (one + !options.recording.empty() != 1 ||
      (!options.forces.empty() && !options.signals.empty()))
    return wrong("", "it is not clear what to import"_text,
                 "give one of --recording, --forces, --signals"_text);
  if (!one)
    return options.folder.empty() ? Result<void>(wrong("--from", "no folder is given"_text,
                                                       "name that of the recording"_text))
                                  : Result<void>();
  if (options.task.empty())
    return wrong("--task", "no task is given"_text,
                 "name the task file that the trial is scored by"_text);
  if (options.patient.empty())
    return wrong("--patient", "no patient is given"_text, "name the code"_text);
  return {};
}

Result<void> run_import(const ImportOptions& options) {
  if (const auto sound = check_import(options); !sound) return sound;
  const auto access = log_in(options.database, options.login);
  if (!access) return access.error();
  if (!options.forces.empty()) return import_forces(options);
  if (!options.signals.empty()) return import_signals(options);
  return import_recording(options);
}

}  // namespace

void add_import(CommandLine& line) {
  auto options = std::make_shared<ImportOptions>();
  Subcommand command =
      line.subcommand("import", "Recordings that others made, as patients and trials");
  command.option("--recording", options->recording,
                 "Recording file (TOML), or the name of one in library/recordings");
  command.option("--from", options->folder, "Folder of the recording");
  command.option("--forces", options->forces,
                 "Finger forces (CSV), or with --protocol or --config a raw log");
  command.option("--protocol", options->protocol, "Of the raw log: rft, ati-netcanoem …");
  command.option("--config", options->config, "Device file (TOML) of the raw log");
  command.option("--signals", options->signals, "Signals of a trial (CSV), as exported");
  command.option("--task", options->task, "Task file (TOML) of forces or signals");
  command.option("--scene", options->scene, "Scene file (TOML) stored with the signals");
  command.option("--patient", options->patient, "Whose forces or signals they are; created if new");
  command.option("--hand", options->hand,
                 "right or left; of exported signals as told beside them, else right");
  command.option("--db", options->database, "Database; made if it does not exist").required();
  options->login.add_to(command);
  command.footer(
      "Example:\n  isograsp import --recording maximum_push --from recordings --db clinic.db\n"
      "  isograsp import --forces forces.csv --task library/tasks/free_handling.toml \\\n"
      "    --patient P-0427 --db clinic.db");
  command.runs([options] { return run_import(*options); });
}

}  // namespace isograsp::app
