// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files: read at once, or written so that they appear complete or not at all.
#pragma once

#include <fstream>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

/// Writes a file that appears under its name only when complete: temporary file, then rename. A
/// path that is a device or a pipe is written to directly.
class FileWriter {
 public:
  [[nodiscard]] static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();  ///< without commit() the temporary file is removed: nothing half-written

  void write(std::string_view text);
  /// Flushes and renames; fails if anything could not be written (full disk).
  [[nodiscard]] Result<void> commit();

 private:
  FileWriter() = default;
  std::string path_;
  std::string temporary_;
  std::ofstream out_;
};

/// A whole text file. Files over 64 MiB are refused.
[[nodiscard]] Result<std::string> read_text(const std::string& path);
/// Writes it through a FileWriter.
[[nodiscard]] Result<void> write_text(const std::string& path, std::string_view text);

/// Fails if `out` is the same file as `in`.
[[nodiscard]] Result<void> check_different(const std::string& in, const std::string& out);

/// An error for a file that cannot be opened for `purpose` ("reading", "writing").
[[nodiscard]] Error cannot_open(const std::string& path, const char* purpose);

}  // namespace isograsp
