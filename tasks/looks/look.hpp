// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen clothes a training task: the same scene, target and tolerance, drawn as
// something of everyday life. An assessment has exactly one look, the plain one.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace isograsp::tasks {

/// What a kind of task has that can be clothed.
enum class Wardrobe : std::uint8_t {
  nothing,
  curve,    ///< a force that follows its target
  object,   ///< an object that is brought to its outline, in three dimensions
  placed,   ///< one that a tracked hand grasps
  carried,  ///< one that two hands carry
  lifted    ///< one that two hands lift
};

enum class Look : std::uint8_t {
  plain,
  river,    ///< a boat between the banks that the band is
  balloon,  ///< a hot-air balloon in a lane of calm air
  cup,      ///< a full cup, brought to its shelf
  lantern,  ///< a lantern that is lifted to its place
  jar,      ///< jars and boxes of a kitchen, put away
  crate,    ///< a crate of apples
  tea_tray  ///< a tray with a tea set
};

struct LookFacts {
  Look look;
  std::string_view name;  ///< in task files: "river"
  Wardrobe of;            ///< plain: nothing, it fits everything
};
/// Every look, the usual one of its wardrobe before the others.
[[nodiscard]] std::span<const LookFacts> all_looks() noexcept;
[[nodiscard]] std::string_view name_of(Look look) noexcept;
/// What training looks like unless somebody says otherwise.
[[nodiscard]] Look usual_look(Wardrobe of) noexcept;
[[nodiscard]] bool fits(Look look, Wardrobe of) noexcept;

/// By how hard a trial is: of the same scene in three lights.
enum class Daylight : std::uint8_t { morning, day, evening };
/// @pre 0 <= level <= 1
[[nodiscard]] Daylight daylight_at(double level) noexcept;

}  // namespace isograsp::tasks
