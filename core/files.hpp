// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files: read without ever waiting, or written so that they appear complete or not at all.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

/// An open file; closed by its end.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) noexcept : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();
  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// A user's file, opened to be read from its beginning. Only a plain file (or a link to one): a
/// folder, pipe, socket or device is refused at once, since it might let a reader wait for ever or
/// never end. Every reader of a file that a user names opens it here.
class InputFile {
 public:
  [[nodiscard]] static Result<InputFile> open(const std::string& path);
  /// When it was opened [bytes].
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  /// Fills `to` unless the file ends before; the number of bytes. -1: the disk fails.
  [[nodiscard]] std::ptrdiff_t read(std::span<char> to) noexcept;

 private:
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// Writes a file that appears under its name only when complete and on the disk: a temporary file
/// (".NAME.part" in the same folder, which no link can lead elsewhere), synchronised, then renamed.
/// What a writer that was killed has left is cleared away by the next one. A new file is for its
/// owner only (0600); one that replaces the user's own keeps its permissions. A path that is a
/// device or a pipe is written to directly.
class FileWriter {
 public:
  /// Errors: also that another program is writing this file now.
  [[nodiscard]] static Result<FileWriter> create(const std::string& path);
  FileWriter(FileWriter&& other) noexcept;
  FileWriter& operator=(FileWriter&&) = delete;
  ~FileWriter();  ///< without commit() the temporary file is removed: nothing half-written

  void write(std::string_view text);
  /// A name under which a library that opens its files by name opens this one (and must not lock
  /// it); until commit(). Empty: it is a device or a pipe. @pre nothing was given to write()
  [[nodiscard]] std::string name_for_library() const;
  /// Flushes and renames; fails if anything could not be written (full disk).
  [[nodiscard]] Result<void> commit();

 private:
  FileWriter() = default;
  void flush() noexcept;

  std::string path_;
  std::string temporary_;  ///< empty: written to directly
  Descriptor out_;
  std::string waiting_;  ///< not yet given to the system
  bool good_ = true;
};

/// A whole text file. Files over 64 MiB are refused.
[[nodiscard]] Result<std::string> read_text(const std::string& path);
/// Writes it through a FileWriter.
[[nodiscard]] Result<void> write_text(const std::string& path, std::string_view text);

/// Fails if `out` is the same file as `in`.
[[nodiscard]] Result<void> check_different(const std::string& in, const std::string& out);

/// An error for a file that cannot be opened for `purpose` ("reading", "writing").
enum class Purpose { reading, writing };
[[nodiscard]] Error cannot_open(const std::string& path, Purpose purpose);

}  // namespace isograsp
