// SPDX-License-Identifier: GPL-3.0-or-later
// Which of many points without names are the markers of a body: those whose distances from each
// other are those of its template. Nothing is guessed: two answers are none. Positions in m.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/spatial.hpp"

namespace isograsp {

class CloudMatch {
 public:
  /// By which a distance may differ from that in the template [m].
  static constexpr double kTolerance_m = 0.005;
  /// Comparisons of one row; a cloud that takes more has no answer. About 0.2 ms.
  static constexpr int kMostComparisons = 100'000;

  /// @pre three points or more
  explicit CloudMatch(std::vector<Vec3> template_m);

  [[nodiscard]] std::size_t markers() const noexcept { return template_m_.size(); }
  /// For each marker, which point it is; false: there is no such choice of points, or another one,
  /// too (a template that looks the same when markers change their places has none at all). All
  /// markers must be seen. Missing points are NaN. Real-time: nothing is allocated.
  /// @pre places.size() == markers()
  [[nodiscard]] bool find(std::span<const Vec3> cloud, std::span<std::size_t> places) noexcept;

 private:
  struct Search;
  std::vector<Vec3> template_m_;
  std::vector<double> distance_m_;  ///< of each marker from each
  std::vector<std::size_t> trial_;
};

}  // namespace isograsp
