// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers postures, adapt, task.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "kinematics/pose_task.hpp"
#include "kinematics/postures.hpp"
#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"

namespace isograsp::app {

namespace {

struct PosturesOptions {
  std::string rig;
  std::vector<std::string> in;
  std::string out;
  std::string name;
  std::optional<Hand> hand;
};
struct AdaptOptions {
  std::string postures;
  std::string start;
  std::string scale = "none";
  bool json = false;
};
struct TaskOptions {
  std::string task;
  std::string poses;
  std::string out;
};

/// The chain of one recording, held still.
Result<StartPosture> held_posture(const Rig& rig, const std::string& path, Hand hand,
                                  const std::vector<std::string>& chain) {
  const auto rows = load_markers(path);
  if (!rows) return rows.error();
  auto poses = poses_of(rig, *rows, hand);
  if (!poses) return about_file(poses.error(), path);
  PoseSeries series;
  series.t_s = rows->t_s;
  series.source = path;
  for (const RigFrame& frame : rig.frames) series.frames.push_back(frame.name);
  series.X_W = std::move(*poses);
  return start_posture(series, chain);
}

Result<void> run_postures(const PosturesOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  Postures library;
  library.name = options.name.empty() ? rig->name : options.name;
  library.hand = hand_of(options.hand);
  library.chain = chain_of(*rig);
  if (library.chain.size() < 2)
    return refused("has no chain of links"_text, "describe each link in [[link]]"_text)
        .at(options.rig);
  for (const std::string& named : options.in) {
    const auto equals = named.find('=');
    if (equals == std::string::npos || equals == 0)
      return refused("'%1' is not NAME=FILE"_text(named), "name the posture and its recording"_text)
          .about("--in");
    const std::string path = named.substr(equals + 1);
    if (auto different = check_different(path, options.out); !different) return different;
    auto held = held_posture(*rig, path, library.hand, library.chain);
    if (!held) return held.error();
    library.postures.push_back({named.substr(0, equals), std::move(held->X_L)});
  }
  if (auto different = check_different(options.rig, options.out); !different) return different;
  const std::string text = postures_text(library);
  if (auto good = parse_postures(text, options.out); !good) return good.error();
  return write_text(options.out, text);
}

Result<void> run_adapt(const AdaptOptions& options) {
  const auto text = read_text(options.postures);
  if (!text) return text.error();
  const auto library = parse_postures(*text, options.postures);
  if (!library) return library.error();
  const auto series = read_poses(options.start);
  if (!series) return series.error();
  const auto start = start_posture(*series, library->chain);
  if (!start) return start.error();
  const auto scale = options.scale == "length" ? SizeScale::length : SizeScale::none;
  auto poses = nlohmann::ordered_json::array();
  for (std::size_t j = 0; j < library->postures.size(); ++j) {
    const Pose X_WO = adapted(*library, j, *start, scale);
    const std::string& name = library->postures[j].name;
    if (options.json)
      poses.push_back({{"posture", name},
                       {"position_m", {X_WO.p.x(), X_WO.p.y(), X_WO.p.z()}},
                       {"quaternion_wxyz", {X_WO.q.w(), X_WO.q.x(), X_WO.q.y(), X_WO.q.z()}}});
    else
      print("%s: %.4f %.4f %.4f m, quaternion %.6f %.6f %.6f %.6f\n", printable(name).c_str(),
            X_WO.p.x(), X_WO.p.y(), X_WO.p.z(), X_WO.q.w(), X_WO.q.x(), X_WO.q.y(), X_WO.q.z());
  }
  if (options.json) print_json({{"rows", start->rows}, {"poses", std::move(poses)}});
  return {};
}

Result<void> run_task(const TaskOptions& options) {
  for (const std::string& read : {options.task, options.poses})
    if (auto different = check_different(read, options.out); !different) return different;
  const auto text = read_text(options.task);
  if (!text) return text.error();
  const auto task = parse_pose_task(*text, options.task);
  if (!task) return task.error();
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  const auto frame = frame_of(*series, task->frame);
  if (!frame) return frame.error();
  return write_pose_events(options.out, *task,
                           run_pose_task(*task, series->t_s, series->X_W[*frame]));
}

}  // namespace

void add_marker_task(Subcommand markers) {
  auto library = std::make_shared<PosturesOptions>();
  Subcommand postures = markers.subcommand(
      "postures", "A library of postures from recordings of a reference subject");
  postures.option("--rig", library->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
  postures.option("--in", library->in, "Each posture held still; the first one is initial")
      .required()
      .type("NAME=FILE");
  postures.option("--out", library->out, "Library to write").required().type("FILE.toml");
  postures.option("--name", library->name, "Name of the library; without it that of the rig");
  postures.option("--hand", library->hand, "Which arm; a left one is reflected");
  postures.runs([library] { return run_postures(*library); });

  auto arm = std::make_shared<AdaptOptions>();
  Subcommand adapt =
      markers.subcommand("adapt", "Postures of the object for an arm of another size");
  adapt.option("--postures", arm->postures, "Library (isograsp-postures-1)")
      .required()
      .type("FILE.toml");
  adapt.option("--start", arm->start, "Poses of the arm in its initial posture (CSV)")
      .required()
      .type("FILE");
  adapt.option("--scale", arm->scale, "length: translations grow with the link")
      .one_of({"none", "length"})
      .shows_default();
  adapt.flag("--json", arm->json, "Print one JSON document");
  adapt.runs([arm] { return run_adapt(*arm); });

  auto asked = std::make_shared<TaskOptions>();
  Subcommand task = markers.subcommand("task", "What became of the targets of a pose task");
  task.option("--task", asked->task, "Task (isograsp-pose-task-1)").required().type("FILE.toml");
  task.option("--poses", asked->poses, "Poses (CSV)").required().type("FILE");
  task.option("--out", asked->out, "Table to write (CSV)").required().type("FILE");
  task.runs([asked] { return run_task(*asked); });
}

}  // namespace isograsp::app
