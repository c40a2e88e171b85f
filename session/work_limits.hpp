// SPDX-License-Identifier: GPL-3.0-or-later
// What one session may ask of a hand: half an hour of work, straps looked at where the skin does
// not feel them, and an end when force is lost. Deterministic, no clock.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/measure.hpp"
#include "core/text.hpp"

namespace isograsp::session {

inline constexpr double kMostWork_s = 30.0 * 60.0;             ///< of a session, rests left out
inline constexpr double kStrapsLookedAtEvery_s = 20.0 * 60.0;  ///< on skin without feeling
inline constexpr double kMostForceLost =
    0.2;  ///< of the session's best maximum in the same channel

class WorkLimits {
 public:
  /// A session begins. `numb_skin`: the screening says so.
  void begin(bool numb_skin);
  /// Strapped, or the straps were looked at, at that session time.
  void straps_seen(double session_time_s) { straps_s_ = session_time_s; }
  /// A trial of work has ended after so many seconds of recording, completed or not.
  void worked(double recorded_s) { work_s_ += recorded_s; }
  /// The measures of a trial, of which maxima count; none of one that does not count.
  void tried(std::span<const Measure> measures);
  /// The therapist helped in the last trial: its maximum does not count. False takes that back.
  void helped(bool helped);

  [[nodiscard]] bool straps_due(double session_time_s) const noexcept;
  /// Why work should end for today; nothing: it may go on. A maximum that comes back takes the loss
  /// of force back.
  [[nodiscard]] std::optional<Text> reason_to_stop() const;

 private:
  struct Maximum {
    double best_N = 0.0;
    double last_N = 0.0;
  };
  bool numb_skin_ = false;
  std::optional<double> straps_s_;
  double work_s_ = 0.0;
  using Maxima = std::map<std::string, Maximum>;  ///< by channel
  Maxima maxima_;
  Maxima without_last_;  ///< as if the last trial had not been; with it while helped_
  bool helped_ = false;
};

}  // namespace isograsp::session
