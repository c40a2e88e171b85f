// SPDX-License-Identifier: GPL-3.0-or-later
// The validator of BIDS, which `scripts/setup --test` installs.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace isograsp::test {

inline CommandResult validate_bids(const std::string& folder) {
  const std::string validator =
      ISOGRASP_SOURCE_DIR "/build/validators/bids-validator/bin/bids-validator";
  EXPECT_TRUE(std::filesystem::exists(validator)) << "install it: scripts/setup --test";
  return run("node --no-warnings " + validator + " --json " + folder);
}

/// The codes of errors or warnings of its report.
inline std::string codes_of(const nlohmann::json& issues) {
  std::string codes;
  for (const auto& issue : issues) codes += issue["key"].get<std::string>() + " ";
  return codes;
}

}  // namespace isograsp::test
