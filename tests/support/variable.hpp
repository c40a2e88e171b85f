// SPDX-License-Identifier: GPL-3.0-or-later
// A variable of the environment for as long as it lives; then it is what it was. Tests of one
// process do not see each other's.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace isograsp::test {

class Variable {
 public:
  Variable(std::string name, const std::string& value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) before_ = before;
    setenv(name_.c_str(), value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_.c_str(), before_->c_str(), 1);
    else
      unsetenv(name_.c_str());
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

}  // namespace isograsp::test
