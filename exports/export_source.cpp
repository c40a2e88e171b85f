// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/export_source.hpp"

#include <algorithm>
#include <cmath>

#include "core/date.hpp"
#include "exports/link_angles.hpp"
#include "hand/anatomical_axes.hpp"
#include "tasks/facts/column_facts.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::exports {

namespace {

/// Where the joints of a tracked hand are (session/tracked_hand/hand_trial).
constexpr std::string_view kJointGroup = "joints";
/// How the calibration of a session with one begins.
constexpr std::string_view kTrackedHand = "format = \"isograsp-tracker-1\"";

/// The day of "2026-03-01" or "2026-03-01T…".
std::optional<Date> day_of(const std::string& iso) {
  constexpr std::size_t kDay = 10;
  return date_from_iso(std::string_view(iso).substr(0, std::min(kDay, iso.size())));
}

std::optional<int> days(const std::string& first, const std::string& second) {
  const auto from = day_of(first);
  const auto to = day_of(second);
  if (!from || !to) return {};
  return days_between(*from, *to);
}

storage::SessionRecord without_identity(const storage::SessionRecord& session, bool tracked) {
  storage::SessionRecord safe = session;
  safe.started_utc.clear();
  safe.ended_utc.clear();
  // The name of a recording's file may name a person, so it is not exported.
  const bool hand = session.calibration.starts_with(kTrackedHand);
  if (safe.recorded)
    safe.device_description = hand      ? "Recorded hands"
                              : tracked ? "Recorded markers"
                                        : "Recorded forces";
  safe.device_uri = session.device_uri.substr(0, session.device_uri.find(':'));
  safe.provenance.clear();
  safe.protocol_text.clear();
  safe.sensors.clear();
  safe.operator_name.clear();
  return safe;
}

/// Positions of joints carry the geometry of a hand, which is a measure of the body: they leave
/// only where research was agreed to; the length of a hand leaves to 10 mm.
void keep_body_to_oneself(bool research_agreed, ExportTrial& exported) {
  constexpr double kPerCoarse = 100.0;  // 10 mm
  auto& references = exported.trial.references;
  if (const auto length = references.find("hand_length_m"); length != references.end())
    length->second = std::round(length->second * kPerCoarse) / kPerCoarse;
  if (research_agreed) return;
  auto& groups = exported.trial.groups;
  if (std::erase_if(groups, [](const auto& group) { return group.name == kJointGroup; }) == 0)
    return;
  Signals kept;
  for (const storage::SignalGroup& group : groups)
    for (const std::string& name : group.columns) {
      const auto values = exported.signals.column(name);
      kept.add_column(name, {values.begin(), values.end()});
    }
  exported.signals = std::move(kept);
}

storage::PreparationRecord without_time(storage::PreparationRecord record) {
  record.recorded_utc.clear();
  record.operator_name.clear();
  return record;
}

ExportPlace place_of(int patient, int session, const storage::TrialRecord& trial) {
  const auto task = tasks::parse_task(trial.task_text, trial.task_name);
  return {patient,
          session,
          trial.number,
          std::string(task ? task->kind->name : "unknown"),
          !trial.scene_text.empty(),
          std::ranges::any_of(trial.groups, [](const storage::SignalGroup& group) {
            return group.name == tasks::kSegmentGroup || group.name == tasks::kMarkerGroup;
          })};
}

/// The forces in the axes of the hand as a group of their own behind the stored ones.
void add_forces_of_the_hand(ExportTrial& exported) {
  const std::size_t stored = exported.signals.names().size();
  // For devices of others it is not known how they stood, and often not for which hand.
  if (exported.session.device_uri != "recording" && exported.session.hand)
    add_anatomical_forces(exported.signals, *exported.session.hand);
  const auto& names = exported.signals.names();
  if (names.size() > stored)
    exported.trial.groups.push_back(
        {"anatomical", {names.begin() + static_cast<std::ptrdiff_t>(stored), names.end()}});
}

}  // namespace

Error not_released(const std::string& code, const std::string& file, const std::string& field) {
  return refused("the records of %1 are not released for research"_text(code),
                 "leave this person out, or record the consent that was given"_text)
      .at(file)
      .about(field);
}

Result<std::size_t> count_not_released(storage::SessionStore& store, const ExportRequest& request) {
  const auto patients = store.patients();
  if (!patients) return patients.error();
  std::size_t count = 0;
  for (const auto& patient : *patients) {
    if (!request.patient.empty() && patient.code != request.patient) continue;
    const auto released = store.may_be_used_for_research(patient.id);
    if (!released) return released.error();
    if (!*released) ++count;
  }
  return count;
}

Result<void> for_each_trial(storage::SessionStore& store, const ExportRequest& request,
                            const std::function<Result<void>(const ExportSource&)>& visit) {
  const auto patients = store.patients();
  if (!patients) return patients.error();
  bool found = request.patient.empty();
  int number = 0;
  for (const auto& patient : *patients) {
    ++number;
    if (!request.patient.empty() && patient.code != request.patient) continue;
    found = true;
    const auto released = store.may_be_used_for_research(patient.id);
    if (!released) return released.error();
    if (!*released && request.patient.empty()) continue;
    if (!*released) return not_released(patient.code, store.path(), "--patient");
    const auto sessions = store.sessions(patient.id);
    if (!sessions) return sessions.error();
    const auto profile = store.profile(patient.id);
    if (!profile) return profile.error();
    ExportSource source;
    source.patient = &patient;
    source.profile = &*profile;
    if (!sessions->empty()) source.first_started_utc = sessions->front().started_utc;
    int session_number = 0;
    for (const auto& session : *sessions) {
      ++session_number;
      if (session_number < request.first_session) continue;
      if (request.last_session && session_number > *request.last_session) continue;
      const auto trials = store.trials(session.id);
      if (!trials) return trials.error();
      source.session = &session;
      for (const auto& trial : *trials) {
        if (trial.status == storage::TrialStatus::running) continue;
        source.trial = &trial;
        source.place = place_of(number, session_number, trial);
        if (const auto done = visit(source); !done) return done;
      }
    }
  }
  if (!found)
    return refused("there is no patient '%1'"_text(request.patient), "check the code"_text)
        .at(store.path())
        .about("--patient");
  return {};
}

Result<ExportTrial> load_trial(storage::SessionStore& store, const ExportSource& source) {
  ExportTrial exported;
  exported.place = source.place;
  exported.patient_code = source.patient->code;
  exported.affected = source.profile->affected;
  exported.dominant = source.profile->dominant;
  exported.onset_day = days(source.first_started_utc, source.profile->onset_date);
  exported.session_day = days(source.first_started_utc, source.session->started_utc);
  exported.session = without_identity(*source.session, source.place.tracked);
  exported.trial = *source.trial;
  if (const auto task = tasks::parse_task(source.trial->task_text, source.trial->task_name))
    exported.instruction = task->instruction;

  auto signals = store.signals(*source.trial);
  if (!signals) return signals.error();
  exported.signals = *std::move(signals);
  const auto research = store.consent_state(source.patient->id, "research");
  if (!research) return research.error();
  keep_body_to_oneself(source.session->simulated || *research == "given", exported);
  add_forces_of_the_hand(exported);
  add_link_angles(exported);

  const auto preparations = store.preparations(source.session->id);
  if (!preparations) return preparations.error();
  for (const auto& one : *preparations) {
    const bool of_two = platform::two_six_axes_of(one.columns, one.mean).has_value();
    if (!of_two && !platform::six_axes_of(one.columns, one.mean)) continue;  // of another apparatus
    const bool in_force = std::ranges::count(source.trial->preparations, one.id) > 0;
    if ((of_two || one.kind == platform::kInstrumentZero) && in_force)
      exported.zero = without_time(one);
    if (one.kind == platform::kRestingForce && one.trial_id == source.trial->id)
      exported.rest = without_time(one);
  }
  auto measures = store.measures(source.trial->id);
  if (!measures) return measures.error();
  exported.measures = *std::move(measures);
  const auto events = store.events(source.session->id);
  if (!events) return events.error();
  for (const auto& event : *events)
    if (event.trial_id == source.trial->id && event.kind != "note")  // may identify a person
      exported.events.push_back(event);
  return exported;
}

}  // namespace isograsp::exports
