// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/task.hpp"

#include <algorithm>

#include "tasks/kinds/make_task.hpp"

namespace isograsp {

namespace {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

Error refused(const TaskSpec& spec, std::string field, std::string what, std::string remedy) {
  return {Error::Code::bad_input, std::move(what), std::move(remedy), spec.file, 0,
          std::move(field)};
}

}  // namespace

double grip_force(const FingerWrenches& wrench_C) noexcept {
  const auto normal = [&](Finger finger) { return wrench_C[index_of(finger)].force.z(); };
  return std::min(normal(Finger::thumb), normal(Finger::index) + normal(Finger::middle));
}

std::string_view name_of(Phase phase) noexcept {
  switch (phase) {
    case Phase::lead_in: return "lead-in";
    case Phase::active: return "active";
    case Phase::transport: return "transport";
    case Phase::hold: return "hold";
    case Phase::paused: return "paused";
    case Phase::done: return "done";
  }
  return "unknown";
}

Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec, const TaskContext& context) {
  if (!(context.period_s > 0.0))
    return refused(spec, "", "the frame period is not positive", "give a rate of 50 to 1000 Hz");
  if (spec.needs_maximum() && !(context.maximum_force_N > 0.0))
    return refused(
        spec, "most_fraction",
        "the target is a share of the maximum force, and no trial of this session measured one",
        "run the resting-force task and a maximum task first, or repeat the maximum");
  return std::visit(
      Overloaded{[&](const RestSpec& kind) { return make_rest(kind, context); },
                 [&](const MaximumSpec& kind) { return make_maximum(kind, context); },
                 [&](const ForceTrackingSpec& kind) { return make_force_tracking(kind, context); },
                 [&](const PoseTargetsSpec& kind) { return make_pose_targets(kind, context); },
                 [&](const ObserveSpec& kind) { return make_observe(kind, context); }},
      spec.kind);
}

}  // namespace isograsp
