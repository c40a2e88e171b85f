// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/disk_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "grasp_model/limit_surface.hpp"

namespace isograsp::hand_world {

namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;
/// Torsional limit / (mu N R).
constexpr double kTorsionShare = 2.0 / 3.0;

DiskFriction share_at(double angle) noexcept {
  return disk_friction(Pressure::uniform, angle < kQuarterTurn ? std::tan(angle) : HUGE_VAL);
}

/// Friction and its slopes over the angle of the slip, between grid points by cubics: to find
/// angles. What is borne at an angle is always the exact share.
class DiskTable {
 public:
  struct At {
    DiskFriction share;
    DiskFriction slope;
  };
  DiskTable() noexcept {
    constexpr double kDifference = 1e-5;  // error of the slopes 1e-10
    for (std::size_t k = 0; k <= kCells; ++k) {
      const double angle = k == kCells ? kQuarterTurn : static_cast<double>(k) * kCell;
      const double from = std::max(0.0, angle - kDifference);
      const double to = std::min(kQuarterTurn, angle + kDifference);
      const DiskFriction before = share_at(from);
      const DiskFriction after = share_at(to);
      at_[k] = {share_at(angle),
                {(after.force - before.force) / (to - from),
                 (after.torque - before.torque) / (to - from)}};
    }
    at_[0].slope.torque = 0.0;  // even about the ends
    at_[kCells].slope.force = 0.0;
  }
  [[nodiscard]] At operator()(double angle) const noexcept {
    const double cells = angle / kCell;
    const auto cell = std::min(static_cast<std::size_t>(cells), kCells - 1);
    const double t = cells - static_cast<double>(cell);
    const At& from = at_[cell];
    const At& to = at_[cell + 1];
    const auto cubic = [t](double y0, double y1, double m0, double m1, double& y, double& slope) {
      const double rise = (y1 - y0) / kCell;
      const double b = 3.0 * rise - 2.0 * m0 - m1;
      const double c = m0 + m1 - 2.0 * rise;
      y = y0 + kCell * t * (m0 + t * (b + t * c));
      slope = m0 + t * (2.0 * b + 3.0 * t * c);
    };
    At at;
    cubic(from.share.force, to.share.force, from.slope.force, to.slope.force, at.share.force,
          at.slope.force);
    cubic(from.share.torque, to.share.torque, from.slope.torque, to.slope.torque, at.share.torque,
          at.slope.torque);
    return at;
  }

 private:
  static constexpr std::size_t kCells = 1024;
  static constexpr double kCell = kQuarterTurn / kCells;
  std::array<At, kCells + 1> at_;
};
const DiskTable kDiskTable;

/// Where a function passes zero that is positive at 0 and negative at a quarter turn; `value` gives
/// it and its slope. Newton from a guess, halving where that leaves the bracket.
template <class Falling>
double zero_of(const Falling& value, double guess) noexcept {
  constexpr double kAngle = 1e-9;  // [rad]; the table is as good
  constexpr int kMost = 40;
  double below = 0.0;
  double above = kQuarterTurn;
  double angle = guess > below && guess < above ? guess : 0.5 * kQuarterTurn;
  for (int k = 0; k < kMost; ++k) {
    const auto [at, slope] = value(angle);
    (at > 0.0 ? below : above) = angle;
    double next = angle - at / slope;
    if (!(next > below && next < above)) next = 0.5 * (below + above);
    const double step = std::abs(next - angle);
    angle = next;
    if (step <= kAngle) break;
  }
  return angle;
}

}  // namespace

bool DiskLimit::bears(const DiskLoad& load) const noexcept {
  if (!(most_N > 0.0)) return load.force == 0.0 && load.torque == 0.0;
  if (!(radius_m > 0.0)) return load.torque == 0.0 && load.force <= most_N;
  const double a = load.force / most_N;
  const double b = load.torque / (most_N * radius_m);
  if (a + b / kTorsionShare <= 1.0) return true;  // between the tips
  if (a * a + b * b / (kTorsionShare * kTorsionShare) >= 1.0) return false;
  if (b == 0.0) return a <= 1.0;
  if (a == 0.0) return b <= kTorsionShare;
  const double angle = zero_of(
      [&](double at_angle) {
        const DiskTable::At at = kDiskTable(at_angle);
        return std::pair(a * at.share.torque - b * at.share.force,
                         a * at.slope.torque - b * at.slope.force);
      },
      std::atan2(a, b));
  // The tangent there: the slip is along its normal, so that an error of the angle counts squared.
  const DiskFriction edge = share_at(angle);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return sine * a + cosine * b <= sine * edge.force + cosine * edge.torque;
}

DiskLoad DiskLimit::nearest(const DiskLoad& trial, double per_force, double per_torque,
                            double& angle) const noexcept {
  if (!(most_N > 0.0)) return {};
  if (!(radius_m > 0.0)) return {std::min(trial.force, most_N), 0.0};
  const double a = trial.force / most_N;
  const double b = trial.torque / (most_N * radius_m);
  const double weight = radius_m * radius_m * per_torque / per_force;
  if (trial.torque == 0.0)
    angle = kQuarterTurn;
  else if (trial.force == 0.0)
    angle = 0.0;
  else
    angle = zero_of(
        [&](double at_angle) {
          const DiskTable::At at = kDiskTable(at_angle);
          const double cosine = std::cos(at_angle);
          const double sine = std::sin(at_angle);
          const double slides = a - at.share.force;
          const double turns = weight * (b - at.share.torque);
          return std::pair(cosine * slides - sine * turns, -sine * slides - cosine * turns -
                                                               cosine * at.slope.force +
                                                               sine * weight * at.slope.torque);
        },
        angle);
  const DiskFriction share = share_at(angle);
  return {share.force * most_N, share.torque * most_N * radius_m};
}

}  // namespace isograsp::hand_world
