// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a task of both hands: what is asked of them, and the forces by which a test answers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/signals.hpp"
#include "hand/two_hands_columns.hpp"
#include "tasks/task.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

/// Two hands of 40 N, the left one affected.
inline tasks::TaskContext known_hands(double period_s) {
  tasks::TaskContext context;
  context.period_s = period_s;
  context.two_hands.affected = Hand::left;
  for (const Hand hand : kBothHands) {
    context.two_hands.of[hand].maximum_N = 40.0;
    context.two_hands.of[hand].resting_N = 0.0;
  }
  return context;
}

/// The grip force of each hand, by what is asked of it.
using PressHands = std::function<OfHands<double>(const tasks::TaskView& view)>;
inline OfHands<double> still_hands(const tasks::TaskView&) {
  return {0.0, 0.0};
}

inline FingerWrenches gripping(double force_N) {
  FingerWrenches wrench_C;
  for (Wrench& wrench : wrench_C) wrench.force = wrench.torque = Vec3::Zero();
  wrench_C[0].force.z() = force_N;
  wrench_C[1].force.z() = wrench_C[2].force.z() = 0.5 * force_N;
  return wrench_C;
}

/// A trial to its end, with the columns that its measures read.
inline Signals play_hands(const tasks::TaskSpec& spec, const tasks::TaskContext& context,
                          const PressHands& press = still_hands) {
  std::vector<std::string> names{columns::t_s,           columns::phase,
                                 columns::sample_flags,  columns::segment,
                                 columns::cue,           columns::target_sum_force_N,
                                 columns::affected_hand, columns::platforms_coupled};
  for (const Hand hand : kBothHands) {
    for (const auto* of : {&columns::hand_grip, &columns::target_hand_grip, &columns::hand_cue,
                           &columns::hand_resting_force_N, &columns::hand_maximum_force_N})
      names.emplace_back((*of)[hand]);
    for (const Column& axis : columns::hand_push[hand]) names.emplace_back(axis);
  }
  Signals signals(names);
  const auto task = must(tasks::make_task(spec, context));
  tasks::TwoHandsInput input{{gripping(0.0), gripping(0.0)}};
  const auto known = [](const std::optional<double>& value) {
    return value.value_or(tasks::kNotMeasured);
  };
  for (int k = 0;; ++k) {
    const tasks::TaskView view = task->step(input);
    const tasks::TwoHandsView& hands = view.two_hands();
    const auto& affected = context.two_hands.affected;
    std::vector<double> row{k * context.period_s,
                            static_cast<double>(view.phase),
                            0.0,
                            static_cast<double>(view.segment),
                            static_cast<double>(view.cue),
                            known(hands.target_sum_N),
                            !affected                 ? tasks::kNotMeasured
                            : *affected == Hand::left ? 0.0
                                                      : 1.0,
                            context.two_hands.coupled
                                ? static_cast<double>(*context.two_hands.coupled)
                                : tasks::kNotMeasured};
    const OfHands<double> force_N = press(view);
    for (const Hand hand : kBothHands) {
      const tasks::HandReferences& of = context.two_hands.of[hand];
      row.insert(row.end(), {force_N[hand], known(hands.of[hand].target_N),
                             static_cast<double>(hands.of[hand].cue), known(of.resting_N),
                             known(of.maximum_N), force_N[hand], 0.0, 0.0});
      input.wrench_C[hand] = gripping(force_N[hand]);
    }
    signals.append_row(row);
    if (view.phase == tasks::Phase::done) return signals;
  }
}

}  // namespace isograsp::test
