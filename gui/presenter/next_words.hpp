// SPDX-License-Identifier: GPL-3.0-or-later
// What comes next, in the words of the language that is set.
#pragma once

#include <string>

#include "gui/presenter/session_state.hpp"

namespace isograsp::gui {

/// "Grip force, sine, practice (2 of 3)"
[[nodiscard]] std::string words_of(const session::ProtocolWalk::Act& act);
/// Of the protocol's next act, or the name of the chosen task; empty: nothing comes.
[[nodiscard]] std::string next_words(const SessionState& state);

}  // namespace isograsp::gui
