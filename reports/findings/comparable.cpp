// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/comparable.hpp"

#include <algorithm>
#include <cmath>

#include "core/ties.hpp"
#include "core/time.hpp"
#include "hand/platform_records.hpp"

namespace isograsp::reports {

namespace {

VisualGain gain_of(const storage::References& references) {
  return {storage::value_of(references, platform::kVisualGain_deg_per_N),
          storage::value_of(references, platform::kMaximumForce_N)};
}

constexpr std::string_view kRigFormat = "isograsp-rig-1";
constexpr std::string_view kPosturesHash = "postures_hash = ";

/// The line of a pose task that says which postures it was made from; empty: none does.
std::string postures_line(std::string_view pose_task) {
  const std::size_t begin = pose_task.find(kPosturesHash);
  if (begin == std::string_view::npos) return "";
  return std::string(pose_task.substr(begin, pose_task.find('\n', begin) - begin));
}

Text difference(const ArmConditions& a, const ArmConditions& b) {
  if (a.rig != b.rig) return "other rig of markers"_text;
  if (a.cameras != b.cameras) return "other system of cameras"_text;
  if (a.postures != b.postures) return "other postures"_text;
  return {};
}

}  // namespace

std::optional<ArmConditions> arm_conditions(const StoredTrial& trial) {
  const storage::SessionRecord& session = *trial.session_record;
  if (session.calibration.find(kRigFormat) == std::string::npos) return std::nullopt;
  const std::string_view uri = session.device_uri;
  const std::size_t scheme = uri.find("://");
  return ArmConditions{
      session.calibration,
      std::string(scheme == std::string_view::npos ? "" : uri.substr(0, scheme + 3)),
      postures_line(trial.trial.scene_text)};
}

Source source_of(const storage::SessionRecord& session) {
  if (session.simulated) return Source::simulated;
  return session.recorded ? Source::recorded : Source::device;
}

bool same_gain(const VisualGain& a, const VisualGain& b) {
  if (!a.deg_per_N || !b.deg_per_N) return a.deg_per_N == b.deg_per_N;
  constexpr double kVisible = 0.01;  // relative: a pixel in a hundred
  const auto alike = [](double x, double y) {
    return std::abs(x - y) <= kVisible * std::max(std::abs(x), std::abs(y));
  };
  return alike(*a.deg_per_N, *b.deg_per_N) || alike(*a.deg_per_N * a.maximum_force_N.value_or(0.0),
                                                    *b.deg_per_N * b.maximum_force_N.value_or(0.0));
}

Conditions conditions_of(const StoredTrial& trial) {
  const storage::SessionRecord& session = *trial.session_record;
  return {session.rate_Hz, session.device_delay_s, session.display_delay_s,
          gain_of(trial.trial.references)};
}

Conditions conditions_of(const storage::PooledValue& value) {
  return {value.rate_Hz, value.device_delay_s, value.display_delay_s, gain_of(value.references)};
}

Text difference(const Conditions& a, const Conditions& b) {
  if (!are_tied(a.device_delay_s, b.device_delay_s)) return "other filter delay of the device"_text;
  const bool same_display = a.display_delay_s && b.display_delay_s
                                ? are_tied(*a.display_delay_s, *b.display_delay_s)
                                : a.display_delay_s == b.display_delay_s;
  if (!same_display) return "other delay of the display"_text;
  if (!are_tied(a.rate_Hz, b.rate_Hz)) return "other frame rate"_text;
  if (!same_gain(a.gain, b.gain)) return "other visual gain"_text;
  return {};
}

Text difference(const StoredTrial& a, const StoredTrial& b) {
  if (source_of(*a.session_record) != source_of(*b.session_record))
    return "other source of forces"_text;
  if (a.trial.task_version != b.trial.task_version) return "other version of the task"_text;
  if (a.trial.task_text != b.trial.task_text) return "other task parameters"_text;
  const auto arm_of_a = arm_conditions(a);
  const auto arm_of_b = arm_conditions(b);
  if (arm_of_a && arm_of_b) {
    if (auto why = difference(*arm_of_a, *arm_of_b); !why.empty()) return why;
  } else if (a.trial.scene_text != b.trial.scene_text) {
    return "other object or scene"_text;
  }
  return difference(conditions_of(a), conditions_of(b));
}

storage::PoolQuery pool_query(const StoredTrial& like, const MeasureSeries& measure) {
  storage::PoolQuery query{like.trial.task_name,
                           like.trial.task_version,
                           like.trial.task_text,
                           like.trial.scene_text,
                           measure.name,
                           measure.channel,
                           measure.unit,
                           measure.version,
                           like.session_record->simulated,
                           like.session_record->recorded};
  if (auto arm = arm_conditions(like)) {
    query.scene_text = arm->postures;
    query.calibration = std::move(arm->rig);
    query.uri_begins = std::move(arm->cameras);
  }
  return query;
}

double DayCounter::day_of(const std::string& started_utc) {
  const auto started = time_of_utc(started_utc);
  if (started && !first_) first_ = day_ = *started;
  if (!first_) return 0.0;
  constexpr double kSecondsPerHour = 3600.0;
  if (started && std::difftime(*started, day_) >= kDayLength_h * kSecondsPerHour) day_ = *started;
  return std::difftime(day_, *first_) / (24.0 * kSecondsPerHour);
}

bool counts(const storage::TrialRecord& trial) {
  return trial.status == storage::TrialStatus::completed && !trial.practice && !trial.helped;
}

}  // namespace isograsp::reports
