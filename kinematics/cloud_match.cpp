// SPDX-License-Identifier: GPL-3.0-or-later
// Depth first: marker after marker is laid on a point whose distances to those of the markers
// before it fit.
#include "kinematics/cloud_match.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/attitude.hpp"

namespace isograsp {

CloudMatch::CloudMatch(std::vector<Vec3> template_m)
    : template_m_(std::move(template_m)), trial_(template_m_.size()) {
  for (const Vec3& one : template_m_)
    for (const Vec3& other : template_m_) distance_m_.push_back((one - other).norm());
}

struct CloudMatch::Search {
  std::span<const double> distance_m;
  std::span<const Vec3> cloud;
  std::span<std::size_t> trial;
  std::span<std::size_t> found;
  int answers = 0;
  int comparisons = 0;

  [[nodiscard]] bool over() const noexcept { return answers > 1 || comparisons > kMostComparisons; }
  [[nodiscard]] bool fits(std::size_t marker, std::size_t point) noexcept {
    for (std::size_t before = 0; before < marker; ++before) {
      ++comparisons;
      const double apart_m = (cloud[point] - cloud[trial[before]]).norm();
      if (trial[before] == point ||
          std::abs(apart_m - distance_m[marker * trial.size() + before]) > kTolerance_m)
        return false;
    }
    return true;
  }
  void lay(std::size_t marker) noexcept {
    if (marker == trial.size()) {
      ++answers;
      std::copy(trial.begin(), trial.end(), found.begin());
      return;
    }
    for (std::size_t point = 0; point < cloud.size() && !over(); ++point) {
      if (is_missing(cloud[point]) || !fits(marker, point)) continue;
      trial[marker] = point;
      lay(marker + 1);
    }
  }
};

bool CloudMatch::find(std::span<const Vec3> cloud, std::span<std::size_t> places) noexcept {
  Search search{distance_m_, cloud, trial_, places};
  search.lay(0);
  return search.answers == 1 && !search.over();
}

}  // namespace isograsp
