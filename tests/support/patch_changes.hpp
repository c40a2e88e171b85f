// SPDX-License-Identifier: GPL-3.0-or-later
// What a patch changes, and that it adds no more than files and one row of a table.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"

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

/// What an addition takes, as its patch shows.
struct Addition {
  std::string patch;             ///< its file
  std::string table;             ///< "tasks/kinds/kinds.cpp"
  std::vector<std::string> row;  ///< what the patch adds there
  std::string lists;             ///< of sources: "tasks/CMakeLists.txt"
  int new_files = 0;
};

/// Fails if the patch changes anything else. `tree`: where it is applied.
inline void expect_new_files_and_one_row(const Addition& addition, const std::string& tree) {
  const std::string lists = must(read_text(tree + "/" + addition.lists));
  int new_files = 0;
  for (const auto& [file, change] : every(changes_of(must(read_text(addition.patch))))) {
    EXPECT_EQ(change.removed, 0) << file;
    if (change.new_file) {
      ++new_files;
      EXPECT_FALSE(std::filesystem::exists(std::string(ISOGRASP_SOURCE_DIR) + "/" + file)) << file;
      if (file.ends_with(".cpp")) {
        EXPECT_NE(lists.find(file.substr(file.find('/') + 1)), std::string::npos) << file;
      }
    } else if (file == addition.table) {
      EXPECT_EQ(change.added, addition.row);
    } else {
      EXPECT_EQ(file, addition.lists) << "beside the table, the list of sources alone";
    }
  }
  EXPECT_EQ(new_files, addition.new_files);
}

}  // namespace isograsp::test
