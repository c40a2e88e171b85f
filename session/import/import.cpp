// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/import/import.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <vector>

#include "core/time.hpp"
#include "hand/columns.hpp"
#include "session/session.hpp"
#include "tasks/score.hpp"

namespace isograsp::session {

namespace {

/// The trials of one session of one patient.
using ImportedGroup = std::span<const RecordedTrial>;

std::vector<ImportedGroup> groups_of(ImportedGroup trials) {
  std::vector<ImportedGroup> groups;
  for (std::size_t first = 0; first < trials.size();) {
    std::size_t last = first + 1;
    while (last < trials.size() && trials[last].patient_code == trials[first].patient_code &&
           trials[last].session == trials[first].session)
      ++last;
    groups.push_back(trials.subspan(first, last - first));
    first = last;
  }
  return groups;
}

Result<void> refuse_known(ImportedGroup trials, storage::SessionStore& store) {
  for (const RecordedTrial& trial : trials) {
    const auto known = store.find_patient(trial.patient_code);
    if (!known) return known.error();
    if (*known)
      return refused("patient %1 exists already"_text(trial.patient_code),
                     "import into another database; nothing was written"_text)
          .at(store.path())
          .about("patient_prefix");
  }
  return {};
}

std::string provenance_text(const RecordingSpec& spec, ImportedGroup trials) {
  std::string text;
  for (const std::string& line : provenance_of(spec)) text += line + "\n";
  if (!trials.front().session_name.empty())
    text += "session: " + trials.front().session_name + "\n";
  std::vector<std::string> files;
  for (const RecordedTrial& trial : trials)
    if (std::find(files.begin(), files.end(), trial.file) == files.end())
      files.push_back(trial.file);
  for (const std::string& file : files) text += "file: " + file + "\n";
  return text;
}

Result<void> store_signals(const Signals& signals, double rate_Hz, storage::RowId trial,
                           storage::SessionStore& store) {
  const auto rows_per_block = static_cast<std::size_t>(std::lround(std::ceil(rate_Hz)));
  std::vector<std::vector<double>> block(1);
  int second = 0;
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    for (std::size_t c = 0; c < signals.names().size(); ++c)
      block[0].push_back(signals.column(c)[row]);
    if ((row + 1) % rows_per_block != 0 && row + 1 != signals.rows()) continue;
    if (auto done = store.append_blocks(trial, second++, block); !done) return done;
    block[0].clear();
  }
  return {};
}

Result<std::vector<Measure>> store_trial(const RecordedTrial& recorded, int number, double rate_Hz,
                                         storage::RowId session, storage::SessionStore& store) {
  storage::TrialRecord trial;
  trial.session_id = session;
  trial.number = number;
  trial.task_name = recorded.task.name;
  trial.task_version = recorded.task.version;
  trial.task_text = recorded.task.text;
  trial.scene_text = recorded.scene_text;
  trial.groups = {{"recording", recorded.signals.names()}};
  const auto id = store.begin_trial(trial);
  if (!id) return id.error();
  trial.id = *id;
  const auto stored = store_signals(recorded.signals, rate_Hz, *id, store);
  if (!stored) {
    trial.status = storage::TrialStatus::aborted;  // an incomplete trial gives no values
    static_cast<void>(store.end_trial(trial, {}).ok());
    return stored.error();
  }
  trial.status = storage::TrialStatus::completed;
  auto measures = tasks::score(recorded.task, recorded.signals);
  if (auto ended = store.end_trial(trial, measures); !ended) return ended.error();
  return measures;
}

/// Rows per second; a grid of a whole number of hertz gives exactly that number.
double rate_of(const Signals& signals) {
  constexpr double kRounding = 1e-6;  // relative: times are written with few digits
  const auto t_s = signals.column(columns::t_s);
  const double rate_Hz = static_cast<double>(t_s.size() - 1) / (t_s.back() - t_s.front());
  const double whole_Hz = std::round(rate_Hz);
  return std::abs(rate_Hz - whole_Hz) <= kRounding * rate_Hz ? whole_Hz : rate_Hz;
}

/// What was stored stays: a second import into the same file would be refused.
Error stopped_after(const Imported& imported, std::size_t trials, Error error) {
  error.what = "%1; %2 of %3 trials are stored"_text(error.what, imported.trials, trials);
  error.remedy = "%1; then import into a new database"_text(error.remedy);
  return error;
}

Result<storage::PatientRecord> patient_of(const std::string& code, storage::SessionStore& store) {
  const auto known = store.find_patient(code);
  if (!known) return known.error();
  if (*known) return **known;
  return store.add_patient(code);
}

}  // namespace

Result<Imported> store_recording(const RecordingSpec& spec, std::span<const RecordedTrial> trials,
                                 storage::SessionStore& store, const std::string& software_version,
                                 const std::function<void(int)>& progress) {
  if (auto fresh = refuse_known(trials, store); !fresh) return fresh.error();
  const auto groups = groups_of(trials);
  // One second apart: only their order is known.
  std::time_t begun = std::time(nullptr) - static_cast<std::time_t>(groups.size());
  Imported imported;
  storage::SessionRecord session;
  std::string patient;
  session.hand = spec.hand.value_or(Hand::right);
  session.device_uri = "recording://" + std::filesystem::path(spec.path).stem().string();
  session.device_description = spec.device;
  session.protocol_name = spec.name;
  session.protocol_text = spec.text;
  session.software_version = software_version;
  session.cpu_features = cpu_features();
  for (const ImportedGroup& group : groups) {
    if (group.front().patient_code != patient) {
      patient = group.front().patient_code;
      const auto added = store.add_patient(patient);
      if (!added) return added.error();
      session.patient_id = added->id;
      ++imported.patients;
    }
    const RecordedTrial& first = group.front();
    session.started_utc = utc_text(begun++);
    session.provenance = provenance_text(spec, group);
    session.calibration = first.calibration;
    session.simulated = std::any_of(group.begin(), group.end(),
                                    [](const RecordedTrial& one) { return one.simulated; });
    session.recorded = !session.simulated;
    session.rate_Hz = spec.rate_Hz > 0.0 ? spec.rate_Hz : rate_of(first.signals);
    const auto id = store.begin_session(session);
    if (!id) return id.error();
    int number = 0;
    for (const RecordedTrial& trial : group) {
      if (const auto done = store_trial(trial, ++number, session.rate_Hz, *id, store); !done) {
        static_cast<void>(store.end_session(*id).ok());
        return stopped_after(imported, trials.size(), done.error());
      }
      imported.samples += static_cast<std::int64_t>(trial.signals.rows());
      ++imported.trials;
      if (progress) progress(imported.trials);
    }
    if (auto ended = store.end_session(*id); !ended) return ended.error();
    ++imported.sessions;
  }
  return imported;
}

Result<std::vector<Measure>> store_signals_trial(const RecordedTrial& trial, Hand hand,
                                                 storage::SessionStore& store,
                                                 const std::string& software_version) {
  const auto patient = patient_of(trial.patient_code, store);
  if (!patient) return patient.error();
  storage::SessionRecord session;
  session.patient_id = patient->id;
  session.hand = hand;
  session.device_uri = "recording://signals";
  session.device_description = "Recorded signals";
  session.simulated = trial.simulated;
  session.recorded = !trial.simulated;
  session.provenance = "signals of a trial, imported\nfile: " + trial.file + "\n";
  session.protocol_name = "Imported signals";
  session.rate_Hz = rate_of(trial.signals);
  session.software_version = software_version;
  session.cpu_features = cpu_features();
  const auto id = store.begin_session(session);
  if (!id) return id.error();
  auto measures = store_trial(trial, 1, session.rate_Hz, *id, store);
  const auto ended = store.end_session(*id);
  if (measures && !ended) return ended.error();
  return measures;
}

}  // namespace isograsp::session
