// SPDX-License-Identifier: GPL-3.0-or-later
// Plays a lift of both hands without devices: the object as a session moves it, the pushes as a
// test wants them, the columns as a session stores them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/signals.hpp"
#include "hand/two_hands_columns.hpp"
#include "session/two_platforms/lifted_object.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

inline const std::string kLiftLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// The push of each hand, by what is asked and where the object is.
using PushHands =
    std::function<OfHands<Vec3>(const tasks::TaskView& view, const session::LiftedView& seen)>;

/// Two hands of these maxima that were measured, the left one affected.
inline tasks::TaskContext lifting_hands(double left_N, double right_N) {
  tasks::TaskContext context;
  context.period_s = 0.01;
  context.two_hands.affected = Hand::left;
  for (const Hand hand : kBothHands) context.two_hands.of[hand].resting_N = 0.0;
  context.two_hands.of.left.maximum_N = left_N;
  context.two_hands.of.right.maximum_N = right_N;
  return context;
}

inline std::vector<std::string> lift_columns() {
  std::vector<std::string> names{columns::t_s,
                                 columns::phase,
                                 columns::sample_flags,
                                 columns::target_index,
                                 columns::targets_reached,
                                 columns::drops,
                                 columns::actual_position[1],
                                 columns::actual_angle_rad,
                                 columns::affected_hand,
                                 columns::platforms_coupled};
  for (const Hand hand : kBothHands) {
    names.emplace_back(columns::hand_push[hand][1]);
    names.emplace_back(columns::hand_squeeze_N[hand]);
    names.emplace_back(columns::hand_utilisation[hand]);
    for (const Column& axis : columns::hand_end[hand]) names.emplace_back(axis);
  }
  return names;
}

/// A trial to its end.
inline Signals play_lift(const tasks::TaskSpec& spec, const tasks::TaskContext& context,
                         const PushHands& push) {
  auto object = must(session::LiftedObject::read(spec, context, kLiftLibrary));
  const auto task = must(tasks::make_task(spec, context));
  session::LiftedView seen;
  object.begin(seen);
  tasks::TaskView view;
  Signals signals(lift_columns());
  const auto& two = context.two_hands;
  for (int k = 0;; ++k) {
    const OfHands<Vec3> push_W = push(view, seen);
    object.press(push_W, seen);
    tasks::TwoHandsInput input;
    for (const Hand hand : kBothHands) {
      for (Wrench& wrench : input.wrench_C[hand]) wrench.force = wrench.torque = Vec3::Zero();
      input.touches[hand] = seen.of[hand].touches;
      input.slips[hand] = seen.of[hand].slips;
    }
    input.object = &seen.object;
    view = task->step(input);
    std::vector<double> row{k * context.period_s,
                            static_cast<double>(view.phase),
                            0.0,
                            static_cast<double>(view.target_index),
                            static_cast<double>(view.targets_reached),
                            static_cast<double>(view.two_hands().moved->drops),
                            seen.object.X_WO.p.y(),
                            seen.object.angle_rad,
                            !two.affected                 ? tasks::kNotMeasured
                            : *two.affected == Hand::left ? 0.0
                                                          : 1.0,
                            two.coupled ? static_cast<double>(*two.coupled) : tasks::kNotMeasured};
    for (const Hand hand : kBothHands) {
      const Vec3 end = seen.object.X_WO.p + seen.object.X_WO.q * seen.of[hand].end_O;
      row.insert(row.end(), {push_W[hand].y(), seen.of[hand].squeeze_N, seen.of[hand].utilisation,
                             end.x(), end.y(), end.z()});
    }
    signals.append_row(row);
    if (view.phase == tasks::Phase::done) return signals;
    if (const auto& moved = view.two_hands().moved; moved->on_rest)
      object.stay(moved->rest_X_WO, seen);
    else
      object.move(seen);
  }
}

}  // namespace isograsp::test
