// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit steps. I w' = tau - C w - spring(q) - w x I w,  q' = q (0, w) / 2, w in body axes.
#include <algorithm>
#include <cmath>

#include "grasp_model/angle_ratio.hpp"
#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/low_orders.hpp"
#include "grasp_model/rotation.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp::so3 {

namespace {

using Pair = double __attribute__((vector_size(16)));

/// A SpinVector in the registers of the processor: (qw qx)(qy qz)(wx wy)(wz work). In other widths
/// than it was written, a vector would be read late.
struct Lanes {
  using Scalar = double;
  std::array<Pair, 4> p;
};
[[gnu::always_inline]] inline Lanes operator+(const Lanes& a, const Lanes& b) noexcept {
  return {{a.p[0] + b.p[0], a.p[1] + b.p[1], a.p[2] + b.p[2], a.p[3] + b.p[3]}};
}
[[gnu::always_inline]] inline Lanes operator-(const Lanes& a, const Lanes& b) noexcept {
  return {{a.p[0] - b.p[0], a.p[1] - b.p[1], a.p[2] - b.p[2], a.p[3] - b.p[3]}};
}
[[gnu::always_inline]] inline Lanes operator*(double c, const Lanes& a) noexcept {
  return {{c * a.p[0], c * a.p[1], c * a.p[2], c * a.p[3]}};
}
[[gnu::always_inline]] inline Lanes lanes_of(const SpinVector& y) noexcept {
  return {{Pair{y[0], y[1]}, Pair{y[2], y[3]}, Pair{y[4], y[5]}, Pair{y[6], y[7]}}};
}
[[gnu::always_inline]] inline void store(const Lanes& a, SpinVector& y) noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    y[static_cast<Eigen::Index>(2 * i)] = a.p[i][0];
    y[static_cast<Eigen::Index>(2 * i + 1)] = a.p[i][1];
  }
}
[[gnu::always_inline]] inline Pair across(Pair a, Pair b) noexcept {
  return Pair{a[1], b[0]};
}
[[gnu::always_inline]] inline Pair swapped(Pair a) noexcept {
  return Pair{a[1], a[0]};
}
[[gnu::always_inline]] inline Pair both(double a) noexcept {
  return Pair{a, a};
}

/// A difference of attitudes as the angle it means [rad].
[[gnu::always_inline]] inline double angle_of(const Lanes& difference) noexcept {
  const Pair squares = difference.p[0] * difference.p[0] + difference.p[1] * difference.p[1];
  return 2.0 * std::sqrt(squares[0] + squares[1]);
}
/// The same with what the difference of velocities turns in a step: where the one happens to
/// vanish, the other does not.
[[gnu::always_inline]] inline double size_of(const Lanes& difference, double h_s) noexcept {
  const Pair attitude = difference.p[0] * difference.p[0] + difference.p[1] * difference.p[1];
  const Pair velocity = difference.p[2] * difference.p[2];
  const double square = (velocity[0] + velocity[1]) + difference.p[3][0] * difference.p[3][0];
  return std::sqrt(4.0 * (attitude[0] + attitude[1]) + h_s * h_s * square);
}

}  // namespace

/// The right-hand side, two components to a register.
class ExplicitRate {
 public:
  explicit ExplicitRate(const SpinRate& rate) noexcept : rate_(rate) {
    const Vec3& I = rate.body_.inertia_kg_m2;
    const Vec3& C = rate.body_.damping;
    const Vec3& tau = rate.torques_.world;
    const Vec3& inverse = rate.inverse_inertia_;
    body_ = Pair{rate.torques_.body.x(), rate.torques_.body.y()};
    xy_ = Pair{tau.x(), tau.y()};
    yz_ = Pair{tau.y(), tau.z()};
    zx_ = Pair{tau.z(), tau.x()};
    damping_ = Pair{C.x(), C.y()};
    inverse_ = Pair{inverse.x(), inverse.y()};
    gyroscopic_ = Pair{I.z() - I.y(), I.x() - I.z()};
    gyroscopic_z_ = I.y() - I.x();
  }
  [[gnu::always_inline]] Lanes operator()(const Lanes& y) const noexcept {
    const Pair wx = y.p[0];
    const Pair yz = y.p[1];
    const Pair zx = across(yz, Pair{wx[1], 0.0});
    const Pair xy = across(wx, yz);
    Pair torque = body_;
    double torque_z = rate_.torques_.body.z();
    if (rate_.world_) {  // R^T tau = tau - w s + v x s, s = 2 v x tau, for a unit quaternion
      const Pair s = both(2.0) * (yz * zx_ - zx * yz_);
      const double sz = 2.0 * (xy[0] * xy_[1] - xy[1] * xy_[0]);
      torque += (xy_ - both(wx[0]) * s) + (yz * Pair{sz, s[0]} - zx * Pair{s[1], sz});
      torque_z += (zx_[0] - wx[0] * sz) + (xy[0] * s[1] - xy[1] * s[0]);
    }
    Pair ab = y.p[2];
    double c = y.p[3][0];
    double work = 0.0;
    if (rate_.watched_) work = (torque[0] * ab[0] + torque[1] * ab[1]) + torque_z * c;
    if (rate_.spring_) {
      const double ratio = angle_ratio((xy[0] * xy[0] + xy[1] * xy[1]) + yz[1] * yz[1], wx[0]);
      if (rate_.even_spring_) {
        const double pull = rate_.body_.stiffness.x() * ratio;
        torque -= pull * xy;
        torque_z -= pull * yz[1];
      } else {
        const Vec3 spring =
            spring_torque({ratio * xy[0], ratio * xy[1], ratio * yz[1]}, rate_.body_.stiffness);
        torque += Pair{spring.x(), spring.y()};
        torque_z += spring.z();
      }
    }
    if (rate_.massless_) {
      const Vec3 w_O = rate_.settled({torque[0], torque[1], torque_z}, {ab[0], ab[1], c});
      ab = Pair{w_O.x(), w_O.y()};
      c = w_O.z();
    }
    const Pair bc{ab[1], c};
    const Pair ca{c, ab[0]};
    // (-x a - y b - z c, w a + y c - z b) / 2, (w b + z a - x c, w c + x b - y a) / 2
    return {{Pair{-0.5, 0.5} *
                 ((swapped(wx) * both(ab[0]) + both(yz[0]) * bc) + both(yz[1]) * Pair{c, -ab[1]}),
             both(0.5) * ((both(wx[0]) * bc + Pair{yz[1], wx[1]} * ab) - xy * ca),
             inverse_ * ((torque - damping_ * ab) - (gyroscopic_ * bc) * ca),
             Pair{rate_.inverse_inertia_.z() *
                      ((torque_z - rate_.body_.damping.z() * c) - gyroscopic_z_ * ab[0] * ab[1]),
                  work}}};
  }

 private:
  const SpinRate& rate_;
  Pair body_, xy_, yz_, zx_, damping_, inverse_, gyroscopic_;
  double gyroscopic_z_ = 0.0;
};

namespace {

/// Rates at the stages of a step, whose states are kept if wanted.
template <class Stages, class Rates>
[[gnu::always_inline]] inline void run(const Stages& stages, const SpinRate& rate,
                                       StageStates* seen, Rates& k) noexcept {
  const ExplicitRate f(rate);
  if (seen == nullptr)
    stages([&](std::size_t, const Lanes& at) { return f(at); }, k);
  else
    stages(
        [&](std::size_t i, const Lanes& at) {
          store(at, (*seen)[i]);
          return f(at);
        },
        k);
}

SpinStep third(const SpinRate& rate, const Lanes& y, double h_s, StageStates* seen) noexcept {
  namespace scheme = bogacki_shampine;
  std::array<Lanes, scheme::kStages> k;
  run([&](const auto& f, auto& at) { scheme::stages(y, h_s, f, at); }, rate, seen, k);
  SpinStep step;
  store(y + h_s * scheme::increment(k), step.end);
  step.error_rad = h_s * size_of(scheme::error2(k), h_s);
  return step;
}

SpinStep fifth(const SpinRate& rate, const Lanes& y, double h_s, StageStates* seen) noexcept {
  namespace scheme = cash_karp;
  std::array<Lanes, scheme::kStages> k;
  run([&](const auto& f, auto& at) { scheme::stages(y, h_s, f, at); }, rate, seen, k);
  SpinStep step;
  store(y + h_s * scheme::increment(k), step.end);
  step.error_rad = h_s * size_of(scheme::error4(k), h_s);
  // The second difference of the rates, at 0, 0.3, 0.6.
  step.coarser_rad = h_s * size_of(1.2 * (k[0] - 2.0 * k[2] + k[3]), h_s);
  return step;
}

/// Hairer's combination of the errors of the embedded formulas.
double combined(double h_s, double error5, double error3) noexcept {
  const double both = error5 * error5 + 0.01 * error3 * error3;
  return both == 0.0 ? 0.0 : h_s * error5 * error5 / std::sqrt(both);
}

SpinStep eighth(const SpinRate& rate, const Lanes& y, double h_s, StageStates* seen) noexcept {
  namespace scheme = dormand_prince;
  std::array<Lanes, 12> k;
  run([&](const auto& f, auto& at) { scheme::stages(y, h_s, f, at); }, rate, seen, k);
  SpinStep step;
  store(y + h_s * scheme::increment(k), step.end);
  const Lanes error5 = scheme::error5(k);
  const Lanes error3 = scheme::error3(k);
  step.error_rad = std::max(combined(h_s, angle_of(error5), angle_of(error3)),
                            0.5 * combined(h_s, size_of(error5, h_s), size_of(error3, h_s)));
  if (rate.watched())  // the fourth difference of the rates, at 0, 1/4, 3/5, 6/7, 1
    step.coarser_rad = h_s * size_of(0.07777777777777778 * k[0] - 0.25098039215686274 * k[6] +
                                         0.46296296296296297 * k[9] - 0.5230936819172113 * k[10] +
                                         0.23333333333333334 * k[11],
                                     h_s);
  return step;
}

}  // namespace

int evaluations(Order order) noexcept {
  constexpr int kEvaluations[] = {3, 6, 12};
  return kEvaluations[static_cast<std::size_t>(order)];
}

double stable_rad(Order order) noexcept {
  constexpr double kStable_rad[] = {1.7, 2.0, 5.0};
  return kStable_rad[static_cast<std::size_t>(order)];
}

double estimate_factor(Order order) noexcept {
  constexpr double kFactor[] = {2.0, 8.0, 32.0};
  return kFactor[static_cast<std::size_t>(order)];
}

double typical_error_rad(Order order, double turn_rad) noexcept {
  // The estimates for a swing of one radian, to lowest order in the turn.
  switch (order) {
    case Order::third: return std::pow(turn_rad, 3) / 12.0;
    case Order::fifth: return std::pow(turn_rad, 5) / 2000.0;
    case Order::eighth: break;
  }
  return std::pow(turn_rad, 8) / 2e6;
}

SpinStep explicit_step(Order order, const SpinRate& rate, const SpinVector& start, double h_s,
                       StageStates* seen) noexcept {
  const Lanes y = lanes_of(start);
  switch (order) {
    case Order::third: return third(rate, y, h_s, seen);
    case Order::fifth: return fifth(rate, y, h_s, seen);
    case Order::eighth: break;
  }
  return eighth(rate, y, h_s, seen);
}

}  // namespace isograsp::so3
