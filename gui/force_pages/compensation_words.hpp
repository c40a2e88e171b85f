// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "session/compensation.hpp"

namespace isograsp::gui {

/// What spoils the trial, with what to do, in plain sentences; empty: nothing.
[[nodiscard]] QString compensation_words(const session::Compensation& compensation);

}  // namespace isograsp::gui
