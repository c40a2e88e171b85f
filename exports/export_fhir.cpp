// SPDX-License-Identifier: GPL-3.0-or-later
// HL7 FHIR R4: a Bundle for each session with the patient (a code and nothing else), the device and
// two Observations for each trial: measures as components, signals as SampledData.
#include <cmath>
#include <tuple>

#include <boost/uuid/uuid_generators.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "exports/export_writer.hpp"
#include "exports/fhir_codes.hpp"
#include "tasks/facts/column_facts.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kUcum = "http://unitsofmeasure.org";
constexpr const char* kPatientCodes = "urn:uuid:0f5c1c0e-7a53-4b1c-8a0e-2f2f5a1d6c77";
constexpr const char* kCodesFile = "codesystem.json";

std::string file_of(const ExportPlace& place) {
  return "patient_" + std::to_string(place.patient) + "/session_" + std::to_string(place.session) +
         "_bundle.json";
}

/// A name that no other export has, so that bundles of several clinics can be put together.
std::string new_urn() {
  return "urn:uuid:" + boost::uuids::to_string(boost::uuids::random_generator()());
}

Text body_site(std::optional<Hand> hand) {
  if (!hand) return "both hands"_text;
  return *hand == Hand::right ? "right hand"_text : "left hand"_text;
}

Json quantity(double value, const std::string& unit) {
  Json json{{"value", value}};
  json["unit"] = unit.empty() ? "1" : unit;
  if (const auto code = ucum_code(unit)) {
    json["system"] = kUcum;
    json["code"] = *code;
  }
  return json;
}

/// Says that a value is not given, and why.
Json absent(const std::string& reason) {
  return {{"coding",
           {{{"system", "http://terminology.hl7.org/CodeSystem/data-absent-reason"},
             {"code", "unknown"}}}},
          {"text", reason}};
}

/// "E": no value; beyond what a number can hold: "U" above, "L" below.
std::string sampled(std::span<const double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    if (std::isnan(value))
      text += 'E';
    else if (std::isinf(value))
      text += value > 0.0 ? 'U' : 'L';
    else
      append_number(text, value);
  }
  return text;
}

/// Group and name of each column of the signals, in order.
std::vector<std::pair<std::string, std::string>> columns_by_group(const ExportTrial& trial) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& group : trial.trial.groups)
    for (const auto& column : group.columns) all.emplace_back(group.name, column);
  return all;
}

class FhirExport final : public ExportWriter {
 public:
  FhirExport(fs::path folder, const Language& language)
      : folder_(std::move(folder)), language_(language) {}

  std::vector<std::string> files_of(const ExportPlace& place) const override {
    return {kCodesFile, file_of(place)};
  }

  Result<void> write(const ExportTrial& trial) override {
    if (trial.place.patient != at_.patient || trial.place.session != at_.session)
      if (const auto done = next_session(trial); !done) return done;
    add_resource(new_urn(), measures_of(trial));
    add_resource(new_urn(), signals_of(trial));
    return {};
  }

  Result<void> finish() override {
    if (const auto done = end_session(); !done) return done;
    return write_below(folder_ / kCodesFile, codes_.resource(language_));
  }

 private:
  Result<void> next_session(const ExportTrial& trial) {
    if (const auto done = end_session(); !done) return done;
    const fs::path path = folder_ / file_of(trial.place);
    if (const auto made = make_folder(path.parent_path()); !made) return made;
    auto file = FileWriter::create(path);
    if (!file) return file.error();
    file_.emplace(*std::move(file));
    if (trial.place.patient != at_.patient) patient_urn_ = new_urn();
    device_urn_ = new_urn();
    at_ = trial.place;
    Json head{{"resourceType", "Bundle"}, {"meta", meta_of(trial)}, {"type", "collection"}};
    add_language(head, language_);
    std::string text = head.dump();
    text.back() = ',';  // what was the closing brace
    file_->write(text + "\"entry\":[");
    first_ = true;
    add_resource(patient_urn_,
                 {{"resourceType", "Patient"},
                  {"identifier", {{{"system", kPatientCodes}, {"value", trial.patient_code}}}}});
    add_resource(device_urn_, device_of(trial));
    return {};
  }

  Result<void> end_session() {
    if (!file_) return {};
    file_->write("]}\n");
    const auto done = file_->commit();
    file_.reset();
    return done;
  }

  void add_resource(const std::string& urn, const Json& resource) {
    const Json entry{{"fullUrl", urn}, {"resource", resource}};
    file_->write((first_ ? "\n" : ",\n") +
                 entry.dump(-1, ' ', false, Json::error_handler_t::replace));
    first_ = false;
  }

  /// Marks the data as pseudonymous, and as test data if the device was simulated.
  static Json meta_of(const ExportTrial& trial) {
    Json meta{{"security",
               {{{"system", "http://terminology.hl7.org/CodeSystem/v3-ObservationValue"},
                 {"code", "PSEUDED"},
                 {"display", "pseudonymized"}}}}};
    if (trial.session.simulated)
      meta["tag"] = {{{"system", "http://terminology.hl7.org/CodeSystem/v3-ActReason"},
                      {"code", "HTEST"},
                      {"display", "test health data"}}};
    return meta;
  }

  static Json device_of(const ExportTrial& trial) {
    return {
        {"resourceType", "Device"},
        {"meta", meta_of(trial)},
        {"deviceName",
         {{{"name", trial.session.device_description.empty() ? "not known"
                                                             : trial.session.device_description},
           {"type", "user-friendly-name"}}}},
        {"version",
         {{{"type", {{"text", "software"}}},
           {"value", "IsoGrasp " + trial.session.software_version}}}}};
  }

  /// The display of a code is in the chosen language; its definition is in English.
  Json coded(const std::string& code, const char* kind, const Text& words, std::string definition) {
    codes_.add(code, {kind, say(words), std::move(definition)});
    const std::string& display = codes_.display(code);
    return {{"coding", {{{"system", kFhirCodes}, {"code", code}, {"display", display}}}},
            {"text", display}};
  }

  std::string say(const Text& text) const { return translated(text, language_); }

  Json context(const std::string& code, Words words, double value, const std::string& unit) {
    return {{"code", coded(code, "context", words, std::string(words.english()) + ".")},
            {"valueQuantity", quantity(value, unit)}};
  }

  /// What both Observations of a trial say.
  Json observation(const ExportTrial& trial, Json code) {
    Json json{{"resourceType", "Observation"}, {"meta", meta_of(trial)}};
    json["status"] = trial.trial.status == storage::TrialStatus::completed ? "final" : "cancelled";
    json["code"] = std::move(code);
    json["subject"] = {{"reference", patient_urn_}};
    // The date stays in the clinic; the day within the course is a component.
    json["_effectiveDateTime"] = {
        {"extension",
         {{{"url", "http://hl7.org/fhir/StructureDefinition/data-absent-reason"},
           {"valueCode", "masked"}}}}};
    json["bodySite"] = {{"text", say(body_site(trial.session.hand))}};
    json["method"] = {{"text", say("%1, version %2"_text(Known{trial.trial.task_name},
                                                         trial.trial.task_version))}};
    json["device"] = {{"reference", device_urn_}};
    json["component"] = Json::array();
    auto& components = json["component"];
    if (trial.session_day)
      components.push_back(context("days_from_first_session", "Days from the first session"_text,
                                   *trial.session_day, "d"));
    components.push_back(
        context("session_number", "Number of the session"_text, trial.place.session, ""));
    components.push_back(
        context("trial_number", "Number of the trial"_text, trial.place.trial, ""));
    components.push_back(context("session_time", "Start of the trial in its session"_text,
                                 trial.trial.session_time_s, "s"));
    for (const auto& [name, words, yes] :
         {std::tuple<const char*, Words, bool>{"practice", "Practice"_text, trial.trial.practice},
          {"helped", "The therapist helped"_text, trial.trial.helped}})
      components.push_back(
          {{"code", coded(name, "context", words, std::string(words.english()) + ".")},
           {"valueBoolean", yes}});
    return json;
  }

  Json measures_of(const ExportTrial& trial) {
    const std::string& task = trial.place.task_kind;
    Json json = observation(trial, coded(task, "task", "%1"_text(task),
                                         "Kind of the task, as docs/file_formats.md calls it."));
    for (const auto& measure : trial.measures) {
      const auto words = tasks::words_of(measure.name, measure.channel);
      const std::string unit = measure.unit.empty() ? "no unit" : measure.unit;
      Json component{
          {"code", coded(fhir_code(measure), "measure", words.title,
                         "Measure " + measure.name + " of channel " + measure.channel +
                             ", version " + std::to_string(measure.version) + "; " + unit + ".")}};
      if (measure.value && std::isfinite(*measure.value))
        component["valueQuantity"] = quantity(*measure.value, measure.unit);
      else
        component["dataAbsentReason"] =
            absent(say(measure.value ? Text("not a finite number"_text)
                                     : tasks::reason_words(measure.reason)));
      json["component"].push_back(std::move(component));
    }
    return json;
  }

  Json signals_of(const ExportTrial& trial) {
    Json json = observation(trial, coded("signals", "task", "Signals of a trial"_text,
                                         "Every column of a trial, one component each."));
    constexpr double kMsPerSecond = 1000.0;
    if (trial.signals.rows() == 0) return json;
    std::size_t next = 0;
    for (const auto& [group, name] : columns_by_group(trial)) {
      const auto facts = tasks::describe_column(name, group);
      const std::string axes = facts.axes.empty() ? "" : " Axes: " + facts.axes + ".";
      // No factor and an origin of 0: the values stand there themselves, to the last bit.
      json["component"].push_back({{"code", coded("signal:" + name, "signal", facts.description,
                                                  english(facts.description) + "." + axes)},
                                   {"valueSampledData",
                                    {{"origin", quantity(0.0, facts.unit)},
                                     {"period", kMsPerSecond / trial.session.rate_Hz},
                                     {"dimensions", 1},
                                     {"data", sampled(trial.signals.column(next++))}}}});
    }
    return json;
  }

  fs::path folder_;
  const Language& language_;
  ExportPlace at_;  ///< of the trial written last
  std::optional<FileWriter> file_;
  bool first_ = true;
  std::string patient_urn_;
  std::string device_urn_;
  FhirCodes codes_;
};

}  // namespace

std::unique_ptr<ExportWriter> make_fhir_writer(fs::path folder, const Language& language) {
  return std::make_unique<FhirExport>(std::move(folder), language);
}

}  // namespace isograsp::exports
