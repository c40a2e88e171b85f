// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked before both hands work at once, each on a platform: the screening of each, of which
// the stricter outcome holds, and what lets the therapist free them at any time. Pure. No widget.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "gui/rules/screening.hpp"
#include "hand/hands.hpp"

namespace isograsp::gui {

using BothScreenings = OfHands<Screening>;

[[nodiscard]] bool complete(const BothScreenings& both) noexcept;
/// The stricter outcome. @pre complete(both)
[[nodiscard]] tasks::Effort allowed(const BothScreenings& both) noexcept;
/// One of them says so.
[[nodiscard]] bool applies_to_one(const BothScreenings& both, Caution caution) noexcept;
/// As stored with the session, of each hand under its name. @pre complete(both)
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const BothScreenings& both);
/// "comfortable, pain 2" of the stricter hand; empty: not complete.
[[nodiscard]] QString summary(const BothScreenings& both);

/// Before a hand is bound while the other one is: both are free within moments.
struct HandsSafety {
  bool stop_tested = false;     ///< its pedal, or key, was pressed once in this session
  bool within_reach = false;    ///< somebody said that they stay there
  bool other_strapped = false;  ///< the less affected hand, which as a rule lies in its supports

  [[nodiscard]] bool complete() const noexcept { return stop_tested && within_reach; }
};
/// As stored with the session.
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const HandsSafety& safety);

}  // namespace isograsp::gui
