// SPDX-License-Identifier: GPL-3.0-or-later
// Task files: what is accepted ends, and keeps its own text.
#include <cmath>

#include "tasks/task_spec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto task = tasks::parse_task(text, "task.toml");
  if (!task) {
    fuzz::require_helpful(task.error(), text);
    return 0;
  }
  const double duration_s = task->duration().worst_s;
  fuzz::require(std::isfinite(duration_s) && duration_s > 0.0, "a task takes some time and ends");
  fuzz::require(task->text == text, "the text of a task is kept");
  return 0;
}
