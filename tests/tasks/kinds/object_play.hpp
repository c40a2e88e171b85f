// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a task with an object through its state machine and records what a session would.
#pragma once

#include <functional>

#include <gtest/gtest.h>

#include "core/signals.hpp"
#include "tasks/task.hpp"

namespace isograsp::test {

/// What the hand does in a frame, and where the object is then.
struct Handled {
  Pose X_WO;
  bool contact = true;
  bool slip = false;
  double grip_N = 3.0;
};

/// `hand` sees the view of the frame before and the object, which the task may have put somewhere.
inline Signals play_object(const tasks::TaskSpec& spec,
                           const std::function<Handled(const tasks::TaskView&, const Pose&)>& hand,
                           double rate_Hz = 100.0) {
  tasks::TaskContext context;
  context.period_s = 1.0 / rate_Hz;
  const auto task = tasks::make_task(spec, context);
  EXPECT_TRUE(task);
  Signals signals({"t_s",          "phase",           "sample_flags", "actual_force_N",
                   "target_x_m",   "target_y_m",      "target_z_m",   "target_angle_rad",
                   "actual_x_m",   "actual_y_m",      "actual_z_m",   "actual_angle_rad",
                   "actual_qw",    "actual_qx",       "actual_qy",    "actual_qz",
                   "target_qw",    "target_qx",       "target_qy",    "target_qz",
                   "target_index", "targets_reached", "drops",        "contact_thumb",
                   "slip_thumb"});
  const auto about_z = [](const Quat& q) { return 2.0 * std::atan2(q.z(), q.w()); };
  tasks::TaskView view;
  Pose object;
  for (int k = 0;; ++k) {
    const Handled now = hand(view, object);
    ObjectState state;
    state.X_WO = now.X_WO;
    tasks::ObjectInput input;
    input.object = &state;
    input.contact[0] = now.contact;
    input.wrench_C[0].force.z() = input.wrench_C[1].force.z() = now.grip_N;
    view = (*task)->step(input);
    if (view.phase == tasks::Phase::done) return signals;
    const Vec3& a = now.X_WO.p;
    const Quat& q = now.X_WO.q;
    const Vec3& b = view.object().X_WT.p;
    const Quat& r = view.object().X_WT.q;
    const double row[] = {k / rate_Hz,
                          static_cast<double>(view.phase),
                          0.0,
                          view.force().actual_force_N,
                          b.x(),
                          b.y(),
                          b.z(),
                          about_z(r),
                          a.x(),
                          a.y(),
                          a.z(),
                          about_z(q),
                          q.w(),
                          q.x(),
                          q.y(),
                          q.z(),
                          r.w(),
                          r.x(),
                          r.y(),
                          r.z(),
                          static_cast<double>(view.target_index),
                          static_cast<double>(view.targets_reached),
                          static_cast<double>(view.object().drops),
                          now.contact ? 1.0 : 0.0,
                          now.slip ? 1.0 : 0.0};
    signals.append_row(row);
    object = view.object().object_placed ? view.object().placed_X_WO : now.X_WO;
  }
}

}  // namespace isograsp::test
