// SPDX-License-Identifier: GPL-3.0-or-later
// A dataset in the layout of Motion-BIDS (Brain Imaging Data Structure 1.9, datatype "motion"): a
// run for each trial. Forces are MISC channels, the virtual object POS, ORNT and VEL; what cameras
// saw of an arm is POS and ORNT, its links JNTANG.
#include <cmath>
#include <cstdio>
#include <set>

#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "exports/bids_events.hpp"
#include "exports/bids_sidecars.hpp"
#include "exports/export_list.hpp"
#include "exports/export_writer.hpp"
#include "hand/columns.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kNotAvailable = "n/a";
const std::string kDerivatives = "derivatives/isograsp/";

std::string label(const char* entity, int number) {
  char text[32];
  std::snprintf(text, sizeof text, "%s-%02d", entity, number);
  return text;
}
std::string subject_of(const ExportPlace& place) {
  return label("sub", place.patient);
}
std::string session_of(const ExportPlace& place) {
  return subject_of(place) + "_" + label("ses", place.session);
}
/// sub-01/ses-02
std::string folder_of(const ExportPlace& place) {
  return subject_of(place) + "/" + label("ses", place.session);
}
/// motion/sub-01_ses-02_task-gripforce_tracksys-isograsp_run-03, below the session's folder; of
/// what cameras saw tracksys-cameras
std::string stem_of(const ExportPlace& place) {
  std::string task;
  for (const char letter : place.task_kind)
    if (letter != '_') task += letter;
  return "motion/" + session_of(place) + "_task-" + task + "_tracksys-" +
         (place.tracked ? "cameras" : "isograsp") + "_" + label("run", place.trial);
}

std::string or_missing(const std::string& text) {
  return text.empty() ? kNotAvailable : text;
}
std::string cell_of(const ExportValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return tsv_cell(*text);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return kNotAvailable;
}

/// Type of a channel as the specification names them.
std::string type_of(std::string_view name, std::string_view group,
                    const tasks::ColumnFacts& facts) {
  if (name == columns::t_s) return "LATENCY";
  if (group == tasks::kLinkGroup) return "JNTANG";
  if (facts.component.starts_with("quat_")) return "ORNT";
  if (facts.component.empty()) return "MISC";
  if (facts.unit == "m") return "POS";
  if (facts.unit == "rad") return "ORNT";
  if (facts.unit == "m/s" || facts.unit == "rad/s") return "VEL";
  return "MISC";
}

/// What motion.json says of the channels.
struct ChannelCounts {
  Json by_type = Json::object();
  std::set<std::string> tracked_points;
};

std::string channels_table(const ExportTrial& trial, ChannelCounts& counts,
                           const Language& language) {
  std::string table =
      "name\tcomponent\ttype\ttracked_point\tunits\treference_frame\tgroup\tdescription\n";
  for (const auto& group : trial.trial.groups)
    for (const auto& name : group.columns) {
      const auto facts = tasks::describe_column(name, group.name);
      const std::string type = type_of(name, group.name, facts);
      const std::string unit = facts.unit == "N m" ? "N*m" : facts.unit;
      for (const auto& field : {name, or_missing(facts.component), type, or_missing(facts.body),
                                or_missing(unit), or_missing(facts.axes), group.name})
        table += tsv_cell(field) + "\t";
      table += translated(facts.description, language) + "\n";
      const std::string count = type + "ChannelCount";
      counts.by_type[count] = counts.by_type.value(count, 0) + 1;
      if (type == "POS" || type == "ORNT" || type == "VEL")
        counts.tracked_points.insert(facts.body);
    }
  return table;
}

/// Rows of numbers without a header. Latency counts from the first row.
std::string motion_table(const Signals& signals) {
  std::string table;
  const auto times = signals.column(columns::t_s);
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    for (std::size_t c = 0; c < signals.names().size(); ++c) {
      if (c > 0) table += '\t';
      double value = signals.column(c)[row];
      if (signals.names()[c] == columns::t_s) value -= times.front();
      if (std::isfinite(value))
        append_number(table, value);
      else
        table += kNotAvailable;
    }
    table += '\n';
  }
  return table;
}

double duration_s(const ExportTrial& trial) {
  const auto times = trial.signals.column(columns::t_s);
  if (times.empty()) return 0.0;
  return times.back() - times.front() + 1.0 / trial.session.rate_Hz;
}

std::string motion_sidecar(const ExportTrial& trial, const ChannelCounts& counts,
                           const Language& language) {
  Json json{{"TaskName", trial.place.task_kind},
            {"TaskDescription", translated("%1, version %2"_text(Known{trial.trial.task_name},
                                                                 trial.trial.task_version),
                                           language)},
            {"Instructions", translated(Known{trial.instruction}, language)},
            {"SamplingFrequency", trial.session.rate_Hz},
            {"TrackingSystemName", trial.place.tracked ? "Cameras" : "IsoGrasp"},
            {"ManufacturersModelName", trial.session.device_description},
            {"SoftwareVersions", trial.session.software_version},
            {"RecordingDuration", duration_s(trial)},
            {"MissingValues", kNotAvailable}};
  json.update(counts.by_type);
  int motion = 0;
  for (const char* type :
       {"POSChannelCount", "ORNTChannelCount", "VELChannelCount", "JNTANGChannelCount"})
    motion += counts.by_type.value(type, 0);
  json["MotionChannelCount"] = motion;
  json["TrackedPointsCount"] = counts.tracked_points.size();
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// What BIDS has no place for: measures, health, zero, texts of task and scene.
std::string derived(const ExportTrial& trial) {
  Json json = Json::parse(trial_as_json(trial, 0), nullptr, false);
  for (const char* of_tables : {"columns", "axes", "infinite_values_left_empty"})
    json.erase(of_tables);
  json["task_text"] = trial.trial.task_text;
  json["scene_text"] = trial.trial.scene_text;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

class BidsExport final : public ExportWriter {
 public:
  BidsExport(fs::path folder, const Language& language)
      : folder_(std::move(folder)), language_(language) {}

  std::vector<std::string> files_of(const ExportPlace& place) const override {
    const std::string subject = subject_of(place) + "/" + subject_of(place);
    const std::string session = folder_of(place) + "/" + session_of(place);
    const std::string stem = folder_of(place) + "/" + stem_of(place);
    return {".bidsignore",
            "README",
            "dataset_description.json",
            "participants.json",
            "participants.tsv",
            subject + "_sessions.json",
            subject + "_sessions.tsv",
            session + "_scans.json",
            session + "_scans.tsv",
            stem + "_channels.json",
            stem + "_channels.tsv",
            stem + "_events.json",
            stem + "_events.tsv",
            stem + "_motion.json",
            stem + "_motion.tsv",
            kDerivatives + "dataset_description.json",
            kDerivatives + stem + "_measures.json"};
  }

  Result<void> write(const ExportTrial& trial) override {
    const ExportPlace& place = trial.place;
    if (place.patient != at_.patient || place.session != at_.session)
      if (const auto done = next_session(trial); !done) return done;
    const fs::path stem = folder_ / folder_of(place) / stem_of(place);
    ChannelCounts counts;
    const std::string channels = channels_table(trial, counts, language_);
    for (const auto& [ending, text] :
         {std::pair<const char*, std::string>{"_channels.tsv", channels},
          {"_channels.json", bids_channels_sidecar(place.tracked, language_)},
          {"_events.tsv", bids_events(trial)},
          {"_events.json", bids_events_sidecar(language_)},
          {"_motion.json", motion_sidecar(trial, counts, language_)},
          {"_motion.tsv", motion_table(trial.signals)}})
      if (const auto done = write_below(stem.string() + ending, text); !done) return done;
    const std::string measures = folder_of(place) + "/" + stem_of(place) + "_measures.json";
    if (const auto done = write_below(folder_ / kDerivatives / measures, derived(trial)); !done)
      return done;
    scans_ += stem_of(place) + "_motion.tsv\t" + format_number(trial.trial.session_time_s) + "\t" +
              std::string(storage::name_of(trial.trial.status)) + "\t" +
              (trial.trial.practice ? "1" : "0") + "\t" + (trial.trial.helped ? "1" : "0") + "\n";
    return {};
  }

  Result<void> finish() override {
    if (const auto done = end_patient(); !done) return done;
    const std::string participants =
        "participant_id\tcode\taffected_side\thandedness\tonset_days_from_first_session\n" +
        participants_;
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{"dataset_description.json",
                                              bids_description("raw", language_)},
          {kDerivatives + "dataset_description.json", bids_description("derivative", language_)},
          {"participants.tsv", participants},
          {"participants.json", bids_participants_sidecar(language_)},
          {".bidsignore", std::string(kExportList) + "\n" + kExportSignature + "\n"},
          {"README", bids_readme(language_)}})
      if (const auto done = write_below(folder_ / name, text); !done) return done;
    return {};
  }

 private:
  Result<void> next_session(const ExportTrial& trial) {
    const bool same = at_.patient == trial.place.patient;
    if (const auto done = same ? end_session() : end_patient(); !done) return done;
    if (!same) {
      participants_ += subject_of(trial.place);
      for (const auto& fact : patient_facts(trial)) participants_ += "\t" + cell_of(fact.value);
      participants_ += "\n";
    }
    at_ = trial.place;
    const storage::SessionRecord& session = trial.session;
    sessions_ += label("ses", at_.session) + "\t" +
                 (trial.session_day ? std::to_string(*trial.session_day) : kNotAvailable) + "\t" +
                 std::string(name_of(session.hand)) + "\t" + (session.simulated ? "1" : "0") +
                 "\t" + (session.recorded ? "1" : "0") + "\n";
    return {};
  }

  Result<void> end_session() {
    const fs::path stem = folder_ / folder_of(at_) / session_of(at_);
    const std::string table = "filename\tsession_time_s\tstatus\tpractice\thelped\n" + scans_;
    scans_.clear();
    if (const auto done = write_below(stem.string() + "_scans.tsv", table); !done) return done;
    return write_below(stem.string() + "_scans.json", bids_scans_sidecar(language_));
  }

  Result<void> end_patient() {
    if (at_.patient == 0) return {};
    if (const auto done = end_session(); !done) return done;
    const fs::path stem = folder_ / subject_of(at_) / subject_of(at_);
    const std::string table =
        "session_id\tdays_from_first_session\thand\tsimulated\trecorded\n" + sessions_;
    sessions_.clear();
    if (const auto done = write_below(stem.string() + "_sessions.tsv", table); !done) return done;
    return write_below(stem.string() + "_sessions.json", bids_sessions_sidecar(language_));
  }

  fs::path folder_;
  const Language& language_;
  ExportPlace at_;  ///< of the trial written last
  // Rows of the tables that are not written yet.
  std::string participants_;
  std::string sessions_;
  std::string scans_;
};

}  // namespace

std::unique_ptr<ExportWriter> make_bids_writer(fs::path folder, const Language& language) {
  return std::make_unique<BidsExport>(std::move(folder), language);
}

}  // namespace isograsp::exports
