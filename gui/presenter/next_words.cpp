// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/next_words.hpp"

#include <QCoreApplication>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct NextTexts {
  Q_DECLARE_TR_FUNCTIONS(NextWords)
};

}  // namespace

std::string words_of(const session::ProtocolWalk::Act& act) {
  if (act.kind != session::ProtocolWalk::Act::Kind::trial)
    return translated(act.words()).toStdString();
  auto words = translated(act.task->name);
  if (act.practice) words = NextTexts::tr("%1, practice").arg(words);
  if (act.planned > 1)
    words = NextTexts::tr("%1 (%2 of %3)").arg(words).arg(act.attempt).arg(act.planned);
  return words.toStdString();
}

std::string next_words(const SessionState& state) {
  const auto& act = state.guide().act();
  if (state.follows()) return act ? words_of(*act) : std::string();
  const auto* spec = state.next_task();
  return spec == nullptr ? std::string() : translated(spec->name).toStdString();
}

}  // namespace isograsp::gui
