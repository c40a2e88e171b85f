// SPDX-License-Identifier: GPL-3.0-or-later
// How the program speaks on a terminal.
#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

/// Prints "isograsp: error: …" to standard error; returns the exit status, 1 or 2.
int print_error(const Error& error);
/// Prints "isograsp: note: …" to standard error.
void print_note(const std::string& text);

/// A bar on standard error, drawn only on a terminal; silent otherwise.
class ProgressBar {
 public:
  explicit ProgressBar(std::string title);
  ~ProgressBar() { end(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// `fraction` 0 … 1; redraws at most about ten times a second.
  void show(double fraction, std::string_view detail = {});
  /// Ends the line, so that other output can follow.
  void end();

 private:
  std::string title_;
  bool on_terminal_;
  long long last_drawn_ms_ = 0;
  bool drawn_ = false;
};

}  // namespace isograsp
