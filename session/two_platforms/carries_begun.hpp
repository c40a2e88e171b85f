// SPDX-License-Identifier: GPL-3.0-or-later
// What both hands have begun to carry in a session, with what it resumes: a patient carries so many
// times, in one way.
#pragma once

#include <optional>

#include "tasks/carry_forces.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

struct CarriesBegun {
  int carries = 0;
  std::optional<tasks::HandsCarry> as;  ///< how, in the newest of them

  /// A trial begins. One that breaks off counts as a whole. Real-time safe.
  void add(const tasks::TaskSpec& spec) {
    const auto carry = spec.hands_carry();
    if (!carry) return;
    carries += spec.repetitions();
    as = carry;
  }
};

}  // namespace isograsp::session
