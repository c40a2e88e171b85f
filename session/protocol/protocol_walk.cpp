// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/protocol/protocol_walk.hpp"

#include <algorithm>

namespace isograsp::session {

namespace {

/// @pre step.prepares()
ProtocolWalk::Act::Kind kind_of(const tasks::ProtocolStep& step) noexcept {
  switch (step.kind) {
    case tasks::ProtocolStep::Kind::start_posture: return ProtocolWalk::Act::Kind::start_posture;
    case tasks::ProtocolStep::Kind::hand_entry: return ProtocolWalk::Act::Kind::hand_entry;
    default: return ProtocolWalk::Act::Kind::instrument_zero;
  }
}

}  // namespace

Text ProtocolWalk::Act::words() const {
  switch (kind) {
    case Kind::instrument_zero: return "Instrument zero"_text;
    case Kind::start_posture: return "Start posture"_text;
    case Kind::hand_entry: return "Entry test of the hand"_text;
    case Kind::pause: return "Pause"_text;
    case Kind::trial: break;
  }
  Text words = Known{task->name};
  if (practice) words = "%1, practice"_text(std::move(words));
  if (planned > 1) words = "%1 (%2 of %3)"_text(std::move(words), attempt, planned);
  return words;
}

ProtocolWalk::ProtocolWalk(const ReadyProtocol& protocol, const EarlierWork& earlier,
                           std::uint64_t order_seed)
    : protocol_(protocol), agenda_(protocol.spec, order_seed) {
  tell(agenda_, protocol.spec, earlier);
  if (agenda_.done() > 0) plan_set_up();
}

void ProtocolWalk::plan_set_up() {
  const auto next = agenda_.next();
  if (!next) return;
  bool prepared = false;
  for (std::size_t i = 0; i < next->step; ++i) {
    Act act;
    act.step = i;
    if (protocol_.spec.steps[i].prepares() && !prepared) {
      prepared = true;
      act.kind = kind_of(protocol_.spec.steps[i]);
      set_up_.push_back(act);
    }
    for (const tasks::TaskSpec& spec : protocol_.tasks[i]) {
      if (!spec.kind->rests) continue;
      act.kind = Act::Kind::trial;
      act.task = &spec;
      set_up_.push_back(act);
    }
  }
}

std::optional<ProtocolWalk::Act> ProtocolWalk::next() const {
  if (!set_up_.empty()) return set_up_.front();
  const auto item = agenda_.next();
  if (!item) return std::nullopt;
  const tasks::ProtocolStep& step = protocol_.spec.steps[item->step];
  Act act;
  act.step = item->step;
  act.not_before_s = item->not_before_s;
  switch (step.kind) {
    case tasks::ProtocolStep::Kind::instrument_zero:
    case tasks::ProtocolStep::Kind::start_posture:
    case tasks::ProtocolStep::Kind::hand_entry: act.kind = kind_of(step); break;
    case tasks::ProtocolStep::Kind::pause:
      act.kind = Act::Kind::pause;
      act.duration_s = step.duration_s;
      break;
    case tasks::ProtocolStep::Kind::task:
      act.task = &protocol_.tasks[item->step][item->task];
      act.practice = step.practice;
      act.adaptive = step.adaptive;
      act.look = step.look;
      act.place = storage::TrialPlace{static_cast<int>(item->step), static_cast<int>(item->task)};
      act.attempt = item->attempt;
      act.planned = std::max(step.repetitions, item->attempt);
      break;
  }
  return act;
}

void ProtocolWalk::record(const tasks::Agenda::Outcome& outcome) {
  if (!set_up_.empty())
    set_up_.pop_front();
  else
    agenda_.record(outcome);
}

void ProtocolWalk::done(double session_time_s) {
  tasks::Agenda::Outcome outcome;
  outcome.ended_s = session_time_s;
  record(outcome);
}

void ProtocolWalk::made(const TrialOutcome& trial, double session_time_s) {
  tasks::Agenda::Outcome outcome;
  outcome.ended_s = session_time_s;
  if (const auto act = next(); act && !trial.trial.helped)
    outcome.agreeing = tasks::agreeing(protocol_.spec.steps[act->step], trial.measures);
  outcome.worked_s = trial.worked_s;
  record(outcome);
}

void ProtocolWalk::left_out(double session_time_s) {
  tasks::Agenda::Outcome outcome;
  outcome.completed = false;
  outcome.ended_s = session_time_s;
  record(outcome);
}

Result<tasks::TaskSpec> task_of(const ProtocolWalk::Act& act, const Training& training) {
  if (!act.adaptive) return *act.task;
  return tasks::at_level(*act.task, training.level(*act.task), act.look);
}

}  // namespace isograsp::session
