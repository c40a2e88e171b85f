// SPDX-License-Identifier: GPL-3.0-or-later
// A text file line by line, in memory that does not depend on the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"

namespace isograsp {

class LineReader {
 public:
  /// `remedy` stands in the error about a line without an end: what to do about such a file.
  [[nodiscard]] static Result<LineReader> open(const std::string& path, std::size_t longest_line,
                                               Text remedy);

  /// False at the end of the file. Errors name file and line: one that is too long, a failing disk.
  [[nodiscard]] Result<bool> next();
  /// The line read last, without its end ("\n"); until the next call.
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Its number, 1-based.
  [[nodiscard]] int line() const noexcept { return line_; }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  explicit LineReader(InputFile file) : file_(std::move(file)) {}
  [[nodiscard]] bool fill();

  std::string path_;
  Text remedy_;
  std::size_t longest_line_ = 0;
  InputFile file_;
  bool at_end_ = false;
  std::vector<char> block_;  ///< a part of the file
  std::size_t begin_ = 0;    ///< in block_: first character that no line has taken yet
  std::size_t end_ = 0;      ///< in block_: behind the last character read
  std::string_view text_;    ///< in block_
  int line_ = 0;
};

}  // namespace isograsp
