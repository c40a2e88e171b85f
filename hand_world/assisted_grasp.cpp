// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/assisted_grasp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "virtual_hand/hand_frame.hpp"

namespace isograsp::hand_world {

namespace {

using namespace virtual_hand;

/// Of a link's dragging force: what lets go of heavy objects, too.
constexpr double kLinkMost = 2.5;  // times the release effort
constexpr double kLinkMost_N = LinkCoupling{}.most_N;

double least_jerk_way(double u) noexcept {
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}
/// Largest acceleration of a way of least jerk is this times way / duration^2.
constexpr double kLeastJerkPeak = 5.773502691896258;  // 10 / sqrt(3)

/// An object that nobody sees stands in where there is none.
ObjectBody no_object() noexcept {
  return solid_object({ObjectShape::Kind::box, Vec3::Constant(0.01)}, 1000.0);
}

bool same_contact(const std::optional<DigitContact>& a,
                  const std::optional<DigitContact>& b) noexcept {
  if (!a || !b) return a.has_value() == b.has_value();
  const Vec3 normal = a->R_OC.col(2);
  const Vec3 other = b->R_OC.col(2);
  return a->link == b->link && (a->p_OC - b->p_OC).norm() < AssistedGrasp::kSamePlace_m &&
         normal.cross(other).norm() < AssistedGrasp::kSameNormal_rad && normal.dot(other) > 0.0;
}

}  // namespace

TieGains tie_gains(AssistanceLevel level, double mass_kg, const WorldRules& rules) noexcept {
  TieDesign design;
  design.mass_kg = mass_kg;
  design.gravity_m_s2 = rules.gravity_W.norm();
  design.patch_radius_m = rules.pad.patch_radius_m;
  const double share = level == AssistanceLevel::softer ? 0.5 : 1.0;
  design.deflection_m /= share;
  TieGains gains = virtual_hand::tie_gains(design);
  gains.release_N *= share;  // at the same stretch
  return gains;
}

GraspObject grasp_object(const StudyObject& object) noexcept {
  ObjectBody body = solid_object(object.shape, 1.0);
  const double density_kg_m3 = object.mass_kg / body.mass_kg;
  return {solid_object(object.shape, density_kg_m3), object.limits};
}

StartPlace start_place(const StudyObject& object, double table_m, double x_m, double z_m) noexcept {
  constexpr double kBlockHalf_m = 0.03;
  StartPlace start;
  start.ground.table_m = table_m;
  const double top_m = table_m + object.support_m;
  if (object.support_m > 0.0)
    start.ground.block = SupportBlock{x_m, z_m, kBlockHalf_m, kBlockHalf_m, top_m};
  const double quarter = 0.5 * std::numbers::pi;
  const bool lies = object.size == SizeClass::slim;
  const double half_m = lies ? object.shape.half_m.x() : object.shape.half_m.z();
  start.X_WO.p = {x_m, top_m + half_m, z_m};
  start.X_WO.q = lies ? Quat(Eigen::AngleAxisd(quarter, Vec3::UnitY()))
                      : Quat(Eigen::AngleAxisd(-quarter, Vec3::UnitX()));
  return start;
}

AssistedGrasp::AssistedGrasp(const HandModel& hand, double frame_s, const WorldRules& rules)
    : model_(hand),
      hand_scale_m_(virtual_hand::hand_scale_m(hand)),
      frame_s_(frame_s),
      steps_(static_cast<int>(std::lround(frame_s / kStep_s))),
      rules_(rules),
      world_(no_object(), rules) {
  state_.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  clear();
}

void AssistedGrasp::place(const GraspObject& object, const StartPlace& at,
                          AssistanceLevel level) noexcept {
  object_ = object;
  start_ = at;
  level_ = level;
  object_there_ = true;
  stand_object();
  world_.set_link_most(std::max(kLinkMost_N, kLinkMost * gains_.release_N));
}

void AssistedGrasp::reset() noexcept {
  if (object_there_) stand_object();
}

void AssistedGrasp::release() noexcept {
  releasing_ = true;
  gains_.release_N =
      kPlacedPull * hand_world::tie_gains(level_, object_.body.mass_kg, rules_).release_N;
  assistance_.set_release(gains_.release_N);
  state_.releasing = true;
}

void AssistedGrasp::let_go() noexcept {
  releasing_ = helped_ = true;
  assistance_ = Assistance(gains_.release_N);
  world_.tie(assistance_.states(), gains_);
  world_.let_through(true);
  publish();
}

void AssistedGrasp::clear() noexcept {
  object_ = {no_object(), {}};
  start_ = {};
  level_ = AssistanceLevel::off;
  object_there_ = false;
  stand_object();
  world_.let_through(true);
}

void AssistedGrasp::stand_object() noexcept {
  releasing_ = helped_ = false;
  gains_ = hand_world::tie_gains(level_, object_.body.mass_kg, rules_);
  assistance_ = Assistance(gains_.release_N);
  chosen_of_ = {};
  choice_ = {};
  report_ = {};
  let_go_at_N_ = {};
  world_.take_object(object_.body);
  world_.place_object({start_.X_WO, Vec3::Zero(), Vec3::Zero()});
  world_.place_ground(start_.ground);
  world_.let_through(false);
  publish();
}

void AssistedGrasp::frame(const HandFrame& hand, bool held) noexcept {
  const auto seen = held ? std::nullopt : target_of_frame(model_, hand);
  state_.frozen = !seen;
  if (!seen) {
    lost_ = true;
    AssistanceRow row;
    row.tracked = false;
    assistance_.step(row);
    return;
  }
  if (!world_.hand()) {
    // target_of_frame() has found the pose, too.
    world_.place_hand(model_, fitted_pose(model_, hand)->pose);
    seen_ = led_ = *seen;
    lost_ = false;
  }
  const HandTarget from = led_;
  led_ = led_to(*seen);
  seen_ = *seen;
  lost_ = false;
  report_ = {};
  let_go_at_N_ = {};
  if (!object_there_) world_.place_object({});
  for (int k = 0; k < steps_; ++k)
    step(between_targets(from, led_, (k + 0.5) / static_cast<double>(steps_), frame_s_));
  choose();
  publish();
}

HandTarget AssistedGrasp::led_to(const HandTarget& seen) noexcept {
  const double way_m = (seen.palm.X_W.p - seen_.palm.X_W.p).norm();
  if (lost_ || way_m > kMostTracked_m_s * frame_s_)
    catch_up_ =
        CatchUp{led_, t_s(), std::sqrt(kLeastJerkPeak * furthest(led_, seen) / kCatchUp_m_s2)};
  if (!catch_up_) return seen;
  const double passed_s = t_s() + frame_s_ - catch_up_->since_s;
  if (passed_s >= catch_up_->lasts_s) {
    catch_up_.reset();
    return seen;
  }
  return between_targets(catch_up_->from, seen, least_jerk_way(passed_s / catch_up_->lasts_s),
                         frame_s_);
}

void AssistedGrasp::step(const HandTarget& target) noexcept {
  world_.step(kStep_s, target);
  ++ticks_;
  AssistanceRow row = world_.assistance_row(t_s(), releasing_);
  const bool ties = level_ != AssistanceLevel::off && !releasing_ && choice_.feasible;
  row.feasible = ties ? choice_.digits : 0;
  assistance_.step(row);
  if (lets_go_in_part()) assistance_.let_go(t_s());
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if (world_.tied(static_cast<Digit>(d)) && assistance_.states()[d] != DigitState::attached)
      let_go_at_N_[d] = row.digits[d].pull_N;
  world_.tie(assistance_.states(), gains_);
  report_.sweeps = std::max(report_.sweeps, world_.solver_report().sweeps);
  report_.residual_m_s = std::max(report_.residual_m_s, world_.solver_report().residual_m_s);
}

bool AssistedGrasp::lets_go_in_part() const noexcept {
  std::array<DigitContact, kDigitCount> left;
  std::size_t count = 0;
  bool lets_go = false;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto tie = world_.tie_of(static_cast<Digit>(d));
    if (!tie) continue;
    if (assistance_.states()[d] == DigitState::attached)
      left[count++] = *tie;
    else
      lets_go = true;
  }
  if (!lets_go || count == 0) return false;
  // Once it is placed nothing is to be held: one digit that opens is enough.
  return releasing_ || !closes(std::span(left).first(count), rules_.pad);
}

bool AssistedGrasp::as_chosen(const Contacts& now) const noexcept {
  return std::equal(now.begin(), now.end(), chosen_of_.begin(), same_contact);
}

void AssistedGrasp::choose() noexcept {
  Contacts now;
  std::array<DigitContact, kDigitCount> contacts;
  std::size_t count = 0;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    now[d] = world_.contact_of(static_cast<Digit>(d));
    if (now[d]) contacts[count++] = *now[d];
  }
  if (as_chosen(now)) return;
  chosen_of_ = now;
  choice_ =
      feasible_grasp(std::span(contacts).first(count), world_.hand()->in_space(),
                     world_.object().motion().X_WO, hand_scale_m_, rules_.pad, object_.limits);
}

void AssistedGrasp::publish() noexcept {
  state_.hand_there = world_.hand() != nullptr;
  state_.object_there = object_there_;
  state_.level = level_;
  state_.releasing = releasing_;
  state_.helped = helped_;
  state_.object = world_.object().motion();
  state_.supported = world_.supported();
  state_.choice = choice_;
  state_.solver = report_;
  int tied = 0;
  int touching = 0;
  const AssistanceRow row = world_.assistance_row(t_s(), releasing_);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const AssistanceRow::OfDigit& digit = row.digits[d];
    const DigitState is = assistance_.states()[d];
    const double pull_N = is == DigitState::attached ? digit.pull_N : let_go_at_N_[d];
    state_.digits[d] = {is, digit.contact, pull_N, world_.touches()[d].normal_N, digit.gap_m};
    tied += is == DigitState::attached ? 1 : 0;
    touching += digit.contact ? 1 : 0;
  }
  state_.held = tied >= 1 || touching >= 2;
  if (!world_.hand()) return;
  const HandInSpace hand = world_.hand()->in_space();
  state_.hand = world_.hand()->pose();
  const auto joints = joint_poses(hand);
  for (std::size_t j = 0; j < kHandJointCount; ++j) state_.joints[j] = joints[j].p;
  state_.tracked_gap_m = furthest(seen_, still_target(hand));
}

}  // namespace isograsp::hand_world
