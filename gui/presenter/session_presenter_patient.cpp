// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that concerns the patient's body and eyes: how they sit, what their screen
// shows, and how old that is.
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

void SessionPresenter::mark_strapped() {
  if (!view_.may_strap) return;
  example_.stop();
  if (strapped_) {  // looked at again
    session_->note("The straps were looked at.");
    limits_.straps_seen(session_time_s());
    return update();
  }
  limits_.straps_seen(session_time_s());
  session_->strapped();
  strapped_ = true;
  // The hand is in: after its minute the resting force follows, or what comes, if that is wanted.
  if (follows() && (guide_.rest_is_next() || rest_done_)) guide_.go_on(by_itself_);
  compensation_.strapped();
  shift_noted_ = {};
  auto answers = stored(seating_.posture());
  if (zeroed_at_)
    answers.push_back(
        {"posture", "donning_time_s", seconds_text(to_seconds(clock_.now() - *zeroed_at_))});
  if (auto taken = session_->answer(answers); !taken) refuse(taken.error());
  update();
}

/// A finger that moved is noted with the session, once: its forces mean something else since then.
void SessionPresenter::watch_compensation() {
  compensation_.add(snapshot_);
  for (const Finger finger : kFingers) {
    const auto shift_m = compensation_.pad_shift_m(finger);
    bool& noted = shift_noted_[index_of(finger)];
    if (noted || !shift_m || *shift_m <= session::kRemarkablePadShift_m) continue;
    noted = true;
    session_->note("Pad shift: " + std::string(name_of(finger)) + " moved " +
                   std::to_string(std::lround(*shift_m * 1000.0)) + " mm on its support");
  }
}

void SessionPresenter::add_screen_answers(std::vector<storage::SessionAnswer>& answers) {
  stored_presentation_ = seating_.presentation();
  for (auto& answer : stored(stored_presentation_)) answers.push_back(std::move(answer));
  const auto delay_s = settings_.now().display_delay_s;
  answers.push_back(
      {"screen", "display_delay_s", delay_s ? seconds_text(*delay_s) : "not measured"});
}

/// What was changed while a session is open is stored with it, too.
void SessionPresenter::store_presentation() {
  if (session_ != nullptr && seating_.presentation() != stored_presentation_) {
    stored_presentation_ = seating_.presentation();
    if (auto taken = session_->answer(stored(stored_presentation_)); !taken) refuse(taken.error());
  }
  Q_EMIT changed();
}

double SessionPresenter::shown_maximum_N() const noexcept {
  const bool wanted = settings_.now().share_of_maximum && session_ != nullptr;
  return wanted ? session_->maximum_force_N() : 0.0;
}

Viewing SessionPresenter::viewing(double picture_height_m) const {
  return {picture_height_m, settings_.now().viewing_distance_m};
}

PatientPicture SessionPresenter::picture(double picture_height_m) const {
  PatientFacts facts;
  if (example_.playing()) {
    facts = example_.facts();
  } else {
    facts.session_open = session_ != nullptr;
    facts.simulated = simulated();
    facts.device_fault = session_ != nullptr && snapshot_.frames > 0 &&
                         snapshot_.stage != session::Stage::finished &&
                         view_.device_mood == Mood::fault;
    facts.broken_off = session_ == nullptr && broken_off_;
    facts.hand = session_ == nullptr ? Hand::right : session_->record().hand;
    facts.snapshot = snapshot_;
    facts.task = running_;
    facts.scene = scene_;
    facts.preview = preview_;
    facts.maximum_force_N = session_ == nullptr ? 0.0 : session_->maximum_force_N();
    facts.just_completed = just_completed_;
    facts.just_missed = just_missed_;
    if (snapshot_.stage == session::Stage::trial)
      facts.ahead_s =
          std::clamp(to_seconds(clock_.now() - snapshot_.published), 0.0, kLongestAhead_s);
  }
  facts.calm = seating_.presentation().calm;
  facts.viewing = viewing(picture_height_m);
  return picture_for(facts);
}

void SessionPresenter::picture_shown(const PatientPicture& picture) {
  if (session_ == nullptr || snapshot_.stage != session::Stage::trial || example_.playing()) return;
  picture_age_.add(to_seconds(clock_.now() - picture.published));
  if (picture_age_.count() % kRenewEvery != 0) return;
  session::ScreenShown screen;
  screen.age_s = picture_age_.quantile_s(0.5);
  screen.gain_deg_per_N = picture.gain_deg_per_N;
  if (picture.gain_deg_per_N) screen.distance_m = settings_.now().viewing_distance_m;
  session_->shown(screen);
  if (picture_age_.count() == kRenewEvery) say_smaller_gain(screen.gain_deg_per_N);
}

/// Once a trial.
void SessionPresenter::say_smaller_gain(std::optional<double> shown) {
  constexpr double kSame = 1.0 - 1e-9;  // of the same number, reckoned twice
  if (preview_ == nullptr || !preview_->gain_deg_per_N || !shown ||
      *shown >= kSame * *preview_->gain_deg_per_N)
    return;
  Q_EMIT failed(tr("The task asks for %1° per newton; the patient's screen can show %2°, which is "
                   "stored. Nearer eyes or a larger picture show more.")
                    .arg(QLocale().toString(*preview_->gain_deg_per_N, 'g', 3),
                         QLocale().toString(*shown, 'g', 3)));
}

}  // namespace isograsp::gui
