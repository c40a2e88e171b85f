// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/protocol_guide.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "gui/words/texts.hpp"
#include "tasks/agenda.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"

namespace isograsp::gui {

using Kind = session::ProtocolWalk::Act::Kind;

namespace {

struct GuideTexts {
  Q_DECLARE_TR_FUNCTIONS(ProtocolGuide)
};

/// "Maximum grip force and 4 more"
std::string tasks_words(const std::vector<tasks::TaskSpec>& tasks) {
  const auto first = translated(tasks.front().name);
  if (tasks.size() == 1) return first.toStdString();
  return GuideTexts::tr("%1 and %n more", "", static_cast<int>(tasks.size()) - 1)
      .arg(first)
      .toStdString();
}

}  // namespace

void ProtocolGuide::begin(const session::ReadyProtocol& protocol,
                          const session::EarlierWork& earlier, std::uint64_t order_seed) {
  end();
  protocol_ = std::make_unique<const session::ReadyProtocol>(protocol);
  walk_ = std::make_unique<session::ProtocolWalk>(*protocol_, earlier, order_seed);
  name_ = protocol_->spec.name;
  look(0.0);
}

void ProtocolGuide::end() {
  act_.reset();
  walk_.reset();
  protocol_.reset();
  name_.clear();
  instructed_.clear();
  goes_on_ = worked_ = rating_due_ = false;
}

bool ProtocolGuide::rest_is_next() const {
  return act_ && act_->kind == Kind::trial && act_->task->kind->rests;
}

bool ProtocolGuide::asks_rest() const {
  if (!act_) return false;
  for (std::size_t i = act_->step; i < protocol_->tasks.size(); ++i)
    for (const tasks::TaskSpec& spec : protocol_->tasks[i])
      if (spec.kind->rests) return true;
  return false;
}

std::vector<ProtocolGuide::Row> ProtocolGuide::rows() const {
  std::vector<Row> rows;
  if (!active()) return rows;
  for (std::size_t i = 0; i < protocol_->spec.steps.size(); ++i) {
    const tasks::ProtocolStep& step = protocol_->spec.steps[i];
    Row row;
    switch (step.kind) {
      case tasks::ProtocolStep::Kind::instrument_zero:
        row.title = GuideTexts::tr("Zero, device empty").toStdString();
        break;
      case tasks::ProtocolStep::Kind::start_posture:
        row.title = GuideTexts::tr("Start posture, arm held still").toStdString();
        break;
      case tasks::ProtocolStep::Kind::hand_entry:
        row.title = GuideTexts::tr("Entry test of the hand").toStdString();
        break;
      case tasks::ProtocolStep::Kind::pause:
        row.title =
            GuideTexts::tr("Pause, %1 s").arg(static_cast<int>(step.duration_s)).toStdString();
        break;
      case tasks::ProtocolStep::Kind::task:
        row.title = tasks_words(protocol_->tasks[i]);
        row.count = step.repetitions * static_cast<int>(protocol_->tasks[i].size());
        row.practice = step.practice;
        break;
    }
    if (over() || (act_ && i < act_->step))
      row.state = RowState::done;
    else if (act_ && i == act_->step)
      row.state = RowState::current;
    rows.push_back(row);
  }
  return rows;
}

double ProtocolGuide::wait_s(double session_time_s) const {
  if (!act_) return 0.0;
  double until_s = act_->not_before_s;
  if (act_->kind == Kind::pause) until_s = std::max(until_s, act_since_s_) + act_->duration_s;
  return std::max(0.0, until_s - session_time_s);
}

double ProtocolGuide::start_in_s(double session_time_s) const {
  double in_s = wait_s(session_time_s);
  if (!act_ || act_->kind != Kind::trial) return in_s;
  const bool known =
      std::find(instructed_.begin(), instructed_.end(), act_->task->file) != instructed_.end();
  if (!known) in_s = std::max(in_s, act_since_s_ + tasks::kInstruction_s - session_time_s);
  return in_s;
}

void ProtocolGuide::look(double session_time_s) {
  act_ = walk_->next();
  act_since_s_ = session_time_s;
  const bool block_over = !act_ || act_->kind == Kind::pause;
  if (block_over && std::exchange(worked_, false)) rating_due_ = true;
  if (!act_) goes_on_ = false;
}

void ProtocolGuide::zeroed(double session_time_s) {
  if (!act_ || act_->kind == Kind::pause || act_->kind == Kind::trial) return;
  walk_->done(session_time_s);
  look(session_time_s);
}

void ProtocolGuide::trial_ended(const session::TrialOutcome& outcome, double session_time_s) {
  if (!act_ || act_->kind != Kind::trial) return;
  if (outcome.trial.place != act_->place || outcome.trial.task_name != act_->task->name) return;
  if (outcome.trial.status != storage::TrialStatus::completed) {
    goes_on_ = false;
    return;
  }
  if (!rest_is_next()) worked_ = true;
  const bool bout = act_->task->kind.get_if<tasks::VirtualPickPlaceSpec>() != nullptr;
  instructed_.push_back(act_->task->file);
  walk_->made(outcome, session_time_s);
  look(session_time_s);
  if (bout && std::exchange(worked_, false)) rating_due_ = true;  // a block of its own
}

void ProtocolGuide::skip(double session_time_s) {
  if (!act_) return;
  if (act_->kind == Kind::trial)
    walk_->left_out(session_time_s);
  else
    walk_->done(session_time_s);
  look(session_time_s);
}

void ProtocolGuide::tick(double session_time_s) {
  while (act_ && act_->kind == Kind::pause && wait_s(session_time_s) <= 0.0) {
    walk_->done(session_time_s);
    look(session_time_s);
  }
}

}  // namespace isograsp::gui
