// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit steps. I w' = tau - C w - spring(q) - w x I w,  q' = q (0, w) / 2, w in body axes.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "grasp_model/angle_ratio.hpp"
#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/low_orders.hpp"
#include "grasp_model/rotation.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp::so3 {

namespace {

using Four = double __attribute__((vector_size(32)));

/// A SpinVector in registers: (qw qx qy qz)(wx wy wz work). Everything on it is inlined into the
/// functions at the end, which exist for processors with and without registers of this width. No
/// product is fused with a sum, so both give the same bits.
struct Lanes {
  using Scalar = double;
  Four q, w;
};
[[gnu::always_inline]] inline Lanes operator+(const Lanes& a, const Lanes& b) noexcept {
  return {a.q + b.q, a.w + b.w};
}
[[gnu::always_inline]] inline Lanes operator-(const Lanes& a, const Lanes& b) noexcept {
  return {a.q - b.q, a.w - b.w};
}
[[gnu::always_inline]] inline Lanes operator*(double c, const Lanes& a) noexcept {
  return {c * a.q, c * a.w};
}

/// A difference of attitudes as the angle it means [rad].
[[gnu::always_inline]] inline double turn_of(const Lanes& difference) noexcept {
  const Four squares = difference.q * difference.q;
  return 2.0 * std::sqrt((squares[0] + squares[2]) + (squares[1] + squares[3]));
}
/// The same with what the difference of velocities turns in a step: where the one happens to
/// vanish, the other does not.
[[gnu::always_inline]] inline double size_of(const Lanes& difference, double h_s) noexcept {
  const Four q = difference.q * difference.q;
  const Four w = difference.w * difference.w;
  return std::sqrt(4.0 * ((q[0] + q[2]) + (q[1] + q[3])) + h_s * h_s * ((w[0] + w[1]) + w[2]));
}

}  // namespace

/// The right-hand side in registers.
class ExplicitRate {
 public:
  [[gnu::always_inline]] explicit ExplicitRate(const SpinRate& rate) noexcept : rate_(rate) {
    const Vec3& I = rate.body_.inertia_kg_m2;
    const Vec3& C = rate.body_.damping;
    const Vec3& tau = rate.torques_.world;
    const Vec3& body = rate.torques_.body;
    const Vec3& inverse = rate.inverse_inertia_;
    body_ = Four{body.x(), body.y(), body.z(), 0.0};
    xyz_ = Four{tau.x(), tau.y(), tau.z(), 0.0};
    yzx_ = Four{tau.y(), tau.z(), tau.x(), 0.0};
    zxy_ = Four{tau.z(), tau.x(), tau.y(), 0.0};
    damping_ = Four{C.x(), C.y(), C.z(), 0.0};
    inverse_ = Four{inverse.x(), inverse.y(), inverse.z(), 0.0};
    gyroscopic_ = Four{I.z() - I.y(), I.x() - I.z(), I.y() - I.x(), 0.0};
  }
  [[gnu::always_inline]] inline Lanes operator()(const Lanes& y) const noexcept {
    const Four q = y.q;
    const Four v = __builtin_shufflevector(q, q, 1, 2, 3, 0);
    Four torque = body_;
    if (rate_.world_) {  // R^T tau = tau - w s + v x s, s = 2 v x tau, for a unit quaternion
      const Four v_yzx = __builtin_shufflevector(q, q, 2, 3, 1, 0);
      const Four v_zxy = __builtin_shufflevector(q, q, 3, 1, 2, 0);
      const Four s = 2.0 * (v_yzx * zxy_ - v_zxy * yzx_);
      torque += (xyz_ - q[0] * s) + (v_yzx * __builtin_shufflevector(s, s, 2, 0, 1, 3) -
                                     v_zxy * __builtin_shufflevector(s, s, 1, 2, 0, 3));
    }
    Four w = y.w;
    double work = 0.0;
    if (rate_.watched_) {
      const Four powers = torque * w;
      work = (powers[0] + powers[1]) + powers[2];
    }
    if (rate_.spring_) {
      const Four squares = q * q;
      const double ratio = angle_ratio((squares[1] + squares[2]) + squares[3], q[0]);
      if (rate_.even_spring_) {
        torque -= (rate_.body_.stiffness.x() * ratio) * v;
      } else {
        const Vec3 spring =
            spring_torque({ratio * v[0], ratio * v[1], ratio * v[2]}, rate_.body_.stiffness);
        torque += Four{spring.x(), spring.y(), spring.z(), 0.0};
      }
    }
    if (rate_.massless_) {
      const Vec3 settled = rate_.settled({torque[0], torque[1], torque[2]}, {w[0], w[1], w[2]});
      w = Four{settled.x(), settled.y(), settled.z(), 0.0};
    }
    const Four w_yzx = __builtin_shufflevector(w, w, 1, 2, 0, 3);
    const Four w_zxy = __builtin_shufflevector(w, w, 2, 0, 1, 3);
    // (-x a - y b - z c, w a + y c - z b, w b + z a - x c, w c + x b - y a) / 2, w = (a, b, c)
    Lanes k{};
    k.q = Four{-0.5, 0.5, 0.5, 0.5} *
          ((__builtin_shufflevector(q, q, 1, 0, 0, 0) * __builtin_shufflevector(w, w, 0, 0, 1, 2) +
            __builtin_shufflevector(q, q, 2, 2, 3, 1) * __builtin_shufflevector(w, w, 1, 2, 0, 1)) +
           __builtin_shufflevector(q, q, 3, 3, 1, 2) *
               (Four{1.0, -1.0, -1.0, -1.0} * __builtin_shufflevector(w, w, 2, 1, 2, 0)));
    k.w = inverse_ * ((torque - damping_ * w) - (gyroscopic_ * w_yzx) * w_zxy);
    k.w[3] = work;
    return k;
  }

 private:
  const SpinRate& rate_;
  Four body_, xyz_, yzx_, zxy_, damping_, inverse_, gyroscopic_;
};

namespace {

template <Order order>
[[gnu::always_inline]] inline void step_of(const SpinRate& rate, const SpinVector& start,
                                           double h_s, StageStates* seen, SpinStep& step) noexcept {
  const ExplicitRate rates(rate);
  const auto f = [&](std::size_t i, const Lanes& at) __attribute__((always_inline)) {
    if (seen != nullptr) std::memcpy((*seen)[i].data(), &at, sizeof at);
    return rates(at);
  };
  Lanes y;
  std::memcpy(&y, start.data(), sizeof y);
  Lanes end;
  if constexpr (order == Order::third) {
    namespace scheme = bogacki_shampine;
    std::array<Lanes, scheme::kStages> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    step.error_rad = h_s * size_of(scheme::error2(k), h_s);
  } else if constexpr (order == Order::fifth) {
    namespace scheme = cash_karp;
    std::array<Lanes, scheme::kStages> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    step.error_rad = h_s * size_of(scheme::error4(k), h_s);
    step.coarser_rad = h_s * size_of(scheme::coarser(k), h_s);
  } else {
    namespace scheme = dormand_prince;
    std::array<Lanes, 12> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    const Lanes error5 = scheme::error5(k);
    const Lanes error3 = scheme::error3(k);
    step.error_rad = scheme::estimate(h_s, turn_of(error5), turn_of(error3), size_of(error5, h_s),
                                      size_of(error3, h_s));
    if (rate.watched()) step.coarser_rad = h_s * size_of(scheme::coarser(k), h_s);
  }
  std::memcpy(step.end.data(), &end, sizeof end);
}

using StepOf = void(const SpinRate&, const SpinVector&, double, StageStates*, SpinStep&) noexcept;

template <Order order>
void narrow(const SpinRate& rate, const SpinVector& start, double h_s, StageStates* seen,
            SpinStep& step) noexcept {
  step_of<order>(rate, start, h_s, seen, step);
}
#if defined(__x86_64__)
template <Order order>
[[gnu::target("avx2")]] void wide(const SpinRate& rate, const SpinVector& start, double h_s,
                                  StageStates* seen, SpinStep& step) noexcept {
  step_of<order>(rate, start, h_s, seen, step);
}
#endif

using Steps = std::array<StepOf*, 3>;
constexpr Steps kNarrow{&narrow<Order::third>, &narrow<Order::fifth>, &narrow<Order::eighth>};

/// Those of this processor.
const Steps& steps() noexcept {
#if defined(__x86_64__)
  static constexpr Steps kWide{&wide<Order::third>, &wide<Order::fifth>, &wide<Order::eighth>};
  static const bool has_wide = __builtin_cpu_supports("avx2") != 0;
  if (has_wide) return kWide;
#endif
  return kNarrow;
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
  SpinStep step;
  steps()[static_cast<std::size_t>(order)](rate, start, h_s, seen, step);
  return step;
}

SpinStep explicit_step_narrow(Order order, const SpinRate& rate, const SpinVector& start,
                              double h_s) noexcept {
  SpinStep step;
  kNarrow[static_cast<std::size_t>(order)](rate, start, h_s, nullptr, step);
  return step;
}

}  // namespace isograsp::so3
