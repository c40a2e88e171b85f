// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that are run once for each language of the program, called by its code.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "languages/languages.hpp"

namespace isograsp::test {

/// ISO 639-1; English first.
inline std::vector<const char*> every_language() {
  std::vector<const char*> codes;
  for (const auto& one : languages::kLanguages) codes.push_back(one.code);
  return codes;
}
/// All but English.
inline std::vector<const char*> translated_languages() {
  auto codes = every_language();
  codes.erase(codes.begin());
  return codes;
}

inline std::string code_of_language(const testing::TestParamInfo<const char*>& language) {
  return language.param;
}

}  // namespace isograsp::test
