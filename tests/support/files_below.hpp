// SPDX-License-Identifier: GPL-3.0-or-later
// The files in a folder and in all folders in it, as paths below it, in the order of the alphabet.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace isograsp::test {

inline std::vector<std::string> files_below(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(std::filesystem::relative(entry.path(), folder));
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace isograsp::test
