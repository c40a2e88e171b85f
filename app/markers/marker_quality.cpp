// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers quality, drinking.
#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/language.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "kinematics/measures/compensation.hpp"
#include "kinematics/measures/coupling.hpp"
#include "kinematics/measures/drinking.hpp"
#include "kinematics/measures/smoothness.hpp"
#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct QualityOptions {
  std::string rig;
  std::string poses;
  std::string events;
  std::vector<std::string> ranges;
  bool json = false;
};

struct DrinkingOptions {
  std::string in;
  std::string hand, glass, face, trunk, shoulder, elbow, wrist;
  bool json = false;
};

/// "EF:1:-1.2:0.8": link, angle, least and largest [rad].
Result<OwnRange> own_range(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  OwnRange range;
  double angle = 0.0;
  if (parts.size() != 4 || !parse_number(parts[1], angle) ||
      (angle != 1.0 && angle != 2.0 && angle != 3.0) || !parse_number(parts[2], range.min_rad) ||
      !parse_number(parts[3], range.max_rad) || !(range.min_rad < range.max_rad))
    return refused("'%1' is not LINK:ANGLE:MIN:MAX"_text(text),
                   "name the link, its angle 1 to 3, and its limits in rad"_text)
        .about("--range");
  range.link = parts[0];
  range.angle = static_cast<int>(angle) - 1;
  return range;
}

Json as_json(const Measure& measure) {
  Json one{{"name", measure.name}, {"channel", measure.channel}};
  one["value"] = number_or_null(measure.value);
  one["unit"] = measure.unit;
  if (!measure.value) one["reason"] = measure.reason;
  return one;
}

std::string value_words(const Measure& measure) {
  if (!measure.value) return spoken(Known{measure.reason});
  return fixed(*measure.value, 4).digits + " " + measure.unit;
}

Result<void> run_quality(const QualityOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  std::vector<OwnRange> ranges;
  for (const std::string& text : options.ranges) {
    auto range = own_range(text);
    if (!range) return range.error();
    ranges.push_back(*std::move(range));
  }
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  const auto targets = read_pose_targets(options.events);
  if (!targets) return targets.error();
  auto measures = movement_smoothness(*rig, *series, *targets);
  if (!measures) return about_file(measures.error(), options.rig);
  const auto compensation = movement_compensation(*rig, *series, *targets);
  if (!compensation) return about_file(compensation.error(), options.rig);
  const auto scores = score_movements(*rig, *series, *targets);
  if (!scores) return about_file(scores.error(), options.rig);
  const auto coupling = movement_coupling(*rig, *series, *scores, ranges);
  if (!coupling) return about_file(coupling.error(), options.rig);
  for (auto& measure : compensation_measures(*compensation))
    measures->push_back(std::move(measure));
  for (auto& measure : coupling_measures(*rig, *coupling)) measures->push_back(std::move(measure));

  auto list = Json::array();
  for (const auto& [movement, measure] : *measures) {
    if (options.json) {
      Json one = as_json(measure);
      one["movement"] = movement;
      list.push_back(std::move(one));
    } else {
      print("%zu %s %s: %s\n", movement, measure.name.c_str(), printable(measure.channel).c_str(),
            value_words(measure).c_str());
    }
  }
  auto notes = Json::array();
  for (std::size_t m = 0; m < compensation->size(); ++m)
    for (const Text& note : (*compensation)[m].notes) {
      if (options.json)
        notes.push_back({{"movement", m}, {"note", english(note)}});
      else
        print("%zu: %s\n", m, spoken(note).c_str());
    }
  if (options.json) print_json({{"measures", std::move(list)}, {"notes", std::move(notes)}});
  return {};
}

/// Positions of a marker; an error if the recording does not have it, nothing if none is named.
Result<std::vector<Vec3>> positions_of(const MarkerRows& rows, const std::string& marker,
                                       const std::string& path) {
  std::vector<Vec3> p_W;
  if (marker.empty()) return p_W;
  const auto at = index_of(rows.markers, marker);
  if (!at)
    return refused("has no marker '%1'"_text(marker), "name one of its markers"_text).at(path);
  for (const auto& row : rows.p_W) p_W.push_back(row[*at]);
  return p_W;
}

Result<void> run_drinking(const DrinkingOptions& options) {
  const auto rows = load_markers(options.in);
  if (!rows) return rows.error();
  DrinkingMarkers markers;
  markers.t_s = rows->t_s;
  for (const auto& [name, part] : {std::pair(&options.hand, &markers.hand),
                                   {&options.glass, &markers.glass},
                                   {&options.face, &markers.face},
                                   {&options.trunk, &markers.trunk},
                                   {&options.shoulder, &markers.shoulder},
                                   {&options.elbow, &markers.elbow},
                                   {&options.wrist, &markers.wrist}}) {
    auto positions = positions_of(*rows, *name, options.in);
    if (!positions) return positions.error();
    *part = *std::move(positions);
  }
  const DrinkingTask task = drinking_task(markers);
  auto phases = Json::array();
  for (std::size_t k = 0; k < kDrinkingPhases.size() && task.reason.empty(); ++k)
    phases.push_back({{"phase", kDrinkingPhases[k]},
                      {"from_s", task.phase_s[k]},
                      {"to_s", task.phase_s[k + 1]}});
  auto list = Json::array();
  for (const Measure& measure : task.measures) {
    if (options.json)
      list.push_back(as_json(measure));
    else
      print("%s %s: %s\n", measure.name.c_str(), measure.channel.c_str(),
            value_words(measure).c_str());
  }
  if (options.json) {
    Json json{{"phases", std::move(phases)}};
    if (!task.reason.empty()) json["reason"] = english(task.reason);
    json["measures"] = std::move(list);
    print_json(json);
  }
  return {};
}

}  // namespace

void add_marker_quality(Subcommand markers) {
  auto movements = std::make_shared<QualityOptions>();
  Subcommand quality =
      markers.subcommand("quality", "Smoothness, compensation and coupling of movements");
  quality.option("--rig", movements->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
  quality.option("--poses", movements->poses, "Poses of its frames (CSV)").required().type("FILE");
  quality.option("--events", movements->events, "Cues, matches and references (CSV)")
      .required()
      .type("FILE");
  quality.option("--range", movements->ranges, "The person's own range of an angle of a link [rad]")
      .type("LINK:ANGLE:MIN:MAX");
  quality.flag("--json", movements->json, "Print one JSON document");
  quality.runs([movements] { return run_quality(*movements); });

  auto task = std::make_shared<DrinkingOptions>();
  Subcommand drinking = markers.subcommand("drinking", "Phases and measures of the drinking task");
  drinking.option("--in", task->in, "Recording: CSV of this program, C3D, TRC or Qualisys TSV")
      .required()
      .type("FILE");
  for (const auto& [name, value, help, needed] :
       {std::tuple("--hand-marker", &task->hand, "Marker of the hand", true),
        {"--glass", &task->glass, "Marker of the glass", true},
        {"--face", &task->face, "Marker of the face", true},
        {"--trunk", &task->trunk, "Marker of the trunk", false},
        {"--shoulder", &task->shoulder, "Marker of the shoulder", false},
        {"--elbow", &task->elbow, "Marker of the elbow", false},
        {"--wrist", &task->wrist, "Marker of the wrist", false}}) {
    Option option = drinking.option(name, *value, help).type("NAME");
    if (needed) option.required();
  }
  drinking.flag("--json", task->json, "Print one JSON document");
  drinking.runs([task] { return run_drinking(*task); });
}

}  // namespace isograsp::app
