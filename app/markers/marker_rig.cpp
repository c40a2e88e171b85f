// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers calibrate, landmark.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"

namespace isograsp::app {

namespace {

struct RigOptions {
  std::string rig;
  std::string in;
  std::string out;
  std::string probe;
  std::string frame;
  std::string name;
  std::optional<Hand> hand;
  bool json = false;
};

nlohmann::ordered_json numbers(const Vec3& values) {
  return nlohmann::ordered_json::array({values.x(), values.y(), values.z()});
}

Result<void> run_calibrate(const RigOptions& options) {
  for (const std::string& read : {options.rig, options.in})
    if (auto different = check_different(read, options.out); !different) return different;
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto rows = load_markers(options.in);
  if (!rows) return rows.error();
  const auto measured = calibrated(*rig, *rows, hand_of(options.hand));
  if (!measured) return about_file(measured.error(), options.in);
  return write_text(options.out, rig_text(*measured));
}

Result<void> run_landmark(const RigOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto rows = load_markers(options.in);
  if (!rows) return rows.error();
  const auto landmark = measure_landmark(*rig, *rows, options.probe, options.frame);
  if (!landmark)  // an option names what the rig does not have
    return about_file(landmark.error(), landmark.error().field.empty() ? options.in : options.rig);
  if (landmark->sd_m.norm() > kLargestLandmarkSd_m)
    print_note("the pointer moved by %1 mm (SD): hold it again"_text(
        fixed(1e3 * landmark->sd_m.norm(), 1)));
  if (options.json) {
    print_json({{"name", options.name},
                {"frame", options.frame},
                {"rows", landmark->rows},
                {"position_m", numbers(landmark->position_m)},
                {"sd_m", numbers(landmark->sd_m)}});
    return {};
  }
  print("[[landmark]]\nname = \"%s\"\nframe = \"%s\"\nposition_m = [%.6f, %.6f, %.6f]\n",
        printable(options.name).c_str(), printable(options.frame).c_str(), landmark->position_m.x(),
        landmark->position_m.y(), landmark->position_m.z());
  return {};
}

}  // namespace

void add_marker_rig(Subcommand markers) {
  auto options = std::make_shared<RigOptions>();
  Subcommand calibrate =
      markers.subcommand("calibrate", "A rig with templates and zeros of an arm held still");
  calibrate.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
  calibrate.option("--static", options->in, "Recording of the arm held still")
      .required()
      .type("FILE");
  calibrate.option("--out", options->out, "Rig to write").required().type("FILE.toml");
  calibrate.option("--hand", options->hand, "Which arm; zeros of a left one are reflected");
  calibrate.runs([options] { return run_calibrate(*options); });

  Subcommand landmark =
      markers.subcommand("landmark", "Where a pointer touched, in a frame of the rig");
  landmark.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
  landmark.option("--in", options->in, "Recording of the pointer").required().type("FILE");
  landmark.option("--probe", options->probe, "Frame whose origin is the tip").required();
  landmark.option("--frame", options->frame, "Frame that the landmark moves with").required();
  landmark.option("--name", options->name, "Name of the landmark").required();
  landmark.flag("--json", options->json, "Print one JSON document");
  landmark.runs([options] { return run_landmark(*options); });
}

}  // namespace isograsp::app
