// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks for tests: of a kind, and those of the library.
#pragma once

#include <string>
#include <utility>

#include "core/files.hpp"
#include "tasks/task.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

/// A task of this kind, else as it is by default.
template <class Kind>
tasks::TaskSpec spec_of(Kind kind) {
  tasks::TaskSpec spec;
  spec.kind = std::move(kind);
  return spec;
}

/// What a file of the library says: "grip_sine.toml".
inline std::string library_task_text(const std::string& file) {
  return must(read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/" + file));
}
inline tasks::TaskSpec library_task(const std::string& file) {
  return must(tasks::parse_task(library_task_text(file), file));
}

}  // namespace isograsp::test
