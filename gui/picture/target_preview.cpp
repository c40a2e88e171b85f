// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/target_preview.hpp"

#include <algorithm>
#include <cmath>

#include "tasks/timeline.hpp"

namespace isograsp::gui {

namespace {

/// Part of the axis at each end that is left for forces beyond the targets.
constexpr double kEnd = 0.22;
/// The same below zero where no target is: pulling hardly matters there.
constexpr double kLowEnd = 0.08;

bool shows_target(const tasks::Segment& segment) {
  return segment.target_shown && !segment.target_N.empty();
}

void append_targets(const tasks::Segment& segment, std::vector<double>& target_N) {
  const auto frames = static_cast<std::size_t>(segment.frames);
  if (!shows_target(segment))
    target_N.insert(target_N.end(), frames, tasks::kNotMeasured);
  else if (segment.target_N.size() == 1)
    target_N.insert(target_N.end(), frames, segment.target_N.front());
  else
    target_N.insert(target_N.end(), segment.target_N.begin(), segment.target_N.end());
}

/// A task of both hands has no timeline that says what it asks of them: it is played.
TargetPreview::Hands hands_of(const tasks::TaskSpec& spec, const tasks::TaskContext& context) {
  TargetPreview::Hands hands;
  const auto task = tasks::make_task(spec, context);
  if (!task) return hands;
  const tasks::TwoHandsInput nothing_pressed;
  for (tasks::TaskView view = (*task)->step(nothing_pressed); view.phase != tasks::Phase::done;
       view = (*task)->step(nothing_pressed)) {
    const tasks::TwoHandsView& asked = view.two_hands();
    hands.most_sum_N = std::max(hands.most_sum_N, asked.target_sum_N.value_or(0.0));
    hands.cues.resize(static_cast<std::size_t>(view.segment) + 1);
    for (const Hand hand : kBothHands) {
      hands.most_N[hand] = std::max(hands.most_N[hand], asked.of[hand].target_N.value_or(0.0));
      hands.cues.back()[hand] = asked.of[hand].cue;
    }
  }
  return hands;
}

}  // namespace

double ForceAxis::share_per_N() const noexcept {
  const double low = least_N < 0.0 ? kEnd : kLowEnd;
  return (1.0 - kEnd - low) / (most_N - least_N);
}

double ForceAxis::share(double force_N) const noexcept {
  const double low = least_N < 0.0 ? kEnd : kLowEnd;
  const double per_N = share_per_N();
  // x / (1 + x / end) begins with slope one and approaches `end`.
  const auto beyond = [](double x, double end) { return x / (1.0 + x / end); };
  if (force_N > most_N) return 1.0 - kEnd + beyond((force_N - most_N) * per_N, kEnd);
  if (force_N < least_N) return low - beyond((least_N - force_N) * per_N, low);
  return low + (force_N - least_N) * per_N;
}

std::optional<double> TargetPreview::at(double task_time_s, double now_s) const noexcept {
  // Times come from frames over a period: a billionth of a second is rounding.
  constexpr double kRounding_s = 1e-9;
  const double end_s = period_s * (static_cast<double>(target_N.size()) - 1.0);
  if (target_N.empty() || task_time_s > now_s + ahead_s + kRounding_s) return std::nullopt;
  if (task_time_s < -kRounding_s || task_time_s > end_s + kRounding_s) return std::nullopt;
  const double place = std::clamp(task_time_s / period_s, 0.0, end_s / period_s);
  const auto before = static_cast<std::size_t>(place);
  const auto after = std::min(before + 1, target_N.size() - 1);
  const double share = place - std::floor(place);
  const double value = std::isnan(target_N[after]) && share < 0.5
                           ? target_N[before]
                           : std::lerp(target_N[before], target_N[after], share);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

const TargetPreview::Part* TargetPreview::next_effort(int segment) const noexcept {
  for (auto k = static_cast<std::size_t>(segment + 1); k < parts.size(); ++k)
    if (parts[k].cue != Cue::relax) return &parts[k];
  return nullptr;
}

TargetPreview preview_target(const tasks::TaskSpec& spec, const tasks::TaskContext& context) {
  TargetPreview preview;
  preview.period_s = context.period_s;
  if (!spec.scene().empty()) return preview;
  if (spec.kind->group == tasks::TaskGroup::two_hands) {
    preview.hands = hands_of(spec, context);
    return preview;
  }
  const auto timeline = tasks::timeline_of(spec, context);
  if (!timeline) return preview;
  const tasks::Aim* aim = spec.aim();
  if (aim != nullptr && !spec.kind->unforeseen_waits) preview.ahead_s = aim->preview_s;
  if (aim != nullptr && aim->gain_deg)
    if (const auto unit = context.references.unit_N(aim->scale, aim->channel, spec.largest_level()))
      preview.gain_deg_per_N = *aim->gain_deg / *unit;
  preview.axis = {0.0, 0.0};
  for (const tasks::Segment& segment : timeline->segments) {
    preview.parts.push_back({segment.cue, segment.channel, segment.target_N.size() == 1});
    for (const double value : segment.target_N) {
      preview.axis.least_N = std::min(preview.axis.least_N, value);
      preview.axis.most_N = std::max(preview.axis.most_N, value);
    }
    for (std::size_t f = 0; f < kFingerCount; ++f)
      if (segment.digits.shown[f])
        preview.digits_N = std::max(preview.digits_N, segment.digits.force_C[f].norm());
    if (preview.ahead_s > 0.0) append_targets(segment, preview.target_N);
  }
  return preview;
}

}  // namespace isograsp::gui
