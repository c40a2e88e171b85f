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

Text any_family() {
  std::string all;
  std::string_view last;
  for (const FamilyFacts* family : all_families()) {
    if (!family->on_wire()) continue;
    if (!last.empty()) all += (all.empty() ? "" : ", ") + std::string(last);
    last = family->name;
  }
  return "%1 or %2"_text(all, last);
}

std::string family_names() {
  return english(any_family());
}

}  // namespace isograsp
