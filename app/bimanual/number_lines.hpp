// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers that commands about two hands write.
#pragma once

#include <string>
#include <utility>

#include "core/csv.hpp"
#include "core/spatial.hpp"

namespace isograsp::app {

/// One line of numbers after the other; NaN is an empty field.
class NumberLines {
 public:
  explicit NumberLines(FileWriter file) : file_(std::move(file)) {}
  void head(const std::string& line) { file_.write(line + "\n"); }
  void put(double number) {
    if (!first_) line_ += ',';
    first_ = false;
    append_number(line_, number);
  }
  void put(const Vec3& v) {
    for (const double number : v) put(number);
  }
  void end() {
    file_.write(line_ + "\n");
    line_.clear();
    first_ = true;
  }
  [[nodiscard]] Result<void> commit() { return file_.commit(); }

 private:
  FileWriter file_;
  std::string line_;
  bool first_ = true;
};

}  // namespace isograsp::app
