// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/bids_sidecars.hpp"

#include <nlohmann/json.hpp>

#include "core/column.hpp"
#include "tasks/facts/column_facts.hpp"

namespace isograsp::exports {

using Json = nlohmann::ordered_json;

std::string bids_channels_sidecar() {
  Json json;
  for (const auto& [axes, description] : kColumnAxes)
    json["reference_frame"]["Levels"][std::string(axes)] = {{"RotationRule", "right-hand"},
                                                            {"Description", description}};
  // Left hands are mirrored: no rule of turning.
  json["reference_frame"]["Levels"]["hand"].erase("RotationRule");
  json["group"] = {{"Description", "Columns that are recorded together"}};
  return json.dump(2) + "\n";
}

std::string bids_participants_sidecar() {
  return Json{
             {"code", {{"Description", "Patient code in the clinic's records"}}},
             {"affected_side",
              {{"Description", "Affected side"},
               {"Levels",
                {{"right", "right"}, {"left", "left"}, {"both", "both"}, {"none", "healthy"}}}}},
             {"handedness",
              {{"Description", "Dominant hand"},
               {"Levels", {{"right", "right"}, {"left", "left"}}}}},
             {"onset_days_from_first_session",
              {{"Description", "Day of onset, counted from the first session; before it: negative"},
               {"Units", "d"}}}}
             .dump(2) +
         "\n";
}

std::string bids_sessions_sidecar() {
  return Json{{"days_from_first_session",
               {{"Description", "Day of the session, counted from the first"}, {"Units", "d"}}},
              {"hand", {{"Description", "Hand that was measured"}}},
              {"simulated", {{"Description", "1: a simulated device, no person"}}},
              {"recorded", {{"Description", "1: a replayed or imported recording"}}}}
             .dump(2) +
         "\n";
}

std::string bids_scans_sidecar() {
  return Json{{"session_time_s",
               {{"Description", "Start of the run, counted from that of the session"},
                {"Units", "s"}}},
              {"status", {{"Description", "completed, aborted or interrupted"}}},
              {"practice", {{"Description", "1: not scored as an assessment"}}},
              {"helped", {{"Description", "1: the therapist helped"}}}}
             .dump(2) +
         "\n";
}

std::string bids_description(std::string_view type) {
  return Json{{"Name", "IsoGrasp research export"},
              {"BIDSVersion", "1.9.0"},
              {"DatasetType", type},
              {"GeneratedBy", {{{"Name", "IsoGrasp"}, {"Version", ISOGRASP_VERSION}}}}}
             .dump(2) +
         "\n";
}

std::string bids_readme() {
  return "Finger forces, tasks and measures of a hand-rehabilitation clinic, exported by "
         "IsoGrasp.\n"
         "\n"
         "Pseudonymous: codes, no dates; days count from the first session of each person.\n"
         "A run is a trial; run-NN is its number in the session. Forces and torques are MISC\n"
         "channels in N and N*m; POS, ORNT and VEL are those of the virtual object and its\n"
         "target, which the forces move. Measures, health of the device, zero and the texts of\n"
         "task and scene stand in derivatives/isograsp.\n";
}

}  // namespace isograsp::exports
