// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/preparing.hpp"

#include <QString>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "gui/library/task_groups.hpp"

namespace isograsp::gui {

Preparing::Preparing(const ActContext& with, NextWork& next)
    : state_(with.state),
      flow_(with.flow),
      seating_(with.seating),
      example_(with.example),
      clock_(with.clock),
      next_(next) {}

void Preparing::set_zero(bool accept_changed) {
  const FlowView& view = flow_.view();
  if (!(accept_changed ? view.may_accept_changed : view.may_zero)) return;
  example_.stop();
  Preparation& preparation = state_.open->preparation;
  preparation.zero_refusal = {};
  preparation.zero_remark = {};
  preparation.zero_only_changed = false;
  session::ZeroRequest request;
  request.device_is_empty = true;
  request.accept_changed = accept_changed;
  if (auto started = state_.open->session->start_zero(request); started) {
    preparation.zero_asked = true;
    preparation.strapped = false;  // the hand is out
  } else {
    flow_.refuse(started.error());
  }
  flow_.update();
}

void Preparing::take(const session::PreparationOutcome& zero) {
  OpenSession& open = *state_.open;
  Preparation& preparation = open.preparation;
  preparation.zero_asked = false;
  preparation.zero_refusal = zero.accepted ? Text() : zero.reason;
  preparation.zero_only_changed = zero.only_changed;
  preparation.zero_remark = zero.remark;
  if (zero.accepted) {
    if (!preparation.rest_done && open.session->known().asks_for(session::PreparationStep::rest))
      next_.select_first(is_rest);
    open.work.guide.zeroed(open.time_s());
    preparation.zeroed_at = clock_.now();
    next_.look_at_act();
  }
  Q_EMIT flow_.changed();
}

void Preparing::check_picture() {
  auto& open = state_.open;
  if (!open) return;
  if (open->picture_check.running())
    open->picture_check.stop();
  else if (flow_.view().may_watch_picture)
    open->picture_check.begin();
  flow_.update();
}

/// What came of it is stored with the session.
void Preparing::look_at_picture() {
  OpenSession& open = *state_.open;
  PictureCheck& check = open.picture_check;
  if (!check.running()) return;
  if (!flow_.view().may_watch_picture) check.stop();  // a trial begins, or the cameras fail
  if (!check.add(open.moved_on_screen(), open.time_s())) return;
  if (check.over()) {
    std::vector<storage::SessionAnswer> answers;
    for (std::size_t k = 0; k < PictureCheck::kWays; ++k) {
      constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
      const std::string way(name_of(static_cast<PictureCheck::Way>(k)));
      answers.push_back(
          {"picture_check", way + "_off_deg",
           QString::number(kDegreesPerRad * *check.off_rad()[k], 'f', 1).toStdString()});
    }
    if (auto taken = open.session->answer(answers); !taken) flow_.refuse(taken.error());
  }
  Q_EMIT flow_.changed();
}

void Preparing::check_platforms() {
  if (!flow_.view().may_check_platforms) return;
  CrossTalkCheck& check = state_.open->crosstalk;
  if (check.running())
    check.stop();
  else
    check.begin();
  flow_.update();
}

void Preparing::skip_platforms_check() {
  if (!flow_.view().may_check_platforms || state_.open->crosstalk.settled()) return;
  state_.open->crosstalk.skip();
  store_platforms_check();
  flow_.update();
}

void Preparing::look_at_platforms() {
  OpenSession& open = *state_.open;
  CrossTalkCheck& check = open.crosstalk;
  if (!open.both || !check.running()) return;
  if (!flow_.view().may_check_platforms) check.stop();  // a zero is set, or a platform fails
  if (!check.add(*open.both)) return;
  if (check.settled()) store_platforms_check();
  Q_EMIT flow_.changed();
}

void Preparing::store_platforms_check() {
  OpenSession& open = *state_.open;
  session::platforms_checked(*open.session, open.crosstalk.coupled());
  if (auto taken = open.session->answer(stored(open.crosstalk)); !taken)
    flow_.refuse(taken.error());
}

void Preparing::stay_within_reach(bool stays) {
  if (!flow_.view().may_promise_reach) return;
  state_.open->preparation.safety.within_reach = stays;
  flow_.update();
}

void Preparing::other_hand_strapped(bool strapped) {
  if (!state_.open) return;
  state_.open->preparation.safety.other_strapped = strapped;
  flow_.update();
}

void Preparing::mark_strapped() {
  if (!flow_.view().may_strap) return;
  example_.stop();
  OpenSession& open = *state_.open;
  Preparation& preparation = open.preparation;
  open.limits.straps_seen(open.time_s());
  if (preparation.strapped) {  // looked at again
    open.session->note("The straps were looked at.");
    return flow_.update();
  }
  open.session->strapped();
  preparation.strapped = true;
  // The hand is in: after its minute the resting force follows, or what comes, if that is wanted.
  if (open.work.follows() && (open.work.guide.rest_is_next() || preparation.rest_done))
    open.work.guide.go_on(state_.choices.by_itself);
  open.compensation.strapped();
  preparation.shift_noted = {};
  auto answers = seating_.posture_answers();
  if (open.both)
    for (auto& answer : stored(preparation.safety)) answers.push_back(std::move(answer));
  if (preparation.zeroed_at) {
    const double donning_s = to_seconds(clock_.now() - *preparation.zeroed_at);
    answers.push_back(
        {"posture", "donning_time_s", QString::number(donning_s, 'f', 4).toStdString()});
  }
  if (auto taken = open.session->answer(answers); !taken) flow_.refuse(taken.error());
  flow_.update();
}

void Preparing::look() {
  OpenSession& open = *state_.open;
  look_at_picture();
  look_at_platforms();
  open.compensation.add(open.snapshot);
  for (const Finger finger : kFingers) {
    const auto shift_m = open.compensation.pad_shift_m(finger);
    bool& noted = open.preparation.shift_noted[index_of(finger)];
    if (noted || !shift_m || *shift_m <= session::kRemarkablePadShift_m) continue;
    noted = true;
    open.session->note("Pad shift: " + std::string(name_of(finger)) + " moved " +
                       std::to_string(std::lround(*shift_m * 1000.0)) + " mm on its support");
  }
}

}  // namespace isograsp::gui
