// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of most scenes: three fingers, every free axis moves independently, no travel ends, no
// torsion. From finger forces to pose in straight code, so that the processor can overlap frames.
// Gives the same bits as step_any, which serves all other scenes.
#include "grasp_model/plan.hpp"

namespace isograsp {

template <int linear, bool turns>
void Plan::step_lanes(const Plan& plan, const FingerWrenches& wrench_C,
                      ObjectState& state) noexcept {
  constexpr int kLanes = linear + (turns ? 1 : 0);
  constexpr int kPairs = (kLanes + 1) / 2;
  using Pair = PlanLanes::Pair;
  Pair sum0{};
  [[maybe_unused]] Pair sum1{};
  unsigned mask = 0;
#pragma GCC unroll 3
  for (std::size_t i = 0; i < kFingerCount; ++i) {
    const Pressing& contact = plan.pressing_[i];
    const Wrench& measured = wrench_C[i];
    bool& on = state.contact[i];
    if (contact.rule.touches(on, measured.force.z())) {
      ContactForce force;
      if (!clamp_without_torsion(contact.limit, measured, force))
        return plan.step_any(wrench_C, state);
      on = true;
      mask |= 1u << i;
      const auto& columns = plan.lanes_.columns[i];
      sum0 += (columns[0][0] * force.fx + columns[1][0] * force.fy) + columns[2][0] * force.fz;
      if constexpr (kPairs == 2)
        sum1 += (columns[0][1] * force.fx + columns[1][1] * force.fy) + columns[2][1] * force.fz;
    } else {
      if (!usable(contact.limit, measured)) return plan.step_any(wrench_C, state);
      on = false;
    }
  }
  if (!plan.acts_[mask]) sum0 = sum1 = Pair{};

  // Position and velocity of a lane.
  Vec3& p_WO = state.X_WO.p;
  Vec3& v_WO_W = state.v_WO_W;
  const auto x = [&](int lane) -> double& {
    return lane < linear ? p_WO[plan.axes_[static_cast<std::size_t>(lane)]] : state.angle_rad;
  };
  const auto v = [&](int lane) -> double& {
    return lane < linear ? v_WO_W[plan.axes_[static_cast<std::size_t>(lane)]]
                         : state.w_WO_W[plan.axis_];
  };
  double angle_rad = 0.0;  // kept in a register on its way to the attitude
  const auto advance = [&]<int pair>(std::integral_constant<int, pair>, const Pair& sum) {
    constexpr int kFirst = 2 * pair;
    constexpr bool kBoth = kFirst + 1 < kLanes;
    constexpr auto p = static_cast<std::size_t>(pair);
    const PlanLanes& a = plan.lanes_;
    const Pair force = sum + a.weight[p];
    const Pair at = Pair{x(kFirst), kBoth ? x(kFirst + 1) : 0.0} - a.anchor[p];
    const Pair speed{v(kFirst), kBoth ? v(kFirst + 1) : 0.0};
    const Pair pushed = a.force_share[p] * force;
    const Pair off = pushed - a.position_share[p] * at;
    const Pair base = a.about_rest[p] != 0.0 ? pushed : at;
    const Pair to = a.anchor[p] + (base + (a.x_of_v[p] * speed + a.x_of_off[p] * off));
    const Pair speed_to = a.v_of_v[p] * speed + a.v_of_off[p] * off;
    if constexpr (turns && kLanes - 1 >= kFirst) angle_rad = to[(kLanes - 1) % 2];
    x(kFirst) = to[0];
    v(kFirst) = speed_to[0];
    if constexpr (kBoth) {
      x(kFirst + 1) = to[1];
      v(kFirst + 1) = speed_to[1];
    }
  };
  advance(std::integral_constant<int, 0>{}, sum0);
  if constexpr (kPairs == 2) advance(std::integral_constant<int, 1>{}, sum1);
  if constexpr (turns) plan.set_attitude(angle_rad, state);
}

void Plan::compile_lanes() {
  bool limited = false;
  for (const bool limit : limited_) limited = limited || limit;
  if (contacts_ != kFingerCount || limited || torsion_ || coupled_ || force_follows_ ||
      rotations_ == Rotations::three)
    return;
  const bool turns = rotations_ == Rotations::one_axis;
  constexpr auto put = &PlanLanes::put;
  for (std::size_t lane = 0; lane < row_count_; ++lane) {
    const bool linear = lane < axis_count_;
    const auto axis = linear ? axes_[lane] : axis_;
    const LinearStep& step = linear ? steps_.linear[static_cast<std::size_t>(axis)] : steps_.turn;
    put(lanes_.weight, lane, linear ? weight_W_[axis] : 0.0);
    put(lanes_.anchor, lane, linear ? anchor_m_[axis] : 0.0);
    put(lanes_.force_share, lane, step.force_share);
    put(lanes_.position_share, lane, step.position_share);
    put(lanes_.x_of_v, lane, step.x_of_v);
    put(lanes_.x_of_off, lane, step.x_of_off);
    put(lanes_.v_of_v, lane, step.v_of_v);
    put(lanes_.v_of_off, lane, step.v_of_off);
    put(lanes_.about_rest, lane, step.about_rest ? 1.0 : 0.0);
    for (std::size_t i = 0; i < contacts_; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        put(lanes_.columns[i][c], lane,
            pressing_[i].moving(static_cast<Eigen::Index>(lane), static_cast<Eigen::Index>(c)));
  }
  constexpr decltype(lanes_.step) kKernels[4][2] = {{nullptr, &step_lanes<0, true>},
                                                    {&step_lanes<1, false>, &step_lanes<1, true>},
                                                    {&step_lanes<2, false>, &step_lanes<2, true>},
                                                    {&step_lanes<3, false>, &step_lanes<3, true>}};
  lanes_.step = kKernels[axis_count_][turns ? 1 : 0];
}

}  // namespace isograsp
