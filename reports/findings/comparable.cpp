// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/comparable.hpp"

#include <algorithm>
#include <cmath>

#include "core/ties.hpp"
#include "core/time.hpp"
#include "hand/platform_records.hpp"
#include "kinematics/pose_task.hpp"

namespace isograsp::reports {

namespace {

VisualGain gain_of(const storage::References& references) {
  return {storage::value_of(references, platform::kVisualGain_deg_per_N),
          storage::value_of(references, platform::kMaximumForce_N)};
}

/// "qtm" of "qtm://HOST"; the rest says where, not what they are.
std::string cameras_of(const std::string& uri) {
  return uri.substr(0, uri.find("://"));
}

/// Cameras have a rig where sensors have their calibration.
bool is_of_an_arm(const storage::SessionRecord& session) {
  return session.calibration.find("isograsp-rig-1") != std::string::npos;
}

/// Of a session with a tracked hand: how it is seen; else nothing.
std::string tracker_of(const std::string& calibration) {
  return calibration.find("isograsp-tracker-1") == std::string::npos ? "" : calibration;
}

}  // namespace

std::string lasting_scene(const std::string& scene_text) {
  if (scene_text.empty()) return "";
  const auto references = parse_pose_task(scene_text, "");
  return references && !references->postures_hash.empty() ? references->postures_hash : scene_text;
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
  return {session.rate_Hz,
          session.device_delay_s,
          session.display_delay_s,
          gain_of(trial.trial.references),
          is_of_an_arm(session) ? ArmConditions{session.calibration, cameras_of(session.device_uri),
                                                lasting_scene(trial.trial.scene_text)}
                                : ArmConditions{},
          tracker_of(session.calibration)};
}

Conditions conditions_of(const storage::PooledValue& value) {
  return {value.rate_Hz,
          value.device_delay_s,
          value.display_delay_s,
          gain_of(value.references),
          ArmConditions{value.calibration, cameras_of(value.device_uri),
                        lasting_scene(value.scene_text)},
          tracker_of(value.calibration)};
}

Text difference(const Conditions& a, const Conditions& b) {
  if (!are_tied(a.device_delay_s, b.device_delay_s)) return "other filter delay of the device"_text;
  const bool same_display = a.display_delay_s && b.display_delay_s
                                ? are_tied(*a.display_delay_s, *b.display_delay_s)
                                : a.display_delay_s == b.display_delay_s;
  if (!same_display) return "other delay of the display"_text;
  if (!are_tied(a.rate_Hz, b.rate_Hz)) return "other frame rate"_text;
  if (!same_gain(a.gain, b.gain)) return "other visual gain"_text;
  if (a.arm.rig != b.arm.rig) return "other rig of markers"_text;
  if (a.arm.cameras != b.arm.cameras) return "other system of cameras"_text;
  if (a.arm.postures != b.arm.postures) return "other postures"_text;
  if (a.tracker != b.tracker) return "other tracker, mounting or delay"_text;
  return {};
}

Text difference(const StoredTrial& a, const StoredTrial& b) {
  if (source_of(*a.session_record) != source_of(*b.session_record))
    return "other source of forces"_text;
  if (a.trial.task_version != b.trial.task_version) return "other version of the task"_text;
  if (a.trial.task_text != b.trial.task_text) return "other task parameters"_text;
  const Conditions of_a = conditions_of(a);
  if (of_a.arm.rig.empty() && a.trial.scene_text != b.trial.scene_text)
    return "other object or scene"_text;
  return difference(of_a, conditions_of(b));
}

storage::PoolQuery pool_query(const StoredTrial& like, const MeasureSeries& measure) {
  const bool of_arm = !conditions_of(like).arm.rig.empty();
  return {like.trial.task_name,
          like.trial.task_version,
          like.trial.task_text,
          of_arm ? std::nullopt : std::optional(like.trial.scene_text),
          measure.name,
          measure.channel,
          measure.unit,
          measure.version,
          like.session_record->simulated,
          like.session_record->recorded};
}

double DayCounter::day_of(const std::string& started_utc) {
  const auto started = time_of_utc(started_utc);
  if (started && !first_) first_ = day_ = *started;
  if (!first_) return 0.0;
  constexpr double kSecondsPerHour = 3600.0;
  if (started && std::difftime(*started, day_) >= kDayLength_h * kSecondsPerHour) day_ = *started;
  return std::difftime(day_, *first_) / (24.0 * kSecondsPerHour);
}

bool is_own_work(const storage::TrialRecord& trial) {
  return trial.status == storage::TrialStatus::completed && !trial.helped;
}

bool counts(const storage::TrialRecord& trial) {
  return is_own_work(trial) && !trial.practice;
}

}  // namespace isograsp::reports
