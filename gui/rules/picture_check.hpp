// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the picture moves as what cameras or a tracker see: an arm's object, or a hand, is moved
// to the right, up and away from whoever looks, one after the other, from rest to rest; in the
// picture it must have gone there within 15 degrees. A rig whose [view] names other axes, or a
// tracker that stands another way than its program says, shows here. Pure but for what was seen
// last.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/spatial.hpp"

namespace isograsp::gui {

class PictureCheck {
 public:
  enum class Way : std::uint8_t { right, up, away };
  static constexpr std::size_t kWays = 3;
  static constexpr double kMostOff_rad = 0.2617993877991494;  ///< 15 degrees
  /// From so far on its way tells a direction; an object that has gone further has gone wrong [m].
  static constexpr double kLeastWay_m = 0.06;
  static constexpr double kMostWay_m = 0.12;

  void begin();
  void stop();
  [[nodiscard]] bool running() const noexcept { return next_ < kWays; }
  /// All ways were gone.
  [[nodiscard]] bool over() const noexcept { return off_rad_[kWays - 1].has_value(); }
  /// What is asked now; nothing: the object has to rest first, or it is not running.
  [[nodiscard]] std::optional<Way> asked() const noexcept;
  /// How far off each way went; nothing: not gone yet.
  [[nodiscard]] const std::array<std::optional<double>, kWays>& off_rad() const noexcept {
    return off_rad_;
  }
  [[nodiscard]] bool good() const noexcept;

  /// Where it is drawn (x right, y up, z to whoever looks); not seen: nothing. True: what is said
  /// of the check changes.
  bool add(const std::optional<Vec3>& p_S, double time_s);

 private:
  std::size_t next_ = kWays;  ///< way; kWays: none
  std::array<std::optional<double>, kWays> off_rad_{};
  std::optional<Vec3> from_S_;   ///< where the object rested
  std::optional<Vec3> rests_S_;  ///< may be resting there
  double since_s_ = 0.0;
};

/// "right", "up", "away".
[[nodiscard]] std::string_view name_of(PictureCheck::Way way) noexcept;

}  // namespace isograsp::gui
