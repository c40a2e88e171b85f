// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/platform_row.hpp"

#include <cmath>
#include <limits>

#include "hand/columns.hpp"

namespace isograsp::session {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

template <class Sink>
void put_axes(Sink& sink, const columns::OfAxes& axes, const Vec3& value, bool known = true) {
  for (std::size_t a = 0; a < 3; ++a)
    sink.put(axes[a], known ? value[static_cast<Eigen::Index>(a)] : kMissing);
}

template <class Sink>
void put_attitude(Sink& sink, const columns::OfComponents& components, const Quat& q, bool known) {
  const std::array<double, 4> value{q.w(), q.x(), q.y(), q.z()};
  for (std::size_t i = 0; i < 4; ++i) sink.put(components[i], known ? value[i] : kMissing);
}

template <class Number>
double number(Number value) {
  return static_cast<double>(value);
}

double known(std::optional<double> value) {
  return value.value_or(kMissing);
}

/// Rotation of an attitude about world z [rad], -pi … pi.
double angle_about_z(const Quat& q) {
  return 2.0 * std::atan2(q.z(), q.w());
}

/// Numbers of enumerations: docs/file_formats.md.
template <class Sink>
void put_force_task(Sink& sink, const RowFrame& frame, const tasks::ForceView& task) {
  sink.put(columns::segment, number(frame.task.segment));
  sink.put(columns::cue, number(frame.task.cue));
  sink.put(columns::channel_digits, number(task.channel.digits));
  sink.put(columns::channel_direction, number(task.channel.direction));
  sink.put(columns::force_shown, number(task.force_shown));
  sink.put(columns::target_shown, number(task.force_target_shown));
  for (std::size_t f = 0; f < kFingerCount; ++f)
    put_axes(sink, columns::target_force[f], task.digit_targets.force_C[f],
             task.digit_targets.shown[f]);
}

template <class Sink>
void put_object_task(Sink& sink, const RowFrame& frame, const tasks::ObjectView& task,
                     const ObjectState& object) {
  const bool shown = task.pose_target_shown;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    sink.put(columns::target_position[a], shown ? task.X_WT.p[axis] : kMissing);
    sink.put(columns::actual_position[a], object.X_WO.p[axis]);
  }
  sink.put(columns::target_angle_rad, shown ? angle_about_z(task.X_WT.q) : kMissing);
  sink.put(columns::actual_angle_rad, object.angle_rad);
  sink.put(columns::target_index, number(frame.task.target_index));
  sink.put(columns::targets_reached, number(frame.task.targets_reached));
  sink.put(columns::drops, number(task.drops));
}

template <class Sink>
void put_task(Sink& sink, const RowFrame& frame, const PlatformFrame& seen) {
  const tasks::ForceView& force = seen.special.force();
  const auto& flags = seen.forces.flags;
  put_progress(sink, frame);
  sink.put(columns::sample_flags, number(flags[0] | flags[1] | flags[2]));
  sink.put(columns::target_force_N, force.has_force_target ? force.target_force_N : kMissing);
  sink.put(columns::actual_force_N, force.actual_force_N);
  sink.put(columns::resting_force_N, known(force.resting_force_N));
  sink.put(columns::maximum_force_N, known(force.maximum_force_N));
  sink.put(columns::noise_sd_N, known(force.noise_sd_N));
  sink.put(columns::resolution_N, known(seen.constants.resolution_N));
  sink.put(columns::device_delay_s, known(seen.constants.device_delay_s));
  sink.put(columns::display_delay_s, known(seen.constants.display_delay_s));
  if (seen.object != nullptr)
    put_object_task(sink, frame, seen.special.object(), *seen.object);
  else
    put_force_task(sink, frame, force);
}

template <class Sink>
void put_forces(Sink& sink, const FingerFrame& forces, const NetPush& push) {
  sink.begin("force");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const bool there = (forces.flags[f] & bit(SampleFlag::missing)) == 0;
    put_axes(sink, columns::finger_force[f], forces.wrench_C[f].force, there);
    put_axes(sink, columns::finger_torque[f], forces.wrench_C[f].torque, there);
  }
  for (std::size_t f = 0; f < kFingerCount; ++f)
    sink.put(columns::finger_flags[f], number(forces.flags[f]));
  put_axes(sink, columns::net_force, push.wrench_P.force, push.known);
  put_axes(sink, columns::net_torque, push.wrench_P.torque, push.known);
  sink.put(columns::net_push_percent, push.share_of_grip_percent.value_or(kMissing));
}

template <class Sink>
void put_counts(Sink& sink, const FingerFrame& forces) {
  sink.begin("raw");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const RawCounts& counts = forces.raw_counts[f];
    for (std::size_t a = 0; a < 3; ++a) sink.put(columns::raw_force[f][a], number(counts[a]));
    for (std::size_t a = 0; a < 3; ++a) sink.put(columns::raw_torque[f][a], number(counts[3 + a]));
  }
}

template <class Sink>
void put_object(Sink& sink, const tasks::ObjectView& task, const ObjectState& object,
                const GraspWrench& grasp) {
  sink.begin("object");
  put_attitude(sink, columns::actual_attitude, object.X_WO.q, true);
  put_attitude(sink, columns::target_attitude, task.X_WT.q, task.pose_target_shown);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    sink.put(columns::object_velocity[a], object.v_WO_W[axis]);
    sink.put(columns::object_angular_velocity[a], object.w_WO_W[axis]);
    sink.put(columns::object_force[a], grasp.F_O_W.force[axis]);
    sink.put(columns::object_torque[a], grasp.F_O_W.torque[axis]);
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    sink.put(columns::contact[f], number(grasp.contact[f]));
    sink.put(columns::slip[f], number(grasp.slip[f]));
    sink.put(columns::utilisation[f], grasp.utilisation[f]);
  }
  sink.put(columns::model_error_rad, object.error_rad);
  sink.put(columns::model_inexact, number(object.tolerance_exceeded));
}

template <class Sink>
void put_all(Sink sink, const RowFrame& frame, const PlatformFrame& seen) {
  put_task(sink, frame, seen);
  put_forces(sink, seen.forces, seen.push);
  put_counts(sink, seen.forces);
  if (seen.object != nullptr) put_object(sink, seen.special.object(), *seen.object, seen.grasp);
  put_timing(sink, frame);
}

}  // namespace

std::vector<storage::SignalGroup> columns_of(const PlatformFrame& seen) {
  std::vector<storage::SignalGroup> groups;
  put_all(ColumnNames{groups}, {}, seen);
  return groups;
}

void write_row(const RowFrame& frame, const PlatformFrame& seen, TrialRow& row) noexcept {
  put_all(ColumnValues{row}, frame, seen);
}

}  // namespace isograsp::session
