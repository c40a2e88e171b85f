// SPDX-License-Identifier: GPL-3.0-or-later
// Which states go side by side, and what their plans have in common.
#include "grasp_model/batch/batch.hpp"

#include <algorithm>
#include <utility>

#include "grasp_model/batch/batch_block.hpp"

namespace isograsp {

Batch::Batch(const Plan& plan, std::size_t count) : Batch(std::vector<const Plan*>(count, &plan)) {}

Batch::Batch(std::vector<const Plan*> plans) : plans_(std::move(plans)) {
  for (std::size_t first = 0; first < size(); first += kLaneCount) {
    BatchTerms::Plans of{};
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      of[lane] = plans_[std::min(first + lane, size() - 1)];
    const auto same = std::find_if(terms_.begin(), terms_.end(),
                                   [&](const BatchTerms& terms) { return terms.plans == of; });
    BatchBlock& block = blocks_.emplace_back();
    block.terms = static_cast<std::size_t>(same - terms_.begin());
    if (same == terms_.end()) terms_.emplace_back(of);
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      block.set(lane, of[lane]->initial_state());
  }
}

Batch::~Batch() = default;
Batch::Batch(Batch&& other) noexcept = default;
Batch& Batch::operator=(Batch&& other) noexcept = default;

ObjectState Batch::state(std::size_t i) const noexcept {
  return blocks_[i / kLaneCount].get(i % kLaneCount);
}

void Batch::set_state(std::size_t i, const ObjectState& state) noexcept {
  BatchBlock& block = blocks_[i / kLaneCount];
  block.set(i % kLaneCount, state);
  if (i + 1 == size())
    for (std::size_t lane = size() % kLaneCount; lane % kLaneCount != 0; ++lane)
      block.set(lane, state);
}

void Batch::step(std::span<const FingerWrenches> wrench_C, bool narrow) noexcept {
  std::size_t row = 0;
  for (BatchBlock& block : blocks_) {
    BatchTerms::Rows rows;
    for (const FingerWrenches*& one : rows) one = &wrench_C[std::min(row++, size() - 1)];
    step_block(terms_[block.terms], rows, block, narrow);
  }
}

ObjectState BatchBlock::get(std::size_t lane) const noexcept {
  ObjectState state;
  state.X_WO.q = Quat(q[0][lane], q[1][lane], q[2][lane], q[3][lane]);
  state.X_WO.p = Vec3(p[0][lane], p[1][lane], p[2][lane]);
  state.v_WO_W = Vec3(v[0][lane], v[1][lane], v[2][lane]);
  state.w_WO_W = Vec3(w[0][lane], w[1][lane], w[2][lane]);
  for (std::size_t f = 0; f < kFingerCount; ++f) state.contact[f] = contact[f][lane] != 0;
  state.angle_rad = angle[lane];
  state.error_rad = error_rad[lane];
  state.level = level[lane];
  state.tolerance_exceeded = exceeded[lane];
  return state;
}

void BatchBlock::set(std::size_t lane, const ObjectState& state) noexcept {
  q[0][lane] = state.X_WO.q.w();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    q[i + 1][lane] = state.X_WO.q.vec()[at];
    p[i][lane] = state.X_WO.p[at];
    v[i][lane] = state.v_WO_W[at];
    w[i][lane] = state.w_WO_W[at];
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) contact[f][lane] = state.contact[f] ? -1 : 0;
  angle[lane] = state.angle_rad;
  error_rad[lane] = state.error_rad;
  level[lane] = state.level;
  exceeded[lane] = state.tolerance_exceeded;
}

bool BatchTerms::stands_alone(const Plan& plan) noexcept {
  return plan.lanes_.step == nullptr || plan.body().inertia_kg_m2.minCoeff() == 0.0;
}

bool BatchTerms::alike(const Plan& a, const Plan& b) noexcept {
  const auto even = [](const Vec3& k) { return k.x() == k.y() && k.y() == k.z(); };
  return a.rotations_ == b.rotations_ && a.axis_count_ == b.axis_count_ && a.axes_ == b.axes_ &&
         (a.rotations_ != Plan::Rotations::one_axis || a.axis_ == b.axis_) &&
         a.rate_.spring() == b.rate_.spring() &&
         even(a.body().stiffness) == even(b.body().stiffness);
}

BatchTerms::BatchTerms(const Plans& of) : plans(of) {
  for (const Plan* plan : plans)
    if (stands_alone(*plan) || !alike(*plan, *plans[0])) return;
  side_by_side = true;
  const Plan& first = *plans[0];
  const std::size_t translations = first.axis_count_;
  for (std::size_t i = 0; i < translations; ++i) axes[i] = static_cast<std::size_t>(first.axes_[i]);
  const bool turns = first.rotations_ == Plan::Rotations::one_axis;
  turn_axis = static_cast<std::size_t>(first.axis_);
  spins = first.rotations_ == Plan::Rotations::three;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    take_fingers(*plans[lane], lane);
    take_axes(*plans[lane], lane, translations + (turns ? 1 : 0));
    if (spins) take_rates(*plans[lane], lane);
  }
  choose_press(translations, first.rotations_);
}

void BatchTerms::take_fingers(const Plan& plan, std::size_t lane) {
  for (unsigned set = 0; set < 8; ++set) acts[lane][set] = plan.acts(set);
  for (int place = 0; place < 4; ++place) {
    const std::size_t f = PlanLanes::kFingerOfLane[static_cast<std::size_t>(place)];
    friction[f][lane] = plan.lanes_.friction[place];
    touches_above[f][lane] = plan.lanes_.touches_above[place];
    stays_above[f][lane] = plan.lanes_.stays_above[place];
    presses_above[f][lane] = plan.lanes_.presses_above[place];
    for (std::size_t r = 0; r < plan.row_count_; ++r)
      for (std::size_t c = 0; c < 3; ++c) columns[r][f][c][lane] = plan.lanes_.columns[r][c][place];
  }
}

void BatchTerms::take_axes(const Plan& plan, std::size_t lane, std::size_t count) {
  const PlanLanes& lanes = plan.lanes_;
  branch[lane] = plan.branch_;
  for (std::size_t a = 0; a < count; ++a) {
    const int place = static_cast<int>(a);
    weight[a][lane] = lanes.weight[place];
    anchor[a][lane] = lanes.anchor[place];
    force_share[a][lane] = lanes.force_share[place];
    position_share[a][lane] = lanes.position_share[place];
    x_of_v[a][lane] = lanes.x_of_v[place];
    x_of_off[a][lane] = lanes.x_of_off[place];
    v_of_v[a][lane] = lanes.v_of_v[place];
    v_of_off[a][lane] = lanes.v_of_off[place];
    about_rest[a][lane] = lanes.about_rest[place];
  }
  some_about_rest = some_about_rest || lanes.some_about_rest;
}

void BatchTerms::take_rates(const Plan& plan, std::size_t lane) {
  rate[lane] = plan.rate_;
  turn_terms[lane] = plan.turn_terms(plan.hold_s_);
  const so3::Body& body = plan.body();
  const Vec3& I = body.inertia_kg_m2;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    rates.inertia[i][lane] = I[at];
    rates.inverse_inertia[i][lane] = 1.0 / I[at];
    rates.damping[i][lane] = body.damping[at];
    rates.stiffness_about[i][lane] = body.stiffness[at];
    rates.gyroscopic[i][lane] = I[(at + 2) % 3] - I[(at + 1) % 3];
  }
  const FreeTurn::Terms& terms = turn_terms[lane];
  hold_s[lane] = terms.hold_s;
  tolerance_rad[lane] = terms.tolerance_rad;
  world[lane] = terms.world ? -1 : 0;
  watched[lane] = plan.rate_.watched() ? -1 : 0;
  some_watched = some_watched || plan.rate_.watched();
  some_pushed = some_pushed || terms.pushed_rate.has_value();
  const double least_rad = so3::stable_rad(order_of(terms.coarsest_level));
  stable_rad = lane == 0 ? least_rad : std::min(stable_rad, least_rad);
  resisting[lane] = plan.rate_.resisting(terms.hold_s);
  own_rate[lane] = plan.rate_.own_rate();
  rates.stiffness[lane] = body.stiffness;
  rates.even_stiffness[lane] = body.stiffness.x();
  rates.spring = plan.rate_.spring();
  rates.even_spring =
      body.stiffness.x() == body.stiffness.y() && body.stiffness.y() == body.stiffness.z();
}

}  // namespace isograsp
