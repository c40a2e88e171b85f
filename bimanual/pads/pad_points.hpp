// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: soft pads point by point, by Newton in the velocities of the bodies.
// However many points a pad has, they see six numbers: how it moves over the object. What a point
// gives is a function of that in closed form, so that six equations a body are left, and a pass
// over the points puts them together. Points that stick would make them stiff without end: they are
// held by springs of velocity, whose force is then held by itself (augmented Lagrangian; Alart,
// Curnier 1991), until nothing slips that sticks.
#pragma once

#include <vector>

#include "bimanual/pads/pad_step.hpp"
#include "bimanual/pads/point_force.hpp"

namespace isograsp::bimanual {

/// Solves step after step. Does not allocate once it has seen as many bodies and points.
class PointSolver {
 public:
  /// `go_on`: from where `solution`, of the step before, ended; else from the free motion.
  void solve(const PadStep& step, bool go_on, PadSolution& solution);

 private:
  struct Body {
    Mat6 inertia, inverse;
    Vec6 free, residual;  ///< velocity; what is left of the impulses
  };
  struct Object : Body {
    Vec6 velocity, way;
    Mat6 system;
  };
  /// A pad; all at its origin.
  struct Face : Body {
    std::size_t object = 0;
    Mat6 there;                    ///< velocity of the object at the pad's origin, from its own
    Vec6 relative, relative_free;  ///< velocity of the pad over the object
    Vec6 wrench;                   ///< on the object
    Mat6 hardness;                 ///< of the wrench
    Mat6 gives;                    ///< inverse of inertia and hardness
    Vec6 way;                      ///< of `relative`
    std::vector<PointState> points;
  };

  void begin(const PadStep& step, bool go_on, const PadSolution& before);
  void begin_points(const PadFace& spec, Face& face) const;
  void look(const PadStep& step);
  void look_at_points(const PadFace& spec, Face& face) const;
  void find_way();
  void foresee(const PadStep& step);
  void go(double share);
  void advance(const PadStep& step);
  [[nodiscard]] double hold(const PadStep& step, double slipped_before);
  [[nodiscard]] double work_left() const;
  [[nodiscard]] double residual() const;
  [[nodiscard]] double speed() const;
  void report(const PadStep& step, PadSolution& solution) const;

  double step_s_ = 0.0;
  int looks_ = 0;
  std::vector<Object> objects_;  ///< as the bodies of the step; those of pads stand aside
  std::vector<Face> faces_;
};

}  // namespace isograsp::bimanual
