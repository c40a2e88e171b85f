// SPDX-License-Identifier: GPL-3.0-or-later
// From what cameras send to the markers of a rig: other names, positions that are none, markers
// without labels. What is not sure is missing. Positions in m.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "kinematics/cloud_match.hpp"
#include "kinematics/frozen_rule.hpp"
#include "kinematics/rig.hpp"

namespace isograsp {

class SeenMarkers {
 public:
  SeenMarkers() = default;
  /// `labels` are those of the columns of a row. Errors: two of them are one marker of the rig.
  [[nodiscard]] static Result<SeenMarkers> compile(const Rig& rig,
                                                   std::span<const std::string> labels);

  /// Names of the markers of see(): the labels as the rig calls them, then the markers that are
  /// found by their distances.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// One row, missing markers NaN; rows in the order of time. Until the next call. Real-time:
  /// nothing is allocated. @pre p_W.size() is the number of labels
  [[nodiscard]] std::span<const Vec3> see(std::span<const Vec3> p_W) noexcept;
  [[nodiscard]] bool is_frozen(std::size_t marker) const noexcept {
    return frozen_.is_frozen(marker);
  }

 private:
  /// A cluster whose markers have no labels.
  struct Unlabelled {
    CloudMatch match;
    std::size_t first = 0;  ///< place of its first marker in names_
    std::vector<std::size_t> places;
  };
  SeenMarkers(const Rig& rig, std::vector<std::string> names, std::vector<std::size_t> cloud,
              std::vector<Unlabelled> unlabelled);

  std::vector<std::string> names_;
  std::vector<std::size_t> cloud_columns_;  ///< that no frame names
  std::vector<Unlabelled> unlabelled_;
  FrozenRule frozen_;
  std::vector<Vec3> cloud_;
  std::vector<Vec3> seen_;
};

}  // namespace isograsp
