// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/next_work.hpp"

#include <algorithm>
#include <utility>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// "The target is … : run …."
std::string sentence_of(const Error& error) {
  QString words = translated(error.what);
  if (!error.remedy.empty()) words += QStringLiteral(": ") + translated(error.remedy);
  words[0] = words[0].toUpper();
  return (words + QLatin1Char('.')).toStdString();
}

/// The first force that the task is scaled to and that was not measured, in words; empty: none.
std::string lack_of(const tasks::TaskSpec& spec, const tasks::ForceReferences& references) {
  for (const tasks::Scale scale :
       {tasks::Scale::of_maximum, tasks::Scale::of_comfortable, tasks::Scale::of_baseline})
    for (const ForceChannel channel : spec.channels_needed(scale)) {
      const auto unit = references.unit_N(scale, channel, spec.largest_level());
      if (!unit) return sentence_of(unit.error());
    }
  return "";
}

}  // namespace

void NextWork::begin() {
  OpenSession& open = *state_.open;
  if (state_.has_protocol())
    open.work.guide.begin(state_.chosen_protocol(), open.session->known().earlier,
                          open.session->known().order_seed());
  look_at_act();
}

void NextWork::look_at_act() {
  Work& work = state_.open->work;
  const session::Training& training = state_.open->session->known().training;
  work.act_task.reset();
  if (const auto& act = work.guide.act();
      act && act->kind == session::ProtocolWalk::Act::Kind::trial) {
    auto spec = session::task_of(*act, training);
    if (spec && act->adaptive) spec = work.at_chosen_level(*spec, act->look);
    if (spec)
      work.act_task = *std::move(spec);
    else
      flow_.refuse(spec.error());
  }
  look_at_task();
}

void NextWork::look_at_task() {
  if (!state_.open) return;
  Work& work = state_.open->work;
  work.task_lacks.clear();
  const auto* spec = state_.next_task();
  // What a protocol asks is not refused beforehand: it is left out, with the reason.
  if (spec == nullptr || work.follows()) return;
  work.task_lacks = lack_of(*spec, state_.open->session->known().references);
}

void NextWork::select(std::optional<int> task) {
  if (task) (state_.open ? state_.open->work.task : state_.choices.task) = task;
  look_at_task();
}

void NextWork::select_first(bool (*fits)(const tasks::TaskSpec&)) {
  select(first_task(state_.library.tasks, fits));
}

void NextWork::select_after_maximum() {
  const auto& references = state_.open->session->known().references;
  select(first_task(state_.library.tasks, [&](const tasks::TaskSpec& spec) {
    return spec.kind->follows_curve && lack_of(spec, references).empty();
  }));
}

void NextWork::hold() {
  if (state_.open) state_.open->work.guide.go_on(false);
}

}  // namespace isograsp::gui
