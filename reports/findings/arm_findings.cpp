// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/arm_findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "hand/arm_columns.hpp"
#include "kinematics/measures/compensation.hpp"
#include "kinematics/pose_series.hpp"
#include "reports/findings/wording.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"
#include "tasks/task_progress.hpp"

namespace isograsp::reports {

namespace {

const tasks::PoseMatchingSpec* matching_of(const TaskSection& section) {
  return section.spec ? section.spec->kind.get_if<tasks::PoseMatchingSpec>() : nullptr;
}

/// How targets with one posture went. Times that did not come are infinite.
struct OfPosture {
  std::string name;
  std::vector<double> times_s;
  int reached = 0;
};

std::vector<OfPosture> by_posture(const tasks::PoseMatchingSpec& spec,
                                  const std::vector<const StoredTrial*>& trials) {
  std::vector<OfPosture> all;
  for (std::size_t target = 0; target < spec.targets(); ++target) {
    const std::string& name = spec.sequence[target % spec.sequence.size()];
    auto posture = std::find_if(all.begin(), all.end(),
                                [&](const OfPosture& one) { return one.name == name; });
    if (posture == all.end()) posture = all.insert(all.end(), {name, {}, 0});
    const std::string channel = "target_" + std::to_string(target + 1);
    for (const StoredTrial* trial : trials)
      for (const Measure& measure : trial->measures) {
        if (measure.name != "completion_time" || measure.channel != channel) continue;
        posture->times_s.push_back(measure.value.value_or(std::numeric_limits<double>::infinity()));
        posture->reached += measure.value ? 1 : 0;
      }
  }
  return all;
}

/// @pre the middle one, or both, are finite
double middle_of(std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  return 0.5 * (times_s[(times_s.size() - 1) / 2] + times_s[times_s.size() / 2]);
}

Text line_of(const OfPosture& posture, double time_limit_s) {
  const int asked = static_cast<int>(posture.times_s.size());
  // Of an even number the median is between two times: both must have come.
  if (posture.reached < asked / 2 + 1)
    return "%1: reached %2 of %3, median longer than %4 s"_text(
        Known{posture.name}, posture.reached, asked, fixed(time_limit_s, 0));
  return "%1: reached %2 of %3, median %4 s"_text(Known{posture.name}, posture.reached, asked,
                                                  fixed(middle_of(posture.times_s), 1));
}

constexpr std::array<Words, kArmLinkCount> kLinkWords{"forearm"_text, "wrist"_text, "fingers"_text};

std::optional<double> value_in(const std::vector<Measure>& measures, std::string_view name,
                               std::string_view channel) {
  for (const Measure& measure : measures)
    if (measure.name == name && measure.channel == channel) return measure.value;
  return std::nullopt;
}

/// Poses of a segment, row by row; missing where a field is empty. Nothing: it was not recorded.
std::optional<std::vector<Pose>> poses_of_segment(const Signals& curves, ArmSegment segment) {
  const columns::OfSegment& names = columns::segment_pose[index_of(segment)];
  std::array<std::span<const double>, 7> values;
  for (std::size_t a = 0; a < 3; ++a) values[a] = curves.column(names.position[a]);
  for (std::size_t i = 0; i < 4; ++i) values[3 + i] = curves.column(names.attitude[i]);
  for (const auto& column : values)
    if (column.empty()) return std::nullopt;
  std::vector<Pose> poses(curves.rows(), missing_pose());
  for (std::size_t row = 0; row < poses.size(); ++row)
    if (std::none_of(values.begin(), values.end(),
                     [row](const auto& column) { return std::isnan(column[row]); }))
      poses[row] = {{values[0][row], values[1][row], values[2][row]},
                    Quat(values[3][row], values[4][row], values[5][row], values[6][row])};
  return poses;
}

PoseSeries series_of(const Signals& curves) {
  PoseSeries series;
  const auto t_s = curves.column(columns::t_s);
  series.t_s.assign(t_s.begin(), t_s.end());
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    if (auto poses = poses_of_segment(curves, static_cast<ArmSegment>(s))) {
      series.frames.emplace_back(kArmSegmentNames[s]);
      series.X_W.push_back(*std::move(poses));
    }
  return series;
}

/// From the cue of each target to the row that reached it.
std::vector<PoseTarget> movements_of(const Signals& curves, std::size_t targets) {
  std::vector<PoseTarget> movements;
  const auto t_s = curves.column(columns::t_s);
  const auto phase = curves.column(columns::phase);
  const auto index = curves.column(columns::target_index);
  const auto matched = curves.column(columns::matched);
  if (index.empty() || matched.empty() || phase.empty()) return movements;
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    if (phase[row] == static_cast<double>(tasks::Phase::paused)) continue;
    if (movements.size() < targets && index[row] == static_cast<double>(movements.size()))
      movements.push_back({"", t_s[row], std::nullopt, Pose{}});
    if (!movements.empty() && matched[row] == 1.0 && !movements.back().matched_s &&
        index[row] == static_cast<double>(movements.size() - 1))
      movements.back().matched_s = t_s[row];
  }
  return movements;
}

}  // namespace

std::vector<Text> posture_lines(const TaskSection& section,
                                const std::vector<const StoredTrial*>& compared) {
  std::vector<Text> lines;
  const auto* const spec = matching_of(section);
  if (spec == nullptr) return lines;
  constexpr double kMillimetres = 1000.0;
  constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;
  lines.push_back("Tolerance %1 mm and %2°, held for %3 s"_text(
      fixed(kMillimetres * spec->position_tolerance_m, 0),
      fixed(kDegreesPerRadian * spec->angle_tolerance_rad, 0), fixed(spec->hold_s, 1)));
  for (const OfPosture& posture : by_posture(*spec, compared))
    if (!posture.times_s.empty()) lines.push_back(line_of(posture, spec->time_limit_s));
  return lines;
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
      began.emplace_back(*t10, kLinkWords[link]);
    if (const auto share = value_in(measures, "relative_rotation", channel))
      shares.push_back("%1 %2"_text(kLinkWords[link], percent_words(*share)));
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
  const auto* const spec = matching_of(section);
  if (spec == nullptr || !section.last || !section.last->problem.empty()) return lines;
  const Signals& curves = section.last->curves;
  const PoseSeries series = series_of(curves);
  const auto names = [&](ArmSegment segment) -> std::optional<std::string> {
    const std::string name(kArmSegmentNames[index_of(segment)]);
    return series.frame(name) ? std::optional(name) : std::nullopt;
  };
  if (!names(ArmSegment::trunk)) lines.emplace_back("Trunk not measured"_text);
  Rig rig;
  rig.score = RigScore{"forearm",
                       "object",
                       "object",
                       std::nullopt,
                       names(ArmSegment::brace),
                       names(ArmSegment::elbow)};
  const auto movements = movement_compensation(rig, series, movements_of(curves, spec->targets()));
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
        "Upper arm moved in %1 of %2 movements of the last trial: the turn of the forearm contains its own"_text(
            upper_arm, measured));
  if (device)
    lines.emplace_back(
        "The brace moved in the last trial: set it up anew, these results are in doubt"_text);
  return lines;
}

}  // namespace isograsp::reports
