// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/toml_reader.hpp"
#include "grasp_model/patch/solid_surface.hpp"

namespace isograsp {

namespace {

/// Decimals in a file cannot give an attitude exactly if axes are locked. An error up to this is
/// accepted and removed.
constexpr double kAttitudeRounding = 1e-9;

/// Principal moments of a homogeneous solid about its COM [kg m^2].
Vec3 solid_inertia(Shape shape, const Vec3& size_m, double mass_kg) {
  const Vec3 squares = size_m.cwiseAbs2();
  if (shape == Shape::box)
    return mass_kg / 12.0 *
           Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  const double radius_squared = squares.x() / 4.0;
  if (shape == Shape::sphere) return Vec3::Constant(0.4 * mass_kg * radius_squared);
  const double across = mass_kg * (radius_squared / 4.0 + squares.y() / 12.0);
  return {across, across, mass_kg * radius_squared / 2.0};
}

/// Above every number of rays or rings that a pad may have.
constexpr std::int64_t kMany = 1'000'000;

void require_not_negative(TomlReader& table, std::string_view key, double value) {
  if (value < 0.0) table.fail(key, "is negative"_text, "write a number that is not negative"_text);
}

void read_object(TomlReader table, Scene& scene) {
  scene.shape = static_cast<Shape>(table.choice("shape", {"box", "cylinder", "sphere"}));
  const std::size_t sizes = scene.shape == Shape::box ? 3 : scene.shape == Shape::cylinder ? 2 : 1;
  const auto size_m = table.numbers("size_m", sizes, sizes);
  for (std::size_t i = 0; i < sizes && i < size_m.size(); ++i) {
    scene.size_m[static_cast<Eigen::Index>(i)] = size_m[i];
    require_not_negative(table, "size_m", size_m[i]);
  }
  scene.mass_kg = table.number("mass_kg");
  require_not_negative(table, "mass_kg", scene.mass_kg);
  scene.inertia_kg_m2 =
      table.vec3("inertia_kg_m2", solid_inertia(scene.shape, scene.size_m, scene.mass_kg));
  require_not_negative(table, "inertia_kg_m2", scene.inertia_kg_m2.minCoeff());
}

void read_limits(TomlReader& dynamics, Scene& scene) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  for (auto& table : dynamics.tables("limits")) {
    TravelLimit limit;
    limit.dof = static_cast<Dof>(table.choice("dof", {"x", "y", "z", "rx", "ry", "rz"}));
    const bool linear = limit.dof <= Dof::z;
    const std::string_view least = linear ? "min_m" : "min_rad";
    const std::string_view most = linear ? "max_m" : "max_rad";
    if (!table.has(least) && !table.has(most))
      table.fail("", "the limit has no bound"_text, "add %1 or %2"_text(least, most));
    limit.least = table.number(least, -kUnbounded);
    limit.most = table.number(most, kUnbounded);
    if (limit.least > limit.most)
      table.fail(least, "is above %1"_text(most), "exchange the two"_text);
    for (const auto& other : scene.limits)
      if (other.dof == limit.dof)
        table.fail("dof", "has two limits"_text, "write both bounds in one entry"_text);
    scene.limits.push_back(limit);
  }
}

/// Attitude of the axes of springs or dampers; identity unless written.
Mat3 read_axes(TomlReader& table, std::string_view key) {
  if (!table.has(key)) return Mat3::Identity();
  const auto q = table.numbers(key, 4, 4);
  if (q.size() != 4) return Mat3::Identity();
  const Quat attitude(q[0], q[1], q[2], q[3]);
  const double norm = attitude.coeffs().stableNorm();
  if (!(norm > 0.0) || !std::isfinite(norm)) {
    table.fail(key, "has no direction"_text, "write a unit quaternion w, x, y, z"_text);
    return Mat3::Identity();
  }
  return Quat(attitude.coeffs() / norm).toRotationMatrix();
}

void read_dynamics(TomlReader table, Scene& scene) {
  for (const auto& word : table.texts("free")) {
    std::size_t dof = 0;
    while (dof < kDofNames.size() && kDofNames[dof] != word) ++dof;
    if (dof == kDofNames.size())
      table.fail("free", "'%1' is not known"_text(word), "write some of: x, y, z, rx, ry, rz"_text);
    else if (scene.free[dof])
      table.fail("free", "'%1' appears twice"_text(word), "keep one of them"_text);
    else
      scene.free[dof] = true;
  }
  for (const auto& [key, values] :
       {std::pair{"stiffness", &scene.stiffness}, std::pair{"damping", &scene.damping}}) {
    const auto read = table.numbers(key, 6, 6);
    for (std::size_t i = 0; i < 6 && i < read.size(); ++i)
      (*values)[static_cast<Eigen::Index>(i)] = read[i];
    require_not_negative(table, key, values->minCoeff());
  }
  scene.R_WK = read_axes(table, "spring_quaternion_wxyz");
  scene.R_WD = read_axes(table, "damper_quaternion_wxyz");
  scene.tolerance_rad = table.number("tolerance_rad", scene.tolerance_rad);
  if (!(scene.tolerance_rad > 0.0))
    table.fail("tolerance_rad", "is not positive"_text, "write an angle such as 1e-9"_text);
  scene.wrench_frame =
      static_cast<WrenchFrame>(table.choice("wrench_frame", {"hand", "object"}, 0));
  scene.gravity_m_s2 = table.vec3("gravity_m_s2", Vec3::Zero());
  scene.anchor_m = table.vec3("anchor_m", Vec3::Zero());
  scene.grasp_rule =
      static_cast<GraspRule>(table.choice("grasp_rule", {"any", "opposition", "closure"}, 0));
  read_limits(table, scene);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const double inertia = i < 3 ? scene.mass_kg : scene.inertia_kg_m2[axis - 3];
    if (scene.free[i] && inertia == 0.0 && scene.damping[axis] == 0.0)
      table.fail("damping",
                 "is 0 on the free axis %1 that has no %2"_text(
                     kDofNames[i], i < 3 ? "mass"_text : "inertia"_text),
                 "give it damping, or the object mass"_text);
  }
}

/// The attitude as a unit quaternion with the file's sign; exact on the axes that cannot turn.
void read_attitude(TomlReader& table, Scene& scene) {
  if (!table.has("quaternion_wxyz")) return;
  const auto q = table.numbers("quaternion_wxyz", 4, 4);
  if (q.size() != 4) return;
  Eigen::Vector4d wxyz(q[0], q[1], q[2], q[3]);
  const double norm = wxyz.stableNorm();
  if (!(norm > 0.0) || !std::isfinite(norm)) {
    table.fail("quaternion_wxyz", "has no direction"_text,
               "write a unit quaternion w, x, y, z"_text);
    return;
  }
  wxyz /= norm;
  int rotations = 0;
  for (std::size_t i = 3; i < 6; ++i) rotations += scene.free[i] ? 1 : 0;
  for (Eigen::Index axis = 0; axis < 3 && rotations < 2; ++axis) {
    if (scene.free[static_cast<std::size_t>(axis) + 3]) continue;
    if (std::abs(wxyz[axis + 1]) > kAttitudeRounding)
      table.fail("quaternion_wxyz", "the free rotations cannot reach this attitude"_text,
                 "start from an attitude about the free axes, or free more rotations"_text);
    wxyz[axis + 1] = 0.0;
  }
  wxyz /= wxyz.norm();
  scene.initial_X_WO.q = Quat(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

void read_initial(TomlReader table, Scene& scene) {
  scene.initial_X_WO.p = table.vec3("position_m", scene.anchor_m);
  read_attitude(table, scene);
  scene.initial_v_WO_W = table.vec3("velocity_m_s", Vec3::Zero());
  scene.initial_w_WO_W = table.vec3("angular_velocity_rad_s", Vec3::Zero());
  for (std::size_t i = 0; i < 6; ++i) {
    const auto axis = static_cast<Eigen::Index>(i % 3);
    const double speed = i < 3 ? scene.initial_v_WO_W[axis] : scene.initial_w_WO_W[axis];
    if (!scene.free[i] && speed != 0.0)
      table.fail(i < 3 ? "velocity_m_s" : "angular_velocity_rad_s",
                 "%1 is locked but has an initial velocity"_text(kDofNames[i]),
                 "set it to 0, or free %1"_text(kDofNames[i]));
  }
  for (const auto& limit : scene.limits) {
    if (limit.dof > Dof::z) continue;
    const double start = scene.initial_X_WO.p[static_cast<Eigen::Index>(limit.dof)];
    if (start < limit.least || start > limit.most)
      table.fail(
          "position_m",
          "starts outside the limit of %1"_text(kDofNames[static_cast<std::size_t>(limit.dof)]),
          "start inside the limit, or widen it"_text);
  }
}

/// A pad becomes a soft contact with the torsional limit of its patch.
void read_pad(TomlReader& contact_table, const Scene& scene, Contact& contact) {
  constexpr double kPerDegree = std::numbers::pi / 180.0;
  if (contact_table.has("torsion_m"))
    contact_table.fail("torsion_m", "follows from the patch"_text, "leave it out"_text);
  TomlReader table = contact_table.table("patch");
  Pad pad;
  const auto axes_m = table.numbers("semi_axes_m", 2, 2);
  if (axes_m.size() == 2) {
    pad.semi_x_m = axes_m[0];
    pad.semi_y_m = axes_m[1];
  }
  pad.rays = static_cast<int>(std::clamp<std::int64_t>(table.integer("rays", pad.rays), 0, kMany));
  pad.rings =
      static_cast<int>(std::clamp<std::int64_t>(table.integer("rings", pad.rings), 0, kMany));
  pad.friction = contact.friction;
  pad.sharp_edge_rad = kPerDegree * table.number("sharp_edge_deg", pad.sharp_edge_rad / kPerDegree);
  pad.rough = table.boolean("rough", false);
  pad.depth_m = table.number("depth_m", 0.0);
  contact.pad = pad;
  if (!contact.R_OC.allFinite()) return;  // told already
  const auto patch =
      scan_patch(*surface_of_solid(scene.shape, scene.size_m), frame_of(contact), pad);
  if (patch) {
    contact.torsion_m = patch->torsion_m;
    return;
  }
  const Error& error = patch.error();
  const bool of_pad = error.field == "pad";
  const std::string_view key = error.field == "point" ? "position_m" : "normal";
  (of_pad ? table : contact_table).fail(of_pad ? "" : key, error.what, error.remedy);
}

void read_contact_of_finger(TomlReader& table, Scene& scene) {
  if (table.has("hand"))
    table.fail("hand", "needs a scene with two hands"_text,
               "add [hands] with coupling = \"force\", or leave it out"_text);
  const auto finger = static_cast<Finger>(table.choice("finger", {"thumb", "index", "middle"}));
  if (scene.contact_of(finger) != nullptr)
    table.fail("finger", "has two contacts"_text, "keep one contact per finger"_text);
  Contact contact = read_contact(table, scene);
  contact.finger = finger;
  scene.contacts.push_back(contact);
}

}  // namespace

Contact read_contact(TomlReader& table, const Scene& scene) {
  Contact contact;
  contact.p_OC = table.vec3("position_m");
  const Vec3 normal = table.vec3("normal").stableNormalized();
  const Vec3 given = table.vec3("tangent").stableNormalized();
  constexpr double kParallel = 1e-6;  // below this the direction would be rounding
  const Vec3 tangent = given - given.dot(normal) * normal;
  if (normal.squaredNorm() == 0.0)
    table.fail("normal", "is zero"_text, "write the direction into the object"_text);
  else if (tangent.norm() < kParallel)
    table.fail("tangent", "is zero or along the normal"_text,
               "write a direction across the normal"_text);
  contact.R_OC.col(0) = tangent.stableNormalized();
  contact.R_OC.col(1) = normal.cross(contact.R_OC.col(0));
  contact.R_OC.col(2) = normal;
  constexpr std::size_t kPad = 3;
  const std::size_t model = table.choice("model", {"frictionless", "point", "soft", "pad"});
  contact.model = model == kPad ? ContactModel::soft : static_cast<ContactModel>(model);
  const bool needs_friction = contact.model != ContactModel::frictionless;
  contact.friction = needs_friction ? table.number("friction") : table.number("friction", 0.0);
  contact.torsion_m = table.number("torsion_m", 0.0);
  contact.threshold_N = table.number("threshold_N", 0.0);
  require_not_negative(table, "friction", contact.friction);
  require_not_negative(table, "torsion_m", contact.torsion_m);
  require_not_negative(table, "threshold_N", contact.threshold_N);
  if (model == kPad) read_pad(table, scene, contact);
  return contact;
}

const Contact* Scene::contact_of(Finger finger) const noexcept {
  for (const auto& contact : contacts)
    if (contact.finger == finger) return &contact;
  return nullptr;
}

std::array<bool, kFingerCount> Scene::fingers_used() const noexcept {
  std::array<bool, kFingerCount> used{};
  for (const auto& contact : contacts) used[index_of(contact.finger)] = true;
  return used;
}

std::unique_ptr<PatchSurface> surface_of_solid(Shape shape, const Vec3& size_m) {
  if (shape == Shape::box) return std::make_unique<BoxSurface>(size_m);
  if (shape == Shape::sphere) return std::make_unique<SphereSurface>(size_m.x());
  return std::make_unique<CylinderSurface>(size_m.x(), size_m.y());
}

PatchFrame frame_of(const Contact& contact) {
  return {contact.p_OC, contact.R_OC.col(2), contact.R_OC.col(0), contact.R_OC.col(1)};
}

Result<Scene> parse_scene(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-scene-1");
  if (!root) return root.error();
  if (root->has("hands"))
    root->fail("hands", "makes it a scene of two hands"_text, "take a scene of one hand"_text);
  Scene scene = read_scene(*root, file);
  if (const auto done = root->finish(); !done) return done.error();
  return scene;
}

Scene read_scene(TomlReader& root, const std::string& file) {
  Scene scene = read_bare_scene(root, file);
  for (auto& table : root.tables("contact")) read_contact_of_finger(table, scene);
  return scene;
}

Scene read_bare_scene(TomlReader& root, const std::string& file) {
  Scene scene;
  scene.file = file;
  scene.name = root.text("name", "");
  read_object(root.table("object"), scene);
  read_dynamics(root.table("dynamics"), scene);
  read_initial(root.table("initial", false), scene);
  return scene;
}

Scene for_hand(Scene scene, Hand hand) {
  if (hand == Hand::right) return scene;
  const Vec3 turn(-1.0, 1.0, -1.0);  // by pi about y
  for (auto& contact : scene.contacts) {
    contact.p_OC = turn.asDiagonal() * contact.p_OC;
    contact.R_OC = turn.asDiagonal() * contact.R_OC;
  }
  return scene;
}

}  // namespace isograsp
