// SPDX-License-Identifier: GPL-3.0-or-later
// A JSON object of numbers and words, for what is stored with a trial.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isograsp::session {

/// @pre the word needs no escape
[[nodiscard]] inline std::string quoted(std::string_view word) {
  return "\"" + std::string(word) + "\"";
}

/// Collects `"key": value`, the values as JSON.
class JsonObject {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += (text_.empty() ? "" : ", ") + quoted(key) + ": " + value;
  }
  void add(std::string_view key, std::uint64_t value) { add(key, std::to_string(value)); }
  [[nodiscard]] std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

}  // namespace isograsp::session
