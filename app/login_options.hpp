// SPDX-License-Identifier: GPL-3.0-or-later
// Options by which a command logs in to a protected database. Secrets come from files, never from
// the command line, where every program on the machine can read them.
#pragma once

#include <memory>
#include <string>

#include "app/command_line.hpp"
#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::app {

struct LoginOptions {
  std::string passphrase_file;
  std::string recovery_key_file;
  std::string user;
  std::string password_file;

  void add_to(Subcommand command);
  [[nodiscard]] bool given() const noexcept;
};

/// Logs in; keep it while the command works. Nothing: the database is not protected, or does not
/// exist yet. Refused: a protected one without a login, a login where none is asked for.
[[nodiscard]] Result<std::unique_ptr<storage::Access>> log_in(const std::string& database,
                                                              const LoginOptions& options);
/// The same for a file of any format that is to be migrated.
[[nodiscard]] Result<std::unique_ptr<storage::Access>> log_in_to_migrate(
    const std::string& database, const LoginOptions& options);
/// The same for commands that are about access itself: the database must exist and be of the
/// current format. `is_copy`: what login finds strange of a copy that this program has just made
/// (nothing stands beside it) is not said.
[[nodiscard]] Result<std::unique_ptr<storage::Access>> open_access(const std::string& database,
                                                                   const LoginOptions& options,
                                                                   bool is_copy = false);

}  // namespace isograsp::app
