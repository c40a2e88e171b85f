// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/device_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hand/anatomical_axes.hpp"

namespace isograsp {

namespace {

constexpr double kEmpty_s = 1.0;
constexpr double kLetGo = 0.5;  // of the least press: below it the supports are free again

/// The words for this finger.
template <std::size_t Places>
Phrase<Places> of(Finger finger, Phrase<Places> thumb, Phrase<Places> index,
                  Phrase<Places> middle) {
  return finger == Finger::thumb ? thumb : finger == Finger::index ? index : middle;
}

/// In the contact frame.
Vec3 direction_of(const CheckStep& step) {
  switch (step.press) {
    case Press::up: return Vec3::UnitX();
    case Press::toward_wrist: return -distal_sign(step.finger, step.hand) * Vec3::UnitY();
    case Press::into:
    case Press::weight: break;
  }
  return Vec3::UnitZ();
}

Number newtons(double force_N) {
  return fixed(force_N, 1);
}

/// What was felt by another support.
Words swapped(Finger asked, Finger felt_by) {
  switch (felt_by) {
    case Finger::thumb:
      return asked == Finger::index
                 ? "It was the thumb's support that felt this: the sensors of index and thumb "
                   "are swapped."_text
                 : "It was the thumb's support that felt this: the sensors of middle and thumb "
                   "are swapped."_text;
    case Finger::index:
      return asked == Finger::thumb
                 ? "It was the index finger's support that felt this: the sensors of thumb and "
                   "index are swapped."_text
                 : "It was the index finger's support that felt this: the sensors of middle and "
                   "index are swapped."_text;
    default:
      return asked == Finger::thumb
                 ? "It was the middle finger's support that felt this: the sensors of thumb and "
                   "middle are swapped."_text
                 : "It was the middle finger's support that felt this: the sensors of index and "
                   "middle are swapped."_text;
  }
}

bool has_value(const FingerFrame& frame, std::size_t f) {
  return (frame.flags[f] & bit(SampleFlag::missing)) == 0;
}

}  // namespace

std::string_view name_of(Press press) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"into", "up", "toward_wrist", "weight"};
  return kNames[static_cast<std::size_t>(press)];
}

Text CheckStep::instruction() const {
  switch (press) {
    case Press::into:
      return of(finger, "Press the thumb's support straight in and hold."_text,
                "Press the index finger's support straight in and hold."_text,
                "Press the middle finger's support straight in and hold."_text);
    case Press::up:
      return of(finger, "Push the thumb's support upward and hold."_text,
                "Push the index finger's support upward and hold."_text,
                "Push the middle finger's support upward and hold."_text);
    case Press::toward_wrist:
      return of(finger, "Push the thumb's support toward the wrist and hold."_text,
                "Push the index finger's support toward the wrist and hold."_text,
                "Push the middle finger's support toward the wrist and hold."_text);
    case Press::weight:
      return of(finger, "Put the reference weight on the thumb's support and wait."_text,
                "Put the reference weight on the index finger's support and wait."_text,
                "Put the reference weight on the middle finger's support and wait."_text);
  }
  return {};
}

Text CheckResult::sentence() const {
  const Finger asked = step.finger;
  switch (verdict) {
    case CheckVerdict::good:
      return of(asked, "Good: the thumb's support felt %1 N."_text,
                "Good: the index finger's support felt %1 N."_text,
                "Good: the middle finger's support felt %1 N."_text)(newtons(force_N.norm()));
    case CheckVerdict::other_finger:
      return joined({swapped(asked, felt_by),
                     "Exchange their cables or their entries in the device file."_text});
    case CheckVerdict::wrong_sign:
      return joined(
          {of(asked, "The sensor under the thumb's support shows the opposite direction."_text,
              "The sensor under the index finger's support shows the opposite direction."_text,
              "The sensor under the middle finger's support shows the opposite direction."_text),
           "Correct quaternion_wxyz or sign in the device file."_text});
    case CheckVerdict::wrong_axis:
      return joined(
          {of(asked,
              "The sensor under the thumb's support shows another direction (%1 N up, %2 N "
              "toward the wrist, %3 N in): it is turned."_text,
              "The sensor under the index finger's support shows another direction (%1 N up, %2 "
              "N toward the wrist, %3 N in): it is turned."_text,
              "The sensor under the middle finger's support shows another direction (%1 N up, %2 "
              "N toward the wrist, %3 N in): it is turned."_text)(
               newtons(force_N.x()), newtons(-distal_sign(step.finger, step.hand) * force_N.y()),
               newtons(force_N.z())),
           "Correct quaternion_wxyz in the device file."_text});
    case CheckVerdict::wrong_scale:
      return joined(
          {of(asked, "The sensor under the thumb's support shows %1 N for a weight of %2 N."_text,
              "The sensor under the index finger's support shows %1 N for a weight of %2 N."_text,
              "The sensor under the middle finger's support shows %1 N for a weight of %2 N."_text)(
               newtons(force_N.z()), newtons(expected_N)),
           "Do not measure with it: have it calibrated."_text});
    case CheckVerdict::nothing_felt:
      return joined(
          {"No sensor felt a press."_text,
           of(asked, "Press the thumb's support more firmly, or check its cable."_text,
              "Press the index finger's support more firmly, or check its cable."_text,
              "Press the middle finger's support more firmly, or check its cable."_text)});
  }
  return {};
}

DeviceCheck::DeviceCheck(double frame_period_s, Hand hand, std::optional<double> weight_N,
                         const CheckLimits& limits)
    : period_s_(frame_period_s), weight_N_(weight_N.value_or(0.0)), limits_(limits) {
  for (const Finger finger : kFingers) {
    for (const Press press : {Press::into, Press::up, Press::toward_wrist})
      steps_.push_back({finger, press, hand});
    if (weight_N) steps_.push_back({finger, Press::weight, hand});
  }
  zero_.fill(Vec3::Zero());
  sum_.fill(Vec3::Zero());
}

bool DeviceCheck::add_empty(const FingerFrame& frame) {
  const auto needed = static_cast<int>(std::ceil(kEmpty_s / period_s_));
  if (empty_frames_ >= needed) return true;
  if (frame.any(SampleFlag::missing)) return false;
  ++empty_frames_;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    zero_[f] += (frame.wrench_C[f].force - zero_[f]) / empty_frames_;
  return empty_frames_ >= needed;
}

std::optional<CheckResult> DeviceCheck::add(const FingerFrame& frame) {
  double largest_N = 0.0;
  std::array<Vec3, kFingerCount> force;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    force[f] = has_value(frame, f) ? Vec3(frame.wrench_C[f].force - zero_[f]) : Vec3::Zero();
    largest_N = std::max(largest_N, force[f].norm());
  }
  if (!released_) {
    released_ = largest_N < kLetGo * limits_.least_N;
    return std::nullopt;
  }
  ++waited_frames_;
  // A light reference weight has to be felt too.
  const double least_N =
      step().press == Press::weight ? std::min(limits_.least_N, weight_N_ / 2.0) : limits_.least_N;
  if (largest_N >= least_N) {
    ++pressed_frames_;
    for (std::size_t f = 0; f < kFingerCount; ++f) sum_[f] += force[f];
  } else {
    pressed_frames_ = 0;
    sum_.fill(Vec3::Zero());
  }
  const bool held = pressed_frames_ * period_s_ >= limits_.hold_s;
  if (!held && waited_frames_ * period_s_ < limits_.patience_s) return std::nullopt;
  results_.push_back(judge());
  ++next_;
  released_ = false;
  pressed_frames_ = waited_frames_ = 0;
  sum_.fill(Vec3::Zero());
  return results_.back();
}

CheckResult DeviceCheck::judge() const {
  CheckResult result;
  result.step = step();
  result.expected_N = step().press == Press::weight ? weight_N_ : 0.0;
  if (pressed_frames_ == 0) return result;
  std::size_t most = 0;
  for (std::size_t f = 1; f < kFingerCount; ++f)
    if (sum_[f].norm() > sum_[most].norm()) most = f;
  result.felt_by = kFingers[most];
  result.force_N = sum_[most] / pressed_frames_;
  const double along = result.force_N.dot(direction_of(step()));
  const double share = along / result.force_N.norm();
  if (result.felt_by != step().finger)
    result.verdict = CheckVerdict::other_finger;
  else if (share <= -limits_.share_of_axis)
    result.verdict = CheckVerdict::wrong_sign;
  else if (share < limits_.share_of_axis)
    result.verdict = CheckVerdict::wrong_axis;
  else if (step().press == Press::weight &&
           std::abs(along - weight_N_) > limits_.scale_tolerance * weight_N_)
    result.verdict = CheckVerdict::wrong_scale;
  else
    result.verdict = CheckVerdict::good;
  return result;
}

bool DeviceCheck::passed() const noexcept {
  return complete() && std::all_of(results_.begin(), results_.end(), [](const CheckResult& r) {
           return r.verdict == CheckVerdict::good;
         });
}

}  // namespace isograsp
