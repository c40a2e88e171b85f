// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual object, its springs and dampers and the fingers that touch it, as a scene file says it.
// Frames: W world, O object, C contact. SI units. Format: docs/file_formats.md.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "grasp_model/patch/contact_patch.hpp"
#include "hand/finger.hpp"

namespace isograsp {

class TomlReader;

enum class Shape : std::uint8_t { box, cylinder, sphere };
/// What a contact passes; `bonded` passes everything and pulls too (grasp maps only, no scene).
enum class ContactModel : std::uint8_t { frictionless, point, soft, bonded };
enum class WrenchFrame : std::uint8_t { hand, object };
enum class GraspRule : std::uint8_t { any, opposition, closure };
/// Degrees of freedom in the order of every array of six below.
enum class Dof : std::uint8_t { x, y, z, rx, ry, rz };
inline constexpr std::array<std::string_view, 6> kDofNames{"x", "y", "z", "rx", "ry", "rz"};

struct Contact {
  Finger finger = Finger::thumb;
  Vec3 p_OC = Vec3::Zero();      ///< from the COM, object axes [m]
  Mat3 R_OC = Mat3::Identity();  ///< columns: tangent x, y = z x x, inward normal z
  ContactModel model = ContactModel::point;
  double friction = 0.0;   ///< mu
  double torsion_m = 0.0;  ///< soft: torsional limit / normal force [m]
  double threshold_N = 0.0;
  std::optional<Pad> pad;  ///< soft: its patch gave the torsional limit
};

struct TravelLimit {
  Dof dof = Dof::x;
  double least = 0.0;  ///< [m] or [rad]
  double most = 0.0;
};

struct Scene {
  std::string name;
  std::string file;  ///< where it was read from, for errors
  Shape shape = Shape::box;
  Vec3 size_m = Vec3::Zero();  ///< box x y z | cylinder diameter, length, 0 | sphere diameter, 0, 0
  double mass_kg = 0.0;
  Vec3 inertia_kg_m2 = Vec3::Zero();
  std::array<bool, 6> free{};
  Vec6 stiffness = Vec6::Zero();  ///< [N/m], [N m/rad]
  Vec6 damping = Vec6::Zero();    ///< [N s/m], [N m s/rad]
  Mat3 R_WK = Mat3::Identity();   ///< axes of the x y z springs in the world
  Mat3 R_WD = Mat3::Identity();   ///< axes of the x y z dampers in the world
  /// Three free rotations: error of the attitude allowed in one hold [rad].
  double tolerance_rad = 3e-10;
  WrenchFrame wrench_frame = WrenchFrame::hand;
  Vec3 gravity_m_s2 = Vec3::Zero();
  Vec3 anchor_m = Vec3::Zero();
  std::vector<TravelLimit> limits;
  GraspRule grasp_rule = GraspRule::any;
  Pose initial_X_WO;
  Vec3 initial_v_WO_W = Vec3::Zero();  ///< [m/s]
  Vec3 initial_w_WO_W = Vec3::Zero();  ///< [rad/s]
  std::vector<Contact> contacts;       ///< at most one per finger, in the order of the file

  [[nodiscard]] const Contact* contact_of(Finger finger) const noexcept;
  [[nodiscard]] std::array<bool, kFingerCount> fingers_used() const noexcept;
};

/// Of a homogeneous solid. `size_m`: as that of a scene.
[[nodiscard]] std::unique_ptr<PatchSurface> surface_of_solid(Shape shape, const Vec3& size_m);
[[nodiscard]] PatchFrame frame_of(const Contact& contact);

/// Reads and checks a scene. `file` is used in errors only.
[[nodiscard]] Result<Scene> parse_scene(std::string_view text, const std::string& file);

/// The same of a file that has more than a scene; what is wrong is remembered by the reader.
[[nodiscard]] Scene read_scene(TomlReader& root, const std::string& file);
/// Without its contacts, and one of them as its table says it, all but whose it is: for scenes
/// whose contacts are not those of one hand.
[[nodiscard]] Scene read_bare_scene(TomlReader& root, const std::string& file);
[[nodiscard]] Contact read_contact(TomlReader& table, const Scene& scene);

/// Scenes are written for the right hand. The left hand's device is turned by pi about its y axis:
/// every contact's position, normal and tangent go (x, y, z) -> (-x, y, -z).
[[nodiscard]] Scene for_hand(Scene scene, Hand hand);

}  // namespace isograsp
