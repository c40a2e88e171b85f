// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands as points: bubbles that the pushes move in and, beyond their edges, along; hands that
// never cross; one view of both. Pure: no clock, no allocation. Formulas: docs/bimanual.md.
#pragma once

#include <array>

#include "bimanual/hands_spec.hpp"

namespace isograsp::bimanual {

/// What the hands do in one row.
struct HandsInput {
  std::array<Vec3, kSides> push_N{Vec3::Zero(), Vec3::Zero()};  ///< axes of the view
  std::array<bool, kSides> clutch{};                            ///< held
};

struct BubblePush {
  Vec3 offset_m = Vec3::Zero();  ///< of the hand from the middle of its bubble, axes of the view
  double excess = 0.0;           ///< how far beyond the edge, over the force at the edge
};
/// Where a push brings a hand in its bubble; at the edge of it for every larger push. Continuous.
[[nodiscard]] BubblePush push_in_bubble(const HandsSpec& spec, Side side,
                                        const Vec3& push_N) noexcept;

struct HandsView {
  Vec3 p_W = Vec3::Zero();  ///< what it looks at
  double yaw_rad = 0.0;
  double distance_m = 0.0;
};

/// Where everything is in one row.
struct HandsState {
  std::array<Vec3, kSides> p_W{Vec3::Zero(), Vec3::Zero()};       ///< of the hands
  std::array<Vec3, kSides> bubble_W{Vec3::Zero(), Vec3::Zero()};  ///< middles of the bubbles
  std::array<double, kSides> excess{};
  std::array<Vec3, kSides> push_W_N{Vec3::Zero(), Vec3::Zero()};  ///< world axes
  HandsView view;
};

class TwoHands {
 public:
  explicit TwoHands(const HandsSpec& spec) noexcept;

  /// Where the hands are under `input`; the bubbles are where the row before left them.
  [[nodiscard]] const HandsState& see(const HandsInput& input) noexcept;
  /// Moves the bubbles until the next row. `joint`: as one. @pre see()
  void move(double step_s, bool joint) noexcept;

  [[nodiscard]] const HandsState& state() const noexcept { return state_; }

 private:
  void apart() noexcept;
  void turn() noexcept;
  [[nodiscard]] std::array<Vec3, kSides> rates() const noexcept;

  HandsSpec spec_;
  HandsState state_;
  std::array<Vec3, kSides> before_plane_W_{
      Vec3::Zero(), Vec3::Zero()};  ///< of the hands, before the plane kept them apart
  std::array<Vec3, kSides> offset_W_{Vec3::Zero(), Vec3::Zero()};
  std::array<bool, kSides> clutched_{};
  Vec3 line_W_ = Vec3::UnitX();  ///< horizontal, from left to right
  double least_distance_m_;
  Vec3 start_middle_W_ = Vec3::Zero();
};

}  // namespace isograsp::bimanual
