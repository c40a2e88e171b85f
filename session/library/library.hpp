// SPDX-License-Identifier: GPL-3.0-or-later
// Shipped and own content: scenes, tasks and protocols by name. A library is a folder with scenes/,
// tasks/ and protocols/; the clinic's own one stands beside its database and is read in addition to
// the shipped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "tasks/agenda.hpp"
#include "tasks/protocol.hpp"

namespace isograsp::session {

/// The clinic's own library: "clinic.library" beside "clinic.db". It need not exist.
[[nodiscard]] std::string own_library_folder(const std::string& database);

/// Finds NAME(.toml) beside `beside` (a file; may be empty), in the library that `beside` is part
/// of, or in LIBRARY/FOLDER, and returns its path. So own files find own and shipped ones, and what
/// a shipped file names is always shipped.
[[nodiscard]] Result<std::string> find_in_library(const std::string& library,
                                                  const std::string& folder,
                                                  const std::string& name,
                                                  const std::string& beside = "");

/// Reads a task file. A target from a CSV file (columns t_s and target, beside the task) is taken
/// into the task's text, so that what is stored with a trial is whole.
[[nodiscard]] Result<tasks::TaskSpec> load_task(const std::string& path);
/// The same for a text that is, or will be, the file `path`.
[[nodiscard]] Result<tasks::TaskSpec> read_task(std::string_view text, const std::string& path);

/// A protocol with all its tasks read: a bad file is found before a session begins.
struct ReadyProtocol {
  tasks::ProtocolSpec spec;
  std::vector<std::vector<tasks::TaskSpec>> tasks;  ///< of each step; empty for zeros and pauses
  [[nodiscard]] tasks::Duration duration() const { return tasks::duration_of(spec, tasks); }
  /// The apparatus that its tasks need; empty: any.
  [[nodiscard]] std::string_view apparatus() const;
};
/// Tasks are looked for beside the protocol, then in the library; their scenes must exist.
[[nodiscard]] Result<ReadyProtocol> read_protocol(const std::string& path,
                                                  const std::string& library);
/// The same for a text that is, or will be, the file `path`.
[[nodiscard]] Result<ReadyProtocol> read_protocol(std::string_view text, const std::string& path,
                                                  const std::string& library);

}  // namespace isograsp::session
