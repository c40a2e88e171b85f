// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/zeroing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isograsp::session {

namespace {
Vec6 six(const Wrench& wrench) {
  Vec6 v;
  v << wrench.force, wrench.torque;
  return v;
}
}  // namespace

Zeroing::Zeroing(double period_s, const ZeroLimits& limits)
    : period_s_(period_s),
      needed_(std::max(2, static_cast<int>(std::lround(limits.duration_s / period_s)))) {}

void Zeroing::add(const FingerFrame& frame) noexcept {
  ++seen_;
  if (frame.any(SampleFlag::missing)) {
    // A lost sample now and then is left out; a longer gap, or too many, start the second anew.
    gap_s_ += period_s_;
    ++left_out_;
    if (gap_s_ > kLongestHold_s || left_out_ > kLargestShareLeftOut * needed_) count_ = 0;
    return;
  }
  gap_s_ = 0.0;
  if (count_ == 0) left_out_ = 0;
  if (complete()) return;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (count_ == 0) {
      first_[f] = six(frame.wrench_C[f]);
      sum_[f].setZero();
      sum_squares_[f].setZero();
      sum_time_[f].setZero();
    }
    const Vec6 d = six(frame.wrench_C[f]) - first_[f];
    sum_[f] += d;
    sum_squares_[f] += d.cwiseProduct(d);
    sum_time_[f] += d * static_cast<double>(count_);
  }
  ++count_;
}

double Zeroing::progress() const noexcept {
  return static_cast<double>(count_) / static_cast<double>(needed_);
}

Zeroing::Statistics Zeroing::statistics() const noexcept {
  Statistics s;
  const double n = count_;
  const double mean_index = (n - 1.0) / 2.0;
  const double index_squares = n * (n * n - 1.0) / 12.0;  // sum of (k - mean)^2, k = 0 … n-1
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Vec6 mean = sum_[f] / n;
    s.mean[f] = first_[f] + mean;
    const Vec6 variance = (sum_squares_[f] - n * mean.cwiseProduct(mean)) / (n - 1.0);
    s.sd[f] = variance.cwiseMax(0.0).cwiseSqrt();
    s.slope[f] = (sum_time_[f] - mean_index * sum_[f]) / index_squares / period_s_;
  }
  return s;
}

double largest_force_change_N(const SixAxes& a, const SixAxes& b) noexcept {
  double largest_N = 0.0;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    largest_N = std::max(largest_N, (a[f] - b[f]).head<3>().cwiseAbs().maxCoeff());
  return largest_N;
}

std::optional<ZeroRefusal> check_zero(
    const Zeroing::Statistics& statistics,
    const std::optional<std::array<Vec6, kFingerCount>>& last_mean,
    const ZeroLimits& limits) noexcept {
  using Why = ZeroRefusal::Why;
  for (const Finger finger : kFingers) {
    const std::size_t f = index_of(finger);
    const Vec6& mean = statistics.mean[f];
    const struct {
      Why why;
      double found;
      double limit;
    } checks[] = {
        {Why::noisy_force, statistics.sd[f].head<3>().maxCoeff(), limits.force_sd_N},
        {Why::noisy_torque, statistics.sd[f].tail<3>().maxCoeff(), limits.torque_sd_Nm},
        {Why::drift, statistics.slope[f].head<3>().cwiseAbs().maxCoeff(), limits.force_slope_N_s},
        {Why::loaded, mean.head<3>().cwiseAbs().maxCoeff(), limits.force_offset_N},
        {Why::changed, last_mean ? (mean - (*last_mean)[f]).head<3>().cwiseAbs().maxCoeff() : 0.0,
         limits.force_change_N}};
    for (const auto& check : checks)
      if (check.found > check.limit)
        return ZeroRefusal{check.why, finger, check.found, check.limit};
  }
  return std::nullopt;
}

Number two_digits(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2g", value);
  return {digits};
}

namespace {

Text fault_words(const ZeroRefusal& refusal) {
  using Why = ZeroRefusal::Why;
  static constexpr std::array kForce{"The thumb sensor is not quiet (%1 N, limit %2 N)."_text,
                                     "The index sensor is not quiet (%1 N, limit %2 N)."_text,
                                     "The middle sensor is not quiet (%1 N, limit %2 N)."_text};
  static constexpr std::array kTorque{"The thumb sensor is not quiet (%1 Nm, limit %2 Nm)."_text,
                                      "The index sensor is not quiet (%1 Nm, limit %2 Nm)."_text,
                                      "The middle sensor is not quiet (%1 Nm, limit %2 Nm)."_text};
  static constexpr std::array kDrift{"The thumb sensor drifts (%1 N/s, limit %2 N/s)."_text,
                                     "The index sensor drifts (%1 N/s, limit %2 N/s)."_text,
                                     "The middle sensor drifts (%1 N/s, limit %2 N/s)."_text};
  static constexpr std::array kLoad{"The thumb sensor is loaded (%1 N, limit %2 N)."_text,
                                    "The index sensor is loaded (%1 N, limit %2 N)."_text,
                                    "The middle sensor is loaded (%1 N, limit %2 N)."_text};
  static constexpr std::array kChange{
      "The thumb sensor differs from the last empty zero (%1 N, limit %2 N)."_text,
      "The index sensor differs from the last empty zero (%1 N, limit %2 N)."_text,
      "The middle sensor differs from the last empty zero (%1 N, limit %2 N)."_text};
  const auto& sentences = refusal.why == Why::noisy_force    ? kForce
                          : refusal.why == Why::noisy_torque ? kTorque
                          : refusal.why == Why::drift        ? kDrift
                          : refusal.why == Why::loaded       ? kLoad
                                                             : kChange;
  return sentences[index_of(refusal.finger)](two_digits(refusal.found), two_digits(refusal.limit));
}

}  // namespace

Text words_of(const ZeroRefusal& refusal) {
  using Why = ZeroRefusal::Why;
  switch (refusal.why) {
    case Why::gaps:
      return "Samples are missing: check the cables of the device, then set the zero again."_text;
    case Why::loaded:
      return joined({fault_words(refusal),
                     "Check that nothing leans on the finger support; if it is free, the sensor "
                     "may be damaged."_text});
    case Why::changed:
      return joined({fault_words(refusal),
                     "If nothing leans on the supports, the sensor may be damaged."_text,
                     "If the device was serviced or remounted since, confirm that."_text});
    case Why::noisy_force:
    case Why::noisy_torque:
    case Why::drift: break;
  }
  return joined({fault_words(refusal),
                 "Take the hand out, let nothing touch the device, and set the zero again."_text});
}

}  // namespace isograsp::session
