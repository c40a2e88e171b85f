// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/bids_events.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "hand/columns.hpp"

namespace isograsp::exports {

namespace {

using Json = nlohmann::ordered_json;

/// By the numbers of the column `phase`; those of `cue` (docs/file_formats.md).
constexpr std::array<const char*, 6> kPhases{"lead_in", "active", "transport",
                                             "hold",    "paused", "done"};
constexpr std::array<const char*, 8> kCues{"hand_out", "relax",     "squeeze", "press",
                                           "follow",   "reproduce", "let_go",  "move"};
constexpr std::array<Words, kCues.size()> kAskedTo{
    "the patient was asked to take the hand out"_text,
    "the patient was asked to relax"_text,
    "the patient was asked to squeeze"_text,
    "the patient was asked to press"_text,
    "the patient was asked to follow the target"_text,
    "the patient was asked to reproduce the force without seeing it"_text,
    "the patient was asked to let go"_text,
    "the patient was asked to move the object"_text};

struct Row {
  double onset_s = 0.0;
  std::optional<double> duration_s;
  std::string type;
  std::string text;
};

/// Stretches in which a column of numbers of an enumeration stays the same.
template <std::size_t Size>
void add_stretches(std::vector<Row>& rows, const ExportTrial& trial, const Column& column,
                   const std::array<const char*, Size>& names) {
  const auto values = trial.signals.column(column);
  const auto times = trial.signals.column(columns::t_s);
  for (std::size_t begin = 0; begin < values.size();) {
    std::size_t end = begin + 1;
    while (end < values.size() && values[end] == values[begin]) ++end;
    const double last_s =
        end < values.size() ? times[end] : times.back() + 1.0 / trial.session.rate_Hz;
    const double value = values[begin];
    if (value >= 0.0 && value < static_cast<double>(Size))
      rows.push_back({times[begin] - times.front(), last_s - times[begin],
                      std::string(column) + "_" + names[static_cast<std::size_t>(value)], ""});
    begin = end;
  }
}

}  // namespace

std::string tsv_cell(std::string text) {
  for (char& letter : text)
    if (letter == '\t' || letter == '\n' || letter == '\r') letter = ' ';
  return text.empty() ? "n/a" : without_formula(std::move(text));
}

std::string bids_events(const ExportTrial& trial) {
  std::vector<Row> rows;
  add_stretches(rows, trial, columns::phase, kPhases);
  add_stretches(rows, trial, columns::cue, kCues);
  const auto times = trial.signals.column(columns::t_s);
  const double begun_s = trial.trial.session_time_s + (times.empty() ? 0.0 : times.front());
  for (const auto& event : trial.events) {
    std::string type = event.kind;
    std::replace(type.begin(), type.end(), ' ', '_');
    rows.push_back({event.session_time_s - begun_s, {}, type, event.text});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.onset_s < b.onset_s; });
  std::string table = "onset\tduration\ttrial_type\tdescription\n";
  for (const auto& row : rows)
    table += format_number(row.onset_s) + "\t" +
             (row.duration_s ? format_number(*row.duration_s) : "n/a") + "\t" + tsv_cell(row.type) +
             "\t" + tsv_cell(row.text) + "\n";
  return table;
}

std::string bids_events_sidecar(const Language& language) {
  const auto say = [&language](const Text& text) { return translated(text, language); };
  Json levels;
  for (const char* phase : kPhases)
    levels[std::string("phase_") + phase] = say("the task is in this phase"_text);
  for (std::size_t i = 0; i < kCues.size(); ++i)
    levels[std::string("cue_") + kCues[i]] = say(kAskedTo[i]);
  levels["fault"] = say("the device had a fault"_text);
  levels["pause"] = say("the trial was paused"_text);
  levels["occluded"] = say("something was out of sight of the cameras"_text);
  levels["object_lost"] = say("the object had left the hand"_text);
  levels["let_go"] = say("the therapist let the object go for the person"_text);
  levels["answer"] = say("the person answered a question about the trial"_text);
  levels["resume"] = say("the trial went on"_text);
  levels["abort"] = say("the trial was ended early"_text);
  return Json{{"trial_type", {{"Description", say("What happened"_text)}, {"Levels", levels}}},
              {"description", {{"Description", say("In words, as the program told it"_text)}}}}
             .dump(2) +
         "\n";
}

}  // namespace isograsp::exports
