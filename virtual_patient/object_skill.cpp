// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/object_skill.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "grasp_model/rotation.hpp"
#include "virtual_patient/loop_delay.hpp"

namespace isograsp::virtual_patient {

namespace {

constexpr double kProportional = 0.3;          ///< of the stiffness
constexpr double kIntegral_per_s = 0.7;        ///< of the stiffness
constexpr double kDamping_per_s = 0.5;         ///< of the damping: moves objects without a spring
constexpr double kFrictionUse = 0.6;           ///< of the friction limit that people dare to use
constexpr double kClosingTime_s = 0.5;         ///< from no force to the full grasp
constexpr double kTouchMargin = 1.5;           ///< of the contact threshold …
constexpr double kTouchMargin_N = 0.3;         ///< … and above it
constexpr double kLargestTouchFraction = 0.4;  ///< of the maximum: weak hands save their strength
constexpr double kLargestCorrectionFraction = 0.5;

/// A target that moves this much between two pictures has jumped.
constexpr double kShift_m = 0.005;
constexpr double kShift_rad = 0.05;

/// A slower target stands or creeps: the person moves to its place instead of pursuing it.
constexpr double kPursued_m_s = 0.005;
constexpr double kPursued_rad_s = 0.05;
constexpr double kSpeedSeen_s = 0.1;  ///< time constant of seeing a speed

/// The shorter way round.
Vec3 shortest_turn(const Quat& from, const Quat& to) noexcept {
  Quat turn = from.conjugate() * to;
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  return so3::log(turn);
}

}  // namespace

PosePlan::PosePlan(const Pose& from, const Pose& to, double start_s, double duration_s) noexcept
    : from_(from),
      to_(to),
      turn_(shortest_turn(from.q, to.q)),
      start_s_(start_s),
      duration_s_(duration_s) {}

PosePlan::Point PosePlan::at(double t_s) const noexcept {
  const double u = std::clamp((t_s - start_s_) / duration_s_, 0.0, 1.0);
  const double share = u * u * u * (10.0 + u * (6.0 * u - 15.0));
  const double rate = 30.0 * u * u * (1.0 - u) * (1.0 - u) / duration_s_;
  Point point;
  point.X_WO.p = from_.p + share * (to_.p - from_.p);
  point.X_WO.q = from_.q * so3::exp(share * turn_);
  point.v_WO_W = rate * (to_.p - from_.p);
  point.w_WO_O = rate * turn_;
  return point;
}

void Pursuit::see(const Pose& target, double dt_s, double t_s) noexcept {
  if (seen_ && dt_s > 0.0) {
    const double share = 1.0 - std::exp(-dt_s / kSpeedSeen_s);
    v_W_ += share * ((target.p - target_.p) / dt_s - v_W_);
    w_T_ += share * (shortest_turn(target_.q, target.q) / dt_s - w_T_);
  }
  target_ = target;
  seen_ = true;
  seen_at_s_ = t_s;
}

bool Pursuit::moves() const noexcept {
  return v_W_.norm() > kPursued_m_s || w_T_.norm() > kPursued_rad_s;
}

void Pursuit::forget() noexcept {
  seen_ = false;
  v_W_.setZero();
  w_T_.setZero();
}

Pose Pursuit::expected(double t_s) const noexcept {
  const double ahead_s = t_s - seen_at_s_ + delay_s_;
  return {target_.p + ahead_s * v_W_, target_.q * so3::exp(ahead_s * w_T_)};
}

void Pursuit::begin(const Pose& from, double t_s, double duration_s, double delay_s) noexcept {
  delay_s_ = delay_s;
  const Pose target = expected(t_s);
  const Pose behind{from.p - target.p, target.q.conjugate() * from.q};
  catch_up_ = PosePlan(behind, Pose{}, t_s, duration_s);
}

PosePlan::Point Pursuit::at(double t_s) const noexcept {
  const Pose target = expected(t_s);
  PosePlan::Point point = catch_up_.at(t_s);
  point.X_WO.p += target.p;
  point.v_WO_W += v_W_;
  point.w_WO_O += point.X_WO.q.conjugate() * w_T_;
  point.X_WO.q = target.q * point.X_WO.q;
  return point;
}

ObjectSkill::ObjectSkill(const PatientTraits& traits, const Scene& scene)
    : traits_(traits), scene_(scene) {
  for (Eigen::Index dof = 0; dof < 6; ++dof)
    free_[dof] = scene.free[static_cast<std::size_t>(dof)] ? 1.0 : 0.0;
  learn_grasp();
}

void ObjectSkill::learn_grasp() {
  Map G = Map::Zero();
  Stacked squeeze = Stacked::Zero();
  double square_arms = 0.0;
  const auto fingers = static_cast<double>(scene_.contacts.size());
  const bool thumb = scene_.contact_of(Finger::thumb) != nullptr;
  for (const Contact& contact : scene_.contacts) {
    const std::size_t f = index_of(contact.finger);
    const auto column = 3 * static_cast<Eigen::Index>(f);
    const Eigen::Index first = contact.model == ContactModel::frictionless ? 2 : 0;
    for (Eigen::Index axis = first; axis < 3; ++axis) {
      const Vec3 direction = contact.R_OC.col(axis);
      G.col(column + axis) << direction, contact.p_OC.cross(direction);
    }
    square_arms += contact.p_OC.squaredNorm();
    squeeze[column + 2] =
        !thumb || contact.finger == Finger::thumb ? 1.0 : 1.0 / std::max(1.0, fingers - 1.0);
    least_N_[f] = std::min(kTouchMargin * contact.threshold_N + kTouchMargin_N,
                           kLargestTouchFraction * traits_.maximum_force_N);
  }
  const double arm_m = square_arms > 0.0 ? std::sqrt(square_arms / fingers) : 1.0;
  Vec6 scale;  // torques as forces at the mean arm; a locked axis needs no force
  scale << 1.0, 1.0, 1.0, Vec3::Constant(1.0 / arm_m);
  scale = scale.cwiseProduct(free_);
  const Map scaled = scale.asDiagonal() * G;
  // The smallest forces that make a wrench: pseudo-inverse, its zero directions left at zero.
  constexpr double kRidge = 1e-9;
  Eigen::Matrix<double, 6, 6> square = scaled * scaled.transpose();
  square.diagonal().array() += kRidge;
  share_ = scaled.transpose() * square.inverse() * scale.asDiagonal();
  // Squeezing as much as possible without moving the object.
  grip_ = squeeze - scaled.transpose() * (square.inverse() * (scaled * squeeze));

  const double most_N = kLargestCorrectionFraction * traits_.maximum_force_N;
  largest_correction_ << Vec3::Constant(most_N), Vec3::Constant(most_N * arm_m);
}

void ObjectSkill::begin(double t_s) noexcept {
  plan_ = PosePlan(picture_.X_WO);
  begin_s_ = t_s;
  waiting_ = pursuing_ = false;
  moving_s_ = 0.0;
  pursuit_.forget();
  correction_.setZero();
  error_.setZero();
  if (seen_ && picture_.object_shown) {
    waiting_ = true;
    waiting_until_s_ = t_s + kClosingTime_s;
  }
}

Vec6 ObjectSkill::error(const Pose& wanted, const Pose& seen) const noexcept {
  Vec6 difference;
  difference << wanted.p - seen.p, seen.q * shortest_turn(seen.q, wanted.q);
  return difference.cwiseProduct(free_);
}

PosePlan::Point ObjectSkill::planned(double t_s) const noexcept {
  return pursuing_ ? pursuit_.at(t_s) : plan_.at(t_s);
}

/// @pre picture_ is the picture before
void ObjectSkill::see_target(const Stimulus& picture, double dt_s, double t_s) noexcept {
  const auto far = [](const Pose& a, const Pose& b) {
    return (a.p - b.p).norm() > kShift_m || angle_between(a.q, b.q) > kShift_rad;
  };
  if (far(picture.X_WT, picture_.X_WT)) {
    if (std::exchange(pursuing_, false)) plan_ = PosePlan(pursuit_.at(t_s).X_WO);
    pursuit_.forget();
    moving_s_ = 0.0;
  }
  pursuit_.see(picture.X_WT, dt_s, t_s);
  moving_s_ = pursuit_.moves() ? moving_s_ + dt_s : 0.0;
  if (pursuing_) return;
  if (moving_s_ >= traits_.reaction_s) {
    pursuit_.begin(plan_.at(t_s).X_WO, t_s, traits_.movement_s, loop_delay_s(traits_));
    pursuing_ = true;
    waiting_ = false;
  } else if (moving_s_ == 0.0 && far(picture.X_WT, plan_.end()) && !waiting_) {
    waiting_ = true;
    waiting_until_s_ = t_s + traits_.reaction_s;
  }
}

void ObjectSkill::perceive(const Stimulus& picture, double t_s) noexcept {
  const double dt_s = seen_ ? std::max(0.0, picture.t_s - picture_.t_s) : 0.0;
  const bool had_object = seen_ && picture_.object_shown;
  if (picture.object_shown) {
    if (!had_object) {
      plan_ = PosePlan(picture.X_WO);
      pursuing_ = false;
      pursuit_.forget();
    }
    see_target(picture, had_object ? dt_s : 0.0, t_s);
  }
  picture_ = picture;
  seen_ = true;
  if (!picture.object_shown) return;

  // The picture shows the effect of what was wanted one loop delay ago.
  const double answered_s = t_s - loop_delay_s(traits_);
  error_ = error(planned(answered_s).X_WO, picture.X_WO);
  bool held = true;
  for (const Contact& contact : scene_.contacts) held &= picture.contact[index_of(contact.finger)];
  if (!held) return;
  correction_ += kIntegral_per_s * dt_s * scene_.stiffness.cwiseProduct(error_);
  correction_ = correction_.cwiseMax(-largest_correction_).cwiseMin(largest_correction_);
}

Vec6 ObjectSkill::wrench_W(double t_s) noexcept {
  if (waiting_ && t_s >= waiting_until_s_) {
    plan_ = PosePlan(plan_.at(t_s).X_WO, picture_.X_WT, t_s, traits_.movement_s);
    waiting_ = false;
  }
  const PosePlan::Point point = planned(t_s);
  const Quat& q = point.X_WO.q;
  Quat near = q;  // of the two signs, the one nearer to the springs' rest
  if (near.w() < 0.0) near.coeffs() = -near.coeffs();
  const Vec3 force = scene_.stiffness.head<3>().cwiseProduct(point.X_WO.p - scene_.anchor_m) +
                     scene_.damping.head<3>().cwiseProduct(point.v_WO_W) -
                     scene_.mass_kg * scene_.gravity_m_s2;
  const Vec3 torque_O = scene_.damping.tail<3>().cwiseProduct(point.w_WO_O) -
                        so3::spring_torque(so3::log(near), scene_.stiffness.tail<3>());
  Vec6 wrench;
  wrench << force, q * torque_O;
  const Vec6 gain = kProportional * scene_.stiffness + kDamping_per_s * scene_.damping;
  return (wrench + gain.cwiseProduct(error_) + correction_).cwiseProduct(free_);
}

void ObjectSkill::squeeze(Stacked& forces) const noexcept {
  // More grip raises what friction can hold; with tilted contacts it also adds tangential force, so
  // the amount is found in a few passes.
  constexpr int kPasses = 3;
  double grip_N = 0.0;
  const Stacked alone = forces;
  for (int pass = 0; pass < kPasses; ++pass) {
    for (const Contact& contact : scene_.contacts) {
      const std::size_t f = index_of(contact.finger);
      const auto column = 3 * static_cast<Eigen::Index>(f);
      const double share = grip_[column + 2];
      constexpr double kNoGrip = 1e-3;  // no other finger opposes this one
      if (share < kNoGrip) continue;
      const double tangential_N = forces.segment<2>(column).norm();
      const double holding_N =
          contact.friction > 0.0 ? tangential_N / (kFrictionUse * contact.friction) : 0.0;
      const double needed_N = std::max(least_N_[f], holding_N);
      grip_N = std::max(grip_N, (needed_N - alone[column + 2]) / share);
    }
    forces = alone + std::min(grip_N, traits_.maximum_force_N) * grip_;
  }
}

FingerForces ObjectSkill::wanted(double t_s) noexcept {
  FingerForces wanted;
  wanted.fill(Vec3::Zero());
  if (!seen_ || !picture_.object_shown) return wanted;
  Vec6 wrench = wrench_W(t_s);
  if (scene_.wrench_frame == WrenchFrame::object) {
    const Quat to_object = picture_.X_WO.q.conjugate();
    wrench.head<3>() = to_object * Vec3(wrench.head<3>());
    wrench.tail<3>() = to_object * Vec3(wrench.tail<3>());
  }
  Stacked forces = share_ * wrench;
  squeeze(forces);
  const double closed = std::clamp((t_s - begin_s_) / kClosingTime_s, 0.0, 1.0);
  for (const Contact& contact : scene_.contacts) {
    const std::size_t f = index_of(contact.finger);
    Vec3 force = closed * forces.segment<3>(3 * static_cast<Eigen::Index>(f));
    force.z() = std::max(force.z(), 0.0);
    const double most_N = kFrictionUse * contact.friction * force.z();
    const double tangential_N = force.head<2>().norm();
    if (tangential_N > most_N) force.head<2>() *= most_N / tangential_N;
    wanted[f] = force;
  }
  return wanted;
}

}  // namespace isograsp::virtual_patient
