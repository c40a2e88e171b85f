// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that follows a protocol.
#include <algorithm>
#include <cmath>

#include "gui/presenter/session_presenter.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

using Act = session::ProtocolWalk::Act;

/// One press on "easier" or "harder", of the whole range of levels.
constexpr double kLevelStep = 0.1;

/// "Grip force, sine, practice (2 of 3)"
std::string words_of(const Act& act) {
  if (act.kind != Act::Kind::trial) return shown(act.words()).toStdString();
  auto words = shown(act.task->name);
  if (act.practice) words = SessionPresenter::tr("%1, practice").arg(words);
  if (act.planned > 1)
    words = SessionPresenter::tr("%1 (%2 of %3)").arg(words).arg(act.attempt).arg(act.planned);
  return words.toStdString();
}

}  // namespace

void SessionPresenter::begin_protocol() {
  if (has_protocol())
    open_->work.guide.begin(library_.protocols[static_cast<std::size_t>(choices_.protocol)],
                            open_->session->earlier(), open_->session->order_seed());
  look_at_act();
}

/// The task of the act at its level, once per act.
void SessionPresenter::look_at_act() {
  open_->work.act_task.reset();
  if (const auto& act = guide().act(); act && act->kind == Act::Kind::trial) {
    auto spec = session::task_of(*act, open_->session->training());
    if (spec && act->adaptive) spec = at_chosen_level(*spec);
    if (spec)
      open_->work.act_task = *std::move(spec);
    else
      refuse(spec.error());
  }
  look_at_task();
}

ProtocolFacts SessionPresenter::protocol_facts() const {
  ProtocolFacts facts;
  facts.active = true;
  facts.goes_on = guide().goes_on();
  facts.by_itself = choices_.by_itself;
  const auto& act = guide().act();
  if (!act) return facts;
  switch (act->kind) {
    case Act::Kind::instrument_zero: facts.act = ProtocolFacts::Act::zero; break;
    case Act::Kind::pause: facts.act = ProtocolFacts::Act::pause; break;
    case Act::Kind::trial: facts.act = ProtocolFacts::Act::trial; break;
  }
  facts.act_words = words_of(*act);
  facts.wait_s = static_cast<int>(std::ceil(guide().wait_s(open_->time_s())));
  facts.start_in_s = static_cast<int>(std::ceil(guide().start_in_s(open_->time_s())));
  return facts;
}

/// Pauses end, and what begins by itself begins.
void SessionPresenter::follow_time() {
  if (!follows()) return;
  const auto before = guide().act();
  open_->work.guide.tick(open_->time_s());
  if (before.has_value() != guide().act().has_value() ||
      (before && before->step != guide().act()->step))
    look_at_act();
  if (!guide().goes_on() || !open_->work.act_task) return;
  view_ = decide(facts());
  if (view_.must_stand_by) return hold();
  // Nothing begins by itself before the word that the hand is in.
  const bool hand_is_in =
      view_.situation != Situation::strap_in && view_.situation != Situation::strap_again;
  if (view_.may_begin && hand_is_in && guide().start_in_s(open_->time_s()) <= 0.0) begin_next();
}

void SessionPresenter::leave_out(const Error& why) {
  const auto words = guide().act()->task->name + ": " + why.what + "; " + why.remedy;
  open_->session->note("Left out: " + words);
  Q_EMIT failed(tr("Left out: %1: %2; %3")
                    .arg(shown(guide().act()->task->name), shown(why.what), shown(why.remedy)));
  open_->work.guide.skip(open_->time_s());
  look_at_act();
  update();
}

void SessionPresenter::choose_by_hand() {
  if (!guide().active() || open_->work.by_hand || !view_.may_choose_task) return;
  example_.stop();
  hold();
  open_->work.by_hand = true;
  look_at_task();
  update();
}

std::string SessionPresenter::next_words() const {
  if (follows()) return guide().act() ? words_of(*guide().act()) : std::string();
  const auto* spec = next_task();
  return spec == nullptr ? std::string() : shown(spec->name).toStdString();
}

void SessionPresenter::follow_protocol() {
  if (!guide().active() || !open_->work.by_hand || !view_.may_choose_task) return;
  example_.stop();
  open_->work.by_hand = false;
  look_at_act();
  update();
}

void SessionPresenter::stand_by() {
  if (!view_.may_stand_by) return;
  hold();
  update();
}

void SessionPresenter::set_by_itself(bool by_itself) {
  choices_.by_itself = by_itself;
  if (!by_itself) hold();
  update();
}

void SessionPresenter::skip() {
  if (!view_.may_skip) return;
  example_.stop();
  open_->session->note("Left out: " + guide().act()->words() + ": skipped by the therapist");
  open_->work.guide.skip(open_->time_s());
  look_at_act();
  update();
}

std::optional<double> SessionPresenter::difficulty() const {
  const auto* spec = next_task();
  if (spec == nullptr || !spec->difficulty) return std::nullopt;
  // An assessment is the same every time; only training becomes easier or harder.
  if (follows() && !guide().act()->adaptive) return std::nullopt;
  if (!open_) return spec->difficulty->start;
  const auto& levels = open_->work.levels;
  if (const auto chosen = levels.find(spec->file); chosen != levels.end()) return chosen->second;
  return follows() ? spec->difficulty->chosen : open_->session->training().level(*spec);
}

Result<tasks::TaskSpec> SessionPresenter::at_chosen_level(const tasks::TaskSpec& spec) const {
  const auto chosen = open_->work.levels.find(spec.file);
  if (chosen == open_->work.levels.end() || !spec.difficulty) return spec;
  return tasks::at_level(spec, chosen->second);
}

void SessionPresenter::adjust_difficulty(int direction) {
  const auto now = difficulty();
  if (!open_ || !now || !view_.may_choose_task) return;
  const double steps = std::round(*now / kLevelStep) + direction;
  open_->work.levels[next_task()->file] = std::clamp(kLevelStep * steps, 0.0, 1.0);
  if (follows()) look_at_act();
  update();
}

}  // namespace isograsp::gui
