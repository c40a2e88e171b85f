// SPDX-License-Identifier: GPL-3.0-or-later
// A place beside a file or folder where it is made, before it gets its name.
#pragma once

#include <string>

#include "core/files.hpp"

namespace isograsp {

/// A new, empty folder ".NAME.making" beside `target` (in the same file system, so that what is
/// made can be renamed to it), for its owner only and locked against other programs. It is removed
/// with this object, with all that is still in it. A folder that a killed program has left is
/// removed by the next one that makes the same target. No link leads out of it.
class StagingFolder {
 public:
  /// Errors: the folder of `target` cannot be written to, or another program makes `target` now.
  [[nodiscard]] static Result<StagingFolder> beside(const std::string& target);
  StagingFolder(StagingFolder&&) noexcept = default;
  StagingFolder& operator=(StagingFolder&&) = delete;
  ~StagingFolder();

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// The name of `target`, in here.
  [[nodiscard]] const std::string& file() const noexcept { return file_; }

 private:
  StagingFolder() = default;

  std::string path_;
  std::string file_;
  Descriptor lock_;
};

}  // namespace isograsp
