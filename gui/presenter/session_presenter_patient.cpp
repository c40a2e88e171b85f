// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that concerns the patient's body and eyes: the empty device and the strapped
// hand, what their screen shows, and how old that is.
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

namespace {

/// The newest state is drawn as it will be when the picture appears, but never further ahead than
/// this: a state that is older stands still.
constexpr double kLongestAhead_s = 0.03;
/// What is stored with the trial is renewed after so many pictures.
constexpr std::uint64_t kRenewEvery = 30;

/// "0.031"; the C locale.
std::string seconds_text(double seconds) {
  const auto text = QString::number(seconds, 'f', 4);
  return text.toStdString();
}

}  // namespace

void SessionPresenter::set_zero(bool accept_changed) {
  if (!(accept_changed ? view_.may_accept_changed : view_.may_zero)) return;
  example_.stop();
  Preparation& preparation = open_->preparation;
  preparation.zero_refusal.clear();
  preparation.zero_remark.clear();
  preparation.zero_only_changed = false;
  session::ZeroRequest request;
  request.device_is_empty = true;
  request.accept_changed = accept_changed;
  if (auto started = open_->session->start_zero(request); started) {
    preparation.zero_asked = true;
    preparation.strapped = false;  // the hand is out
  } else {
    refuse(started.error());
  }
  update();
}

void SessionPresenter::take_zero(const session::ZeroOutcome& zero) {
  Preparation& preparation = open_->preparation;
  preparation.zero_asked = false;
  preparation.zero_refusal = zero.accepted ? "" : zero.reason;
  preparation.zero_only_changed = zero.only_changed;
  preparation.zero_remark = zero.remark;
  if (zero.accepted) {
    if (!preparation.rest_done) select(first_task(is_rest));
    open_->work.guide.zeroed(open_->time_s());
    preparation.zeroed_at = clock_.now();
    look_at_act();
  }
  Q_EMIT changed();
}

void SessionPresenter::mark_strapped() {
  if (!view_.may_strap) return;
  example_.stop();
  Preparation& preparation = open_->preparation;
  open_->limits.straps_seen(open_->time_s());
  if (preparation.strapped) {  // looked at again
    open_->session->note("The straps were looked at.");
    return update();
  }
  open_->session->strapped();
  preparation.strapped = true;
  // The hand is in: after its minute the resting force follows, or what comes, if that is wanted.
  if (follows() && (guide().rest_is_next() || preparation.rest_done))
    open_->work.guide.go_on(choices_.by_itself);
  open_->compensation.strapped();
  preparation.shift_noted = {};
  auto answers = stored(seating_.posture());
  if (preparation.zeroed_at)
    answers.push_back({"posture", "donning_time_s",
                       seconds_text(to_seconds(clock_.now() - *preparation.zeroed_at))});
  if (auto taken = open_->session->answer(answers); !taken) refuse(taken.error());
  update();
}

/// A finger that moved is noted with the session, once: its forces mean something else since then.
void SessionPresenter::watch_compensation() {
  open_->compensation.add(open_->snapshot);
  for (const Finger finger : kFingers) {
    const auto shift_m = open_->compensation.pad_shift_m(finger);
    bool& noted = open_->preparation.shift_noted[index_of(finger)];
    if (noted || !shift_m || *shift_m <= session::kRemarkablePadShift_m) continue;
    noted = true;
    open_->session->note("Pad shift: " + std::string(name_of(finger)) + " moved " +
                         std::to_string(std::lround(*shift_m * 1000.0)) + " mm on its support");
  }
}

std::vector<storage::SessionAnswer> SessionPresenter::screen_answers() const {
  auto answers = stored(seating_.presentation());
  const auto delay_s = settings_.now().display_delay_s;
  answers.push_back(
      {"screen", "display_delay_s", delay_s ? seconds_text(*delay_s) : "not measured"});
  return answers;
}

/// What was changed while a session is open is stored with it, too.
void SessionPresenter::store_presentation() {
  if (open_ && seating_.presentation() != open_->stored_presentation) {
    open_->stored_presentation = seating_.presentation();
    if (auto taken = open_->session->answer(stored(open_->stored_presentation)); !taken)
      refuse(taken.error());
  }
  Q_EMIT changed();
}

double SessionPresenter::shown_maximum_N() const noexcept {
  const bool wanted = settings_.now().share_of_maximum && open_;
  return wanted ? open_->session->maximum_force_N() : 0.0;
}

Viewing SessionPresenter::viewing(double picture_height_m) const {
  return {picture_height_m, settings_.now().viewing_distance_m};
}

PatientFacts SessionPresenter::patient_facts() const {
  PatientFacts facts;
  facts.simulated = simulated();
  facts.broken_off = !open_ && broken_off();
  if (!open_) return facts;
  const session::Snapshot& now = open_->snapshot;
  facts.session_open = true;
  facts.device_fault =
      now.frames > 0 && now.stage != session::Stage::finished && view_.device_mood == Mood::fault;
  facts.hand = open_->session->record().hand;
  facts.snapshot = now;
  facts.maximum_force_N = open_->session->maximum_force_N();
  if (const auto& trial = open_->trial) {
    facts.task = trial->task;
    facts.scene = trial->scene;
    facts.preview = trial->preview;
  } else if (open_->ended) {
    facts.just_completed = open_->ended->completed;
    facts.just_missed = open_->ended->missed;
  }
  if (now.stage == session::Stage::trial)
    facts.ahead_s = std::clamp(to_seconds(clock_.now() - now.published), 0.0, kLongestAhead_s);
  return facts;
}

PatientPicture SessionPresenter::picture(double picture_height_m) const {
  PatientFacts facts = example_.playing() ? example_.facts() : patient_facts();
  facts.calm = seating_.presentation().calm;
  facts.viewing = viewing(picture_height_m);
  return picture_for(facts);
}

void SessionPresenter::picture_shown(const PatientPicture& picture) {
  if (!open_ || !open_->trial || example_.playing()) return;
  if (open_->snapshot.stage != session::Stage::trial) return;
  Histogram& age = open_->trial->picture_age;
  age.add(to_seconds(clock_.now() - picture.published));
  if (age.count() % kRenewEvery != 0) return;
  session::ScreenShown screen;
  screen.age_s = age.quantile_s(0.5);
  screen.gain_deg_per_N = picture.gain_deg_per_N;
  if (picture.gain_deg_per_N) screen.distance_m = settings_.now().viewing_distance_m;
  open_->session->shown(screen);
  if (age.count() == kRenewEvery) say_smaller_gain(screen.gain_deg_per_N);
}

/// Once a trial.
void SessionPresenter::say_smaller_gain(std::optional<double> shown) {
  constexpr double kSame = 1.0 - 1e-9;  // of the same number, reckoned twice
  const auto& asked = open_->trial->preview->gain_deg_per_N;
  if (!asked || !shown || *shown >= kSame * *asked) return;
  Q_EMIT failed(tr("The task asks for %1° per newton; the patient's screen can show %2°, which is "
                   "stored. Nearer eyes or a larger picture show more.")
                    .arg(QLocale().toString(*asked, 'g', 3), QLocale().toString(*shown, 'g', 3)));
}

}  // namespace isograsp::gui
