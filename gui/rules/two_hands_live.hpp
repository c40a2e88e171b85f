// SPDX-License-Identifier: GPL-3.0-or-later
// What a therapist reads of both hands while they work: what each gives above its rest, and the
// share of the affected one. To look at: what is scored comes from the stored rows. Pure.
#pragma once

#include <optional>

#include "gui/look/hands_history.hpp"
#include "tasks/references.hpp"

namespace isograsp::gui {

struct HandsLive {
  /// Mean of the last second above the resting force; nothing: one of them is not known.
  OfHands<std::optional<double>> above_rest_N;
  /// Of what both give above rest, as docs/measures.md says it; nothing: the affected side or a
  /// rest is not known, or both rest.
  std::optional<double> share_affected_percent;
  /// The same of what each gives as a part of its maximum; nothing also: a maximum is not known.
  std::optional<double> effort_share_affected_percent;
};
[[nodiscard]] HandsLive hands_live(const HandsHistory& history,
                                   const tasks::TwoHandsReferences& references);

/// What both give is less than this: a share of it is noise [N].
inline constexpr double kLeastShared_N = 0.5;

}  // namespace isograsp::gui
