// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of most scenes: three fingers, every free axis moves independently, no travel ends, no
// torsion. From finger forces to pose in straight code, so that the processor can overlap frames;
// three free rotations get their torque here and turn in plan_turn.cpp. Gives the same bits as
// step_any, which serves all other scenes.
#include "grasp_model/plan.hpp"

namespace isograsp {

template <int linear, Plan::Rotations turning>
void Plan::step_lanes(const Plan& plan, const FingerWrenches& wrench_C,
                      ObjectState& state) noexcept {
  constexpr bool kTurns = turning == Rotations::one_axis;
  constexpr bool kFree = turning == Rotations::three;
  constexpr int kLanes = linear + (kTurns ? 1 : 0);
  constexpr int kPairs = (linear + (kFree ? 3 : kTurns ? 1 : 0) + 1) / 2;
  using Pair = PlanLanes::Pair;
  Pair sum0{};
  [[maybe_unused]] Pair sum1{};
  [[maybe_unused]] Pair sum2{};
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
      if constexpr (kPairs >= 2)
        sum1 += (columns[0][1] * force.fx + columns[1][1] * force.fy) + columns[2][1] * force.fz;
      if constexpr (kPairs == 3)
        sum2 += (columns[0][2] * force.fx + columns[1][2] * force.fy) + columns[2][2] * force.fz;
    } else {
      if (!usable(contact.limit, measured)) return plan.step_any(wrench_C, state);
      on = false;
    }
  }
  if (!plan.acts_[mask]) sum0 = sum1 = sum2 = Pair{};

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
    if constexpr (kTurns && kLanes - 1 >= kFirst) angle_rad = to[(kLanes - 1) % 2];
    x(kFirst) = to[0];
    v(kFirst) = speed_to[0];
    if constexpr (kBoth) {
      x(kFirst + 1) = to[1];
      v(kFirst + 1) = speed_to[1];
    }
  };
  if constexpr (kLanes > 0) advance(std::integral_constant<int, 0>{}, sum0);
  if constexpr (kLanes > 2) advance(std::integral_constant<int, 1>{}, sum1);
  if constexpr (kTurns) plan.set_attitude(angle_rad, state);
  if constexpr (kFree) {
    const double rows[] = {sum0[0], sum0[1], sum1[0], sum1[1], sum2[0], sum2[1]};
    plan.turn_freely(plan.hold_s_,
                     {Vec3::Zero(), Vec3(rows[linear], rows[linear + 1], rows[linear + 2])}, state);
  }
}

void Plan::compile_lanes() {
  bool limited = false;
  for (const bool limit : limited_) limited = limited || limit;
  if (contacts_ != kFingerCount || limited || torsion_ || coupled_ || force_follows_) return;
  const auto put = [](auto& lanes, std::size_t lane, double value) {
    PlanLanes::put(lanes, lane, value);
  };
  for (std::size_t lane = 0; lane < row_count_; ++lane) {
    for (std::size_t i = 0; i < contacts_; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        put(lanes_.columns[i][c], lane,
            pressing_[i].moving(static_cast<Eigen::Index>(lane), static_cast<Eigen::Index>(c)));
    const bool linear = lane < axis_count_;
    if (!linear && rotations_ == Rotations::three) continue;
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
  }
  constexpr auto kNone = Rotations::none;
  constexpr auto kAxis = Rotations::one_axis;
  constexpr auto kThree = Rotations::three;
  constexpr decltype(lanes_.step) kKernels[4][3] = {
      {nullptr, &step_lanes<0, kAxis>, &step_lanes<0, kThree>},
      {&step_lanes<1, kNone>, &step_lanes<1, kAxis>, &step_lanes<1, kThree>},
      {&step_lanes<2, kNone>, &step_lanes<2, kAxis>, &step_lanes<2, kThree>},
      {&step_lanes<3, kNone>, &step_lanes<3, kAxis>, &step_lanes<3, kThree>}};
  lanes_.step = kKernels[axis_count_][static_cast<std::size_t>(rotations_)];
}

}  // namespace isograsp
