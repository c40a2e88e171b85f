// SPDX-License-Identifier: GPL-3.0-or-later
// Shipped and own content: scenes, tasks and protocols by name.
#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "tasks/agenda.hpp"
#include "tasks/protocol.hpp"

namespace isograsp {

/// Finds NAME(.toml) beside `beside` (a file; may be empty) or in LIBRARY/FOLDER and returns its
/// path.
[[nodiscard]] Result<std::string> find_in_library(const std::string& library,
                                                  const std::string& folder,
                                                  const std::string& name,
                                                  const std::string& beside = "");

/// Reads a task file. A target from a CSV file (columns t_s and target, beside the task) is taken
/// into the task's text, so that what is stored with a trial is whole.
[[nodiscard]] Result<TaskSpec> load_task(const std::string& path);

/// A protocol with all its tasks read: a bad file is found before a session begins.
struct ReadyProtocol {
  ProtocolSpec spec;
  std::vector<std::vector<TaskSpec>> tasks;  ///< of each step; empty for zeros and pauses
  [[nodiscard]] Duration duration() const { return duration_of(spec, tasks); }
};
/// Tasks are looked for beside the protocol, then in the library; their scenes must exist.
[[nodiscard]] Result<ReadyProtocol> read_protocol(const std::string& path,
                                                  const std::string& library);

}  // namespace isograsp
