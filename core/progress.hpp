// SPDX-License-Identifier: GPL-3.0-or-later
// Long work tells how far it is and asks whether to go on.
#pragma once

#include <functional>

#include "core/result.hpp"

namespace isograsp {

/// Called between the steps of long work, on its thread: the fraction that is done, 0 … 1, and what
/// comes next, in words ("page 3 of 7"). False: stop. Empty: nobody watches.
using Progress = std::function<bool(double fraction, const Text& words)>;

/// False if the watcher wants the work to stop.
[[nodiscard]] inline bool tell(const Progress& progress, double fraction, const Text& words) {
  return !progress || progress(fraction, words);
}

/// What stopped work returns; nothing of it is kept.
[[nodiscard]] inline Error cancelled() {
  return failed("cancelled"_text, {});
}

}  // namespace isograsp
