// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/two_hands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp::bimanual {

namespace {

constexpr std::size_t kLeft = index_of(Side::left);
constexpr std::size_t kRight = index_of(Side::right);
constexpr double kAspect = 16.0 / 9.0;

/// 1 at the edge of the bubble.
double gauge(const HandsSpec& spec, const Vec3& q) noexcept {
  switch (spec.shape) {
    case BubbleShape::ellipsoid: return q.norm();
    case BubbleShape::box: return q.cwiseAbs().maxCoeff();
    case BubbleShape::superellipsoid: break;
  }
  const double largest = q.cwiseAbs().maxCoeff();
  if (largest == 0.0) return 0.0;
  double sum = 0.0;
  for (const double component : q) sum += std::pow(std::abs(component) / largest, spec.exponent);
  return largest * std::pow(sum, 1.0 / spec.exponent);
}

Vec3 turned(const Vec3& v, double yaw_rad) noexcept {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()};
}

}  // namespace

BubblePush push_in_bubble(const HandsSpec& spec, Side side, const Vec3& push_N) noexcept {
  const Vec3 q = push_N.cwiseQuotient(spec.hands[index_of(side)].force_at_edge_N);
  const double rho = gauge(spec, q);
  return {spec.half_size_m.cwiseProduct(q) / std::max(1.0, rho), std::max(0.0, rho - 1.0)};
}

TwoHands::TwoHands(const HandsSpec& spec) noexcept
    : spec_(spec), least_distance_m_(spec.least_bubble_distance_m) {
  for (std::size_t side = 0; side < kSides; ++side) {
    state_.bubble_W[side] = spec.hands[side].center_m;
    state_.p_W[side] = before_plane_W_[side] = state_.bubble_W[side];
  }
  start_middle_W_ = 0.5 * (state_.bubble_W[kLeft] + state_.bubble_W[kRight]);
  turn();
}

void TwoHands::turn() noexcept {
  Vec3 across = state_.bubble_W[kRight] - state_.bubble_W[kLeft];
  across.y() = 0.0;
  // Nearer they would turn the world on the spot.
  if (const double distance_m = across.norm(); distance_m > 0.0 && distance_m >= least_distance_m_)
    line_W_ = across / distance_m;
  const double yaw_rad = std::atan2(-line_W_.z(), line_W_.x());
  state_.view.yaw_rad += std::remainder(yaw_rad - state_.view.yaw_rad, 2.0 * std::numbers::pi);
}

const HandsState& TwoHands::see(const HandsInput& input) noexcept {
  for (std::size_t side = 0; side < kSides; ++side) {
    const BubblePush push = push_in_bubble(spec_, static_cast<Side>(side), input.push_N[side]);
    state_.excess[side] = push.excess;
    state_.push_W_N[side] = turned(input.push_N[side], state_.view.yaw_rad);
    offset_W_[side] = turned(push.offset_m, state_.view.yaw_rad);
    clutched_[side] = spec_.explore == Explore::clutch && input.clutch[side];
    // The hand that is let go stays, and its bubble comes along.
    if (clutched_[side])
      state_.bubble_W[side] = before_plane_W_[side] - offset_W_[side];
    else
      before_plane_W_[side] = state_.bubble_W[side] + offset_W_[side];
    state_.p_W[side] = before_plane_W_[side];
  }
  if (spec_.explore == Explore::clutch) turn();
  apart();
  // The view holds both bubbles and what is between them.
  const Vec3 between = state_.bubble_W[kRight] - state_.bubble_W[kLeft];
  const double across_m = std::hypot(between.x(), between.z());
  const double r = spec_.shape == BubbleShape::ellipsoid ? spec_.half_size_m.maxCoeff()
                                                         : spec_.half_size_m.norm();
  const double t = std::tan(spec_.view_fov_rad / 2.0);
  state_.view.p_W = 0.5 * (state_.bubble_W[kLeft] + state_.bubble_W[kRight]);
  state_.view.distance_m = spec_.view_margin * std::max((0.5 * across_m + r) / (kAspect * t),
                                                        (0.5 * std::abs(between.y()) + r) / t) +
                           r;
  return state_;
}

void TwoHands::apart() noexcept {
  const Vec3 middle_W = spec_.explore == Explore::clutch
                            ? start_middle_W_
                            : Vec3(0.5 * (state_.bubble_W[kLeft] + state_.bubble_W[kRight]));
  const double half_m = spec_.separation_m / 2.0;
  for (const auto& [side, sign] : {std::pair{kLeft, -1.0}, std::pair{kRight, 1.0}}) {
    const double out_m = sign * line_W_.dot(state_.p_W[side] - middle_W);
    if (out_m < half_m) state_.p_W[side] += sign * (half_m - out_m) * line_W_;
  }
}

std::array<Vec3, kSides> TwoHands::rates() const noexcept {
  std::array<Vec3, kSides> v_W{Vec3::Zero(), Vec3::Zero()};
  if (spec_.explore != Explore::bubble) return v_W;
  for (std::size_t side = 0; side < kSides; ++side) {
    const double reach_m = offset_W_[side].norm();
    if (!(state_.excess[side] > 0.0) || reach_m == 0.0) continue;
    const double speed_m_s = std::min(
        spec_.rate_m_s * std::pow(state_.excess[side], spec_.rate_exponent), spec_.rate_limit_m_s);
    v_W[side] = speed_m_s / reach_m * offset_W_[side];
  }
  return v_W;
}

void TwoHands::move(double step_s, bool joint) noexcept {
  auto v_W = rates();
  if (joint) {
    const Vec3 both = spec_.left_share * v_W[kLeft] + (1.0 - spec_.left_share) * v_W[kRight];
    v_W = {both, both};
  } else {
    // What brings the bubbles together is as much as leaves them far enough apart.
    double inward_m = 0.0, outward_m = 0.0;
    for (const auto& [side, sign] : {std::pair{kLeft, 1.0}, std::pair{kRight, -1.0}}) {
      const double toward_m_s = sign * line_W_.dot(v_W[side]);
      (toward_m_s > 0.0 ? inward_m : outward_m) += step_s * std::abs(toward_m_s);
    }
    const double distance_m = line_W_.dot(state_.bubble_W[kRight] - state_.bubble_W[kLeft]);
    if (inward_m > 0.0) {
      const double share =
          std::clamp((distance_m - least_distance_m_ + outward_m) / inward_m, 0.0, 1.0);
      for (const auto& [side, sign] : {std::pair{kLeft, 1.0}, std::pair{kRight, -1.0}}) {
        const double toward_m_s = sign * line_W_.dot(v_W[side]);
        if (toward_m_s > 0.0) v_W[side] -= sign * (1.0 - share) * toward_m_s * line_W_;
      }
    }
  }
  for (std::size_t side = 0; side < kSides; ++side) state_.bubble_W[side] += step_s * v_W[side];
  turn();
}

}  // namespace isograsp::bimanual
