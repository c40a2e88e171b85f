// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/hand_body.hpp"

#include "grasp_model/rotation.hpp"

namespace isograsp::hand_world {

namespace {

using namespace virtual_hand;

HandPose moved_hand(const HandPose& pose, const HandVelocity& velocity, double time_s) noexcept {
  HandPose moved;
  moved.X_WP.p = pose.X_WP.p + time_s * velocity.palm_v_W;
  moved.X_WP.q = (so3::exp(time_s * velocity.palm_w_W) * pose.X_WP.q).normalized();
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t a = 0; a < kAngleCount; ++a)
      moved.angles[d][a] =
          pose.angles[d][a] + time_s * velocity.rates[d][static_cast<Eigen::Index>(a)];
  return moved;
}

Vec3 middle_of_link(const DigitPose& digit, std::size_t link) noexcept {
  return 0.5 * (digit.joints[link] + digit.joints[link + 1]);
}

double sphere_inertia(double mass_kg, double diameter_m) noexcept {
  return 0.1 * mass_kg * diameter_m * diameter_m;  // 2/5 m r^2
}

/// Mass, damper and spring of one implicit step: what an increment of the mean velocity costs.
double implicit_mass(double mass, double share, double damping, double stiffness,
                     double step_s) noexcept {
  return mass + share * (0.5 * step_s * damping + 0.25 * step_s * step_s * stiffness);
}

/// Masses `alpha` I and `beta` I of a body whose middle is `arm` from the palm's origin.
void add_palm_mass(HubMatrix& hub, const Vec3& arm, double alpha, double beta) noexcept {
  const Mat3 cross = skew(arm);
  hub.diagonal().head<3>().array() += alpha;
  hub.block<3, 3>(3, 0) += alpha * cross;
  hub.block<3, 3>(0, 3) -= alpha * cross;
  hub.block<3, 3>(3, 3) -= alpha * (cross * cross);
  hub.diagonal().segment<3>(3).array() += beta;
}

void add_palm_pull(ArrowVector& pull, const Vec3& arm, const Wrench& wrench) noexcept {
  pull.hub.head<3>() += wrench.force;
  pull.hub.segment<3>(3) += arm.cross(wrench.force) + wrench.torque;
}

}  // namespace

Pose palm_middle(const HandInSpace& hand) noexcept {
  constexpr std::size_t kMiddle = index_of(Digit::middle);
  return {0.5 * (hand.metacarpals[kMiddle] + hand.digits[kMiddle].joints[0]), hand.X_WP.q};
}

HandTarget still_target(const HandInSpace& hand) noexcept {
  HandTarget target;
  target.palm.X_W = palm_middle(hand);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      target.links[d][k].X_W = {middle_of_link(hand.digits[d], k), hand.digits[d].links[k]};
  return target;
}

HandBody::HandBody(const HandModel& model, const HandDynamics& dynamics) noexcept
    : model_(model), dynamics_(dynamics), middle_(hand_in_space(model, pose_)) {}

void HandBody::place(const HandPose& pose) noexcept {
  pose_ = pose;
  velocity_ = HandVelocity();
  middle_ = in_space();
}

void HandBody::predict(double step_s) noexcept {
  middle_ = hand_in_space(model_, moved_hand(pose_, velocity_, 0.5 * step_s));
}

void HandBody::add_to(Arrow& matrix, ArrowVector& pull, const HandTarget& target,
                      double step_s) const noexcept {
  const Vec3& origin = middle_.X_WP.p;
  {
    const LinkCoupling& coupling = dynamics_.palm;
    const Pose X_W = palm_middle(middle_);
    const Vec3 arm = X_W.p - origin;
    const LinkMotion is{X_W, velocity_.palm_v_W + velocity_.palm_w_W.cross(arm),
                        velocity_.palm_w_W};
    const CoupledLink coupled = coupled_link(coupling, is, target.palm);
    add_palm_pull(pull, arm, coupled.wrench);
    add_palm_mass(
        matrix.hub, arm,
        implicit_mass(dynamics_.palm_kg, coupled.force_share, coupling.damping_N_s_m,
                      coupling.stiffness_N_m, step_s),
        implicit_mass(sphere_inertia(dynamics_.palm_kg, model_.breadth_m), coupled.torque_share,
                      coupling.damping_N_m_s_rad, coupling.stiffness_N_m_rad, step_s));
  }
  const LinkCoupling& coupling = dynamics_.link;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const DigitPose& digit = middle_.digits[d];
    const LeafVector& rates = velocity_.rates[d];
    for (std::size_t k = 0; k < kLinkCount; ++k) {
      const Vec3 p_W = middle_of_link(digit, k);
      const Vec3 arm = p_W - origin;
      LinkMotion is{{p_W, digit.links[k]},
                    velocity_.palm_v_W + velocity_.palm_w_W.cross(arm),
                    velocity_.palm_w_W};
      const auto used = static_cast<Eigen::Index>(k + 2);
      std::array<Vec3, kAngleCount> moves;
      for (Eigen::Index a = 0; a < used; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        moves[axis] = digit.axes[axis].cross(p_W - digit.joints[axis == 0 ? 0 : axis - 1]);
        is.v_m_s += rates[a] * moves[axis];
        is.w_rad_s += rates[a] * digit.axes[axis];
      }
      const CoupledLink coupled = coupled_link(coupling, is, target.links[d][k]);
      const double alpha = implicit_mass(dynamics_.link_kg[k], coupled.force_share,
                                         coupling.damping_N_s_m, coupling.stiffness_N_m, step_s);
      const double beta = implicit_mass(
          sphere_inertia(dynamics_.link_kg[k], model_.digits[d].lengths_m[k]), coupled.torque_share,
          coupling.damping_N_m_s_rad, coupling.stiffness_N_m_rad, step_s);
      add_palm_pull(pull, arm, coupled.wrench);
      add_palm_mass(matrix.hub, arm, alpha, beta);
      for (Eigen::Index a = 0; a < used; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        const Vec3& turn = digit.axes[axis];
        pull.leaves[d][a] +=
            moves[axis].dot(coupled.wrench.force) + turn.dot(coupled.wrench.torque);
        matrix.edges[d].col(a).segment<3>(kPalmPart) += alpha * moves[axis];
        matrix.edges[d].col(a).segment<3>(kPalmPart + 3) +=
            alpha * arm.cross(moves[axis]) + beta * turn;
        for (Eigen::Index b = 0; b <= a; ++b) {
          const auto other = static_cast<std::size_t>(b);
          const double mass =
              alpha * moves[axis].dot(moves[other]) + beta * turn.dot(digit.axes[other]);
          matrix.leaves[d](a, b) += mass;
          if (a != b) matrix.leaves[d](b, a) += mass;
        }
      }
    }
  }
}

void HandBody::write_velocity(ArrowVector& to) const noexcept {
  to.hub.head<3>() = velocity_.palm_v_W;
  to.hub.segment<3>(3) = velocity_.palm_w_W;
  to.leaves = velocity_.rates;
}

void HandBody::advance(const ArrowVector& velocity, double step_s) noexcept {
  HandVelocity end;
  end.palm_v_W = velocity.hub.head<3>();
  end.palm_w_W = velocity.hub.segment<3>(3);
  end.rates = velocity.leaves;
  HandVelocity mean;
  mean.palm_v_W = 0.5 * (velocity_.palm_v_W + end.palm_v_W);
  mean.palm_w_W = 0.5 * (velocity_.palm_w_W + end.palm_w_W);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    mean.rates[d] = 0.5 * (velocity_.rates[d] + end.rates[d]);
  pose_ = moved_hand(pose_, mean, step_s);
  velocity_ = end;
}

HandBody::PointRows HandBody::rows_of(int digit, std::size_t link, const Vec3& p_W) const noexcept {
  PointRows rows;
  rows.palm.leftCols<3>().setIdentity();
  rows.palm.rightCols<3>() = -skew(p_W - middle_.X_WP.p);
  if (digit == kPalm) return rows;
  const DigitPose& of = middle_.digits[static_cast<std::size_t>(digit)];
  for (std::size_t a = 0; a <= link + 1; ++a) {
    const auto column = static_cast<Eigen::Index>(a);
    rows.axes.col(column) = of.axes[a];
    rows.rates.col(column) = of.axes[a].cross(p_W - of.joints[a == 0 ? 0 : a - 1]);
  }
  return rows;
}

}  // namespace isograsp::hand_world
