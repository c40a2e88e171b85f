// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/kinds/two_hands/ only: how far what one hand moves has gone.
#pragma once

#include <array>

#include "core/spatial.hpp"
#include "hand/columns.hpp"
#include "tasks/record.hpp"

namespace isograsp::tasks {

/// Over rows that are next to each other [m]: a drop is no way. @pre the section has these columns
[[nodiscard]] inline double way_m(const Section& section, const columns::OfAxes& place) {
  const std::array axes{section.values(place[0]), section.values(place[1]),
                        section.values(place[2])};
  double way_m = 0.0;
  for (std::size_t k = 1; k < section.rows.size(); ++k) {
    if (section.rows[k] != section.rows[k - 1] + 1) continue;
    Vec3 step_m;
    for (std::size_t a = 0; a < 3; ++a)
      step_m[static_cast<Eigen::Index>(a)] = axes[a][k] - axes[a][k - 1];
    way_m += step_m.norm();
  }
  return way_m;
}

}  // namespace isograsp::tasks
