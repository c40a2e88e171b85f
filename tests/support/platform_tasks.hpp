// SPDX-License-Identifier: GPL-3.0-or-later
// Those tasks of the library that a platform of force sensors can do, with what stands beside them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "session/library/library.hpp"
#include "tests/support/must.hpp"

namespace isograsp::test {

inline std::vector<tasks::TaskSpec> platform_tasks(const std::string& library) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(library + "/tasks"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<tasks::TaskSpec> specs;
  for (const std::string& path : paths) {
    auto spec = must(session::load_task(path));
    if (spec.apparatus().empty() || spec.apparatus() == "platform")
      specs.push_back(std::move(spec));
  }
  return specs;
}

}  // namespace isograsp::test
