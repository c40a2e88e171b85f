// SPDX-License-Identifier: GPL-3.0-or-later
// The guided check of a device: the therapist presses each empty support as told (into it, up,
// toward the wrist, and a reference weight where there is one), and swapped sensors, wrong signs,
// turned axes and wrong scales show. Pure: frames in, words out. Contact frames, SI units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What the therapist is asked to do with one support.
enum class Press : std::uint8_t {
  into,          ///< along the normal: +z of the contact frame
  up,            ///< along +x of the contact frame: its tangent
  toward_wrist,  ///< along ±y: hand/anatomical_axes.hpp
  weight         ///< the reference weight, put on along +z
};
[[nodiscard]] std::string_view name_of(Press press) noexcept;

struct CheckStep {
  Finger finger = Finger::thumb;
  Press press = Press::into;
  Hand hand = Hand::right;  ///< for which the platform stands: it says where the wrist is

  /// What to do, for the therapist.
  [[nodiscard]] Text instruction() const;
};

enum class CheckVerdict : std::uint8_t {
  good,
  other_finger,  ///< another support felt it: sensors are swapped
  wrong_sign,    ///< felt in the opposite direction
  wrong_axis,    ///< felt along another axis: the mounting is turned
  wrong_scale,   ///< the weight weighs something else
  nothing_felt
};

struct CheckResult {
  CheckStep step;
  CheckVerdict verdict = CheckVerdict::nothing_felt;
  Finger felt_by = Finger::thumb;  ///< the support with the largest force
  Vec3 force_N = Vec3::Zero();     ///< that it felt, mean of the press
  double expected_N = 0.0;         ///< weight: what it should be

  /// One sentence for the therapist, with what to do.
  [[nodiscard]] Text sentence() const;
};

struct CheckLimits {
  double least_N = 3.0;        ///< smallest force of a press: above any noise and cable pull
  double hold_s = 0.5;         ///< shortest time of a press
  double patience_s = 30.0;    ///< longest wait for a press
  double share_of_axis = 0.8;  ///< cosine to the asked axis: within 37 degrees, as hands press
  double scale_tolerance = 0.05;
};

/// Takes one step after the other; between two presses all supports have to be let go.
class DeviceCheck {
 public:
  /// `hand`: for which the platform stands now. `weight_N`: of the reference weight; none: the
  /// steps with it are left out.
  DeviceCheck(double frame_period_s, Hand hand, std::optional<double> weight_N,
              const CheckLimits& limits = {});

  [[nodiscard]] bool complete() const noexcept { return next_ == steps_.size(); }
  /// @pre !complete()
  [[nodiscard]] const CheckStep& step() const noexcept { return steps_[next_]; }
  /// The device is empty and untouched now: what it shows is taken as zero. Call with every frame
  /// until it returns true.
  [[nodiscard]] bool add_empty(const FingerFrame& frame);
  /// A frame while the step is asked for; the result when the step is over. @pre !complete()
  [[nodiscard]] std::optional<CheckResult> add(const FingerFrame& frame);

  [[nodiscard]] const std::vector<CheckResult>& results() const noexcept { return results_; }
  [[nodiscard]] bool passed() const noexcept;

 private:
  [[nodiscard]] CheckResult judge() const;

  double period_s_;
  double weight_N_;
  CheckLimits limits_;
  std::vector<CheckStep> steps_;
  std::size_t next_ = 0;
  std::vector<CheckResult> results_;

  int empty_frames_ = 0;
  std::array<Vec3, kFingerCount> zero_;
  bool released_ = true;
  int pressed_frames_ = 0;
  int waited_frames_ = 0;
  std::array<Vec3, kFingerCount> sum_;
};

}  // namespace isograsp
