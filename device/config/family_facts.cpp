// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/family_facts.hpp"

#include <algorithm>

namespace isograsp {

const FamilyFacts* family_named(std::string_view name) noexcept {
  const auto all = all_families();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const FamilyFacts* family) { return family->name == name; });
  return found == all.end() ? nullptr : *found;
}

std::string family_names() {
  std::vector<std::string_view> names;
  for (const FamilyFacts* family : all_families())
    if (family->on_wire()) names.push_back(family->name);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += names[i];
  }
  return text;
}

}  // namespace isograsp
