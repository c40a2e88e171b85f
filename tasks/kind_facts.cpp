// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kind_facts.hpp"

#include <algorithm>

namespace isograsp::tasks {

std::size_t order_of(const KindFacts& kind) noexcept {
  const auto all = all_kinds();
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), &kind) - all.begin());
}

}  // namespace isograsp::tasks
