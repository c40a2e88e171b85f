// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/protocol_acts.hpp"

#include "gui/words/texts.hpp"

namespace isograsp::gui {

ProtocolActs::ProtocolActs(const ActContext& with, NextWork& next)
    : state_(with.state), flow_(with.flow), example_(with.example), next_(next) {}

void ProtocolActs::choose_by_hand() {
  if (!state_.follows() || !flow_.view().may_choose_task) return;
  example_.stop();
  next_.hold();
  state_.open->work.by_hand = true;
  next_.look_at_task();
  flow_.update();
}

void ProtocolActs::follow() {
  if (!state_.guide().active() || state_.follows() || !flow_.view().may_choose_task) return;
  example_.stop();
  state_.open->work.by_hand = false;
  next_.look_at_act();
  flow_.update();
}

void ProtocolActs::stand_by() {
  if (!flow_.view().may_stand_by) return;
  next_.hold();
  flow_.update();
}

void ProtocolActs::set_by_itself(bool by_itself) {
  state_.choices.by_itself = by_itself;
  if (!by_itself) next_.hold();
  flow_.update();
}

void ProtocolActs::skip() {
  if (!flow_.view().may_skip) return;
  example_.stop();
  OpenSession& open = *state_.open;
  open.session->note("Left out: " + english(open.work.guide.act()->words()) +
                     ": skipped by the therapist");
  open.work.guide.skip(open.time_s());
  next_.look_at_act();
  flow_.update();
}

void ProtocolActs::leave_out(const Error& why) {
  OpenSession& open = *state_.open;
  const std::string& task = open.work.guide.act()->task->name;
  open.session->note("Left out: " + task + ": " + english("%1; %2"_text(why.what, why.remedy)));
  Q_EMIT flow_.failed(SessionFlow::tr("Left out: %1: %2; %3")
                          .arg(translated(task), translated(why.what), translated(why.remedy)));
  open.work.guide.skip(open.time_s());
  next_.look_at_act();
  flow_.update();
}

}  // namespace isograsp::gui
