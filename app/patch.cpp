// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp patch: what a finger pad covers of a surface, and the friction of points under pressure.
#include <memory>
#include <numbers>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/tables/word_table.hpp"
#include "grasp_model/patch/mesh_surface.hpp"
#include "grasp_model/patch/pressed_patch.hpp"
#include "grasp_model/patch/solid_surface.hpp"
#include "grasp_model/scene.hpp"
#include "hand/columns.hpp"

namespace isograsp::app {

namespace {

using PatchJson = nlohmann::ordered_json;
constexpr double kPerDegree = std::numbers::pi / 180.0;

struct PatchOptions {
  std::string scene, finger, shape, mesh, points, twists;
  std::vector<std::string> size, point, normal, tangent, pad;
  double friction = 0.8;
  int rays = 64, rings = 8;
  double sharp_edge_deg = 30.0;
  bool rough = false;
  double depth_m = 0.0;
  bool json = false;
};

Result<std::vector<double>> numbers_of(const char* option, const std::vector<std::string>& words,
                                       std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& word : words) {
    double number = 0.0;
    if (!parse_number(word, number))
      return refused("'%1' is not a number"_text(word), "write one"_text).about(option);
    numbers.push_back(number);
  }
  if (numbers.size() != count)
    return refused("needs %1 numbers"_text(count), "write them with blanks between"_text)
        .about(option);
  return numbers;
}
Result<Vec3> three_of(const char* option, const std::vector<std::string>& words) {
  const auto numbers = numbers_of(option, words, 3);
  if (!numbers) return numbers.error();
  return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

Result<std::unique_ptr<PatchSurface>> surface_of(const PatchOptions& options) {
  if (!options.mesh.empty()) {
    const auto text = read_text(options.mesh);
    if (!text) return text.error();
    auto mesh = MeshSurface::parse(*text, options.mesh);
    if (!mesh) return mesh.error();
    return std::unique_ptr<PatchSurface>(std::make_unique<MeshSurface>(*std::move(mesh)));
  }
  const Shape shape = options.shape == "box"        ? Shape::box
                      : options.shape == "cylinder" ? Shape::cylinder
                                                    : Shape::sphere;
  const std::size_t sizes = shape == Shape::box ? 3 : shape == Shape::cylinder ? 2 : 1;
  const auto size_m = numbers_of("--size", options.size, sizes);
  if (!size_m) return size_m.error();
  Vec3 whole = Vec3::Zero();
  for (std::size_t i = 0; i < sizes; ++i) {
    if (!((*size_m)[i] > 0.0))
      return refused("is no size"_text, "write lengths above zero"_text).about("--size");
    whole[static_cast<Eigen::Index>(i)] = (*size_m)[i];
  }
  return surface_of_solid(shape, whole);
}

/// What is asked of a surface: from the command line, or from a contact of a scene.
struct PatchQuestion {
  std::unique_ptr<PatchSurface> surface;
  PatchFrame frame;
  Pad pad;
};

/// An option stands for each field that scanning refuses.
Error of_option(Error error) {
  if (!error.field.empty()) error.field = "--" + error.field;
  return error;
}

Result<PatchQuestion> asked_directly(const PatchOptions& options) {
  PatchQuestion question;
  auto surface = surface_of(options);
  if (!surface) return surface.error();
  question.surface = *std::move(surface);
  const auto p = three_of("--point", options.point);
  if (!p) return p.error();
  const auto normal = three_of("--normal", options.normal);
  if (!normal) return normal.error();
  const auto tangent = three_of("--tangent", options.tangent);
  if (!tangent) return tangent.error();
  const auto axes_m = numbers_of("--pad", options.pad, 2);
  if (!axes_m) return axes_m.error();
  const auto frame = PatchFrame::along(*p, *normal, *tangent);
  if (!frame) return of_option(frame.error());
  question.frame = *frame;
  question.pad = {(*axes_m)[0],  (*axes_m)[1],     options.rays,
                  options.rings, options.friction, kPerDegree * options.sharp_edge_deg,
                  options.rough, options.depth_m};
  return question;
}

/// The first contact with a pad, or that of the finger.
Result<PatchQuestion> asked_by_scene(const PatchOptions& options) {
  const auto text = read_text(options.scene);
  if (!text) return text.error();
  const auto scene = parse_scene(*text, options.scene);
  if (!scene) return scene.error();
  const auto finger = finger_from_name(options.finger);
  if (!finger && !options.finger.empty())
    return refused("'%1' is not a finger"_text(options.finger), "write thumb, index or middle"_text)
        .about("--finger");
  for (const Contact& contact : scene->contacts) {
    if (!contact.pad || (finger && contact.finger != *finger)) continue;
    PatchQuestion question;
    question.surface = surface_of_solid(scene->shape, scene->size_m);
    question.frame = frame_of(contact);
    question.pad = *contact.pad;
    return question;
  }
  return refused("has no contact with model = \"pad\""_text,
                 "write one, or give --shape or --mesh"_text)
      .at(options.scene);
}

PatchJson pair_of(const Vec2& p) {
  return {p.x(), p.y()};
}

Result<void> show_patch(const PatchQuestion& question, bool json) {
  const auto patch = scan_patch(*question.surface, question.frame, question.pad);
  if (!patch) return of_option(patch.error());
  if (json) {
    PatchJson stopped;
    for (std::size_t k = 0; k < kRayStopNames.size(); ++k)
      stopped[std::string(kRayStopNames[k])] = patch->stopped[k];
    auto outline = PatchJson::array();
    for (const Vec2& p : patch->outline_m) outline.push_back(pair_of(p));
    print_json({{"area_m2", patch->area_m2},
                {"centroid_m", pair_of(patch->centroid_m)},
                {"torsion_m", patch->torsion_m},
                {"pure_torsion_limit_m", patch->pure_torsion_limit_m},
                {"elements", patch->elements},
                {"stopped", std::move(stopped)},
                {"outline_m", std::move(outline)}});
    return {};
  }
  constexpr double kMm = 1e3;
  print("area            %10.3f mm2\n", kMm * kMm * patch->area_m2);
  print("centroid        %10.3f %.3f mm\n", kMm * patch->centroid_m.x(),
        kMm * patch->centroid_m.y());
  print("torsional limit %10.4f mm (N mm per N)\n", kMm * patch->torsion_m);
  // About the centroid the sum of moments is larger than what comes without a force.
  constexpr double kDiffer = 1.1;
  if (patch->torsion_m > kDiffer * patch->pure_torsion_limit_m)
    print("without a force %10.4f mm\n", kMm * patch->pure_torsion_limit_m);
  for (std::size_t k = 0; k < kRayStopNames.size(); ++k)
    if (patch->stopped[k] > 0)
      print("rays stopped by %-9s %5zu\n", std::string(kRayStopNames[k]).c_str(),
            patch->stopped[k]);
  return {};
}

/// The rows of a table with these columns.
Result<std::vector<std::vector<double>>> rows_of(const std::string& path,
                                                 std::initializer_list<std::string_view> names) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  std::vector<std::size_t> places;
  for (const std::string_view column : names) {
    const auto place = table->require(column);
    if (!place) return place.error();
    places.push_back(*place);
  }
  std::vector<std::vector<double>> rows;
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) return rows;
    auto& row = rows.emplace_back();
    for (const std::size_t place : places) {
      const auto number = table->required_number(place);
      if (!number) return number.error();
      row.push_back(*number);
    }
  }
}

Result<void> show_points(const PatchOptions& options) {
  const auto rows = rows_of(options.points, {"x_m", "y_m", "area_m2", "penetration_m"});
  if (!rows) return rows.error();
  std::vector<PatchPoint> points;
  for (const auto& row : *rows) points.push_back({{row[0], row[1]}, row[2], row[3]});
  const auto patch = press(points, options.friction);
  if (!patch) return Error(patch.error()).at(options.points);
  auto twists = PatchJson::array();
  if (!options.twists.empty()) {
    const auto slips =
        rows_of(options.twists, {columns::object_velocity[0], columns::object_velocity[1],
                                 columns::object_angular_velocity[2]});
    if (!slips) return slips.error();
    for (const auto& slip : *slips) {
      const SlipFriction friction =
          friction_of(*patch, options.friction, {{slip[0], slip[1]}, slip[2]});
      twists.push_back({{"force", pair_of(friction.force)},
                        {"torque_m", friction.torque_m},
                        {"dissipation", friction.dissipation}});
    }
  }
  PatchJson answer{{"weights", patch->weights},
                   {"centroid_m", pair_of(patch->centroid_m)},
                   {"torsion_m", patch->torsion_m},
                   {"pure_torsion_limit_m", patch->pure_torsion_limit_m},
                   {"volume_m3", patch->volume_m3}};
  if (!options.twists.empty()) answer["twists"] = std::move(twists);
  print_json(answer);
  return {};
}

}  // namespace

void add_patch(CommandLine& line) {
  auto options = std::make_shared<PatchOptions>();
  Subcommand command = line.subcommand(
      "patch", "What a finger pad covers of a surface, and the torsion it can hold");
  OptionGroup of = command.exactly_one("Surface");
  of.option("--scene", options->scene, "Scene with a contact of model = \"pad\"");
  of.option("--shape", options->shape, "box, cylinder or sphere, its middle at the origin")
      .one_of({"box", "cylinder", "sphere"});
  of.option("--mesh", options->mesh, "Triangles (Wavefront OBJ) [m]");
  of.option("--points", options->points,
            "Points under pressure (CSV: x_m, y_m, area_m2, penetration_m); printed as JSON");
  command.option("--finger", options->finger, "Of the scene: thumb, index or middle");
  command.option("--size", options->size, "Of the shape [m]: x y z, diameter length, or diameter");
  command.option("--point", options->point, "Contact point x y z [m]");
  command.option("--normal", options->normal, "Direction into the object x y z");
  command.option("--tangent", options->tangent, "Direction of the first axis of the pad x y z");
  command.option("--pad", options->pad, "Semi-axes of the pad a b [m]");
  command.option("--friction", options->friction, "Friction coefficient")
      .positive()
      .shows_default();
  command.option("--rays", options->rays, "Rays").range(3, 100000).shows_default();
  command.option("--rings", options->rings, "Rings").range(1, 10000).shows_default();
  command.option("--sharp-edge-deg", options->sharp_edge_deg, "A crease above it is an edge")
      .range(0.0, 180.0)
      .shows_default();
  command.flag("--rough", options->rough, "The pulp bridges grooves");
  command.option("--depth", options->depth_m,
                 "With --rough: what lies within it of the tangent plane counts [m]");
  command.option("--twists", options->twists,
                 "With --points: how the patch slips (CSV: vx_mps, vy_mps, wz_radps)");
  command.flag("--json", options->json, "Print JSON");
  command.footer(
      "Example:\n  isograsp patch --shape box --size 0.065 0.06 0.08 --point -0.0325 0.028 0 \\\n"
      "    --normal 1 0 0 --tangent 0 1 0 --pad 0.0075 0.0055 --friction 0.8");
  command.runs([options]() -> Result<void> {
    if (!options->points.empty()) return show_points(*options);
    const auto question =
        options->scene.empty() ? asked_directly(*options) : asked_by_scene(*options);
    if (!question) return question.error();
    return show_patch(*question, options->json);
  });
}

}  // namespace isograsp::app
