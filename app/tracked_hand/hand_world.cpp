// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand hold, squeeze, slide: the world of contacts on cases whose motion is known.
#include <cmath>
#include <filesystem>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/toml_reader.hpp"
#include "hand_world/experiments.hpp"

namespace isograsp::app {

namespace {

using namespace hand_world;

constexpr double kLeastStep_s = 1e-6;
constexpr double kMostStep_s = 0.01;

struct HoldPoint {
  std::string name;
  Vec3 p_O = Vec3::Zero();
  double stiffness_N_m = 0.0;
  double damping_N_s_m = 0.0;
};
/// An object that hangs on points which are led ("isograsp-hold-1").
struct HoldCase {
  double duration_s = 0.0;
  std::string anchors;
  ObjectBody object;
  Vec3 gravity_W = Vec3::Zero();
  std::vector<HoldPoint> points;
};

double read_positive(TomlReader& table, const char* key) {
  const double value = table.number(key);
  if (table.has(key) && !(value > 0.0))
    table.fail(key, "is out of range"_text, "write a number above 0"_text);
  return value;
}

Result<HoldCase> read_hold(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto root = TomlReader::parse(*text, path, "isograsp-hold-1");
  if (!root) return root.error();
  HoldCase hold;
  (void)root->text("name");
  hold.duration_s = read_positive(*root, "duration_s");
  constexpr double kLongestHold_s = 3600.0;
  if (hold.duration_s > kLongestHold_s)
    root->fail("duration_s", "is out of range"_text,
               "write seconds, at most %1"_text(format_number(kLongestHold_s)));
  hold.anchors = std::filesystem::path(path).parent_path() / root->text("anchors");
  TomlReader object = root->table("object");
  (void)object.choice("shape", {"box"});
  hold.object.shape.half_m = 0.5 * object.vec3("size_m");
  hold.object.mass_kg = read_positive(object, "mass_kg");
  hold.object.inertia_kg_m2 = object.vec3("inertia_kg_m2");
  if (!(hold.object.inertia_kg_m2.minCoeff() > 0.0))
    object.fail("inertia_kg_m2", "is out of range"_text, "write a number above 0"_text);
  hold.gravity_W = object.vec3("gravity_m_s2");
  for (TomlReader& table : root->tables("attached")) {
    HoldPoint point;
    point.name = table.text("finger");
    point.p_O = table.vec3("object_point_m");
    point.stiffness_N_m = read_positive(table, "stiffness_N_m");
    point.damping_N_s_m = table.number("damping_N_s_m");
    if (!(point.damping_N_s_m >= 0.0))
      table.fail("damping_N_s_m", "is out of range"_text, "write a number above 0"_text);
    hold.points.push_back(std::move(point));
  }
  if (hold.points.empty() || hold.points.size() > World::kLed)
    root->fail("attached", "stands there %1 times"_text(hold.points.size()),
               "write one [[attached]] for each of one to five fingers"_text);
  if (auto done = root->finish(); !done) return done.error();
  return hold;
}

/// Where the points are at one time.
struct HoldRow {
  double t_s = 0.0;
  std::vector<Vec3> points;
};
Result<std::vector<HoldRow>> read_anchors(const HoldCase& hold) {
  std::vector<HoldRow> rows;
  const auto read = read_cases(hold.anchors, [&](CaseTable& row) {
    HoldRow now;
    now.t_s = row.number("t_s");
    for (const HoldPoint& point : hold.points)
      now.points.push_back(row.three(point.name + "_", "_m"));
    if (!rows.empty() && !(now.t_s > rows.back().t_s))
      row.fail("t_s", "time does not increase"_text, "sort the rows and remove repeats"_text);
    rows.push_back(std::move(now));
  });
  if (!read) return read.error();
  if (rows.empty())
    return refused("the file has no rows"_text, "give at least one"_text).at(hold.anchors);
  return rows;
}

void write_motion(FileWriter& out, double t_s, const ObjectMotion& motion) {
  std::string line = format_number(t_s);
  const auto add = [&line](const auto& values) {
    for (const double value : values) line += "," + format_number(value);
  };
  const Quat& q = motion.X_WO.q;
  add(motion.X_WO.p);
  add(std::array{q.w(), q.x(), q.y(), q.z()});
  add(motion.v_WO_W);
  add(motion.w_WO_W());
  out.write(line + "\n");
}

struct HandHoldOptions {
  std::string hold;
  std::string out;
  double step_s = 0.001;
};

Result<void> run_hand_hold(const HandHoldOptions& options) {
  const auto hold = read_hold(options.hold);
  if (!hold) return hold.error();
  const auto rows = read_anchors(*hold);
  if (!rows) return rows.error();
  for (const std::string& in : {options.hold, hold->anchors})
    if (auto different = check_different(in, options.out); !different) return different;
  auto out = FileWriter::create(options.out);
  if (!out) return out.error();
  out->write("t_s,x_m,y_m,z_m,qw,qx,qy,qz,vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps\n");
  WorldRules rules;
  rules.gravity_W = hold->gravity_W;
  const auto world = std::make_unique<World>(hold->object, rules);
  for (const HoldPoint& point : hold->points)
    world->hang(point.p_O, point.stiffness_N_m, point.damping_N_s_m);
  constexpr double kSlack_s = 1e-9;  // of times that are written in decimals
  for (std::size_t r = 0; r < rows->size() && (*rows)[r].t_s <= hold->duration_s + kSlack_s; ++r) {
    const HoldRow& now = (*rows)[r];
    if (r > 0) {
      const HoldRow& last = (*rows)[r - 1];
      const double span_s = now.t_s - last.t_s;
      const double count = std::ceil(span_s / options.step_s - kSlack_s);
      for (double k = 0.0; k < count; k += 1.0) {
        const double share = (k + 0.5) / count;
        for (std::size_t p = 0; p < now.points.size(); ++p) {
          const Vec3 way = now.points[p] - last.points[p];
          world->lead(p, last.points[p] + share * way, way / span_s);
        }
        world->step(span_s / count);
      }
    }
    write_motion(*out, now.t_s, world->object().motion());
  }
  return out->commit();
}

struct HandSqueezeOptions {
  Squeeze setup;
  bool json = false;
};
Result<void> run_hand_squeeze(const HandSqueezeOptions& options) {
  const SqueezeResult result = squeeze(options.setup);
  if (options.json)
    print_json({{"slip_m", result.slip_m}, {"turn_rad", result.turn_rad}});
  else
    print("%.6g m\n%.6g rad\n", result.slip_m, result.turn_rad);
  return {};
}

struct HandSlideOptions {
  Slide setup;
  bool json = false;
};
Result<void> run_hand_slide(const HandSlideOptions& options) {
  const SlideResult result = slide(options.setup);
  if (!result.stopped)
    return refused("the disk does not come to rest within %1 s"_text(format_number(kLongest_s)),
                   "give more friction or gravity"_text);
  if (options.json)
    print_json({{"stop_s", result.stop_s},
                {"distance_m", result.distance_m},
                {"angle_rad", result.angle_rad}});
  else
    print("%.6g s\n%.6g m\n%.6g rad\n", result.stop_s, result.distance_m, result.angle_rad);
  return {};
}

void add_step(Subcommand command, double& step_s) {
  command.option("--step", step_s, "Of the simulation [s]")
      .range(kLeastStep_s, kMostStep_s)
      .shows_default();
}
void add_gravity(Subcommand command, double& gravity_m_s2) {
  command.option("--gravity", gravity_m_s2, "[m/s2]").range(0.0, 1000.0).shows_default();
}
void add_friction(Subcommand command, double& friction) {
  command.option("--friction", friction, "Coefficient of friction")
      .range(1e-3, 10.0)
      .shows_default();
}

}  // namespace

void add_hand_world(Subcommand hand) {
  auto led = std::make_shared<HandHoldOptions>();
  Subcommand hold = hand.subcommand("hold", "Motion of an object on springs whose ends are led");
  hold.option("--case", led->hold, "Object and springs (TOML)").required().type("FILE");
  hold.option("--out", led->out, "Motion to write (CSV)").required().type("FILE");
  add_step(hold, led->step_s);
  hold.runs([led] { return run_hand_hold(*led); });

  auto pads = std::make_shared<HandSqueezeOptions>();
  Squeeze& pinched = pads->setup;
  Subcommand squeezes =
      hand.subcommand("squeeze", "Whether two pads hold a cuboid: how far it slips and turns");
  squeezes.option("--mass", pinched.mass_kg, "Of the cuboid [kg]").required().range(1e-6, 1e3);
  add_gravity(squeezes, pinched.gravity_m_s2);
  squeezes.option("--offset", pinched.offset_m, "Of its centre from the line of the pads [m]")
      .range(0.0, 0.075)
      .shows_default();
  add_friction(squeezes, pinched.pad.friction);
  squeezes.option("--patch-radius", pinched.pad.patch_radius_m, "Radius of a pad's patch [m]")
      .range(1e-6, 1.0)
      .shows_default();
  squeezes.option("--force", pinched.force_N, "Of each pad [N]").required().range(0.0, 1e4);
  squeezes.option("--duration", pinched.duration_s, "[s]").range(1e-3, 1e3).shows_default();
  add_step(squeezes, pinched.step_s);
  squeezes.flag("--json", pads->json, "Print one JSON document");
  squeezes.runs([pads] { return run_hand_squeeze(*pads); });

  auto disk = std::make_shared<HandSlideOptions>();
  Slide& sliding = disk->setup;
  sliding.friction = 0.5;
  Subcommand slides = hand.subcommand("slide", "How a disk that slides and turns comes to rest");
  add_friction(slides, sliding.friction);
  add_gravity(slides, sliding.gravity_m_s2);
  slides.option("--radius", sliding.radius_m, "[m]").required().range(1e-3, 1.0);
  slides.option("--v0", sliding.v0_m_s, "Speed at the begin [m/s]").required().range(0.0, 100.0);
  slides.option("--w0", sliding.w0_rad_s, "Turning at the begin [rad/s]")
      .required()
      .range(-1000.0, 1000.0);
  add_step(slides, sliding.step_s);
  slides.flag("--json", disk->json, "Print one JSON document");
  slides.runs([disk] { return run_hand_slide(*disk); });
}

}  // namespace isograsp::app
