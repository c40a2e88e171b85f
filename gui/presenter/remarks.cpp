// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/remarks.hpp"

namespace isograsp::gui {

Remarks::Remarks(const ActContext& with)
    : state_(with.state), flow_(with.flow), clinic_(with.clinic) {}

void Remarks::rate_effort(int effort) {
  if (!state_.open) return;
  state_.open->rating.effort = effort;
  store_rating();
}

void Remarks::rate_pain(int pain) {
  if (!state_.open) return;
  state_.open->rating.pain = pain;
  store_rating();
}

void Remarks::rate_shoulder_pain(int pain) {
  if (!state_.open) return;
  state_.open->rating.shoulder_pain = pain;
  store_rating();
}

void Remarks::answer_question(std::size_t question, std::optional<int> number) {
  if (!state_.open || state_.open->rating.questions.asked == nullptr) return;
  TrialQuestions& questions = state_.open->rating.questions;
  questions.said[question] = number;
  const tasks::AskedQuestion asked{questions.asked, &questions.asked->questions[question]};
  state_.open->session->answer_question(asked.full_name(), number);
  flow_.update();
}

void Remarks::store_rating() {
  OpenSession& open = *state_.open;
  Rating& rating = open.rating;
  const bool whole =
      rating.effort && rating.pain && (rating.shoulder_pain || !state_.measures_hand());
  if (whole) {
    const int effort = *rating.effort;
    const int pain = *rating.pain;
    using Said = session::Session::Said;
    const auto reason = open.session->rate(effort, pain, rating.shoulder_pain,
                                           rating.corrects ? Said::corrected : Said::anew);
    rating.stop_reason = reason.value_or(Text());
    if (!rating.stop_reason.empty()) open.work.guide.go_on(false);
    if (!rating.corrects) open.work.guide.rated();
    rating.last = Rating::Answer{effort, pain, rating.shoulder_pain};
    rating.corrects = true;
  }
  flow_.update();
}

void Remarks::show_rated() {
  if (!state_.rating().last) return;
  Rating& rating = state_.open->rating;
  rating.effort = rating.last->effort;
  rating.pain = rating.last->pain;
  rating.shoulder_pain = rating.last->shoulder_pain;
  rating.corrects = true;
  flow_.update();
}

void Remarks::ask_rating_anew() {
  Rating& rating = state_.open->rating;
  if (!rating.corrects) return;
  rating.effort.reset();
  rating.pain.reset();
  rating.shoulder_pain.reset();
  rating.corrects = false;
}

bool Remarks::may_help() const noexcept {
  const auto& open = state_.open;
  return open && (flow_.view().may_stop || (open->ended && !open->starting()));
}

void Remarks::toggle_helped() {
  if (!may_help()) return;
  OpenSession& open = *state_.open;
  const bool ended_before = open.limits.reason_to_stop().has_value();
  const bool now = !state_.helped();
  if (open.trial) {
    open.trial->helped = now;
  } else {
    open.ended->helped = now;
    open.limits.helped(now);
  }
  open.session->mark_helped(now);
  if (!ended_before && open.limits.reason_to_stop()) open.work.guide.go_on(false);
  clinic_.load_history(state_.choices.patient);
  flow_.update();
}

void Remarks::note(const std::string& text) {
  if (state_.open && !text.empty()) state_.open->session->note(text);
}

}  // namespace isograsp::gui
