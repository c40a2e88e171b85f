// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/looks/look.hpp"

#include <algorithm>
#include <array>

namespace isograsp::tasks {

namespace {

constexpr std::array<LookFacts, 8> kLooks{{{Look::plain, "plain", Wardrobe::nothing},
                                           {Look::river, "river", Wardrobe::curve},
                                           {Look::balloon, "balloon", Wardrobe::curve},
                                           {Look::cup, "cup", Wardrobe::object},
                                           {Look::lantern, "lantern", Wardrobe::object},
                                           {Look::jar, "jar", Wardrobe::placed},
                                           {Look::crate, "crate", Wardrobe::carried},
                                           {Look::tea_tray, "tea_tray", Wardrobe::lifted}}};

}  // namespace

std::span<const LookFacts> all_looks() noexcept {
  return kLooks;
}

std::string_view name_of(Look look) noexcept {
  return std::ranges::find(kLooks, look, &LookFacts::look)->name;
}

Look usual_look(Wardrobe of) noexcept {
  return std::ranges::find(kLooks, of, &LookFacts::of)->look;
}

bool fits(Look look, Wardrobe of) noexcept {
  return look == Look::plain || std::ranges::find(kLooks, look, &LookFacts::look)->of == of;
}

Daylight daylight_at(double level) noexcept {
  if (level < 1.0 / 3.0) return Daylight::morning;
  return level < 2.0 / 3.0 ? Daylight::day : Daylight::evening;
}

}  // namespace isograsp::tasks
