// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a force task through its state machine and records what a session would, the row after the
// end included.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/signals.hpp"
#include "tasks/task.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::test {

constexpr double kPeriod_s = 0.01;

/// What the hand does in a frame, seen in that frame; t_s since the trial began.
using Answer = std::function<FingerWrenches(const tasks::TaskView&, double t_s)>;

inline FingerWrenches pressing(double thumb_N, double index_N, double middle_N) {
  FingerWrenches wrench_C;
  for (Wrench& w : wrench_C) w.force = w.torque = Vec3::Zero();
  wrench_C[0].force.z() = thumb_N;
  wrench_C[1].force.z() = index_N;
  wrench_C[2].force.z() = middle_N;
  return wrench_C;
}
inline FingerWrenches grip_of(double grip_N) {
  return pressing(grip_N, 0.5 * grip_N, 0.5 * grip_N);
}

/// Of a hand with maxima of 40 N and no tone.
inline tasks::TaskContext force_context() {
  tasks::TaskContext made;
  made.period_s = kPeriod_s;
  made.seed = 3;
  made.references.resting_C = grip_of(0.0);
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    made.references.maximum_N[{static_cast<Digits>(digits)}] = 40.0;
  return made;
}

inline Signals play_force(const tasks::TaskSpec& spec, const Answer& answer, double start_s = 0.0) {
  const tasks::TaskContext made = force_context();
  auto task = tasks::make_task(spec, made);
  EXPECT_TRUE(task) << (task ? "" : task.error().message());
  std::vector<std::string> names{"t_s",
                                 "phase",
                                 "sample_flags",
                                 "target_force_N",
                                 "actual_force_N",
                                 "resting_force_N",
                                 "maximum_force_N",
                                 "resolution_N",
                                 "device_delay_s",
                                 "segment",
                                 "cue",
                                 "channel_digits",
                                 "channel_direction"};
  for (const char* prefix : {"", "target_"})
    for (const Finger finger : kFingers)
      for (const char* axis : {"_fx_N", "_fy_N", "_fz_N"})
        names.push_back(prefix + std::string(name_of(finger)) + axis);
  Signals signals(names);
  FingerWrenches wrench_C = grip_of(0.0);
  for (int k = 0;; ++k) {
    const tasks::TaskView view = (*task)->step(tasks::ForceInput{wrench_C});
    wrench_C = answer(view, k * kPeriod_s);
    std::vector<double> row{
        start_s + k * kPeriod_s,
        static_cast<double>(view.phase),
        0.0,
        view.force().has_force_target ? view.force().target_force_N : std::nan(""),
        force_of(wrench_C, view.force().channel),
        view.force().resting_force_N.value_or(std::nan("")),
        view.force().maximum_force_N.value_or(std::nan("")),
        0.01,
        0.03,
        static_cast<double>(view.segment),
        static_cast<double>(view.cue),
        static_cast<double>(view.force().channel.digits),
        static_cast<double>(view.force().channel.direction)};
    for (const Wrench& w : wrench_C) row.insert(row.end(), {w.force.x(), w.force.y(), w.force.z()});
    for (std::size_t f = 0; f < kFingerCount; ++f)
      for (int axis = 0; axis < 3; ++axis)
        row.push_back(view.force().digit_targets.shown[f]
                          ? view.force().digit_targets.force_C[f][axis]
                          : std::nan(""));
    signals.append_row(row);
    if (view.phase == tasks::Phase::done) return signals;
  }
}

}  // namespace isograsp::test
