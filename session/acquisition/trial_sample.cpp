// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/trial_sample.hpp"

#include <functional>
#include <limits>

namespace isograsp::session {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct Column {
  std::string name;
  std::function<double(const TrialSample&)> value;
};
struct Group {
  std::string name;
  std::vector<Column> columns;
};

/// A noise of 0 means that no noise was measured.
double known(double value) {
  return value > 0.0 ? value : kMissing;
}

double number(bool yes) {
  return yes ? 1.0 : 0.0;
}

/// Rotation of an attitude about world z [rad], -pi … pi.
double angle_about_z(const Quat& q) {
  return 2.0 * std::atan2(q.z(), q.w());
}

/// Numbers of enumerations: docs/file_formats.md.
void add_force_task_columns(Group& group) {
  const auto add = [&group](std::string name, std::function<double(const TrialSample&)> value) {
    group.columns.push_back({std::move(name), std::move(value)});
  };
  add("segment", [](const auto& s) { return static_cast<double>(s.task.segment); });
  add("cue", [](const auto& s) { return static_cast<double>(s.task.cue); });
  add("channel_digits", [](const auto& s) { return static_cast<double>(s.task.channel.digits); });
  add("channel_direction",
      [](const auto& s) { return static_cast<double>(s.task.channel.direction); });
  add("force_shown", [](const auto& s) { return number(s.task.force_shown); });
  add("target_shown", [](const auto& s) { return number(s.task.force_target_shown); });
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (const int axis : {0, 1, 2})
      add("target_" + std::string(kFingerNames[f]) + "_f" + "xyz"[axis] + "_N",
          [f, axis](const auto& s) {
            const auto& target = s.task.digit_targets;
            return target.shown[f] ? target.force_C[f][axis] : kMissing;
          });
}

Group task_columns(bool has_object) {
  Group group{
      "task",
      {{"t_s", [](const auto& s) { return s.t_s; }},
       {"task_time_s", [](const auto& s) { return s.task.task_time_s; }},
       {"phase", [](const auto& s) { return static_cast<double>(s.task.phase); }},
       {"sample_flags",
        [](const auto& s) {
          const auto& f = s.forces.flags;
          return static_cast<double>(f[0] | f[1] | f[2]);
        }},
       {"target_force_N",
        [](const auto& s) { return s.task.has_force_target ? s.task.target_force_N : kMissing; }},
       {"actual_force_N", [](const auto& s) { return s.task.actual_force_N; }},
       {"resting_force_N", [](const auto& s) { return s.task.resting_force_N; }},
       {"maximum_force_N", [](const auto& s) { return s.task.maximum_force_N; }},
       {"noise_sd_N", [](const auto& s) { return known(s.task.noise_sd_N); }},
       {"resolution_N", [](const auto& s) { return s.constants.resolution_N; }},
       {"device_delay_s", [](const auto& s) { return s.constants.device_delay_s; }},
       {"display_delay_s", [](const auto& s) { return s.constants.display_delay_s; }}}};
  if (!has_object) {
    add_force_task_columns(group);
    return group;
  }
  for (const int axis : {0, 1, 2}) {
    const std::string name = std::string(1, "xyz"[axis]) + "_m";
    group.columns.push_back({"target_" + name, [axis](const auto& s) {
                               return s.task.pose_target_shown ? s.task.target.p_WO[axis]
                                                               : kMissing;
                             }});
    group.columns.push_back(
        {"actual_" + name, [axis](const auto& s) { return s.object.pose.p_WO[axis]; }});
  }
  group.columns.push_back({"target_angle_rad", [](const auto& s) {
                             return s.task.pose_target_shown ? angle_about_z(s.task.target.q_WO)
                                                             : kMissing;
                           }});
  group.columns.push_back({"actual_angle_rad", [](const auto& s) { return s.object.angle_rad; }});
  group.columns.push_back(
      {"target_index", [](const auto& s) { return static_cast<double>(s.task.target_index); }});
  group.columns.push_back({"targets_reached", [](const auto& s) {
                             return static_cast<double>(s.task.targets_reached);
                           }});
  group.columns.push_back(
      {"drops", [](const auto& s) { return static_cast<double>(s.task.drops); }});
  return group;
}

Group force_columns() {
  Group group{"force", {}};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (const int axis : {0, 1, 2, 3, 4, 5}) {
      const std::string part = axis < 3 ? "_f" : "_t";
      const std::string unit = axis < 3 ? "_N" : "_Nm";
      group.columns.push_back(
          {std::string(kFingerNames[f]) + part + "xyz"[axis % 3] + unit, [f, axis](const auto& s) {
             if (s.forces.flags[f] & bit(SampleFlag::missing)) return kMissing;
             const auto& w = s.forces.wrench_C[f];
             return axis < 3 ? w.force[axis] : w.torque[axis - 3];
           }});
    }
  for (std::size_t f = 0; f < kFingerCount; ++f)
    group.columns.push_back({std::string(kFingerNames[f]) + "_flags", [f](const auto& s) {
                               return static_cast<double>(s.forces.flags[f]);
                             }});
  for (const int axis : {0, 1, 2, 3, 4, 5}) {
    const bool force = axis < 3;
    group.columns.push_back(
        {std::string(force ? "net_f" : "net_t") + "xyz"[axis % 3] + (force ? "_N" : "_Nm"),
         [axis](const auto& s) {
           const auto& w = s.push.wrench_P;
           if (!s.push.known) return kMissing;
           return axis < 3 ? w.force[axis] : w.torque[axis - 3];
         }});
  }
  group.columns.push_back({"net_push_percent", [](const auto& s) {
                             return s.push.share_of_grip_percent.value_or(kMissing);
                           }});
  return group;
}

Group raw_columns() {
  Group group{"raw", {}};
  constexpr std::array<const char*, 6> kAxes{"fx", "fy", "fz", "tx", "ty", "tz"};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (std::size_t axis = 0; axis < 6; ++axis)
      group.columns.push_back(
          {std::string(kFingerNames[f]) + "_" + kAxes[axis] + "_counts",
           [f, axis](const auto& s) { return static_cast<double>(s.forces.raw_counts[f][axis]); }});
  return group;
}

Group object_columns() {
  Group group{"object", {}};
  const auto add = [&group](std::string name, std::function<double(const TrialSample&)> value) {
    group.columns.push_back({std::move(name), std::move(value)});
  };
  add("actual_qw", [](const auto& s) { return s.object.pose.q_WO.w(); });
  add("actual_qx", [](const auto& s) { return s.object.pose.q_WO.x(); });
  add("actual_qy", [](const auto& s) { return s.object.pose.q_WO.y(); });
  add("actual_qz", [](const auto& s) { return s.object.pose.q_WO.z(); });
  for (std::size_t i = 0; i < 4; ++i)
    add(std::string("target_q") + "wxyz"[i], [i](const auto& s) {
      const Quat& q = s.task.target.q_WO;
      return s.task.pose_target_shown ? std::array{q.w(), q.x(), q.y(), q.z()}[i] : kMissing;
    });
  for (const int axis : {0, 1, 2}) {
    const char letter = "xyz"[axis];
    add(std::string("v") + letter + "_mps",
        [axis](const auto& s) { return s.object.v_WO_W[axis]; });
    add(std::string("w") + letter + "_radps",
        [axis](const auto& s) { return s.object.w_WO_W[axis]; });
    add(std::string("f") + letter + "_N",
        [axis](const auto& s) { return s.grasp.F_O_W.force[axis]; });
    add(std::string("t") + letter + "_Nm",
        [axis](const auto& s) { return s.grasp.F_O_W.torque[axis]; });
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const std::string finger(kFingerNames[f]);
    add("contact_" + finger, [f](const auto& s) { return number(s.grasp.contact[f]); });
    add("slip_" + finger, [f](const auto& s) { return number(s.grasp.slip[f]); });
    add("utilisation_" + finger, [f](const auto& s) { return s.grasp.utilisation[f]; });
  }
  // Of the hold that ends at this sample.
  add("model_error_rad", [](const auto& s) { return s.object.error_rad; });
  add("model_inexact", [](const auto& s) { return number(s.object.tolerance_exceeded); });
  return group;
}

Group timing_columns() {
  return {"timing",
          {{"lateness_s", [](const auto& s) { return s.lateness_s; }},
           {"compute_s", [](const auto& s) { return s.compute_s; }}}};
}

const std::vector<Group>& table(bool has_object) {
  static const std::vector<Group> kForceTask{task_columns(false), force_columns(), raw_columns(),
                                             timing_columns()};
  static const std::vector<Group> kObjectTask{task_columns(true), force_columns(), raw_columns(),
                                              object_columns(), timing_columns()};
  return has_object ? kObjectTask : kForceTask;
}

}  // namespace

std::vector<storage::SignalGroup> signal_groups(bool has_object) {
  std::vector<storage::SignalGroup> groups;
  for (const auto& group : table(has_object)) {
    groups.push_back({group.name, {}});
    for (const auto& column : group.columns) groups.back().columns.push_back(column.name);
  }
  return groups;
}

void append_rows(const TrialSample& sample, bool has_object,
                 std::vector<std::vector<double>>& rows_of_group) {
  const auto& groups = table(has_object);
  rows_of_group.resize(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const auto& column : groups[g].columns) rows_of_group[g].push_back(column.value(sample));
}

}  // namespace isograsp::session
