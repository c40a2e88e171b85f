// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/start_posture.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::session {

namespace {

/// Pose of `child` in `parent`; "elbow_x_m" of the first.
void add_columns(std::vector<std::string>& columns, const std::string& name) {
  for (const std::string_view axis : columns::kXyz)
    columns.push_back(name + "_" + std::string(axis) + "_m");
  for (const std::string_view part : columns::kWxyz)
    columns.push_back(name + "_q" + std::string(part));
}

void add_values(std::vector<double>& values, const Pose& X) {
  for (const double value : {X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()})
    values.push_back(value);
}

}  // namespace

StartPostureCapture::StartPostureCapture(double period_s, double settle_s)
    : period_s_(period_s), wait_s_(settle_s) {}

bool StartPostureCapture::add(std::span<const Pose> X_W) noexcept {
  if (wait_s_ > 0.0) {
    wait_s_ -= period_s_;
    return false;
  }
  constexpr StartPostureLimits kLimits;
  mean_.add(X_W);
  waited_s_ += period_s_;
  if (static_cast<double>(mean_.rows()) * period_s_ >= kLimits.duration_s - kMarkerTimeSlack_s) {
    if (!(mean_.largest_sd_m() <= kLimits.largest_sd_m)) refusal_ = Refusal::moved;
    return true;
  }
  if (waited_s_ < kLimits.longest_s) return false;
  refusal_ = Refusal::not_seen;
  return true;
}

double StartPostureCapture::progress() const noexcept {
  constexpr StartPostureLimits kLimits;
  return std::min(1.0, static_cast<double>(mean_.rows()) * period_s_ / kLimits.duration_s);
}

PreparationOutcome StartPostureCapture::outcome() const {
  PreparationOutcome outcome;
  outcome.name = "start posture";
  outcome.accepted = refusal_ == Refusal::none;
  if (refusal_ == Refusal::not_seen)
    outcome.reason =
        "elbow, forearm, hand and object were not seen together: turn them towards the cameras"_text;
  if (refusal_ == Refusal::moved)
    outcome.reason = "the arm moved: hold it still in the start posture"_text;
  storage::PreparationRecord& record = outcome.record;
  record.kind = kStartPosture;
  record.samples = static_cast<std::int64_t>(mean_.rows());
  if (!outcome.accepted) return outcome;
  const StartPosture start = mean_.mean();
  add_columns(record.columns, std::string(kArmSegmentNames[index_of(kArmChain[0])]));
  add_values(record.mean, start.X_W);
  for (std::size_t link = 0; link < start.X_L.size(); ++link) {
    add_columns(record.columns, std::string(kArmSegmentNames[index_of(kArmChain[link + 1])]) +
                                    "_in_" +
                                    std::string(kArmSegmentNames[index_of(kArmChain[link])]));
    add_values(record.mean, start.X_L[link]);
  }
  record.sd.assign(record.mean.size(), std::nan(""));
  record.references.emplace("largest_sd_m", mean_.largest_sd_m());
  return outcome;
}

}  // namespace isograsp::session
