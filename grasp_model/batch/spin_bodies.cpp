// SPDX-License-Identifier: GPL-3.0-or-later
// I w' = tau - C w - spring(q) - w x I w,  q' = q (0, w) / 2, w in body axes, for four bodies:
// every sum in the order in which spin_explicit.cpp makes it.
#include "grasp_model/batch/spin_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "grasp_model/angle_ratio.hpp"
#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/low_orders.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp::so3 {

namespace {

using B = Four;

struct NoWork {};
/// Attitude and velocity; the work where `works`.
template <bool works>
struct Spins {
  using Scalar = B;
  B q0, qx, qy, qz, wx, wy, wz;
  [[no_unique_address]] std::conditional_t<works, B, NoWork> work{};
};
template <bool works>
[[gnu::always_inline]] inline Spins<works> operator+(const Spins<works>& a,
                                                     const Spins<works>& b) noexcept {
  Spins<works> c{a.q0 + b.q0, a.qx + b.qx, a.qy + b.qy, a.qz + b.qz,
                 a.wx + b.wx, a.wy + b.wy, a.wz + b.wz};
  if constexpr (works) c.work = a.work + b.work;
  return c;
}
template <bool works>
[[gnu::always_inline]] inline Spins<works> operator-(const Spins<works>& a,
                                                     const Spins<works>& b) noexcept {
  Spins<works> c{a.q0 - b.q0, a.qx - b.qx, a.qy - b.qy, a.qz - b.qz,
                 a.wx - b.wx, a.wy - b.wy, a.wz - b.wz};
  if constexpr (works) c.work = a.work - b.work;
  return c;
}
template <class Factor, bool works>
[[gnu::always_inline]] inline Spins<works> operator*(const Factor& f,
                                                     const Spins<works>& a) noexcept {
  Spins<works> c{f * a.q0, f * a.qx, f * a.qy, f * a.qz, f * a.wx, f * a.wy, f * a.wz};
  if constexpr (works) c.work = f * a.work;
  return c;
}

template <bool works>
[[gnu::always_inline]] inline B turn_squared(const Spins<works>& d) noexcept {
  return (d.q0 * d.q0 + d.qy * d.qy) + (d.qx * d.qx + d.qz * d.qz);
}
template <bool works>
[[gnu::always_inline]] inline B angles_of(const Spins<works>& d) noexcept {
  return 2.0 * roots(turn_squared(d));
}
template <bool works>
[[gnu::always_inline]] inline B sizes_of(const Spins<works>& d, const B& h_s) noexcept {
  return roots(4.0 * turn_squared(d) + h_s * h_s * ((d.wx * d.wx + d.wy * d.wy) + d.wz * d.wz));
}

/// The right-hand side.
template <bool works>
[[gnu::always_inline]] inline Spins<works> rate_of(const BodyRates& r, const BodyTorques& t,
                                                   const Spins<works>& y) noexcept {
  const B &w = y.q0, &x = y.qx, &p = y.qy, &z = y.qz;
  B tx = t.body[0], ty = t.body[1], tz = t.body[2];
  if (in_some_lane(
          t.has_world)) {  // R^T tau = tau - w s + v x s, s = 2 v x tau, for a unit quaternion
    const B sx = 2.0 * (p * t.world[2] - z * t.world[1]);
    const B sy = 2.0 * (z * t.world[0] - x * t.world[2]);
    const B sz = 2.0 * (x * t.world[1] - p * t.world[0]);
    const B ax = tx + ((t.world[0] - w * sx) + (p * sz - z * sy));
    const B ay = ty + ((t.world[1] - w * sy) + (z * sx - x * sz));
    const B az = tz + ((t.world[2] - w * sz) + (x * sy - p * sx));
    tx = t.has_world ? ax : tx;
    ty = t.has_world ? ay : ty;
    tz = t.has_world ? az : tz;
  }
  Spins<works> k;
  if constexpr (works) {
    const B work = (tx * y.wx + ty * y.wy) + tz * y.wz;
    k.work = only(t.watched, work);
  }
  if (r.spring) {
    const B ratio = angle_ratios((x * x + p * p) + z * z, w);
    if (r.even_spring) {
      const B stiff = r.even_stiffness * ratio;
      tx -= stiff * x;
      ty -= stiff * p;
      tz -= stiff * z;
    } else {
      for (std::size_t i = 0; i < kLaneCount; ++i) {
        const Vec3 spring =
            spring_torque({ratio[i] * x[i], ratio[i] * p[i], ratio[i] * z[i]}, r.stiffness[i]);
        tx[i] += spring.x();
        ty[i] += spring.y();
        tz[i] += spring.z();
      }
    }
  }
  const B &a = y.wx, &b = y.wy, &c = y.wz;
  k.q0 = -0.5 * ((x * a + p * b) + z * c);
  k.qx = 0.5 * ((w * a + p * c) - z * b);
  k.qy = 0.5 * ((w * b + z * a) - x * c);
  k.qz = 0.5 * ((w * c + x * b) - p * a);
  k.wx = r.inverse_inertia[0] * ((tx - r.damping[0] * a) - (r.gyroscopic[0] * b) * c);
  k.wy = r.inverse_inertia[1] * ((ty - r.damping[1] * b) - (r.gyroscopic[1] * c) * a);
  k.wz = r.inverse_inertia[2] * ((tz - r.damping[2] * c) - (r.gyroscopic[2] * a) * b);
  return k;
}

// The right-hand side by itself: twelve copies of it would not fit where the processor keeps what
// it has decoded.
template <bool works>
[[gnu::noinline]] void narrow_rate(const BodyRates& r, const BodyTorques& t, const Spins<works>& y,
                                   Spins<works>& k) noexcept {
  k = rate_of(r, t, y);
}
#if defined(__x86_64__)
template <bool works>
[[gnu::noinline, gnu::target("avx2")]] void wide_rate(const BodyRates& r, const BodyTorques& t,
                                                      const Spins<works>& y,
                                                      Spins<works>& k) noexcept {
  k = rate_of(r, t, y);
}
#endif
template <bool works>
using RateOf = void(const BodyRates&, const BodyTorques&, const Spins<works>&,
                    Spins<works>&) noexcept;

template <Order order, bool works, RateOf<works>& rate>
[[gnu::always_inline]] inline void steps_of(const BodyRates& r, const BodyTorques& t,
                                            const BodySpins& start, const B& h_s,
                                            BodySteps& out) noexcept {
  using State = Spins<works>;
  const auto f = [&](std::size_t, const State& at) __attribute__((always_inline)) {
    State k;
    rate(r, t, at, k);
    return k;
  };
  State y{start[0], start[1], start[2], start[3], start[4], start[5], start[6]};
  if constexpr (works) y.work = start[7];
  State end;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  B coarser{kNone, kNone, kNone, kNone};
  if constexpr (order == Order::third) {
    namespace scheme = bogacki_shampine;
    std::array<State, scheme::kStages> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    out.error_rad = h_s * sizes_of(scheme::error2(k), h_s);
  } else if constexpr (order == Order::fifth) {
    namespace scheme = cash_karp;
    std::array<State, scheme::kStages> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    out.error_rad = h_s * sizes_of(scheme::error4(k), h_s);
    coarser = h_s * sizes_of(scheme::coarser(k), h_s);
  } else {
    namespace scheme = dormand_prince;
    std::array<State, 12> k;
    scheme::stages(y, h_s, f, k);
    end = y + h_s * scheme::increment(k);
    const State error5 = scheme::error5(k);
    const State error3 = scheme::error3(k);
    const B angle5 = angles_of(error5), angle3 = angles_of(error3);
    const B size5 = sizes_of(error5, h_s), size3 = sizes_of(error3, h_s);
    for (std::size_t i = 0; i < kLaneCount; ++i)
      out.error_rad[i] = scheme::estimate(h_s[i], angle5[i], angle3[i], size5[i], size3[i]);
    if constexpr (works) {
      const B size = h_s * sizes_of(scheme::coarser(k), h_s);
      coarser = t.watched ? size : coarser;
    }
  }
  out.coarser_rad = coarser;
  out.end = {end.q0, end.qx, end.qy, end.qz, end.wx, end.wy, end.wz, start[7]};
  if constexpr (works) out.end[7] = end.work;
}

using StepsOf = void(const BodyRates&, const BodyTorques&, const BodySpins&, const B&,
                     BodySteps&) noexcept;

using BodyStepTable = std::array<std::array<StepsOf*, 2>, 3>;

template <Order order, bool works>
void narrow_steps(const BodyRates& r, const BodyTorques& t, const BodySpins& start, const B& h_s,
                  BodySteps& out) noexcept {
  steps_of<order, works, narrow_rate<works>>(r, t, start, h_s, out);
}
constexpr BodyStepTable kNarrowSteps{
    {{&narrow_steps<Order::third, false>, &narrow_steps<Order::third, true>},
     {&narrow_steps<Order::fifth, false>, &narrow_steps<Order::fifth, true>},
     {&narrow_steps<Order::eighth, false>, &narrow_steps<Order::eighth, true>}}};
#if defined(__x86_64__)
template <Order order, bool works>
[[gnu::target("avx2")]] void wide_steps(const BodyRates& r, const BodyTorques& t,
                                        const BodySpins& start, const B& h_s,
                                        BodySteps& out) noexcept {
  steps_of<order, works, wide_rate<works>>(r, t, start, h_s, out);
}
constexpr BodyStepTable kWideSteps{
    {{&wide_steps<Order::third, false>, &wide_steps<Order::third, true>},
     {&wide_steps<Order::fifth, false>, &wide_steps<Order::fifth, true>},
     {&wide_steps<Order::eighth, false>, &wide_steps<Order::eighth, true>}}};
#else
constexpr const BodyStepTable& kWideSteps = kNarrowSteps;
#endif

}  // namespace

void explicit_steps(Order order, const BodyRates& rates, const BodyTorques& torques,
                    const BodySpins& start, const Four& h_s, BodySteps& out, bool narrow) noexcept {
  const BodyStepTable& steps = narrow ? kNarrowSteps : kWideSteps;
  steps[static_cast<std::size_t>(order)][in_some_lane(torques.watched) ? 1 : 0](rates, torques,
                                                                                start, h_s, out);
}

}  // namespace isograsp::so3
