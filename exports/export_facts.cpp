// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/column.hpp"
#include "exports/export_trial.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
ExportValue known(const std::optional<T>& value) {
  if (!value) return {};
  if constexpr (std::is_same_v<T, int>)
    return std::int64_t{*value};
  else
    return *value;
}

template <class Named>
ExportValue named(const std::optional<Named>& value) {
  if (!value) return {};
  return std::string(name_of(*value));
}

Json as_json(const std::vector<ExportFact>& facts) {
  Json json = Json::object();
  for (const auto& [name, value] : facts)
    std::visit(
        [&json, &name = name](const auto& known) {
          if constexpr (std::is_same_v<std::decay_t<decltype(known)>, std::monostate>)
            json[name] = nullptr;
          else
            json[name] = known;
        },
        value);
  return json;
}

Json as_json(const std::array<Vec6, kFingerCount>& wrenches) {
  Json all;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Vec6& w = wrenches[f];
    all[std::string(kFingerNames[f])] = {w[0], w[1], w[2], w[3], w[4], w[5]};
  }
  return all;
}

/// Of one platform, or of that of each hand.
Json zero_as_json(const storage::PreparationRecord& zero) {
  Json json{{"session_time_s", zero.session_time_s}, {"units", "N N N Nm Nm Nm"}};
  for (const auto& [name, row] : {std::pair("mean", &zero.mean), std::pair("sd", &zero.sd)}) {
    if (const auto both = platform::two_six_axes_of(zero.columns, *row))
      for (const Hand hand : kBothHands)
        json[std::string(name_of(hand))][name] = as_json((*both)[hand]);
    else
      json[name] = as_json(wrenches_of(zero, *row));
  }
  return json;
}

Json as_json(const Measure& measure) {
  Json one{{"name", measure.name}, {"channel", measure.channel}, {"value", nullptr}};
  const bool is_number = measure.value && std::isfinite(*measure.value);  // JSON has no other
  if (is_number) one["value"] = *measure.value;
  one["unit"] = measure.unit;
  one["version"] = measure.version;
  one["samples"] = measure.samples;
  one["excluded"] = measure.excluded;
  if (!is_number) one["reason"] = measure.value ? "not a finite number" : measure.reason;
  return one;
}

Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(nullptr) : json;
}

Json columns_of(const ExportTrial& trial, const Language& language) {
  Json columns = Json::array();
  for (const auto& group : trial.trial.groups)
    for (const auto& column : group.columns) {
      const auto facts = tasks::describe_column(column, group.name);
      Json one{{"name", column}, {"unit", facts.unit}, {"group", group.name}};
      if (!facts.axes.empty()) one["axes"] = facts.axes;
      one["description"] = translated(facts.description, language);
      columns.push_back(std::move(one));
    }
  return columns;
}

}  // namespace

namespace {

/// Of an arm that cameras saw there are no forces to tell of; what it was given stands by name.
void put_references(std::vector<ExportFact>& facts, const storage::References& references) {
  std::erase_if(facts, [](const ExportFact& fact) { return unit_of(fact.name) == "N"; });
  for (const auto& [name, value] : references)
    if (std::ranges::none_of(facts, [&name = name](const auto& fact) { return fact.name == name; }))
      facts.push_back({name, value});
}

}  // namespace

std::vector<ExportFact> patient_facts(const ExportTrial& trial) {
  return {{"code", trial.patient_code},
          {"affected_side", named(trial.affected)},
          {"dominant_hand", named(trial.dominant)},
          {"onset_days_from_first_session", known(trial.onset_day)}};
}

std::vector<ExportFact> session_facts(const ExportTrial& trial) {
  const storage::SessionRecord& session = trial.session;
  std::vector<ExportFact> facts{
      {"number", std::int64_t{trial.place.session}},
      {"days_from_first_session", known(trial.session_day)},
      {"hand", std::string(name_of(session.hand))},
      {"device", session.device_description},
      {"device_scheme", session.device_uri},
      {"simulated", session.simulated},
      {"recorded", session.recorded},
      {"protocol", session.protocol_name},
      {"rate_Hz", session.rate_Hz},
      {"device_delay_s", session.device_delay_s},
      {"display_delay_s", known(session.display_delay_s)},
      {"software_version", session.software_version},
      {"cpu_features", session.cpu_features},
      {"seed", session.seed},
      {"screening", session.allowed},
      {"ceiling_N", known(storage::value_of(session.references, platform::kCeiling_N))}};
  if (trial.place.tracked) put_references(facts, session.references);
  return facts;
}

std::vector<ExportFact> trial_facts(const ExportTrial& exported) {
  const storage::TrialRecord& trial = exported.trial;
  const auto reference = [&](std::string_view name) {
    return storage::value_of(trial.references, name);
  };
  std::vector<ExportFact> facts{
      {"number", std::int64_t{trial.number}},
      {"task", trial.task_name},
      {"task_kind", exported.place.task_kind},
      {"task_version", std::int64_t{trial.task_version}},
      {"practice", trial.practice},
      {"helped", trial.helped},
      {"status", std::string(storage::name_of(trial.status))},
      {"session_time_s", trial.session_time_s},
      {"maximum_force_N", reference(platform::kMaximumForce_N).value_or(0)},
      {"resting_force_N", reference(platform::kRestingForce_N).value_or(0)},
      {"samples", trial.samples},
      {"dropped", trial.dropped},
      {"worst_lateness_s", trial.worst_lateness_s},
      {"worst_compute_s", trial.worst_compute_s}};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    facts.push_back({std::string(kFingerNames[f]) + "_threshold_N",
                     known(reference(platform::kThreshold_N[f]))});
  for (auto& fact : std::vector<ExportFact>{
           {"seed", trial.seed},
           {"zero_drift_N", known(storage::value_of(trial.drift, platform::kDrift_N))},
           {"zero_drifted", trial.drifted},
           {"display_age_s", known(trial.display_age_s)},
           {"visual_gain_deg_per_N", known(reference(platform::kVisualGain_deg_per_N))},
           {"viewing_distance_m", known(trial.viewing_distance_m)}})
    facts.push_back(std::move(fact));
  if (exported.place.tracked) put_references(facts, trial.references);
  return facts;
}

bool are_of_cameras(std::string_view axes) noexcept {
  return axes == "cameras" || axes == "link";
}

std::string trial_as_json(const ExportTrial& trial, std::int64_t infinite,
                          const Language& language) {
  Json json{{"format", "isograsp-trial-2"},
            {"patient", as_json(patient_facts(trial))},
            {"session", as_json(session_facts(trial))},
            {"trial", as_json(trial_facts(trial))},
            {"health", parsed(trial.trial.health_json)},
            {"timing", parsed(trial.trial.timing_json)},
            {"columns", columns_of(trial, language)},
            {"axes", Json::object()},
            {"infinite_values_left_empty", infinite},
            {"instrument_zero", nullptr}};
  for (const auto& [axes, description] : kColumnAxes)
    if (trial.place.tracked || !are_of_cameras(axes))
      json["axes"][std::string(axes)] = translated(description, language);
  if (trial.zero) json["instrument_zero"] = zero_as_json(*trial.zero);
  if (const auto& rest = trial.rest) {
    const auto since_s = storage::value_of(rest->references, platform::kSinceStrapping_s);
    json["resting_force"] = {
        {"duration_s", storage::value_of(rest->references, platform::kDuration_s).value_or(0.0)},
        {"since_strapping_s", since_s ? Json(*since_s) : Json(nullptr)},
        {"samples", rest->samples.value_or(0)},
        {"units", "N N N Nm Nm Nm"},
        {"mean", as_json(wrenches_of(*rest, rest->mean))},
        {"sd", as_json(wrenches_of(*rest, rest->sd))}};
  }
  json["measures"] = Json::array();
  for (const auto& measure : trial.measures) json["measures"].push_back(as_json(measure));
  json["events"] = Json::array();
  for (const auto& event : trial.events)
    json["events"].push_back(
        {{"session_time_s", event.session_time_s}, {"kind", event.kind}, {"text", event.text}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace isograsp::exports
