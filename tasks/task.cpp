// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/task.hpp"

#include "tasks/timeline.hpp"

namespace isograsp::tasks {

Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec, const TaskContext& context) {
  if (!(context.period_s > 0.0))
    return refused("the frame period is not positive"_text, "give a rate of 50 to 1000 Hz"_text)
        .at(spec.file);
  if (spec.kind->make == nullptr && spec.kind->segments == nullptr)
    return refused("is a task of recordings, which nobody can do live"_text,
                   "choose another task, or read the recording with isograsp import"_text)
        .at(spec.file)
        .about("kind");
  if (spec.kind->make != nullptr) return spec.kind->make(spec.kind, context);
  auto timeline = timeline_of(spec, context);
  if (!timeline) return timeline.error();
  return play(*std::move(timeline), context);
}

}  // namespace isograsp::tasks
