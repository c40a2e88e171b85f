// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/db/person_export.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "hand/platform_records.hpp"
#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "storage/records/patient_code.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Thrown inside this file only.
struct Stopped {
  Error error;
};
template <class T>
T need(Result<T> result) {
  if (!result) throw Stopped{result.error()};
  return std::move(result).value();
}
void need(const Result<void>& result) {
  if (!result) throw Stopped{result.error()};
}

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json known_of(storage::SessionStore& store, const storage::PatientRecord& patient) {
  const storage::PatientProfile profile = need(store.profile(patient.id));
  Json json{{"affected", profile.affected ? storage::name_of(*profile.affected) : ""},
            {"dominant", profile.dominant ? name_of(*profile.dominant) : ""},
            {"onset_date", profile.onset_date},
            {"notes", profile.notes},
            {"goals", profile.goals},
            {"sex", profile.sex ? storage::name_of(*profile.sex) : ""},
            {"birth_year", or_null(profile.birth_year)}};
  for (const auto& mark : need(store.treatment_marks(patient.id)))
    json["treatment_marks"].push_back(
        {{"on_date", mark.on_date}, {"kind", mark.kind}, {"text", mark.text}});
  for (const auto& score : need(store.clinical_scores(patient.id)))
    json["clinical_scores"].push_back({{"on_date", score.on_date},
                                       {"scale", score.scale},
                                       {"value", score.value},
                                       {"text", score.text}});
  for (const auto& primary : need(store.primary_measures(patient.id)))
    json["primary_measures"].push_back({{"task", primary.task_name},
                                        {"hand", name_of(primary.hand)},
                                        {"measure", primary.measure},
                                        {"channel", primary.channel},
                                        {"chosen_utc", primary.chosen_utc},
                                        {"chosen_by", primary.chosen_by}});
  for (const auto& period : need(store.stable_periods(patient.id)))
    json["stable_periods"].push_back({{"from_date", period.from_date},
                                      {"until_date", period.until_date},
                                      {"judged_utc", period.judged_utc},
                                      {"judged_by", period.judged_by},
                                      {"text", period.text}});
  return json;
}

Json wrench_rows(const std::array<Vec6, kFingerCount>& wrenches) {
  Json json = Json::array();
  for (const Vec6& wrench : wrenches)
    json.push_back(std::vector<double>(wrench.data(), wrench.data() + wrench.size()));
  return json;
}

/// Preparations of three fingers keep the form that they always had; others have the names of their
/// columns.
void add_preparations(const std::vector<storage::PreparationRecord>& all, Json& session) {
  const auto add = [&](const char* list, const char* kind) {
    for (const auto& one : all) {
      const auto mean = platform::six_axes_of(one.columns, one.mean);
      const auto sd = platform::six_axes_of(one.columns, one.sd);
      if (!mean || !sd || one.kind != kind) continue;
      Json json{{"session_time_s", one.session_time_s}};
      if (const auto duration_s = storage::value_of(one.references, platform::kDuration_s))
        json["duration_s"] = *duration_s;
      json["mean_N_Nm"] = wrench_rows(*mean);
      json["sd_N_Nm"] = wrench_rows(*sd);
      session[list].push_back(json);
    }
  };
  add("instrument_zeros", platform::kInstrumentZero);
  add("resting_forces", platform::kRestingForce);
  for (const auto& one : all)
    if (!platform::six_axes_of(one.columns, one.mean))
      session["preparations"].push_back({{"kind", one.kind},
                                         {"session_time_s", one.session_time_s},
                                         {"columns", one.columns},
                                         {"mean", one.mean},
                                         {"sd", one.sd}});
}

Json trial_of(storage::SessionStore& store, const storage::TrialRecord& trial) {
  Json json{{"number", trial.number},
            {"task", trial.task_name},
            {"task_version", trial.task_version},
            {"practice", trial.practice},
            {"session_time_s", trial.session_time_s},
            {"status", storage::name_of(trial.status)},
            {"samples", trial.samples},
            {"maximum_force_N",
             storage::value_of(trial.references, platform::kMaximumForce_N).value_or(0.0)},
            {"resting_force_N",
             storage::value_of(trial.references, platform::kRestingForce_N).value_or(0.0)},
            {"helped", trial.helped},
            {"task_text", trial.task_text},
            {"scene_text", trial.scene_text}};
  for (const Measure& measure : need(store.measures_of_all_versions(trial.id)))
    json["measures"].push_back({{"name", measure.name},
                                {"channel", measure.channel},
                                {"value", or_null(measure.value)},
                                {"unit", measure.unit},
                                {"version", measure.version},
                                {"reason", measure.reason}});
  return json;
}

Json session_of(storage::SessionStore& store, const storage::SessionRecord& session) {
  Json json{{"started_utc", session.started_utc},
            {"ended_utc", session.ended_utc},
            {"hand", name_of(session.hand)},
            {"device", session.device_description},
            {"simulated", session.simulated},
            {"recorded", session.recorded},
            {"protocol", session.protocol_name},
            {"operator", session.operator_name},
            {"allowed", session.allowed},
            {"ceiling_N", or_null(storage::value_of(session.references, platform::kCeiling_N))}};
  for (const auto& answer : need(store.answers(session.id)))
    json["answers"].push_back(
        {{"topic", answer.topic}, {"item", answer.item}, {"value", answer.value}});
  add_preparations(need(store.preparations(session.id)), json);
  for (const auto& rating : need(store.ratings(session.id)))
    json["ratings"].push_back(
        {{"session_time_s", rating.session_time_s},
         {"effort", rating.effort},
         {"pain", rating.pain},
         {"shoulder_pain", rating.shoulder_pain ? Json(*rating.shoulder_pain) : Json(nullptr)}});
  for (const auto& event : need(store.events(session.id)))
    json["events"].push_back(
        {{"session_time_s", event.session_time_s}, {"kind", event.kind}, {"text", event.text}});
  return json;
}

Json access_of(storage::Access& access, const std::string& code) {
  Json json = Json::object();
  if (access.is_protected())
    if (const auto identity = need(storage::read_identity_for_person(access, code)))
      json["identity"] = {{"name", identity->name},
                          {"birth_date", identity->birth_date},
                          {"contact", identity->contact}};
  for (const storage::Consent& consent : need(storage::consents(access, code)))
    json["consents"].push_back({{"on_date", consent.on_date},
                                {"purpose", consent.purpose},
                                {"basis", consent.basis},
                                {"state", consent.state},
                                {"text", consent.text},
                                {"recorded_utc", consent.recorded_utc},
                                {"recorded_by", consent.recorded_by}});
  return json;
}

int write_all_of(storage::Access& access, storage::SessionStore& store,
                 const storage::PatientRecord& patient, const fs::path& folder) {
  Json json{{"code", patient.code}, {"created_utc", patient.created_utc}};
  json.update(access_of(access, patient.code));
  json["profile"] = known_of(store, patient);
  std::string table =
      "session,started_utc,hand,simulated,recorded,trial,task,measure,channel,value,unit,version,"
      "reason\n";
  int trials = 0;
  int number = 0;
  for (const storage::SessionRecord& session : need(store.sessions(patient.id))) {
    const std::string session_name = "session_" + std::to_string(++number);
    fs::create_directory(folder / session_name);
    Json one = session_of(store, session);
    for (const storage::TrialRecord& trial : need(store.trials(session.id))) {
      ++trials;
      one["trials"].push_back(trial_of(store, trial));
      const Signals signals = need(store.signals(trial));
      if (signals.rows() > 0)
        need(write_signals(
            signals,
            (folder / session_name / ("trial_" + std::to_string(trial.number) + ".csv")).string()));
      for (const Measure& measure : need(store.measures_of_all_versions(trial.id)))
        table += std::to_string(number) + "," + csv_field(session.started_utc) + "," +
                 std::string(name_of(session.hand)) + "," + (session.simulated ? "1," : "0,") +
                 (session.recorded ? "1," : "0,") + std::to_string(trial.number) + "," +
                 csv_field(trial.task_name) + "," + csv_field(measure.name) + "," +
                 csv_field(measure.channel) + "," +
                 (measure.value ? format_number(*measure.value) : "") + "," +
                 csv_field(measure.unit) + "," + std::to_string(measure.version) + "," +
                 csv_field(measure.reason) + "\n";
    }
    json["sessions"].push_back(std::move(one));
  }
  need(write_text((folder / "measures.csv").string(), table));
  constexpr int kIndent = 2;
  need(write_text((folder / "person.json").string(),
                  json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n"));
  return trials;
}

}  // namespace

Result<int> export_person(storage::Access& access, const std::string& code,
                          const std::string& folder) {
  const bool known = storage::check_patient_code(code).ok();
  if (access.is_protected())
    if (const auto allowed =
            access.require(storage::Right::identities, "export person", known ? code : "");
        !allowed)
      return allowed.error();
  const auto store = storage::open_store_to_read(access.path());
  if (!store) return store.error();
  const auto patient = (*store)->find_patient(code);
  if (!patient) return patient.error();
  if (!*patient)
    return refused("there is no patient of this code"_text, "see the list of patients"_text)
        .at(access.path())
        .about("--patient");
  std::error_code failure;
  if (!fs::create_directory(folder, failure))
    return refused(failure ? "cannot be made: %1"_text(Known{failure.message()})
                           : "exists already"_text,
                   "name a new folder in one that exists"_text)
        .at(folder)
        .about("--out");
  fs::permissions(folder, fs::perms::owner_all, failure);
  Result<int> done = 0;
  try {
    done = write_all_of(access, **store, **patient, folder);
  } catch (const Stopped& stopped) {
    done = stopped.error;
  } catch (const std::exception& why) {
    done = failed(Known{why.what()}, "check the disk"_text).at(folder);
  }
  if (!done) fs::remove_all(folder, failure);
  if (access.can_log())
    if (const auto logged = storage::log_act(access, "export person", (*patient)->code, done.ok());
        !logged)
      return logged.error();
  return done;
}

}  // namespace isograsp::app
