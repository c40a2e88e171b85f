// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/bids_sidecars.hpp"

#include <nlohmann/json.hpp>

#include "core/column.hpp"
#include "exports/export_trial.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

using Json = nlohmann::ordered_json;

namespace {

struct Said {
  const Language& language;
  std::string operator()(const Text& text) const { return translated(text, language); }
};

}  // namespace

std::string bids_channels_sidecar(bool tracked, const Language& language) {
  const Said say{language};
  Json json;
  Json& levels = json["reference_frame"]["Levels"];
  for (const auto& [axes, description] : kColumnAxes) {
    if (!tracked && are_of_cameras(axes)) continue;
    levels[std::string(axes)] = {{"RotationRule", "right-hand"}, {"Description", say(description)}};
  }
  // Data of a left hand are mirrored, so no rotation rule holds.
  levels["hand"].erase("RotationRule");
  json["group"] = {{"Description", say("Columns that are recorded together"_text)}};
  return json.dump(2) + "\n";
}

std::string bids_participants_sidecar(const Language& language) {
  const Said say{language};
  return Json{{"code", {{"Description", say("Patient code in the clinic's records"_text)}}},
              {"affected_side",
               {{"Description", say("Affected side"_text)},
                {"Levels",
                 {{"right", say("right"_text)},
                  {"left", say("left"_text)},
                  {"both", say("both"_text)},
                  {"none", say("healthy"_text)}}}}},
              {"handedness",
               {{"Description", say("Dominant hand"_text)},
                {"Levels", {{"right", say("right"_text)}, {"left", say("left"_text)}}}}},
              {"onset_days_from_first_session",
               {{"Description",
                 say("Day of onset, counted from the first session; before it: negative"_text)},
                {"Units", "d"}}}}
             .dump(2) +
         "\n";
}

std::string bids_sessions_sidecar(const Language& language) {
  const Said say{language};
  return Json{{"days_from_first_session",
               {{"Description", say("Day of the session, counted from the first"_text)},
                {"Units", "d"}}},
              {"hand", {{"Description", say("Hand that was measured"_text)}}},
              {"simulated", {{"Description", say("1: a simulated device, no person"_text)}}},
              {"recorded", {{"Description", say("1: a replayed or imported recording"_text)}}}}
             .dump(2) +
         "\n";
}

std::string bids_scans_sidecar(const Language& language) {
  const Said say{language};
  return Json{{"session_time_s",
               {{"Description", say("Start of the run, counted from that of the session"_text)},
                {"Units", "s"}}},
              {"status", {{"Description", say("completed, aborted or interrupted"_text)}}},
              {"practice", {{"Description", say("1: not scored as an assessment"_text)}}},
              {"helped", {{"Description", say("1: the therapist helped"_text)}}}}
             .dump(2) +
         "\n";
}

std::string bids_description(std::string_view type, const Language& language) {
  const Said say{language};
  return Json{{"Name", say("IsoGrasp research export"_text)},
              {"BIDSVersion", "1.9.0"},
              {"DatasetType", type},
              {"GeneratedBy", {{{"Name", "IsoGrasp"}, {"Version", ISOGRASP_VERSION}}}}}
             .dump(2) +
         "\n";
}

std::string bids_readme(const Language& language) {
  const Said say{language};
  return say("Finger forces, tasks and measures of a hand-rehabilitation clinic, exported by IsoGrasp."_text) +
         "\n\n" +
         say("Pseudonymous: codes, no dates; days count from the first session of each person.\n"
             "A run is a trial; run-NN is its number in the session. Forces and torques are MISC\n"
             "channels in N and N*m; POS, ORNT and VEL are those of the virtual object and its\n"
             "target, which the forces move; of an arm seen by cameras (tracksys-cameras) those "
             "of its\n"
             "segments and markers, and JNTANG is how far each link has turned. Measures, health "
             "of the\n"
             "device, zero and the texts of task and scene stand in derivatives/isograsp."_text) +
         "\n";
}

}  // namespace isograsp::exports
