// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/tables/event_csv.hpp"

#include <array>

#include "core/csv.hpp"
#include "core/tables/word_table.hpp"

namespace isograsp {

namespace {

void append_optional(std::string& text, const std::optional<double>& value) {
  text += ',';
  append_number(text, value.value_or(kMissing));
}

/// The pose of a reference from seven numbers.
Result<Pose> reference_at(const WordTable& table, const std::array<std::size_t, 7>& columns) {
  std::array<double, 7> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto value = table.required_number(columns[k]);
    if (!value) return value.error();
    values[k] = *value;
  }
  const auto q = unit_quaternion(values[3], values[4], values[5], values[6]);
  if (!q)
    return table.error_here("ref_qw", "is no attitude"_text,
                            "write a quaternion w, x, y, z that is not zero"_text);
  return Pose{{values[0], values[1], values[2]}, *q};
}

}  // namespace

Result<void> write_pose_events(const std::string& path, const PoseTask& task,
                               std::span<const PoseEvent> events) {
  std::string text = "posture,cue_s,enter_s,done_s,time_s,position_error_m,angle_error_rad\n";
  for (const PoseEvent& event : events) {
    text += csv_field(task.references[event.reference].name);
    for (const auto& value :
         {std::optional(event.cue_s), event.enter_s, std::optional(event.done_s), event.time_s,
          event.position_error_m, event.angle_error_rad})
      append_optional(text, value);
    text += '\n';
  }
  return write_text(path, text);
}

Result<std::vector<PoseTarget>> read_pose_targets(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  constexpr std::array<const char*, 10> kNames{"posture", "cue_s",   "matched_s", "ref_x_m",
                                               "ref_y_m", "ref_z_m", "ref_qw",    "ref_qx",
                                               "ref_qy",  "ref_qz"};
  std::array<std::size_t, kNames.size()> columns{};
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    const auto at = table->require(kNames[k]);
    if (!at) return at.error();
    columns[k] = *at;
  }
  std::array<std::size_t, 7> reference{};
  for (std::size_t k = 0; k < reference.size(); ++k) reference[k] = columns[k + 3];
  std::vector<PoseTarget> targets;
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) break;
    PoseTarget target;
    target.posture = table->word(columns[0]);
    const auto cue_s = table->required_number(columns[1]);
    if (!cue_s) return cue_s.error();
    const auto matched_s = table->number(columns[2]);
    if (!matched_s) return matched_s.error();
    const auto X_WR = reference_at(*table, reference);
    if (!X_WR) return X_WR.error();
    target.cue_s = *cue_s;
    target.matched_s = *matched_s;
    target.X_WR = *X_WR;
    if (target.matched_s && *target.matched_s < target.cue_s)
      return table->error_here("matched_s", "is before the cue"_text, "correct the times"_text);
    targets.push_back(std::move(target));
  }
  return targets;
}

Result<void> write_bands(const std::string& path, std::span<const BandPoint> band) {
  std::string text = "posture,channel,tau,n,mean,sd\n";
  for (const BandPoint& point : band) {
    text += csv_field(point.posture) + "," + csv_field(point.channel) + "," +
            format_number(point.tau) + "," + std::to_string(point.n) + "," +
            format_number(point.mean);
    append_optional(text, point.sd);
    text += '\n';
  }
  return write_text(path, text);
}

}  // namespace isograsp
