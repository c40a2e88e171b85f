// SPDX-License-Identifier: GPL-3.0-or-later
// Which trials may be compared with each other: the rules that begin a new series.
#pragma once

#include <ctime>
#include <optional>
#include <string>

#include "core/text.hpp"
#include "reports/findings/measure_series.hpp"

namespace isograsp::reports {

[[nodiscard]] Source source_of(const storage::SessionRecord& session);

/// How large a force is drawn. Targets in newtons keep the degrees per newton, targets relative to
/// the maximum those per share of it: one of the two is equal. A gain that is not known equals none
/// that is known: otherwise two different ones would both be equal to it.
struct VisualGain {
  std::optional<double> deg_per_N;
  std::optional<double> maximum_force_N;
};
[[nodiscard]] bool same_gain(const VisualGain& a, const VisualGain& b);

/// What decides how an arm seen by markers is measured, beside its task. References are adapted to
/// the arm of each day: what they come from is compared, not they.
struct ArmConditions {
  std::string rig;       ///< its file; empty: forces were measured
  std::string cameras;   ///< how they are reached, "qtm": another system sees otherwise
  std::string postures;  ///< hash of their file; empty: the task shows no reference
  bool operator==(const ArmConditions&) const = default;
};

/// What of a trial's scene stays the same from day to day: of references that were adapted to an
/// arm the hash of the postures they come from, of everything else the scene itself.
[[nodiscard]] std::string lasting_scene(const std::string& scene_text);

/// What a trial was measured and shown with.
struct Conditions {
  double rate_Hz = 0.0;
  double device_delay_s = 0.0;
  std::optional<double> display_delay_s;  ///< lags are corrected by it; nothing: they are not
  VisualGain gain;
  ArmConditions arm;
  /// Of a tracked hand: tracker, version of its service, mounting, delay; empty: it is none.
  std::string tracker;
};
[[nodiscard]] Conditions conditions_of(const StoredTrial& trial);
[[nodiscard]] Conditions conditions_of(const storage::PooledValue& value);
/// Why values measured so must not be compared; empty: they may.
[[nodiscard]] Text difference(const Conditions& a, const Conditions& b);

/// Why two trials of one task and hand must not be compared; empty: they may.
[[nodiscard]] Text difference(const StoredTrial& a, const StoredTrial& b);

/// What values of other people must equal to be pooled with `measure` of a trial.
[[nodiscard]] storage::PoolQuery pool_query(const StoredTrial& like, const MeasureSeries& measure);

/// Days are told apart by the time between sessions, not by dates: a working day of the clinic can
/// have two dates in UTC, and where the clinic is, is not stored. A session that begins less than
/// this after the first one of a day belongs to that day; half of a day lies between the longest
/// working day and the shortest night.
inline constexpr double kDayLength_h = 12.0;
class DayCounter {
 public:
  /// From the first session to the first one of the day of this session [d]. Sessions come oldest
  /// first; one whose time cannot be read stands on the day before it.
  [[nodiscard]] double day_of(const std::string& started_utc);

 private:
  std::optional<std::time_t> first_;
  std::time_t day_ = 0;  ///< when the first session of the current day began
};

/// Completed and not helped, be it practice.
[[nodiscard]] bool is_own_work(const storage::TrialRecord& trial);
/// The trial is an assessment: completed, neither practice nor helped.
[[nodiscard]] bool counts(const storage::TrialRecord& trial);

}  // namespace isograsp::reports
