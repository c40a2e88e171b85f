// SPDX-License-Identifier: GPL-3.0-or-later
// Converts files of older formats to the format of this program.
#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/file/open_mode.hpp"

namespace isograsp::storage {

struct Migration {
  int from = kDatabaseFormat;  ///< format that the file had
  std::string copy;            ///< of the file as it was; empty: nothing was to be done
  int packed = 0;              ///< trials that were in blocks of a second
  /// Trials that stay in such blocks because they cannot be read, and why.
  std::vector<Text> not_packed{};
};
/// Brings a file to the format of this program, in one transaction, after a checked copy beside
/// it was made; then packs the signals that are not, trial by trial. Every row is
/// sealed as it is found. Refused while somebody records into the file; a protected one without a
/// login (Access::open_to_migrate()) that may write.
[[nodiscard]] Result<Migration> migrate_database(const std::string& path);

}  // namespace isograsp::storage
