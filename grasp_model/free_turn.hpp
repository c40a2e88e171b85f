// SPDX-License-Identifier: GPL-3.0-or-later
// One hold of a body that turns freely: which steps it takes, when one is good enough, what is left
// of them at the end. Who takes the steps, one body or four at once, is not said here.
// docs/grasp_model.md, "Three rotations". Inside grasp_model/ only; plan.hpp includes it because a
// Plan tells its terms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "grasp_model/follow.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp {

/// The coarsest of levels 0 … that divides `turn_rad` into parts of `part_rad`; more than
/// kFinestLevel: not possible.
[[nodiscard]] inline int level_for(double turn_rad, double part_rad) noexcept {
  int level = 0;
  for (; level <= kFinestLevel && !(turn_rad <= part_rad); ++level) turn_rad *= 0.5;
  return level;
}

/// Into which steps a hold is divided, and when one is good enough. Levels above 0 halve the step,
/// those below take a cheaper order (order_of()). Real-time safe.
struct TurnPace {
  int level = 0;
  int coarsest = 0;
  int slot = 0;  ///< of kSlots that a hold has
  bool stiff = false;

  static constexpr int kSlots = 1 << kFinestLevel;
  /// The coarsest level at which explicit steps are stable, if the fastest rate turns that much in
  /// the hold; more than kFinestLevel: none is.
  [[nodiscard]] static int coarsest_for(int coarsest, double turn_rad) noexcept {
    while (coarsest < 0 && !(turn_rad <= so3::stable_rad(order_of(coarsest)))) ++coarsest;
    return coarsest == 0 ? level_for(turn_rad, so3::stable_rad(so3::Order::eighth)) : coarsest;
  }
  [[nodiscard]] bool turning() const noexcept { return slot < kSlots; }
  [[nodiscard]] int halvings() const noexcept { return std::max(level, 0); }
  /// Of the hold: exact.
  [[nodiscard]] double part() const noexcept { return kPart[static_cast<std::size_t>(halvings())]; }
  /// False: the step is taken again, a finer one.
  [[nodiscard, gnu::always_inline]] bool accepts(double error_rad, double tolerance_rad) noexcept {
    if (error_rad <= part() * tolerance_rad || level >= kFinestLevel) return true;
    ++level;
    return false;
  }
  /// Behind a step that erred by that much, and by `coarser_rad` in the next lower order.
  [[gnu::always_inline]] void advance(double error_rad, double coarser_rad,
                                      double tolerance_rad) noexcept {
    const double allowed_rad = part() * tolerance_rad;
    slot += kSlots >> halvings();
    if (level <= coarsest) return;
    if (level <= 0) {
      if (coarser_rad <= allowed_rad) --level;
    } else if (slot % (kSlots >> (level - 1)) == 0 &&
               std::ldexp(error_rad, stiff ? kStiffOrder : kExplicitOrder) <= allowed_rad) {
      --level;
    }
  }

 private:
  static constexpr std::array<double, kFinestLevel + 1> kPart{
      1.0, 1.0 / 2.0, 1.0 / 4.0, 1.0 / 8.0, 1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0};
  /// A step of twice the length makes an error larger by 2 to this power.
  static constexpr int kExplicitOrder = 8;
  static constexpr int kStiffOrder = 5;
};

/// A panel turns the fastest rate by at most this: error of the quadrature below 1e-13 of the
/// force.
inline constexpr double kPanel_rad = 0.5;

/// Real-time safe.
class FreeTurn {
 public:
  /// What of a plan counts.
  struct Terms {
    double hold_s = 0.0;
    double tolerance_rad = 0.0;
    int coarsest_level = 0;
    bool world = true;    ///< the torque stays constant in world axes, else in object axes
    double branch = 1.0;  ///< q of the spring's branch = branch * pose.q
    /// The force turns with the object and moves something that is as fast as this [1/s].
    std::optional<double> pushed_rate;
  };
  /// Of half of so3::kSpringReach_rad, 1.9 pi.
  static constexpr double kCosineOfReach = -0.98768834059513773;
  /// If a damper needs more than 2 to this explicit steps, one stiff step is better.
  static constexpr int kStiffLevel = 3;
  /// As ObjectState has it.
  struct End {
    double error_rad = 0.0;
    bool exceeded = false;
  };

  [[gnu::always_inline]] FreeTurn(const so3::SpinRate& rate, const Terms& terms, const Vec3& torque,
                                  const Quat& q_WO, const Vec3& w_WO_W, int level) noexcept
      : rate_(rate), hold_s_(terms.hold_s), tolerance_rad_(terms.tolerance_rad) {
    rate_.load(terms.world ? so3::Torques{torque, Vec3::Zero()}
                           : so3::Torques{Vec3::Zero(), torque});
    y_ = so3::pack({Quat(terms.branch * q_WO.coeffs()), q_WO.conjugate() * w_WO_W});
    start_ = y_;

    const double turn_rad = rate_.fastest(y_, hold_s_) * hold_s_;
    int& coarsest = pace_.coarsest;
    coarsest = TurnPace::coarsest_for(terms.coarsest_level, turn_rad);
    pace_.stiff = coarsest > (rate_.overdamped() ? kStiffLevel : kFinestLevel);
    if (pace_.stiff) coarsest = 0;
    int follow_level = 0;
    if (terms.pushed_rate) follow_level = level_for(*terms.pushed_rate * hold_s_, kPanel_rad);
    exceeded_ = follow_level > kFinestLevel ||
                (pace_.stiff && rate_.too_fast(y_, std::ldexp(hold_s_, -kFinestLevel), hold_s_));
    if (follow_level > 0) coarsest = std::max(coarsest, std::min(follow_level, kFinestLevel));

    // What may not be followed must not gain energy either.
    watched_ = rate_.watched();
    hard_ = pace_.stiff || coarsest == kFinestLevel;
    if (hard_) rate_.watch();
    pace_.level = std::clamp(level, coarsest, kFinestLevel);
  }

  /// A step is to be taken: of step_s() from y(), of order_of(level()) or the stiff one.
  [[nodiscard]] bool turning() const noexcept { return pace_.turning(); }
  [[nodiscard]] const so3::SpinRate& rate() const noexcept { return rate_; }
  [[nodiscard]] const so3::SpinVector& y() const noexcept { return y_; }
  [[nodiscard]] bool stiff() const noexcept { return pace_.stiff; }
  [[nodiscard]] int level() const noexcept { return pace_.level; }
  [[nodiscard]] int halvings() const noexcept { return pace_.halvings(); }
  [[nodiscard]] double step_s() const noexcept { return pace_.part() * hold_s_; }
  /// False: the step is taken again, a finer one.
  [[nodiscard, gnu::always_inline]] bool accepts(const so3::SpinStep& step) noexcept {
    return pace_.accepts(step.error_rad, tolerance_rad_);
  }
  [[gnu::always_inline]] void advance(const so3::SpinStep& step) noexcept {
    y_ = step.end;
    error_rad_ += step.error_rad;
    pace_.advance(step.error_rad, step.coarser_rad, tolerance_rad_);
  }
  /// What the hold made of the body.
  [[gnu::always_inline]] End finish(double branch, Quat& q_WO, Vec3& w_WO_W) noexcept {
    bool exceeded = exceeded_ || !(error_rad_ <= tolerance_rad_);
    if (!(y_.squaredNorm() < std::numeric_limits<double>::infinity()))
      y_ = so3::pack({so3::unpack(start_).q_WO, Vec3::Zero()});
    if (watched_ || (exceeded && hard_))
      error_rad_ += rate_.limit_energy(rate_.energy(start_) + y_[7], y_);
    rate_.settle(y_);
    y_.head<4>() /= y_.head<4>().norm();
    const so3::Spin spin = so3::unpack(y_);
    // The angle is beyond kSpringReach_rad.
    if (spin.q_WO.w() < kCosineOfReach && rate_.spring()) exceeded = true;
    q_WO.coeffs() = branch * spin.q_WO.coeffs();
    w_WO_W = q_WO * spin.w_O;
    return {error_rad_, exceeded || !(error_rad_ <= tolerance_rad_)};
  }

 private:
  so3::SpinRate rate_;
  so3::SpinVector start_, y_;
  double hold_s_;
  double tolerance_rad_;
  double error_rad_ = 0.0;
  TurnPace pace_;
  bool hard_ = false;
  bool watched_ = false;  ///< by the plan
  bool exceeded_ = false;
};

}  // namespace isograsp
