// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that hold for every family whose sensors can be emulated: those of the table, so that a new
// one is tested without being named.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/config/family_facts.hpp"

namespace isograsp::test {

[[nodiscard]] inline std::vector<const FamilyFacts*> emulated_families() {
  std::vector<const FamilyFacts*> emulated;
  for (const FamilyFacts* family : all_families())
    if (family->on_wire()) emulated.push_back(family);
  return emulated;
}

/// "ati_netcanoem"
[[nodiscard]] inline std::string test_name(const FamilyFacts& family) {
  std::string name(family.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
[[nodiscard]] inline std::string name_of_family(
    const ::testing::TestParamInfo<const FamilyFacts*>& tested) {
  return test_name(*tested.param);
}

}  // namespace isograsp::test
