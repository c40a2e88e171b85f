// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/next_words.hpp"

#include "gui/words/texts.hpp"

namespace isograsp::gui {

std::string words_of(const session::ProtocolWalk::Act& act) {
  return translated(act.words()).toStdString();
}

std::string next_words(const SessionState& state) {
  const auto& act = state.guide().act();
  if (state.follows()) return act ? words_of(*act) : std::string();
  const auto* spec = state.next_task();
  return spec == nullptr ? std::string() : translated(spec->name).toStdString();
}

}  // namespace isograsp::gui
