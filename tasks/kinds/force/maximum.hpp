// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at a force as large as possible, or as large as is comfortable.
#pragma once

#include "hand/force_channel.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct MaximumSpec {
  ForceChannel channel;
  bool comfortable = false;
  double lead_in_s = 1.0;
  double squeeze_s = 3.0;
  double window_s = 0.5;    ///< best moving mean over this window counts
  bool force_shown = true;  ///< a live bar

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
