// SPDX-License-Identifier: GPL-3.0-or-later
// Instrument zero: one second of the empty device, accepted only if it is quiet.
// Contact frames, SI units.
#pragma once

#include <array>
#include <optional>

#include "core/text.hpp"
#include "hand/platform_records.hpp"
#include "hand/stale.hpp"

namespace isograsp::session {

/// Limits of an acceptable zero. A resting hand shows a slow drift and a tremor well above them.
struct ZeroLimits {
  double duration_s = 1.0;
  double force_sd_N = 0.2;       ///< 2.5 LSB of the axial force of the paper's sensor
  double torque_sd_Nm = 0.01;    ///< 5 LSB of the torque
  double force_slope_N_s = 0.3;  ///< of the straight line through the second
  double force_offset_N = 30.0;  ///< 10 % of the axial range: an intact empty sensor is inside
  double force_change_N = 2.0;   ///< band round the last empty zero of this device
  double force_drift_N = 0.4;    ///< between two zeros of a session: half a contact threshold
};

/// Largest force component by which two zeros differ [N]. Real-time safe.
[[nodiscard]] double largest_force_change_N(const SixAxes& a, const SixAxes& b) noexcept;

/// Collects frames; add() is real-time safe.
class Zeroing {
 public:
  Zeroing() = default;
  explicit Zeroing(double period_s, const ZeroLimits& limits = {});

  /// Takes one frame, before zero. A frame with a missing finger is left out; a gap of more than
  /// 50 ms, or more than a tenth left out, make it start anew.
  void add(const FingerFrame& frame) noexcept;
  [[nodiscard]] bool complete() const noexcept { return count_ >= needed_; }
  /// 0 … 1
  [[nodiscard]] double progress() const noexcept;
  /// Too many frames came without a complete second. @pre !complete()
  [[nodiscard]] bool hopeless() const noexcept { return seen_ > kPatience * needed_; }

  struct Statistics {
    std::array<Vec6, kFingerCount> mean;
    std::array<Vec6, kFingerCount> sd;
    std::array<Vec6, kFingerCount> slope;  ///< per second
  };
  /// @pre complete()
  [[nodiscard]] Statistics statistics() const noexcept;

 private:
  static constexpr int kPatience = 5;  ///< times the duration before giving up on gaps
  static constexpr double kLargestShareLeftOut = 0.1;
  double period_s_ = 0.01;
  int needed_ = 100;
  int count_ = 0;
  int seen_ = 0;
  int left_out_ = 0;
  double gap_s_ = 0.0;
  std::array<Vec6, kFingerCount> first_;  ///< values are summed relative to these: no cancellation
  std::array<Vec6, kFingerCount> sum_;
  std::array<Vec6, kFingerCount> sum_squares_;
  std::array<Vec6, kFingerCount> sum_time_;
};

/// What is wrong with a zero; finger and numbers for the sentence.
struct ZeroRefusal {
  enum class Why : std::uint8_t { gaps, noisy_force, noisy_torque, drift, loaded, changed };
  Why why = Why::gaps;
  Finger finger = Finger::thumb;
  double found = 0.0;
  double limit = 0.0;
};

/// Whether this zero may be used. `last_mean`: the last accepted zero of the same device; nothing:
/// none is known, or somebody confirmed that the device was serviced or remounted. Real-time safe.
[[nodiscard]] std::optional<ZeroRefusal> check_zero(
    const Zeroing::Statistics& statistics,
    const std::optional<std::array<Vec6, kFingerCount>>& last_mean,
    const ZeroLimits& limits = {}) noexcept;

/// The reason and the remedy in words for the therapist.
[[nodiscard]] Text words_of(const ZeroRefusal& refusal);
/// "0.35": enough for people.
[[nodiscard]] Number two_digits(double value);

/// Whether the present zero can be used for a trial that is to begin.
enum class ZeroStanding : std::uint8_t {
  missing,
  outdated,  ///< a sensor started anew after it was measured: it is that of another sensor
  good
};
/// The rule for windows and unattended runs alike. `recorded`: the zero of recorded forces has been
/// subtracted already. `zeroed`, `restarted`: of the newest snapshot.
[[nodiscard]] constexpr ZeroStanding standing_of_zero(bool recorded, bool zeroed,
                                                      bool restarted) noexcept {
  if (recorded) return ZeroStanding::good;
  if (!zeroed) return ZeroStanding::missing;
  return restarted ? ZeroStanding::outdated : ZeroStanding::good;
}

}  // namespace isograsp::session
