// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp export: trials as files for research. Pseudonymous: patient codes, no dates, no notes,
// no paths. Layout: docs/file_formats.md, "Research export".
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "core/anatomical_axes.hpp"
#include "core/csv.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ExportOptions {
  std::string database;
  std::string patient;
  int session = 0;  ///< 0: all
  std::string format = "csv";
  std::string out;
  bool json = false;
};

/// A trial with all that its files say about it.
struct TrialSource {
  const PatientRecord* patient = nullptr;
  int patient_number = 0;  ///< place in the database: the same in every export from it
  const SessionRecord* session = nullptr;
  int session_number = 0;  ///< 1, 2, … of the patient
  std::string first_started_utc;
  const TrialRecord* trial = nullptr;
};

/// "2026-03-01T…": the day; nothing if it is no date.
std::optional<std::chrono::sys_days> day_of(const std::string& utc) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) return {};
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!date.ok()) return {};
  return std::chrono::sys_days(date);
}

Json days_between(const std::string& first_utc, const std::string& utc) {
  const auto first = day_of(first_utc);
  const auto day = day_of(utc);
  if (!first || !day) return nullptr;
  return (*day - *first).count();
}

/// The unit at the end of a column's name; empty: a number without one.
std::string unit_of(const std::string& column) {
  static const std::pair<const char*, const char*> kUnits[] = {
      {"_N", "N"},     {"_Nm", "N m"},  {"_m", "m"},         {"_s", "s"},
      {"_rad", "rad"}, {"_mps", "m/s"}, {"_radps", "rad/s"}, {"_counts", "counts"}};
  for (const auto& [ending, unit] : kUnits)
    if (column.ends_with(ending)) return unit;
  return "";
}

Json as_json(const std::array<Vec6, kFingerCount>& wrenches) {
  Json all;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Vec6& w = wrenches[f];
    all[std::string(kFingerNames[f])] = {w[0], w[1], w[2], w[3], w[4], w[5]};
  }
  return all;
}

Json as_json(const Measure& measure) {
  Json one{{"name", measure.name}, {"channel", measure.channel}, {"value", nullptr}};
  if (measure.value) one["value"] = *measure.value;
  one["unit"] = measure.unit;
  one["version"] = measure.version;
  one["samples"] = measure.samples;
  one["excluded"] = measure.excluded;
  if (!measure.value) one["reason"] = measure.reason;
  return one;
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// The sidecar of one trial. `written`: the columns of its signals file.
Result<Json> describe(SessionStore& store, const TrialSource& source,
                      const std::vector<std::string>& written, std::int64_t infinite) {
  const SessionRecord& session = *source.session;
  const TrialRecord& trial = *source.trial;
  Json json;
  json["format"] = "isograsp-trial-1";
  json["patient"] = source.patient->code;
  json["session"] = {
      {"number", source.session_number},
      {"days_from_first_session", days_between(source.first_started_utc, session.started_utc)},
      {"hand", name_of(session.hand)},
      // The name of a recording's file may be a person's: it stays here.
      {"device", session.recorded ? "Recorded forces" : session.device_description},
      {"device_scheme", session.device_uri.substr(0, session.device_uri.find(':'))},
      {"simulated", session.simulated},
      {"recorded", session.recorded},
      {"protocol", session.protocol_name},
      {"rate_Hz", session.rate_Hz},
      {"device_delay_s", session.device_delay_s},
      {"software_version", session.software_version},
      {"cpu_features", session.cpu_features},
      {"seed", session.seed},
      {"screening", session.allowed},
      {"ceiling_N", or_null(session.ceiling_N)}};
  json["trial"] = {{"number", trial.number},
                   {"task", trial.task_name},
                   {"task_version", trial.task_version},
                   {"practice", trial.practice},
                   {"helped", trial.helped},
                   {"status", name_of(trial.status)},
                   {"session_time_s", trial.session_time_s},
                   {"maximum_force_N", trial.maximum_force_N},
                   {"resting_force_N", trial.resting_force_N},
                   {"samples", trial.samples},
                   {"dropped", trial.dropped},
                   {"worst_lateness_s", trial.worst_lateness_s},
                   {"worst_compute_s", trial.worst_compute_s}};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    json["trial"]["contact_threshold_N"][std::string(kFingerNames[f])] =
        or_null(trial.threshold_N[f]);
  json["trial"]["seed"] = trial.seed;
  json["trial"]["zero_drift_N"] = or_null(trial.zero_drift_N);
  json["trial"]["zero_drifted"] = trial.zero_drifted;
  json["trial"]["display_age_s"] = or_null(trial.display_age_s);
  json["trial"]["visual_gain_deg_per_N"] = or_null(trial.visual_gain_deg_per_N);
  json["trial"]["viewing_distance_m"] = or_null(trial.viewing_distance_m);
  json["health"] = Json::parse(trial.health_json, nullptr, false);
  if (json["health"].is_discarded()) json["health"] = nullptr;
  json["timing"] = Json::parse(trial.timing_json, nullptr, false);
  if (json["timing"].is_discarded()) json["timing"] = nullptr;

  json["columns"] = Json::array();
  std::size_t stored = 0;
  const auto add_column = [&json](const std::string& column, const std::string& group) {
    json["columns"].push_back({{"name", column}, {"unit", unit_of(column)}, {"group", group}});
  };
  for (const auto& group : trial.groups)
    for (const auto& column : group.columns) {
      add_column(column, group.name);
      ++stored;
    }
  for (; stored < written.size(); ++stored) add_column(written[stored], "anatomical");
  json["infinite_values_left_empty"] = infinite;

  const auto zeros = store.zeros(session.id);
  if (!zeros) return zeros.error();
  json["instrument_zero"] = nullptr;
  for (const auto& zero : *zeros)
    if (zero.id == trial.zero_id)
      json["instrument_zero"] = {{"session_time_s", zero.session_time_s},
                                 {"units", "N N N Nm Nm Nm"},
                                 {"mean", as_json(zero.mean)},
                                 {"sd", as_json(zero.sd)}};

  const auto rests = store.resting_forces(session.id);
  if (!rests) return rests.error();
  for (const auto& rest : *rests)
    if (rest.trial_id == trial.id)
      json["resting_force"] = {
          {"duration_s", rest.duration_s}, {"since_strapping_s", or_null(rest.since_strapping_s)},
          {"samples", rest.samples},       {"units", "N N N Nm Nm Nm"},
          {"mean", as_json(rest.mean)},    {"sd", as_json(rest.sd)}};

  const auto measures = store.measures(trial.id);
  if (!measures) return measures.error();
  json["measures"] = Json::array();
  for (const auto& measure : *measures) json["measures"].push_back(as_json(measure));

  const auto events = store.events(session.id);
  if (!events) return events.error();
  json["events"] = Json::array();
  for (const auto& event : *events)
    if (event.trial_id == trial.id && event.kind != "note")  // notes may identify a person
      json["events"].push_back(
          {{"session_time_s", event.session_time_s}, {"kind", event.kind}, {"text", event.text}});
  return json;
}

Result<void> write_file(const std::string& path, const std::string& text) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  writer->write(text);
  return writer->commit();
}

/// CSV has no infinity: such values are left empty and counted.
std::pair<Signals, std::int64_t> without_infinity(const Signals& signals) {
  Signals finite;
  std::int64_t count = 0;
  for (std::size_t c = 0; c < signals.names().size(); ++c) {
    const auto column = signals.column(c);
    std::vector<double> values(column.begin(), column.end());
    for (double& value : values)
      if (std::isinf(value)) {
        value = std::numeric_limits<double>::quiet_NaN();
        ++count;
      }
    finite.add_column(signals.names()[c], std::move(values));
  }
  return {std::move(finite), count};
}

/// Numbers only: no name from the database gets into a path.
fs::path place_of(const TrialSource& source) {
  return fs::path("patient_" + std::to_string(source.patient_number)) /
         ("session_" + std::to_string(source.session_number)) /
         ("trial_" + std::to_string(source.trial->number));
}

Result<void> write_trial(SessionStore& store, const TrialSource& source, const fs::path& folder) {
  const std::string stem = (folder / place_of(source)).string();
  std::error_code failure;
  fs::create_directories(fs::path(stem).parent_path(), failure);
  if (failure)
    return Error{Error::Code::failed,
                 "the folder cannot be made: " + failure.message(),
                 "check its permissions",
                 fs::path(stem).parent_path(),
                 0,
                 ""};
  const auto stored = store.signals(*source.trial);
  if (!stored) return stored.error();
  auto [signals, infinite] = without_infinity(*stored);
  // How others' devices stood, and often which hand it was, is not known.
  if (!source.session->device_uri.starts_with("recording:"))
    add_anatomical_forces(signals, source.session->hand);
  if (const auto done = write_signals(signals, stem + "_signals.csv"); !done) return done.error();
  const auto json = describe(store, source, signals.names(), infinite);
  if (!json) return json.error();
  if (const auto done = write_file(stem + ".json", json->dump(2) + "\n"); !done)
    return done.error();
  if (const auto done = write_file(stem + "_task.toml", source.trial->task_text); !done)
    return done.error();
  if (source.trial->scene_text.empty()) return {};
  return write_file(stem + "_scene.toml", source.trial->scene_text);
}

/// Calls `visit` for each trial asked for; trials being recorded now are not among them.
Result<void> for_each_trial(SessionStore& store, const ExportOptions& options,
                            const std::function<Result<void>(const TrialSource&)>& visit) {
  const auto patients = store.patients();
  if (!patients) return patients.error();
  TrialSource source;
  for (const auto& patient : *patients) {
    ++source.patient_number;
    if (!options.patient.empty() && patient.code != options.patient) continue;
    const auto sessions = store.sessions(patient.id);
    if (!sessions) return sessions.error();
    source.patient = &patient;
    source.session_number = 0;
    source.first_started_utc = sessions->empty() ? "" : sessions->front().started_utc;
    for (const auto& session : *sessions) {
      ++source.session_number;
      if (options.session != 0 && options.session != source.session_number) continue;
      const auto trials = store.trials(session.id);
      if (!trials) return trials.error();
      source.session = &session;
      for (const auto& trial : *trials) {
        source.trial = &trial;
        if (trial.status == TrialStatus::running) continue;
        if (const auto done = visit(source); !done) return done.error();
      }
    }
  }
  return {};
}

/// Moves every file of `from` to the same place in `to`. Nothing is overwritten.
Result<void> publish(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(from))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), from));
  for (const auto& file : files)
    if (fs::exists(fs::symlink_status(to / file)))
      return Error{Error::Code::bad_input,
                   "exists already",
                   "choose an empty folder for --out",
                   to / file,
                   0,
                   ""};
  for (const auto& file : files) {
    fs::create_directories((to / file).parent_path());
    fs::rename(from / file, to / file);
  }
  return {};
}

Result<void> run_export(const ExportOptions& options) {
  if (options.format != "csv")
    return Error{Error::Code::bad_input,
                 "'" + options.format + "' is not an export format",
                 "available is: csv",
                 "",
                 0,
                 "--format"};
  if (options.out.empty())
    return Error{Error::Code::bad_input, "no folder is given", "name one", "", 0, "--out"};
  const auto store = SessionStore::open_to_read(options.database);
  if (!store) return store.error();
  if (!options.patient.empty()) {
    const auto patient = (*store)->find_patient(options.patient);
    if (!patient) return patient.error();
    if (!*patient)
      return Error{Error::Code::bad_input,
                   "there is no patient '" + options.patient + "'",
                   "check the code",
                   options.database,
                   0,
                   "--patient"};
  }
  std::size_t total = 0;
  const auto counted = for_each_trial(**store, options, [&total](const TrialSource&) {
    ++total;
    return Result<void>();
  });
  if (!counted) return counted.error();
  if (total == 0)
    return Error{Error::Code::bad_input,
                 "holds no such trial",
                 "check --patient and --session (1 is the patient's first)",
                 options.database,
                 0,
                 ""};

  // Everything is written into a folder of its own first: all of it appears, or nothing.
  const fs::path out = options.out;
  std::error_code failure;
  const bool made = fs::create_directories(out, failure);
  if (failure || !fs::is_directory(out))
    return Error{Error::Code::bad_input,
                 "the folder cannot be made",
                 "choose another one",
                 options.out,
                 0,
                 "--out"};
  const fs::path staging = out / (".part" + std::to_string(getpid()));
  std::size_t written = 0;
  ProgressBar bar("Exporting");
  auto done = for_each_trial(**store, options, [&](const TrialSource& source) {
    bar.show(static_cast<double>(written) / static_cast<double>(total), source.patient->code);
    ++written;
    return write_trial(**store, source, staging);
  });
  bar.show(1.0);
  if (done) try {
      done = publish(staging, out);
    } catch (const fs::filesystem_error& why) {
      done = Error{Error::Code::failed,
                   why.code().message(),
                   "check the disk and the permissions",
                   options.out,
                   0,
                   "--out"};
    }
  fs::remove_all(staging, failure);
  if (!done) {
    if (made) fs::remove(out, failure);
    return done.error();
  }
  const std::string text = std::to_string(written) + (written == 1 ? " trial" : " trials") +
                           " written to " + options.out;
  std::puts(options.json ? Json{{"out", options.out}, {"trials", written}}.dump(2).c_str()
                         : text.c_str());
  return {};
}

}  // namespace

void add_export(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "Research export: pseudonymous, no dates");
  command->add_option("--db", options->database, "Database file")->required();
  command->add_option("--patient", options->patient, "Patient code; without it all patients");
  command->add_option("--session", options->session, "Session number of the patient, from 1")
      ->check([](const std::string& text) {
        return std::atoi(text.c_str()) >= 1 ? "" : "'" + text + "' is no whole number from 1";
      });
  command->add_option("--format", options->format, "csv")->capture_default_str();
  command->add_option("--out", options->out, "Folder; made if it does not exist")->required();
  command->add_flag("--json", options->json, "Print one JSON document");
  command->footer(
      "Example:\n  isograsp export --db clinic.db --patient P-0427 --format csv --out study");
  command->callback([options, &action] { action = [options] { return run_export(*options); }; });
}

}  // namespace isograsp
