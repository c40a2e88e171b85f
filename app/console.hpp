// SPDX-License-Identifier: GPL-3.0-or-later
// Output on a terminal: all output of the program goes through these functions, so that no control
// character from a file reaches the terminal. Words from a file go through printable() as well, so
// that they stay on their line.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/printable.hpp"
#include "core/result.hpp"

namespace isograsp::app {

/// Writes like std::printf to standard output, through printable_lines().
[[gnu::format(printf, 1, 2)]] void print(const char* format, ...);
/// Lines for people, in the spoken language; each goes through printable() and so stays one line.
class Lines {
 public:
  Lines() = default;
  Lines(const Text& first) { add(first); }  // NOLINT: a text is a line
  Lines(Words first) { add(first); }        // NOLINT: words are a line
  void add(const Text& line);
  /// A row of a table: columns are the same in every language.
  void add_row(std::string row) { lines_.push_back(std::move(row)); }
  [[nodiscard]] bool empty() const noexcept { return lines_.empty(); }
  /// All of them with their ends.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::string> lines_;
};
/// A line for people to standard output, in the spoken language.
void print_line(const Text& line);
/// To standard output.
void print_lines(const Lines& lines);
/// One document. Characters beyond ASCII are written as \uXXXX, which means the same. Bytes that
/// are no UTF-8, as may be in the name of a file, become U+FFFD.
void print_json(const nlohmann::ordered_json& document);
/// As print(), to standard error.
[[gnu::format(printf, 1, 2)]] void print_aside(const char* format, ...);
/// Prints "isograsp: error: …" to standard error, what is wrong in the spoken language; returns the
/// exit status, 1 or 2.
int print_error(const Error& error);
/// Prints "isograsp: note: …" to standard error, in the spoken language (app/language.hpp).
void print_note(const Text& text);

/// A bar on standard error, drawn only on a terminal; silent otherwise.
class ProgressBar {
 public:
  explicit ProgressBar(Words title);
  ~ProgressBar() { end(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// `fraction` 0 … 1; redraws at most about ten times a second.
  void show(double fraction, const Text& detail = {});
  /// Ends the line, so that other output can follow.
  void end();

 private:
  std::string title_;
  bool on_terminal_;
  long long last_drawn_ms_ = 0;
  bool drawn_ = false;
};

}  // namespace isograsp::app
