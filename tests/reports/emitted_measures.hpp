// SPDX-License-Identifier: GPL-3.0-or-later
// Every measure that any task can give: all kinds, made up so that they give all they can, and all
// shipped tasks.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/signals.hpp"
#include "session/library/library.hpp"
#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_direction.hpp"
#include "tasks/kinds/force/force_sense.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/grip_release.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/recorded.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/force/steadiness.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/kinds/object/observe.hpp"
#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tests/tasks/kinds/hands_play.hpp"
#include "tests/tasks/kinds/object_play.hpp"
#include "tests/tasks/reference_subject.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::test {

inline std::vector<tasks::TaskSpec> force_tasks() {
  tasks::MaximumSpec opening;
  opening.channel.direction = Direction::minus_z;
  tasks::MaximumSpec comfortable;
  comfortable.comfortable = true;
  tasks::ForceTrackingSpec trapezoid;
  trapezoid.waveform.shape = tasks::Waveform::Shape::trapezoid;
  tasks::ForceTrackingSpec several_sines;
  several_sines.waveform.shape = tasks::Waveform::Shape::multi_sine;
  several_sines.waveform.frequencies = {0.1, 0.3};
  tasks::ForceTrackingSpec many_cycles;
  many_cycles.aim.channel.digits = Digits::sum;
  many_cycles.waveform.frequency_Hz = 1.0;
  tasks::GripReleaseSpec open;
  open.open = true;
  tasks::ForceDirectionSpec direction;
  direction.targets.resize(1);
  direction.targets[0].asked.fill(true);
  direction.targets[0].direction_C.fill(Vec3::UnitX());
  return {spec_of(tasks::RestSpec{}),
          spec_of(tasks::MaximumSpec{}),
          spec_of(opening),
          spec_of(comfortable),
          spec_of(tasks::DirectionalMaximaSpec{{Finger::thumb, Finger::index},
                                               {Direction::plus_x, Direction::minus_z}}),
          spec_of(tasks::ForceTrackingSpec{}),
          spec_of(trapezoid),
          spec_of(several_sines),
          spec_of(many_cycles),
          spec_of(tasks::SteadinessSpec{}),
          spec_of(tasks::StepResponseSpec{}),
          spec_of(tasks::GripReleaseSpec{}),
          spec_of(open),
          spec_of(tasks::ForceSenseSpec{}),
          spec_of(tasks::FatigueSpec{}),
          spec_of(tasks::IndividuationSpec{}),
          spec_of(direction)};
}
inline std::vector<tasks::TaskSpec> object_tasks() {
  tasks::PoseTargetsSpec targets;
  targets.scene = "scene";
  targets.targets.resize(2);
  tasks::PoseTrackingSpec tracking;
  tracking.scene = "scene";
  tracking.axes.resize(1);
  tasks::PickPlaceSpec pick_place;
  pick_place.scene = "scene";
  pick_place.items.resize(1);
  tasks::ObserveSpec observe;
  observe.scene = "scene";
  return {spec_of(targets), spec_of(tracking), spec_of(pick_place), spec_of(observe)};
}

inline std::vector<tasks::TaskSpec> recorded_tasks() {
  using Measures = tasks::RecordedSpec::Measures;
  std::vector<tasks::TaskSpec> tasks;
  for (const Measures measures :
       {Measures::corridor, Measures::maximum, Measures::tracking, Measures::finger_forces}) {
    tasks::RecordedSpec recorded;
    recorded.measures = measures;
    recorded.fingers = {"index", "ring"};
    tasks.push_back(spec_of(recorded));
  }
  return tasks;
}

constexpr double kMaximum_N = 40.0;

/// A trial of a force task in which the hand lies still, with every column that tells its parts.
inline Signals still_hand(const tasks::TaskSpec& spec) {
  if (spec.apparatus() == "two_platforms") return play_hands(spec, known_hands(0.05));
  tasks::TaskContext context;
  context.period_s = 0.05;
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    for (const Direction direction : {Direction::plus_z, Direction::minus_z}) {
      const ForceChannel channel{static_cast<Digits>(digits), direction};
      for (auto* known : {&context.references.maximum_N, &context.references.comfortable_N,
                          &context.references.baseline_N})
        (*known)[channel] = kMaximum_N;
    }
  std::vector<std::string> names{"t_s",
                                 "phase",
                                 "segment",
                                 "cue",
                                 "channel_digits",
                                 "channel_direction",
                                 "target_force_N",
                                 "actual_force_N",
                                 "resting_force_N",
                                 "maximum_force_N",
                                 "net_fx_N",
                                 "net_fy_N",
                                 "net_fz_N"};
  for (const Finger finger : kFingers)
    for (const char* axis : {"_fx_N", "_fy_N", "_fz_N"}) {
      names.push_back(std::string(name_of(finger)) + axis);
      names.push_back("target_" + std::string(name_of(finger)) + axis);
    }
  if (spec.kind->postures != nullptr) context.arm = reference_subject(spec);
  const Pose here = context.arm ? initial_pose(*context.arm) : Pose{};
  Signals signals(names);
  auto task = tasks::make_task(spec, context);
  if (!task) {
    ADD_FAILURE() << task.error().message();
    return signals;
  }
  for (int k = 0;; ++k) {
    tasks::HandInput hand;
    hand.seen = true;
    hand.frames = k + 1;
    const tasks::TaskView view = spec.apparatus() == "arm"
                                     ? (*task)->step(tasks::ArmInput{k * context.period_s, here})
                                 : spec.apparatus() == "tracked_hand" ? (*task)->step(hand)
                                                                      : (*task)->step({});
    if (view.phase == tasks::Phase::done) return signals;
    std::vector<double> row{
        k * context.period_s,
        static_cast<double>(view.phase),
        static_cast<double>(view.segment),
        static_cast<double>(view.cue),
        static_cast<double>(view.force().channel.digits),
        static_cast<double>(view.force().channel.direction),
        view.force().has_force_target ? view.force().target_force_N : tasks::kNotMeasured,
        view.force().actual_force_N,
        0.0,
        kMaximum_N,
        0.0,
        0.0,
        0.0};
    for (const Finger finger : kFingers)
      for (const int axis : {0, 1, 2}) {
        const auto f = index_of(finger);
        row.push_back(0.0);
        row.push_back(view.force().digit_targets.shown[f]
                          ? view.force().digit_targets.force_C[f][axis]
                          : tasks::kNotMeasured);
      }
    signals.append_row(row);
  }
}

/// The tasks that the program is shipped with.
inline std::vector<tasks::TaskSpec> library_tasks() {
  namespace fs = std::filesystem;
  std::vector<tasks::TaskSpec> tasks;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ISOGRASP_SOURCE_DIR) / "library/tasks")) {
    if (entry.path().extension() != ".toml") continue;
    auto parsed = session::load_task(entry.path());
    if (parsed)
      tasks.push_back(*std::move(parsed));
    else
      ADD_FAILURE() << entry.path() << ": " << parsed.error().message();
  }
  return tasks;
}

/// A target that is reached and held at once by an object that leans.
inline std::vector<Measure> leaning_object(const tasks::TaskSpec& spec) {
  return tasks::score(spec, play_object(spec, [](const tasks::TaskView&, const Pose&) {
                        constexpr double kLean_rad = 0.1;
                        Handled now;
                        now.X_WO.q = Quat(Eigen::AngleAxisd(kLean_rad, Vec3::UnitX()));
                        return now;
                      }));
}

struct Emitted {
  tasks::TaskSpec spec;
  std::vector<Measure> measures;
};
/// What every kind of task, made up and shipped, gives.
inline const std::vector<Emitted>& emitted() {
  static const std::vector<Emitted> all = [] {
    std::vector<Emitted> list;
    const auto add = [&](const tasks::TaskSpec& spec) {
      const bool recorded = spec.kind.is<tasks::RecordedSpec>();
      list.push_back({spec, recorded ? tasks::score(spec, Signals({"t_s"}))
                            : spec.scene().empty()
                                ? tasks::score(spec, still_hand(spec))
                                : tasks::score(spec, Signals({"t_s", "phase"}))});
    };
    for (const auto& tasks : {force_tasks(), recorded_tasks(), object_tasks(), library_tasks()})
      for (const tasks::TaskSpec& spec : tasks) add(spec);
    tasks::PoseTargetsSpec reached;
    reached.scene = "free_block";
    reached.targets.resize(1);
    reached.targets[0].hold_s = 0.2;
    list.push_back({spec_of(reached), leaning_object(spec_of(reached))});
    return list;
  }();
  return all;
}

/// Words made of nothing but the name.
inline std::string own_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace isograsp::test
