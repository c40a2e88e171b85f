// SPDX-License-Identifier: GPL-3.0-or-later
// What a patch changes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace isograsp::test {

struct Change {
  bool new_file = false;
  std::vector<std::string> added;
  int removed = 0;
};

/// By the path of the file that is there afterwards.
inline std::map<std::string, Change> changes_of(const std::string& patch) {
  std::map<std::string, Change> changes;
  Change* change = nullptr;
  std::string before;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = patch.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = patch.substr(begin, end - begin);
    if (line.starts_with("--- ")) {
      before = line.substr(4);
    } else if (line.starts_with("+++ b/")) {
      change = &changes[line.substr(6)];
      change->new_file = before == "/dev/null";
    } else if (line.starts_with("+++ ")) {
      ADD_FAILURE() << "a file is taken away: " << before;
    } else if (change != nullptr && line.starts_with("+")) {
      change->added.push_back(line.substr(1));
    } else if (change != nullptr && line.starts_with("-")) {
      ++change->removed;
    }
  }
  return changes;
}

}  // namespace isograsp::test
