// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers: recordings of markers on an arm become poses, angles and measures, offline
// (docs/markers.md).
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp::app {

Result<Rig> load_rig(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return parse_rig(*text, path);
}

Result<MarkerRows> load_markers(const std::string& path) {
  const auto reader = open_markers(path);
  if (!reader) return reader.error();
  MarkerRows rows;
  rows.markers = (*reader)->markers();
  std::vector<Vec3> p_W(rows.markers.size());
  for (;;) {
    double t_s = 0.0;
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) break;
    rows.t_s.push_back(t_s);
    rows.p_W.push_back(p_W);
  }
  return rows;
}

Error about_file(const Error& error, const std::string& path) {
  Error named = error;
  if (named.file.empty()) named.file = path;
  return named;
}

nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

void add_markers(CommandLine& line) {
  Subcommand markers =
      line.subcommand("markers", "Recordings of markers on an arm: poses, angles and measures");
  markers.requires_subcommand();
  add_marker_poses(markers);
  add_marker_rig(markers);
  add_marker_task(markers);
  add_marker_scores(markers);
  add_marker_quality(markers);
  add_marker_box(markers);
  markers.footer(
      "Example:\n  isograsp markers poses --rig rig.toml --in trial.c3d --out poses.csv");
}

}  // namespace isograsp::app
