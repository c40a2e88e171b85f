// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: pads as one block of rows each: bodies that forces move, rows between
// an object and a pad, sweeps until nothing changes; and what all solvers call settled.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "bimanual/pads/pad_step.hpp"

namespace isograsp::bimanual {

inline constexpr int kMostSweeps = 20000;
/// Of the largest velocity: what may be left.
inline constexpr double kSettled = 1e-10;
/// Bodies slower than this stand still: what a sweep changes is compared with it [m/s], [rad/s].
inline constexpr double kStill = 1e-3;
using Vec2 = Eigen::Vector2d;

/// How a direction at a point moves with a body.
inline Vec6 row_of(const Vec3& direction, const Vec3& arm) {
  Vec6 row;
  row << direction, arm.cross(direction);
  return row;
}

/// Two directions across a normal.
struct Tangents {
  explicit Tangents(const Vec3& normal) {
    const Vec3 aside = std::abs(normal.x()) < 0.5 ? Vec3::UnitX() : Vec3::UnitY();
    first = normal.cross(aside).normalized();
    second = normal.cross(first);
  }
  Vec3 first, second;
};

/// The bodies, moved by forces between two of them at a time.
class Bodies {
 public:
  explicit Bodies(const PadStep& step);
  double step_s;
  std::vector<Vec6> velocity;
  std::vector<Mat6> inverse;
};

/// Rows between an object and a pad: the velocity of the pad along them less that of the object.
/// A force along them acts on the object, and against it on the pad.
template <int N>
struct Rows {
  using Columns = Eigen::Matrix<double, 6, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  Columns object, pad;            ///< a row each
  Columns by_object, by_pad;      ///< velocity for a unit of impulse
  Eigen::Matrix<double, N, N> W;  ///< slip for a unit of force, over one step

  void prepare(const Bodies& bodies, const PadFace& face) {
    by_object = bodies.inverse[face.object] * object;
    by_pad = bodies.inverse[face.pad] * pad;
    W = bodies.step_s * (object.transpose() * by_object + pad.transpose() * by_pad);
    W = 0.5 * (W + W.transpose()).eval();
  }
  [[nodiscard]] Vector slip(const Bodies& bodies, const PadFace& face) const {
    return pad.transpose() * bodies.velocity[face.pad] -
           object.transpose() * bodies.velocity[face.object];
  }
  void push(Bodies& bodies, const PadFace& face, const Vector& force) const {
    bodies.velocity[face.object] += bodies.step_s * (by_object * force);
    bodies.velocity[face.pad] -= bodies.step_s * (by_pad * force);
  }
};

/// Largest change of a velocity in a sweep.
class Change {
 public:
  explicit Change(const Bodies& bodies) : before_(bodies.velocity) {}
  [[nodiscard]] bool settled(const Bodies& bodies) const {
    double change = 0.0, size = kStill;
    for (std::size_t b = 0; b < before_.size(); ++b) {
      change = std::max(change, (bodies.velocity[b] - before_[b]).cwiseAbs().maxCoeff());
      size = std::max(size, bodies.velocity[b].cwiseAbs().maxCoeff());
    }
    return change <= kSettled * size;
  }

 private:
  std::vector<Vec6> before_;
};

/// Sweeps until none changes a velocity any more.
template <class Sweep>
void sweep_until_settled(Bodies& bodies, PadSolution& solution, Sweep&& sweep) {
  solution.settled = false;
  for (int k = 0; k < kMostSweeps && !solution.settled; ++k) {
    const Change change(bodies);
    sweep();
    ++solution.sweeps;
    solution.settled = change.settled(bodies);
  }
}

/// 4 rows for each pad (pad_faces.cpp); `exact`: with the friction of its points.
[[nodiscard]] PadSolution solve_faces(const PadStep& step, bool exact, const PadSolution* before);

}  // namespace isograsp::bimanual
