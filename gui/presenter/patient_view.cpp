// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/patient_view.hpp"

#include <QLocale>
#include <algorithm>

#include "gui/presenter/patient_facts.hpp"

namespace isograsp::gui {

namespace {

/// The newest state is drawn as it will be when the picture appears, but never further ahead than
/// this: a state that is older stands still.
constexpr double kLongestAhead_s = 0.03;
/// What is stored with the trial is renewed after so many pictures.
constexpr std::uint64_t kRenewEvery = 30;

}  // namespace

PatientView::PatientView(const ActContext& with)
    : state_(with.state),
      flow_(with.flow),
      settings_(with.settings),
      seating_(with.seating),
      example_(with.example),
      clock_(with.clock) {}

namespace {

PatientFacts facts_of_session(const OpenSession& open) {
  if (open.both) return patient_facts(*open.both);
  if (open.hand) return patient_facts(*open.hand);
  return open.arm ? patient_facts(*open.arm) : patient_facts(open.snapshot);
}

}  // namespace

PatientFacts PatientView::facts() const {
  PatientFacts facts = state_.open ? facts_of_session(*state_.open) : PatientFacts{};
  facts.simulated = state_.simulated();
  facts.broken_off = !state_.open && state_.broken_off();
  if (!state_.open) return facts;
  const OpenSession& open = *state_.open;
  const session::Snapshot& now = open.snapshot;
  facts.session_open = true;
  facts.both_hands = measures_both(state_);
  facts.device_fault = now.frames > 0 && now.stage != session::Stage::finished &&
                       flow_.view().device_mood == Mood::fault;
  facts.arm = open.arm_space;
  facts.hand = open.session->known().record.hand.value_or(Hand::right);
  facts.maximum_force_N = open.session->known().maximum_force_N();
  if (const auto& trial = open.trial) {
    facts.task = trial->task;
    facts.scene = trial->scene;
    facts.preview = trial->preview;
  } else if (open.ended) {
    facts.just_completed = open.ended->completed;
    facts.just_missed = open.ended->missed;
  }
  if (const auto& act = open.work.guide.act(); act && open.work.follows() && !open.trial) {
    facts.rest_left_s = open.work.guide.wait_s(now.session_time_s);
    facts.trains = act->adaptive;
  }
  if (now.stage == session::Stage::trial)
    facts.ahead_s = std::clamp(to_seconds(clock_.now() - now.published), 0.0, kLongestAhead_s);
  return facts;
}

PatientPicture PatientView::picture(double picture_height_m) const {
  PatientFacts seen = example_.playing() ? example_.facts() : facts();
  seen.calm = seating_.presentation().calm;
  seen.viewing = {picture_height_m, settings_.now().viewing_distance_m};
  return picture_for(seen);
}

void PatientView::picture_shown(const PatientPicture& picture) {
  if (!state_.open || !state_.open->trial || example_.playing()) return;
  OpenSession& open = *state_.open;
  if (open.snapshot.stage != session::Stage::trial) return;
  Histogram& age = open.trial->picture_age;
  age.add(to_seconds(clock_.now() - picture.published));
  if (age.count() % kRenewEvery != 0) return;
  session::ScreenShown screen;
  screen.age_s = age.quantile_s(0.5);
  screen.gain_deg_per_N = picture.gain_deg_per_N;
  if (picture.gain_deg_per_N) screen.distance_m = settings_.now().viewing_distance_m;
  open.session->shown(screen);
  if (age.count() == kRenewEvery) say_smaller_gain(screen.gain_deg_per_N);
}

/// Once a trial.
void PatientView::say_smaller_gain(std::optional<double> shown) {
  constexpr double kSame = 1.0 - 1e-9;  // the same number, computed in two ways
  const auto& asked = state_.open->trial->preview->gain_deg_per_N;
  if (!asked || !shown || *shown >= kSame * *asked) return;
  Q_EMIT flow_.failed(
      SessionFlow::tr("The task asks for %1° per newton; the patient's screen can show %2°, which "
                      "is stored. Nearer eyes or a larger picture show more.")
          .arg(QLocale().toString(*asked, 'g', 3), QLocale().toString(*shown, 'g', 3)));
}

void PatientView::store_presentation() {
  if (state_.open && seating_.presentation() != state_.open->stored_presentation) {
    OpenSession& open = *state_.open;
    open.stored_presentation = seating_.presentation();
    if (auto taken = open.session->answer(stored(open.stored_presentation)); !taken)
      flow_.refuse(taken.error());
  }
  Q_EMIT flow_.changed();
}

}  // namespace isograsp::gui
