// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/hand_frame.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/attitude.hpp"
#include "statistics/percentile.hpp"

namespace isograsp::virtual_hand {

namespace {

constexpr double kLeastConfidence = 0.5;

/// What the frames give of one quantity; those that do not know it are not there.
class Median {
 public:
  void add(double value) {
    if (std::isfinite(value)) values_.push_back(value);
  }
  [[nodiscard]] std::optional<double> value() const {
    if (values_.empty()) return std::nullopt;
    return statistics::median(values_).value;
  }

 private:
  std::vector<double> values_;
};
class MedianPlace {
 public:
  void add(const Vec3& p) {
    for (std::size_t a = 0; a < 3; ++a) axes_[a].add(p[static_cast<Eigen::Index>(a)]);
  }
  [[nodiscard]] std::optional<Vec3> value() const {
    const auto x = axes_[0].value();
    const auto y = axes_[1].value();
    const auto z = axes_[2].value();
    if (!x || !y || !z) return std::nullopt;
    return Vec3(*x, *y, *z);
  }

 private:
  std::array<Median, 3> axes_;
};

struct DigitMedians {
  std::array<Median, kLinkCount> lengths_m;
  MedianPlace base_m;
  MedianPlace metacarpal_m;
};

/// A place in the palm, of a left hand reflected.
Vec3 in_palm(const Pose& X_WP, const Vec3& p_W, Hand side) noexcept {
  const Vec3 p_P = X_WP.q.conjugate() * (p_W - X_WP.p);
  return side == Hand::left ? mirrored(p_P) : p_P;
}

Error never_given(std::string_view digit) {
  return refused("a joint of the %1 is never given"_text(Known{std::string(digit)}),
                 "record the open hand again, all fingers in view"_text);
}

}  // namespace

std::optional<Pose> palm_of(const HandFrame& frame) noexcept {
  const Vec3& wrist = frame.joints[kWristJoint];
  const Vec3& index = frame.joints[joint_of(Digit::index, 0)];
  const Vec3& middle = frame.joints[joint_of(Digit::middle, 0)];
  const Vec3& little = frame.joints[joint_of(Digit::little, 0)];
  const double side = frame.side == Hand::right ? 1.0 : -1.0;
  const Vec3 z = (wrist - middle).normalized();
  const Vec3 y = z.cross(side * (little - index)).normalized();
  const Vec3 x = y.cross(z);
  Mat3 R;
  R << x, y, z;
  // Joints that are missing or on a line give no number, or no axes.
  constexpr double kAxesRounding = 1e-9;
  if (!R.allFinite() || std::abs(R.determinant() - 1.0) > kAxesRounding) return std::nullopt;
  return Pose{wrist, Quat(R)};
}

Result<CalibratedHand> calibrated_hand(std::span<const HandFrame> frames, Hand side,
                                       const HandModel& model) {
  CalibratedHand calibrated;
  std::array<DigitMedians, kDigitCount> digits;
  Median knuckle_m;
  for (const HandFrame& frame : frames) {
    if (frame.side != side || !frame.tracked || !(frame.confidence >= kLeastConfidence)) continue;
    const auto X_WP = palm_of(frame);
    if (!X_WP) continue;
    ++calibrated.frames;
    knuckle_m.add((frame.joints[kWristJoint] - frame.joints[joint_of(Digit::middle, 0)]).norm());
    for (std::size_t d = 0; d < kDigitCount; ++d) {
      const auto digit = static_cast<Digit>(d);
      const auto joint = [&](std::size_t end) { return frame.joints[joint_of(digit, end)]; };
      for (std::size_t k = 0; k < kLinkCount; ++k)
        digits[d].lengths_m[k].add((joint(k + 1) - joint(k)).norm());
      digits[d].base_m.add(in_palm(*X_WP, joint(0), side));
      digits[d].metacarpal_m.add(in_palm(*X_WP, frame.joints[metacarpal_joint_of(digit)], side));
    }
  }
  if (calibrated.frames == 0)
    return refused(side == Hand::right ? "no frame shows the right hand well"_text
                                       : "no frame shows the left hand well"_text,
                   "record the open hand for some seconds, or name the other side"_text);

  HandModel& hand = calibrated.hand;
  hand = model;
  hand.side = side;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    for (std::size_t k = 0; k < kLinkCount; ++k) {
      const auto length_m = digits[d].lengths_m[k].value();
      if (!length_m) return never_given(kDigitNames[d]);
      hand.digits[d].lengths_m[k] = *length_m;
    }
    hand.digits[d].base_m = *digits[d].base_m.value();  // its first link begins there
  }
  const auto& middle_m = hand.digit(Digit::middle).lengths_m;
  hand.length_m = *knuckle_m.value() + middle_m[0] + middle_m[1] + middle_m[2];
  const double scale = hand.length_m / model.length_m;
  hand.breadth_m = scale * model.breadth_m;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    for (double& radius_m : hand.digits[d].radii_m) radius_m *= scale;
    hand.digits[d].metacarpal_m =
        digits[d].metacarpal_m.value().value_or(scale * model.digits[d].metacarpal_m);
  }
  return calibrated;
}

std::optional<FittedPose> fitted_pose(const HandModel& hand, const HandFrame& frame) noexcept {
  const auto X_WP = palm_of(frame);
  if (!X_WP) return std::nullopt;
  FittedPose fit;
  fit.pose.X_WP = *X_WP;
  const auto direction_in = [&](const Quat& q_P, Digit digit, std::size_t k) {
    const Vec3& from = frame.joints[joint_of(digit, k)];
    const Vec3& to = frame.joints[joint_of(digit, k + 1)];
    const Vec3 d_W = to - from;
    const Vec3 d_P = X_WP->q.conjugate() * d_W;
    return Vec3(q_P.conjugate() * (hand.side == Hand::left ? mirrored(d_P) : d_P));
  };
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto digit = static_cast<Digit>(d);
    const DigitModel& model = hand.digits[d];
    DigitAngles& angles = fit.pose.angles[d];
    const Vec3 first = direction_in(model.base_q, digit, 0);
    if (!first.allFinite()) return std::nullopt;
    // A digit that is bent beyond a right angle points backwards: it is not spread the other way.
    const double s = first.z() <= 0.0 ? 1.0 : -1.0;
    angles[0] = std::clamp(std::atan2(-s * first.x(), -s * first.z()), model.limits[0].least,
                           model.limits[0].most);
    Quat q = model.base_q * Quat(Eigen::AngleAxisd(angles[0], Vec3::UnitY()));
    for (std::size_t k = 0; k < kLinkCount; ++k) {
      const Vec3 e = direction_in(q, digit, k);
      if (!e.allFinite()) return std::nullopt;
      angles[k + 1] = std::atan2(-e.y(), -e.z());
      q = q * Quat(Eigen::AngleAxisd(-angles[k + 1], Vec3::UnitX()));
    }
  }
  const HandInSpace fitted = hand_in_space(hand, fit.pose);
  double squares = 0.0;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t end = 1; end <= kLinkCount; ++end)
      squares += (fitted.digits[d].joints[end] - frame.joints[joint_of(static_cast<Digit>(d), end)])
                     .squaredNorm();
  fit.residual_m = std::sqrt(squares / static_cast<double>(kDigitCount * kLinkCount));
  return fit;
}

}  // namespace isograsp::virtual_hand
