// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: soft pads point by point, by Newton in the velocities of the bodies.
// However many points a pad has, they see six numbers: how it moves over the object. What a point
// gives is a function of that in closed form, so that six equations a body are left, and a pass
// over the points puts them together. Points that stick would make them stiff without end: they are
// held by springs of velocity, whose force is then held by itself (augmented Lagrangian; Alart,
// Curnier 1991), until nothing slips that sticks. With the friction of one plane for each pad this
// is aggregate_exact: the sum of what its points give is the gradient of the support function.
#pragma once

#include <vector>

#include "bimanual/pads/pad_step.hpp"
#include "bimanual/pads/point_force.hpp"

namespace isograsp::bimanual {

/// Solves step after step. Does not allocate once it has seen as many bodies and points.
class PointSolver {
 public:
  /// `one_plane`: all points of a pad rub in the plane across its mean normal through the centroid
  /// of its pressure, both as they are at the end of the step; else each where it presses.
  explicit PointSolver(bool one_plane) : one_plane_(one_plane) {}

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
    Vec3 plane = Vec3::Zero();  ///< normal of the one plane
    std::vector<Vec3> arms;     ///< the points in it
  };

  void begin(const PadStep& step, bool go_on, const PadSolution& before);
  void begin_points(const PadFace& spec, Face& face) const;
  void look(const PadStep& step);
  void look_at_points(const PadFace& spec, Face& face) const;
  void look_in_plane(const PadFace& spec, Face& face) const;
  [[nodiscard]] double lay_plane(const PadFace& spec, Face& face) const;
  [[nodiscard]] double lay_planes(const PadStep& step);
  [[nodiscard]] PointSlip slip_of(const PadFace& spec, const Face& face, std::size_t i,
                                  const Vec6& velocity) const;
  [[nodiscard]] const Vec3& normal_of(const PadFace& spec, const Face& face, std::size_t i) const {
    return one_plane_ ? face.plane : spec.points[i].normal;
  }
  void find_way();
  void foresee(const PadStep& step);
  void go(double share);
  void advance(const PadStep& step);
  [[nodiscard]] double hold(const PadStep& step, double slipped_before);
  [[nodiscard]] double work_left() const;
  [[nodiscard]] double residual() const;
  [[nodiscard]] double speed() const;
  void report(const PadStep& step, PadSolution& solution) const;

  bool one_plane_;
  double step_s_ = 0.0;
  int looks_ = 0;
  std::vector<Object> objects_;  ///< as the bodies of the step; those of pads stand aside
  std::vector<Face> faces_;
};

}  // namespace isograsp::bimanual
