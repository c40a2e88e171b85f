// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/task.hpp"

#include "tasks/timeline.hpp"

namespace isograsp::tasks {

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

TaskView blank_view(const ForceReferences& references, ForceChannel channel) {
  TaskView view;
  view.channel = channel;
  view.resting_force_N = references.resting(channel);
  view.maximum_force_N = references.maximum(channel);
  view.noise_sd_N = references.noise(channel);
  return view;
}

Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec, const TaskContext& context) {
  if (!(context.period_s > 0.0))
    return refused("the frame period is not positive", "give a rate of 50 to 1000 Hz")
        .at(spec.file);
  if (spec.kind->make == nullptr && spec.kind->segments == nullptr)
    return refused("is a task of recordings, which nobody can do live",
                   "choose another task, or read the recording with isograsp import")
        .at(spec.file)
        .about("kind");
  if (spec.kind->make != nullptr) return spec.kind->make(spec.kind, context);
  auto timeline = timeline_of(spec, context);
  if (!timeline) return timeline.error();
  return play(*std::move(timeline), context);
}

}  // namespace isograsp::tasks
