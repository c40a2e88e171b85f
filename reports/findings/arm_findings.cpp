// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/arm_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "hand/arm_columns.hpp"
#include "kinematics/measures/compensation.hpp"
#include "reports/findings/wording.hpp"
#include "statistics/percentile.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::reports {

namespace {

const tasks::PoseMatchingSpec* matching_of(const TaskSection& section) {
  return section.spec ? section.spec->kind.get_if<tasks::PoseMatchingSpec>() : nullptr;
}

/// A time that did not come is infinite. @pre not empty
std::optional<double> median_time(std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  // Of an even number the median is between two times: both must have come.
  const double middle = 0.5 * (times_s[(times_s.size() - 1) / 2] + times_s[times_s.size() / 2]);
  return std::isfinite(middle) ? std::optional(middle) : std::nullopt;
}

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> value_in(const std::vector<Measure>& measures, std::string_view name,
                               std::string_view channel) {
  for (const Measure& measure : measures)
    if (measure.name == name && measure.channel == channel) return measure.value;
  return std::nullopt;
}

}  // namespace

std::vector<PostureResult> posture_results(const TaskSection& section,
                                           const std::vector<const StoredTrial*>& compared) {
  std::vector<PostureResult> results;
  const auto* const spec = matching_of(section);
  if (spec == nullptr) return results;
  for (const std::string& name : spec->sequence)
    if (std::none_of(results.begin(), results.end(),
                     [&](const PostureResult& one) { return one.name == name; }))
      results.push_back({name, 0, 0, {}, {}, {}, {}, {}});
  for (PostureResult& result : results) {
    std::vector<double> times_s;
    for (std::size_t target = 0; target < spec->targets(); ++target) {
      if (spec->sequence[target % spec->sequence.size()] != result.name) continue;
      const std::string channel = "target_" + std::to_string(target + 1);
      for (const StoredTrial* trial : compared)
        for (const Measure& measure : trial->measures)
          if (measure.name == "completion_time" && measure.channel == channel)
            times_s.push_back(measure.value.value_or(std::numeric_limits<double>::infinity()));
    }
    result.asked = static_cast<int>(times_s.size());
    result.reached = static_cast<int>(
        std::count_if(times_s.begin(), times_s.end(), [](double t) { return std::isfinite(t); }));
    if (!times_s.empty()) result.median_s = median_time(std::move(times_s));
  }
  std::erase_if(results, [](const PostureResult& one) { return one.asked == 0; });
  return results;
}

void add_poses(TaskSection& section, const Signals& signals) {
  const auto* const spec = matching_of(section);
  if (spec == nullptr) return;
  tasks::PoseTrial trial = tasks::pose_trial(*spec, signals);
  if (!section.poses) section.poses.emplace();
  // Of a trial in which other segments were recorded the movements are not those of the others.
  if (!tasks::append(*section.poses, trial)) section.poses = std::move(trial);
}

void finish_postures(TaskSection& section) {
  const auto* const spec = matching_of(section);
  if (spec == nullptr || !section.poses) return;
  const tasks::PoseTrial& trial = *section.poses;
  for (PostureResult& result : section.postures) {
    std::vector<double> position_m, angle_rad, rotation_rad, unseen;
    for (std::size_t i = 0; i < trial.events.size(); ++i) {
      const PoseEvent& event = trial.events[i];
      if (spec->sequence[event.reference % spec->sequence.size()] != result.name) continue;
      unseen.push_back(trial.unseen[i]);
      if (event.position_error_m) position_m.push_back(*event.position_error_m);
      if (event.angle_error_rad) angle_rad.push_back(*event.angle_error_rad);
      if (!trial.unmeasured.empty()) continue;
      const std::size_t object = *trial.rig.link(trial.rig.score->sync);
      if (const Valued& turned = trial.movements.links[i][object].rotation; turned.value)
        rotation_rad.push_back(*turned.value);
    }
    result.position_error_m = mean_of(position_m);
    result.angle_error_rad = mean_of(angle_rad);
    if (!rotation_rad.empty()) result.rotation_rad = statistics::median(rotation_rad).value;
    result.unseen = mean_of(unseen);
  }
}

Text tolerance_words(const TaskSection& section) {
  const auto* const spec = matching_of(section);
  if (spec == nullptr) return {};
  constexpr double kMillimetres = 1000.0;
  constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
  return "Tolerance %1 mm and %2°, held for %3 s"_text(
      fixed(kMillimetres * spec->position_tolerance_m, 0),
      fixed(kDegreesPerRadian * spec->angle_tolerance_rad, 0), fixed(spec->hold_s, 1));
}

std::vector<Text> sharing_lines(const TaskSection& section,
                                const std::vector<const StoredTrial*>& compared) {
  std::vector<Text> lines;
  if (matching_of(section) == nullptr || compared.empty()) return lines;
  const std::vector<Measure>& measures = compared.back()->measures;
  const auto recognition = value_in(measures, "recognition_time", "object");
  const auto movement = value_in(measures, "movement_time", "object");
  if (recognition && movement)
    lines.push_back("Last trial: recognition %1 s, then movement %2 s"_text(fixed(*recognition, 1),
                                                                            fixed(*movement, 1)));
  std::vector<std::pair<double, Words>> began;
  std::vector<Text> shares;
  for (std::size_t link = 0; link < kArmLinkCount; ++link) {
    const std::string_view channel = kArmLinkNames[link];
    if (const auto t10 = value_in(measures, "rotation_t10", channel))
      began.emplace_back(*t10, link_words(static_cast<ArmLink>(link)));
    if (const auto share = value_in(measures, "relative_rotation", channel))
      shares.push_back("%1 %2"_text(link_words(static_cast<ArmLink>(link)), percent_words(*share)));
  }
  std::stable_sort(began.begin(), began.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Text> order;
  for (const auto& [t10_s, link] : began) order.push_back("%1 %2 s"_text(link, fixed(t10_s, 2)));
  if (order.size() > 1)
    lines.push_back(
        "Turned first to last (a tenth of the turn after the cue): %1"_text(listed(order)));
  if (shares.size() > 1)
    lines.push_back(
        "Share of the turn when the forearm had 63 % of its own: %1"_text(listed(shares)));
  return lines;
}

std::vector<Text> compensation_lines(const TaskSection& section) {
  std::vector<Text> lines;
  if (!section.poses) return lines;
  const tasks::PoseTrial& trial = *section.poses;
  if (!trial.rig.score) return lines;
  if (!trial.series.frame(kArmSegmentNames[index_of(ArmSegment::trunk)]))
    lines.emplace_back("Trunk not measured"_text);
  const auto movements = movement_compensation(trial.rig, trial.series, trial.movements.targets);
  if (!movements) return lines;
  int measured = 0;
  int upper_arm = 0;
  bool device = false;
  for (const MovementCompensation& one : *movements) {
    if (one.elbow_displacement.value) {
      ++measured;
      upper_arm += *one.elbow_displacement.value > kUpperArmMoved_m ? 1 : 0;
    }
    device = device || one.brace_displacement.value.value_or(0.0) > kDeviceMoved_m ||
             one.brace_rotation.value.value_or(0.0) > kDeviceMoved_rad;
  }
  if (upper_arm > 0)
    lines.push_back(
        "Upper arm moved in %1 of %2 movements of the last session: the turn of the forearm contains its own"_text(
            upper_arm, measured));
  if (device)
    lines.emplace_back(
        "The brace moved in the last session: set it up anew, these results are in doubt"_text);
  return lines;
}

}  // namespace isograsp::reports
