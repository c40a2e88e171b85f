// SPDX-License-Identifier: GPL-3.0-or-later
// Translations under a force that turns with the object inside the hold: the response of each axis
// is exact for the force at the end of a panel, plus a quadrature of the impulse response for its
// difference from that. A hold is 2^level panels. SI units. Formulas: docs/grasp_model.md.
#pragma once

#include <array>
#include <vector>

#include "core/spatial.hpp"
#include "grasp_model/spin.hpp"
#include "grasp_model/zoh.hpp"

namespace isograsp {

/// Nodes of a quadrature on [0, 1].
struct Quadrature {
  static constexpr std::size_t kMost = 8;
  std::size_t size = 0;
  std::array<double, kMost> time{};
  std::array<double, kMost> weight{};
  std::array<std::size_t, kMost> stage{};  ///< of a step, that a node is
};
/// Gauss-Legendre, five nodes: exact for polynomials of degree 9.
[[nodiscard]] const Quadrature& gauss5() noexcept;
/// The weighted stages of an explicit step of so3: of its order along its own motion.
[[nodiscard]] const Quadrature& stage_nodes(so3::Order order) noexcept;

/// Forces in one panel, world axes [N].
struct PanelForces {
  Vec3 begin;
  std::array<Vec3, Quadrature::kMost> node;
  Vec3 end;
};

/// Fastest rate of one axis [1/s]: sqrt(k/m) + c/m, or k/c without mass.
[[nodiscard]] double fastest_rate(const Oscillator& oscillator) noexcept;

/// Free axes without coupling; a locked one has no response.
struct FreeAxes {
  std::array<Oscillator, 3> oscillator{};
  std::array<bool, 3> free{};
  /// Fastest rate of the free axes [1/s].
  [[nodiscard]] double fastest_rate() const noexcept;
};

/// Response of the axes over one panel. Real-time safe.
class QuadraturePanel {
 public:
  QuadraturePanel(const FreeAxes& axes, const Quadrature& nodes, double length_s) noexcept;
  [[nodiscard]] double length_s() const noexcept { return length_s_; }
  /// Moves one free axis; x from the spring's rest.
  [[nodiscard]] Motion advance(Eigen::Index axis, const Motion& start,
                               const PanelForces& forces) const noexcept;

 private:
  std::size_t nodes_ = 0;
  double length_s_ = 0.0;
  std::array<LinearStep, 3> whole_;
  /// At the panel's end after a unit of force at the node, times its weight.
  std::array<std::array<Motion, Quadrature::kMost>, 3> push_{};
};

/// Most halvings of a hold: 64 panels or steps.
inline constexpr int kFinestLevel = 6;
/// Levels below 0 are one step of a lower order.
inline constexpr int kCoarsestLevel = -2;
[[nodiscard]] inline so3::Order order_of(int level) noexcept {
  return level >= 0 ? so3::Order::eighth : level == -1 ? so3::Order::fifth : so3::Order::third;
}

/// The panels of a hold at its levels, made once.
class Follower {
 public:
  Follower() = default;
  /// Panels down to the 2^finest of a hold.
  Follower(const FreeAxes& axes, const Quadrature& nodes, double hold_s, int finest);
  /// One of the 2^level panels of the hold.
  [[nodiscard]] const QuadraturePanel& panel(int level) const noexcept {
    return levels_[static_cast<std::size_t>(level)];
  }
  [[nodiscard]] double hold_s() const noexcept { return hold_s_; }
  /// A panel of any length, made now.
  [[nodiscard]] QuadraturePanel panel_of(double length_s) const noexcept {
    return {axes_, *nodes_, length_s};
  }
  [[nodiscard]] const FreeAxes& axes() const noexcept { return axes_; }
  [[nodiscard]] const Quadrature& nodes() const noexcept { return *nodes_; }

 private:
  FreeAxes axes_;
  const Quadrature* nodes_ = nullptr;
  double hold_s_ = 0.0;
  std::vector<QuadraturePanel> levels_;
};

}  // namespace isograsp
