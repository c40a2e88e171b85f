// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers score, rom.
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/language.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"
#include "kinematics/range_of_motion.hpp"
#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct MarkerScoreOptions {
  std::string rig;
  std::string poses;
  std::string events;
  std::string bands;
  bool json = false;
};

std::string number_or_dash(const std::optional<double>& value) {
  return value ? fixed(*value, 4).digits : "-";
}

Result<void> run_movement_score(const MarkerScoreOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  auto targets = read_pose_targets(options.events);
  if (!targets) return targets.error();
  const auto scores = score_movements(*rig, *series, std::move(*targets));
  if (!scores) return about_file(scores.error(), options.rig);
  if (!options.bands.empty()) {
    for (const std::string& read : {options.rig, options.poses, options.events})
      if (auto different = check_different(read, options.bands); !different) return different;
    const auto band = movement_bands(*rig, *series, *scores);
    if (!band) return band.error();
    if (auto done = write_bands(options.bands, *band); !done) return done;
  }
  auto list = Json::array();
  for (const auto& [movement, measure] : movement_measures(*rig, *scores)) {
    if (!options.json) {
      print("%zu %s %s: %s\n", movement, measure.name.c_str(), printable(measure.channel).c_str(),
            measure.value ? (number_or_dash(measure.value) + " " + measure.unit).c_str()
                          : spoken(Known{measure.reason}).c_str());
      continue;
    }
    Json one{{"name", measure.name},
             {"channel", measure.channel},
             {"movement", movement},
             {"value", number_or_null(measure.value)},
             {"unit", measure.unit}};
    if (!measure.value) one["reason"] = measure.reason;
    list.push_back(std::move(one));
  }
  if (options.json) print_json({{"measures", std::move(list)}});
  return {};
}

Result<void> run_rom(const MarkerScoreOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  auto list = Json::array();
  for (const RigLink& link : rig->links) {
    const auto poses = link_poses(*series, link.parent, link.child);
    if (!poses) return poses.error();
    std::vector<std::vector<double>> angles(3);
    for (const Pose& X_L : *poses) {
      const Vec3 three =
          is_missing(X_L) ? Vec3(Vec3::Constant(kMissing)) : link_angles(X_L.q, link);
      for (std::size_t a = 0; a < 3; ++a) angles[a].push_back(three[static_cast<Eigen::Index>(a)]);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const Range range = range_of_motion(series->t_s, angles[a]);
      if (options.json)
        list.push_back({{"link", link.name},
                        {"angle", a + 1},
                        {"min_rad", number_or_null(range.min_rad)},
                        {"max_rad", number_or_null(range.max_rad)},
                        {"min_held_rad", number_or_null(range.min_held_rad)},
                        {"max_held_rad", number_or_null(range.max_held_rad)}});
      else
        print_line("%1 angle %2: %3 to %4 rad, held %5 to %6 rad"_text(
            link.name, a + 1, number_or_dash(range.min_rad), number_or_dash(range.max_rad),
            number_or_dash(range.min_held_rad), number_or_dash(range.max_held_rad)));
    }
  }
  if (options.json) print_json({{"rom", std::move(list)}});
  return {};
}

}  // namespace

void add_marker_scores(Subcommand markers) {
  auto options = std::make_shared<MarkerScoreOptions>();
  const auto with_poses = [&options](Subcommand command) {
    command.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
    command.option("--poses", options->poses, "Poses of its frames (CSV)").required().type("FILE");
    command.flag("--json", options->json, "Print one JSON document");
  };
  Subcommand score = markers.subcommand("score", "Measures of movements to targets");
  with_poses(score);
  score.option("--events", options->events, "Cues, matches and references (CSV)")
      .required()
      .type("FILE");
  score.option("--bands", options->bands, "Mean and SD of movements to write (CSV)").type("FILE");
  score.runs([options] { return run_movement_score(*options); });

  Subcommand rom = markers.subcommand("rom", "How far each angle of each link went");
  with_poses(rom);
  rom.runs([options] { return run_rom(*options); });
}

}  // namespace isograsp::app
