// SPDX-License-Identifier: GPL-3.0-or-later
// An object that soft pads hold, step by step: each pad hangs on its proxy, which is led
// (docs/bimanual.md, "Pads"). SI units, world axes.
#pragma once

#include <array>
#include <vector>

#include "bimanual/pads/pad_step.hpp"
#include "bimanual/pads/side.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp::bimanual {

/// A pad as a scene says it.
struct PadSpec {
  Side hand = Side::left;
  Vec3 from_hand_m = Vec3::Zero();  ///< of the pad's origin, from its hand's proxy, whose axes
  Vec3 normal = Vec3::UnitX();      ///< of its face at the begin, into the object
  Vec3 tangent = Vec3::UnitY();     ///< across the normal
  Pad face;                         ///< semi-axes, rays, rings
  double friction = 0.8;
  double foundation_N_m3 = 0.0;   ///< pressure over penetration
  Vec6 stiffness = Vec6::Zero();  ///< against its proxy [N/m], [N m/rad]
  Vec6 damping = Vec6::Zero();    ///< [N s/m], [N m s/rad]
};

class HeldByPads {
 public:
  /// Pads stand where their proxies want them. @pre the object has mass and inertia
  HeldByPads(const Scene& scene, std::vector<PadSpec> pads, double step_s, PadSolver solver,
             const std::array<Pose, kSides>& proxies);

  /// What a step from here would solve; the proxies at its end.
  [[nodiscard]] PadStep next(const std::array<Pose, kSides>& proxies,
                             const Vec3& gravity_m_s2) const;
  /// One step; the proxies at its end. Does not allocate but in the first one.
  void step(const std::array<Pose, kSides>& proxies, const Vec3& gravity_m_s2);

  /// Pads stand where these proxies want them. Real-time safe.
  void begin(const std::array<Pose, kSides>& proxies) noexcept;
  /// The object stands here, at rest. Real-time safe.
  void put(const Pose& X_WO) noexcept;

  [[nodiscard]] const Pose& X_WO() const noexcept { return X_WO_; }
  [[nodiscard]] const std::vector<Pose>& X_WP() const noexcept { return X_WP_; }
  /// Of each pad on the object in the last step, about the pad's own origin.
  [[nodiscard]] const std::vector<Wrench>& wrenches() const noexcept { return wrenches_; }
  [[nodiscard]] const std::vector<PadSpec>& pads() const noexcept { return pads_; }
  /// Rows and sweeps of the last step; 0: there was none.
  [[nodiscard]] std::size_t constraints() const noexcept { return steps_.last().constraints; }
  [[nodiscard]] int sweeps() const noexcept { return steps_.last().sweeps; }
  /// All steps so far settled.
  [[nodiscard]] bool settled() const noexcept { return settled_; }

 private:
  struct Body {
    Mat6 inertia;
    Vec6 velocity_free;
  };
  [[nodiscard]] Body object_body(const Vec3& gravity_m_s2) const;
  [[nodiscard]] Body pad_body(std::size_t pad, const std::array<Pose, kSides>& proxies) const;
  void put_face(std::size_t pad, const Vec6& object_free, const Vec6& pad_free,
                PadFace& face) const;
  void put_step(const std::array<Pose, kSides>& proxies, const Vec3& gravity_m_s2,
                PadStep& step) const;

  Scene scene_;
  std::vector<PadSpec> pads_;
  double step_s_;
  PadSteps steps_;
  PadStep step_;
  std::vector<std::vector<PressedPoint>> points_;  ///< of each face; a share is an area [m^2]
  std::vector<Pose> X_WP_;                         ///< of the pads
  std::array<Pose, kSides> proxies_;
  Pose X_WO_;
  Vec3 v_W_ = Vec3::Zero();
  Vec3 w_W_ = Vec3::Zero();
  std::vector<Wrench> wrenches_;
  bool settled_ = true;
};

}  // namespace isograsp::bimanual
