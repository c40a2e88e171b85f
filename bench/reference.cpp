// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/reference.hpp"

#include <algorithm>
#include <stdexcept>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

namespace isograsp::bench {

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Matrix3 = std::array<std::array<Quad, 3>, 3>;

Matrix3 times(const Matrix3& a, const Matrix3& b) {
  Matrix3 c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// exp(a): Taylor series of a / 2^20, squared 20 times. 113 bits leave more than 1e-20 of error.
Matrix3 exponential(Matrix3 a) {
  constexpr int kSquarings = 20;
  constexpr int kTerms = 24;
  for (auto& row : a)
    for (auto& x : row) x /= Quad(1 << kSquarings);
  Matrix3 sum{};
  for (std::size_t i = 0; i < 3; ++i) sum[i][i] = 1;
  Matrix3 term = sum;
  for (int n = 1; n <= kTerms; ++n) {
    term = times(term, a);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        term[i][j] /= n;
        sum[i][j] += term[i][j];
      }
  }
  for (int n = 0; n < kSquarings; ++n) sum = times(sum, sum);
  return sum;
}

/// One degree of freedom over all holds: m x" + c x' + k x = force.
class Line {
 public:
  Line(double m, double c, double k, double hold_s, double x, double v) : x_(x), v_(v) {
    const Quad h = hold_s;
    const Quad mass = m;
    step_ = exponential({{{0, h, 0}, {-h * k / mass, -h * c / mass, h / mass}, {0, 0, 0}}});
  }
  void advance(double force) {
    const Quad x = step_[0][0] * x_ + step_[0][1] * v_ + step_[0][2] * force;
    v_ = step_[1][0] * x_ + step_[1][1] * v_ + step_[1][2] * force;
    x_ = x;
  }
  [[nodiscard]] const Quad& x() const { return x_; }
  [[nodiscard]] double v() const { return static_cast<double>(v_); }

 private:
  Matrix3 step_;
  Quad x_;
  Quad v_;
};

using Real = long double;
using Vector = std::array<Real, 3>;
/// q (w x y z), w_O, p_WO, v_WO_W
using Turning = std::array<Real, 13>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector turned(const Real* q, const Vector& u) {
  const Vector axis{q[1], q[2], q[3]};
  Vector t = cross(axis, u);
  for (Real& x : t) x *= 2;
  const Vector s = cross(axis, t);
  return {u[0] + q[0] * t[0] + s[0], u[1] + q[0] * t[1] + s[1], u[2] + q[0] * t[2] + s[2]};
}
Vector turned_back(const Real* q, const Vector& u) {
  const Real inverse[4] = {q[0], -q[1], -q[2], -q[3]};
  return turned(inverse, u);
}
Vector vector_of(const Triple& a) {
  return {a[0], a[1], a[2]};
}

/// Gradient of the energy phi^T diag(k) phi / 2 with respect to a turn in body axes.
Vector spring_torque(const Real* q, const std::array<double, 6>& stiffness) {
  const Real sine = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const Real angle = 2 * std::atan2(sine, q[0]);
  constexpr Real kSmall = 1e-3L;  // the series below is exact to 64 bits there
  const Real scale = sine == 0 ? 2 : angle / sine;
  const Vector phi{scale * q[1], scale * q[2], scale * q[3]};
  const Real a2 = angle * angle;
  const Real d = angle < kSmall ? 1.0L / 12 + a2 / 720 + a2 * a2 / 30240
                                : (1 - angle / 2 / std::tan(angle / 2)) / a2;
  const Vector u{stiffness[3] * phi[0], stiffness[4] * phi[1], stiffness[5] * phi[2]};
  const Vector once = cross(phi, u);
  const Vector twice = cross(phi, once);
  // Jr^-T(phi) = Jl^-1(phi) = 1 - [phi] / 2 + d [phi]^2
  Vector torque{};
  for (std::size_t i = 0; i < 3; ++i) torque[i] = -(u[i] - once[i] / 2 + d * twice[i]);
  return torque;
}

/// The equations of motion with three free rotations.
struct Equations {
  const Case& scene;
  Push push;

  void operator()(const Turning& y, Turning& dy, Real /*t*/) const {
    const Real* q = y.data();
    const Vector w{y[4], y[5], y[6]};
    dy[0] = (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]) / 2;
    dy[1] = (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]) / 2;
    dy[2] = (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]) / 2;
    dy[3] = (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]) / 2;
    Vector torque = vector_of(push.torque);
    Vector force = vector_of(push.force);
    if (scene.follows)
      force = turned(q, force);
    else
      torque = turned_back(q, torque);
    const Vector spring = spring_torque(q, scene.stiffness);
    Vector momentum{};
    for (std::size_t i = 0; i < 3; ++i) momentum[i] = scene.inertia_kg_m2[i] * w[i];
    const Vector gyroscopic = cross(w, momentum);
    for (std::size_t i = 0; i < 3; ++i) {
      dy[4 + i] = (torque[i] + spring[i] - scene.damping[3 + i] * w[i] - gyroscopic[i]) /
                  scene.inertia_kg_m2[i];
      dy[7 + i] = scene.free[i] ? y[10 + i] : 0;
      dy[10 + i] = scene.free[i]
                       ? (force[i] - scene.stiffness[i] * y[7 + i] - scene.damping[i] * y[10 + i]) /
                             scene.mass_kg
                       : 0;
    }
  }
};

/// Steps a hold for which the fastest rate turns by at most kTurn_rad a step.
int steps_per_hold(const Case& scene) {
  constexpr double kTurn_rad = 0.2;
  constexpr double kLeast = 32.0;
  constexpr double kFastestSpin = 100.0;  // [rad/s], more than any scene here reaches
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto faster = [&rate](double k, double c, double m) {
      rate = std::max(rate, std::sqrt(k / m) + c / m);
    };
    faster(scene.stiffness[3 + i], scene.damping[3 + i], scene.inertia_kg_m2[i]);
    if (scene.free[i]) faster(scene.stiffness[i], scene.damping[i], scene.mass_kg);
  }
  return static_cast<int>(
      std::max(kLeast, std::ceil((rate + kFastestSpin) * scene.hold_s / kTurn_rad)));
}

void turn_freely(Case& scene) {
  Turning y{};
  for (std::size_t i = 0; i < 4; ++i) y[i] = scene.start.q_WO[i];
  const Vector w_O = turned_back(y.data(), vector_of(scene.start.w_WO_W));
  for (std::size_t i = 0; i < 3; ++i) {
    y[4 + i] = w_O[i];
    y[7 + i] = scene.start.p_WO[i];
    y[10 + i] = scene.start.v_WO_W[i];
  }
  boost::numeric::odeint::runge_kutta_fehlberg78<Turning, Real> stepper;
  const int steps = steps_per_hold(scene);
  const Real h = Real(scene.hold_s) / steps;
  for (const Push& push : scene.pushes) {
    const Equations equations{scene, push};
    for (int i = 0; i < steps; ++i) stepper.do_step(std::cref(equations), y, Real(0), h);
    const Real norm = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
    for (std::size_t i = 0; i < 4; ++i) y[i] /= norm;
    Motion6 motion;
    const Vector w = turned(y.data(), {y[4], y[5], y[6]});
    for (std::size_t i = 0; i < 4; ++i) motion.q_WO[i] = static_cast<double>(y[i]);
    for (std::size_t i = 0; i < 3; ++i) {
      motion.w_WO_W[i] = static_cast<double>(w[i]);
      motion.p_WO[i] = static_cast<double>(y[7 + i]);
      motion.v_WO_W[i] = static_cast<double>(y[10 + i]);
    }
    scene.reference.push_back(motion);
  }
}

void add_lines(Case& scene) {
  scene.reference.resize(scene.pushes.size(), scene.start);
  for (std::size_t dof : {0u, 1u, 2u, 5u}) {
    if (!scene.free[dof]) continue;
    const bool turns = dof == 5;
    const std::size_t axis = dof % 3;
    Line line(turns ? scene.inertia_kg_m2[axis] : scene.mass_kg, scene.damping[dof],
              scene.stiffness[dof], scene.hold_s, turns ? 0.0 : scene.start.p_WO[axis],
              turns ? scene.start.w_WO_W[axis] : scene.start.v_WO_W[axis]);
    for (std::size_t k = 0; k < scene.pushes.size(); ++k) {
      Motion6& motion = scene.reference[k];
      line.advance(turns ? scene.pushes[k].torque[axis] : scene.pushes[k].force[axis]);
      if (turns) {
        const Quad half = line.x() / 2;
        motion.q_WO = {static_cast<double>(cos(half)), 0, 0, static_cast<double>(sin(half))};
        motion.w_WO_W[axis] = line.v();
      } else {
        motion.p_WO[axis] = static_cast<double>(line.x());
        motion.v_WO_W[axis] = line.v();
      }
    }
  }
}

}  // namespace

void add_reference(Case& scene) {
  scene.reference.clear();
  const bool three = scene.free_rotations() == 3;
  if (!three && (scene.free[3] || scene.free[4] || scene.follows))
    throw std::runtime_error(scene.name + ": no reference for this choice of rotations");
  if (three) turn_freely(scene);
  if (!three) add_lines(scene);
  for (const Motion6& motion : scene.reference) {
    const Distance d = distance(motion, Motion6{});
    scene.excursion_m = std::max(scene.excursion_m, d.metres);
    scene.excursion_rad = std::max(scene.excursion_rad, d.radians);
  }
}

}  // namespace isograsp::bench
