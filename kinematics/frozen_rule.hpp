// SPDX-License-Identifier: GPL-3.0-or-later
// A marker that stands still to the last bit while its body moves is not seen: some systems go on
// sending the last position of one that was lost. Positions in m.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/spatial.hpp"
#include "kinematics/rig.hpp"

namespace isograsp {

class FrozenRule {
 public:
  /// Rows that are the same to the last bit.
  static constexpr int kRows = 10;
  /// By which the body has moved meanwhile [m].
  static constexpr double kMoved_m = 0.005;

  FrozenRule() = default;
  /// `names`: of the markers of a row.
  FrozenRule(const Rig& rig, std::span<const std::string> names);

  /// Makes those missing that are frozen. Rows in the order of time. Real-time: nothing is
  /// allocated. A cluster has moved if its other markers have, on the average; the points of a
  /// frame, if their distances from the marker have changed: a joint that others turn about may
  /// stand still.
  void apply(std::span<Vec3> p_W) noexcept;
  [[nodiscard]] bool is_frozen(std::size_t marker) const noexcept {
    return markers_[marker].frozen;
  }

 private:
  struct Marker {
    Vec3 last = Vec3::Zero();
    int rows = 0;  ///< for which it has stood still
    bool frozen = false;
  };
  struct Body {
    bool rigid = true;
    std::vector<std::size_t> members;
    /// For each member, where all of them were when it began to stand still.
    std::vector<Vec3> began;
  };
  void add(bool rigid, const std::vector<std::string>& members, std::span<const std::string> names);
  void remember(Body& body, std::size_t member, std::span<const Vec3> p_W) noexcept;
  [[nodiscard]] double moved_m(const Body& body, std::size_t member,
                               std::span<const Vec3> p_W) const noexcept;

  std::vector<Marker> markers_;
  std::vector<Body> bodies_;
};

}  // namespace isograsp
