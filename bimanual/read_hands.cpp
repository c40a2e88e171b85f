// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/read_hands.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bimanual/read_hand_contacts.hpp"
#include "core/toml_reader.hpp"

namespace isograsp::bimanual {

namespace {

double read_positive(TomlReader& table, std::string_view key, std::optional<double> fallback) {
  const double value = table.number(key, fallback);
  if (!(value > 0.0)) table.fail(key, "is not above zero"_text, "write a larger number"_text);
  return value;
}
Vec3 read_positive_vec3(TomlReader& table, std::string_view key, std::optional<Vec3> fallback) {
  const Vec3 value = table.vec3(key, fallback);
  if (!(value.minCoeff() > 0.0))
    table.fail(key, "is not above zero"_text, "write larger numbers"_text);
  return value;
}

/// Of hands, and of what pads press on and with, each number in SI units: beyond this it is that of
/// no hand, and what is made of it overflows when a step multiplies it, or is lost to rounding.
constexpr double kMostOfPads = 1e9;

using Named = std::pair<std::string_view, double>;
void refuse_beyond(TomlReader& table, std::initializer_list<Named> numbers) {
  for (const auto& [key, most] : numbers)
    if (most > kMostOfPads)
      table.fail(key, "is beyond what hands hold"_text, "check its unit"_text);
}

HandsSpec read_hands(TomlReader& table) {
  HandsSpec spec;
  spec.explore =
      static_cast<Explore>(table.choice("explore", {"bubble", "clutch", "fixed", "prescribed"}, 0));
  spec.joint_control = table.boolean("joint_control", false);
  spec.left_share = table.number("left_share", spec.left_share);
  if (!(spec.left_share >= 0.0 && spec.left_share <= 1.0))
    table.fail("left_share", "is no share"_text, "write a number from 0 to 1"_text);
  spec.half_size_m = read_positive_vec3(table, "half_size_m", spec.half_size_m);
  spec.shape =
      static_cast<BubbleShape>(table.choice("shape", {"ellipsoid", "box", "superellipsoid"}, 0));
  spec.exponent = read_positive(table, "exponent", spec.exponent);
  spec.rate_m_s = read_positive(table, "rate_m_s", spec.rate_m_s);
  spec.rate_exponent = read_positive(table, "rate_exponent", spec.rate_exponent);
  spec.rate_limit_m_s = read_positive(table, "rate_limit_m_s", spec.rate_limit_m_s);
  spec.separation_m = read_positive(table, "separation_m", spec.separation_m);
  spec.least_bubble_distance_m =
      read_positive(table, "least_bubble_distance_m", spec.least_bubble_distance_m);
  constexpr double kPerDegree = std::numbers::pi / 180.0;
  constexpr double kWidest_deg = 120.0;
  const double fov_deg = read_positive(table, "view_fov_deg", spec.view_fov_rad / kPerDegree);
  if (fov_deg > kWidest_deg)
    table.fail("view_fov_deg", "is no angle of a view"_text, "write at most 120"_text);
  spec.view_fov_rad = kPerDegree * fov_deg;
  spec.view_margin = read_positive(table, "view_margin", spec.view_margin);
  refuse_beyond(table, {{"half_size_m", spec.half_size_m.maxCoeff()},
                        {"separation_m", spec.separation_m},
                        {"least_bubble_distance_m", spec.least_bubble_distance_m},
                        {"rate_m_s", spec.rate_m_s},
                        {"rate_limit_m_s", spec.rate_limit_m_s}});
  if (spec.explore == Explore::prescribed) return spec;
  for (const auto& [key, side] : {std::pair{"left", Side::left}, std::pair{"right", Side::right}}) {
    TomlReader hand = table.table(key);
    HandSpec& of = spec.hands[index_of(side)];
    of.center_m = hand.vec3("center_m");
    of.force_at_edge_N = read_positive_vec3(hand, "force_at_edge_N", std::nullopt);
    refuse_beyond(hand, {{"center_m", of.center_m.cwiseAbs().maxCoeff()}});
  }
  const Vec3 across = spec.hands[1].center_m - spec.hands[0].center_m;
  if (std::hypot(across.x(), across.z()) < spec.least_bubble_distance_m)
    table.fail("left", "begins nearer to the right hand than least_bubble_distance_m"_text,
               "move the hands apart"_text);
  return spec;
}

GraspDetection read_detection(TomlReader& table) {
  GraspDetection rule;
  rule.force_on_N.fill(read_positive(table, "force_on_N", std::nullopt));
  rule.reach_m = read_positive(table, "reach_m", std::nullopt);
  rule.least_chord_m = read_positive(table, "least_chord_m", std::nullopt);
  return rule;
}

Magnet read_magnet(TomlReader& table) {
  Magnet magnet;
  magnet.mode = static_cast<Magnet::Mode>(table.choice("mode", {"off", "spring", "constraint"}));
  if (magnet.mode != Magnet::Mode::spring) return magnet;
  magnet.stiffness_N_m = read_positive(table, "stiffness_N_m", std::nullopt);
  magnet.damping_N_s_m = table.number("damping_N_s_m", 0.0);
  if (!(magnet.damping_N_s_m >= 0.0))
    table.fail("damping_N_s_m", "is negative"_text, "write a number that is not negative"_text);
  return magnet;
}

Vec6 read_six(TomlReader& table, std::string_view key) {
  Vec6 values = Vec6::Ones();
  const auto read = table.numbers(key, 6, 6);
  for (std::size_t i = 0; i < 6 && i < read.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = read[i];
  if (!(values.minCoeff() >= 0.0))
    table.fail(key, "is negative"_text, "write a number that is not negative"_text);
  return values;
}

void refuse_beyond(TomlReader& table, const PadSpec& pad) {
  refuse_beyond(table, {{"foundation_N_m3", pad.foundation_N_m3},
                        {"friction", pad.friction},
                        {"stiffness", pad.stiffness.maxCoeff()},
                        {"damping", pad.damping.maxCoeff()},
                        {"from_hand_m", pad.from_hand_m.cwiseAbs().maxCoeff()}});
}

void refuse_beyond(TomlReader& root, const Scene& scene) {
  const auto most = [](const Vec3& v) { return v.cwiseAbs().maxCoeff(); };
  TomlReader object = root.table("object");
  refuse_beyond(object, {{"size_m", most(scene.size_m)},
                         {"mass_kg", scene.mass_kg},
                         {"inertia_kg_m2", most(scene.inertia_kg_m2)}});
  TomlReader dynamics = root.table("dynamics");
  refuse_beyond(dynamics, {{"stiffness", scene.stiffness.maxCoeff()},
                           {"damping", scene.damping.maxCoeff()},
                           {"anchor_m", most(scene.anchor_m)}});
  TomlReader initial = root.table("initial", false);
  refuse_beyond(initial, {{"position_m", most(scene.initial_X_WO.p)},
                          {"velocity_m_s", most(scene.initial_v_WO_W)},
                          {"angular_velocity_rad_s", most(scene.initial_w_WO_W)}});
}

PadSpec read_pad(TomlReader& table) {
  PadSpec pad;
  pad.hand = static_cast<Side>(table.choice("hand", {"left", "right"}));
  pad.from_hand_m = table.vec3("from_hand_m", Vec3::Zero());
  const auto frame = PatchFrame::along(Vec3::Zero(), table.vec3("normal"), table.vec3("tangent"));
  if (frame) {
    pad.normal = frame->normal;
    pad.tangent = frame->x;
  } else {
    table.fail(frame.error().field, frame.error().what, frame.error().remedy);
  }
  constexpr std::int64_t kMostRays = 360, kMostRings = 100;
  TomlReader patch = table.table("patch");
  const auto axes_m = patch.numbers("semi_axes_m", 2, 2);
  if (axes_m.size() == 2) {
    pad.face.semi_x_m = axes_m[0];
    pad.face.semi_y_m = axes_m[1];
  }
  if (!(pad.face.semi_x_m > 0.0 && pad.face.semi_y_m > 0.0))
    patch.fail("semi_axes_m", "is not above zero"_text, "write a larger number"_text);
  refuse_beyond(patch, {{"semi_axes_m", std::max(pad.face.semi_x_m, pad.face.semi_y_m)}});
  for (const auto& [key, value, most] : {std::tuple{"rays", &pad.face.rays, kMostRays},
                                         std::tuple{"rings", &pad.face.rings, kMostRings}}) {
    const std::int64_t count = patch.integer(key, *value);
    if (count < 1 || count > most)
      patch.fail(key, "is out of range"_text, "write a whole number from 1 to %1"_text(most));
    else
      *value = static_cast<int>(count);
  }
  pad.friction = table.number("friction");
  if (!(pad.friction >= 0.0))
    table.fail("friction", "is negative"_text, "write a number that is not negative"_text);
  pad.foundation_N_m3 = read_positive(table, "foundation_N_m3", std::nullopt);
  pad.stiffness = read_six(table, "stiffness");
  pad.damping = read_six(table, "damping");
  if (!((pad.stiffness + pad.damping).minCoeff() > 0.0))
    table.fail("stiffness", "leaves an axis without spring and damper"_text,
               "give each axis one of the two"_text);
  refuse_beyond(table, pad);
  return pad;
}

void read_holding(TomlReader& root, HandsScene& scene) {
  if (root.has("grasp_detection")) {
    TomlReader table = root.table("grasp_detection");
    scene.grasp = read_detection(table);
  }
  if (!root.has("magnet")) return;
  TomlReader table = root.table("magnet");
  scene.magnet = read_magnet(table);
  if (scene.magnet.mode != Magnet::Mode::off && !scene.grasp)
    root.fail("magnet", "needs [grasp_detection]"_text, "add it, or write mode = \"off\""_text);
  if (scene.magnet.mode == Magnet::Mode::spring && scene.object.mass_kg == 0.0)
    root.fail("magnet", "needs an object with mass"_text, "give it one"_text);
}

void read_pads(TomlReader& root, HandsScene& scene) {
  for (TomlReader& table : root.tables("pad")) scene.pads.push_back(read_pad(table));
  if (scene.pads.empty()) return;
  TomlReader dynamics = root.table("dynamics");
  scene.pad_step_s = read_positive(dynamics, "step_s", scene.pad_step_s);
  if (!(scene.pad_step_s * kMostOfPads >= 1.0))
    dynamics.fail("step_s", "is beyond what hands need"_text, "check its unit"_text);
  if (!(scene.object.mass_kg > 0.0) || !(scene.object.inertia_kg_m2.minCoeff() > 0.0))
    root.fail("pad", "needs an object with mass and inertia"_text, "give it both"_text);
}

/// Bubbles, what holds and pads: measured forces have no place that they could move.
void refuse_what_proxies_have(TomlReader& root, TomlReader& hands) {
  const Text what = "belongs to hands that are points in the scene"_text;
  const Text remedy = "leave it out, or write coupling = \"proxy\""_text;
  for (const std::string& key : hands.keys())
    if (key != "coupling") hands.fail(key, what, remedy);
  for (const char* key : {"grasp_detection", "magnet", "pad"})
    if (root.has(key)) root.fail(key, what, remedy);
}

}  // namespace

bool has_hands(std::string_view text) noexcept {
  return text.find("[hands]") != std::string_view::npos;
}

Result<HandsScene> parse_hands_scene(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-scene-1");
  if (!root) return root.error();
  HandsScene scene;
  TomlReader hands = root->table("hands");
  scene.coupling = static_cast<Coupling>(hands.choice("coupling", {"none", "force", "proxy"}));
  switch (scene.coupling) {
    case Coupling::none:
      scene.object.file = file;
      scene.object.name = root->text("name", "");
      refuse_what_proxies_have(*root, hands);
      for (const char* key : {"object", "dynamics", "initial", "contact"})
        if (root->has(key))
          root->fail(key, "belongs to an object, and hands without coupling have none"_text,
                     "leave it out, or write coupling = \"force\""_text);
      break;
    case Coupling::force:
      scene.object = read_bare_scene(*root, file);
      refuse_what_proxies_have(*root, hands);
      scene.contacts = read_hand_contacts(*root, scene.object);
      break;
    case Coupling::proxy:
      for (TomlReader& contact : root->tables("contact"))
        if (contact.has("hand"))
          contact.fail("hand", "belongs to measured forces"_text,
                       "leave it out, or write coupling = \"force\""_text);
      scene.object = read_scene(*root, file);
      scene.hands = read_hands(hands);
      read_holding(*root, scene);
      read_pads(*root, scene);
      refuse_beyond(*root, scene.object);
      break;
  }
  if (const auto done = root->finish(); !done) return done.error();
  return scene;
}

}  // namespace isograsp::bimanual
