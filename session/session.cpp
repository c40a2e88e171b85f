// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "session/library/arm_rules.hpp"
#include "session/library/hand_rules.hpp"
#include "session/resting.hpp"
#include "session/session_parts.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "storage/records/trial_answers.hpp"

namespace isograsp::session {

Session::Session(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Session::~Session() {
  close();
}

const SessionKnowledge& Session::known() const noexcept {
  return parts_->known;
}
const Moment& Session::moment() noexcept {
  return parts_->apparatus->newest();
}
const Snapshot& Session::snapshot() noexcept {
  Parts& p = *parts_;
  if (p.platform != nullptr) return p.platform->snapshots().read();
  static_cast<Moment&>(p.blank) = moment();
  if (!p.known.asks_for(PreparationStep::zero)) p.blank.zeroed = true;
  return p.blank;
}
std::vector<Measure> Session::live_score() const {
  return parts_->recorder->live_score();
}

void Session::strapped() {
  const double now_s = moment().session_time_s;
  parts_->strapped_at_s = now_s;
  parts_->recorder->add_event({std::nullopt, now_s, "strapped", ""});
}

double Session::settling_s() noexcept {
  const auto& at_s = parts_->strapped_at_s;
  return at_s ? std::max(0.0,
                         *at_s + parts_->config.settle_after_strapping_s - moment().session_time_s)
              : 0.0;
}

Result<void> Session::start_zero(const ZeroRequest& request) {
  Parts& p = *parts_;
  auto made = p.apparatus->make_preparation(request);
  if (!made) return made.error();
  if (p.pending) return failed("a trial or a zero is still running"_text, "wait for its end"_text);
  auto sent = p.send({.kind = Command::Kind::prepare, .preparation = made->get()});
  if (!sent) return sent;
  p.preparations.push_back(*std::move(made));
  p.pending = true;
  p.strapped_at_s.reset();
  return {};
}

Result<void> Session::start_trial(const tasks::TaskSpec& spec, bool practice,
                                  std::optional<storage::TrialPlace> place) {
  Parts& p = *parts_;
  if (p.pending) return failed("a trial or a zero is still running"_text, "wait for its end"_text);
  if (const double wait_s = settling_s(); wait_s > 0.0 && spec.kind->rests)
    return failed("the hand was strapped less than a minute ago and still settles"_text,
                  "wait another %1 s"_text(std::lround(std::ceil(wait_s))));
  if (auto ready = p.apparatus->ready(); !ready) return ready;
  if (auto fits = check_apparatus(spec.apparatus(), p.known.apparatus); !fits) return fits;
  if (!practice) {
    if (auto assessed = check_assessment(spec); !assessed) return assessed;
    if (auto assessed = check_hand_assessment(spec); !assessed) return assessed;
  }
  auto prepared = p.apparatus->make_trial(spec, p.known.next_context());
  if (!prepared) return prepared.error();
  auto setup = *std::move(prepared);
  if (p.strapped_at_s) setup->since_strapping_s = moment().session_time_s - *p.strapped_at_s;
  storage::TrialRecord& record = setup->record;
  record.session_id = p.known.record.id;
  record.number = static_cast<int>(p.setups.size()) + 1;
  record.practice = practice;
  record.place = place;
  auto sent = p.send({.kind = Command::Kind::begin, .setup = setup.get()});
  if (!sent) return sent;
  p.setups.push_back(std::move(setup));
  ++p.known.trials_begun;
  p.pending = p.in_trial = true;
  p.helped = false;
  return {};
}

void Session::pause() {
  (void)parts_->send({.kind = Command::Kind::pause});
}
void Session::resume() {
  (void)parts_->send({.kind = Command::Kind::resume});
}
void Session::abort(Words reason) {
  (void)parts_->send({.kind = Command::Kind::abort, .reason = reason});
}

void Session::note(const std::string& text) {
  parts_->recorder->add_event({std::nullopt, moment().session_time_s, "note", text});
}

Result<void> Session::answer(const std::vector<storage::SessionAnswer>& answers) {
  for (const auto& answer : answers)
    if (auto good = storage::check_answer(answer); !good) return good;
  parts_->recorder->add_answers(answers);
  return {};
}

void Session::shown(const ScreenShown& screen) {
  parts_->recorder->set_screen(screen);
}

void Session::mark_helped(bool helped) {
  Parts& p = *parts_;
  p.helped = helped;
  if (p.in_trial || !p.last) return;  // a running trial is marked at its end
  p.last->trial.helped = helped;
  p.recorder->mark_helped(p.last->trial.id, helped);
  static_cast<Lessons&>(p.known) = p.before_last;
  p.learn(*p.last);
}

void Session::answer_question(const std::string& question, std::optional<int> number) {
  if (!parts_->last) return;
  parts_->recorder->add_event({parts_->last->trial.id, moment().session_time_s,
                               storage::kAnswerEvent, storage::answer_text(question, number)});
}

std::optional<Text> Session::rate(int effort, int pain, std::optional<int> shoulder_pain,
                                  Said said) {
  auto& all = parts_->ratings;
  const bool anew = said == Said::anew;
  if (anew) all.emplace_back().session_time_s = moment().session_time_s;
  storage::RatingRecord& rating = all.back();
  rating.effort = effort;
  rating.pain = pain;
  rating.shoulder_pain = shoulder_pain;
  if (anew) {
    parts_->recorder->add_rating(rating);
  } else {
    storage::RatingRecord correction = rating;
    correction.session_time_s = moment().session_time_s;
    parts_->recorder->correct_rating(correction);
  }
  return reason_to_stop(all);
}

std::vector<SessionNews> Session::take_news() {
  auto news = parts_->recorder->take_news();
  parts_->learn(news);
  return news;
}

std::vector<SessionNews> Session::wait_for_news() {
  Parts& p = *parts_;
  for (;;) {
    auto news = take_news();
    if (!news.empty() || !p.pending || is_to_stop()) return news;
    if (p.virtual_time()) {
      if (p.finished) return take_news();
      p.step();
    } else {
      if (moment().stage == Stage::finished) {
        // The recorder may still be writing what came last.
        constexpr double kGrace_s = 5.0;
        p.recorder->wait_for_news(kGrace_s);
        return take_news();
      }
      constexpr double kLook_s = 0.5;
      p.recorder->wait_for_news(kLook_s);
    }
  }
}

void Session::let_pass(double duration_s) {
  Parts& p = *parts_;
  if (!p.virtual_time()) {
    using Steady = std::chrono::steady_clock;
    const auto end = Steady::now() + std::chrono::duration_cast<Steady::duration>(
                                         std::chrono::duration<double>(duration_s));
    constexpr auto kLook = std::chrono::milliseconds(100);
    while (!is_to_stop() && !failure() && Steady::now() < end)
      std::this_thread::sleep_for(std::min<Steady::duration>(kLook, end - Steady::now()));
    return;
  }
  const double until_s = moment().session_time_s + duration_s;
  while (!p.finished && !is_to_stop() && moment().session_time_s < until_s) p.step();
}

void Session::close() {
  Parts& p = *parts_;
  if (p.closed) return;
  p.closed = true;
  p.config.stop = nullptr;  // the end is waited for
  if (p.pending) abort("The session was closed."_text);
  constexpr int kTries = 3;  // news of a failure may come before those of the trial
  for (int tries = 0; p.pending && tries < kTries; ++tries) (void)wait_for_news();
  p.threads.stop();
  p.apparatus->stop();
  p.recorder->pump();
  // Virtual time has its own end.
  p.recorder->end_session(p.virtual_time() ? std::optional(moment().session_time_s) : std::nullopt);
}

std::optional<Error> Session::failure() const {
  return parts_->recorder->failure();
}

bool Session::is_to_stop() const noexcept {
  const auto* const stop = parts_->config.stop;
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

void let_go(Session& session) {
  (void)session.parts_->send({.kind = Command::Kind::let_go});
}

void hold_clutch(Session& session, bool held) {
  (void)session.parts_->send({.kind = Command::Kind::clutch, .held = held});
}

void platforms_checked(Session& session, std::optional<bool> coupled) noexcept {
  session.parts_->known.two_hands.coupled = coupled;
}

std::string stored_until_utc(const Session& session) {
  return session.parts_->recorder->stored_until_utc();
}

const ArmSnapshot* arm_of(Session& session) noexcept {
  // What an arm publishes is one (MarkerArm::newest).
  return session.known().arm ? static_cast<const ArmSnapshot*>(&session.moment()) : nullptr;
}

const HandSnapshot* hand_of(Session& session) noexcept {
  // What a tracked hand publishes is one (TrackedHand::newest).
  return session.known().apparatus.kind == TrackedHand::kKind
             ? static_cast<const HandSnapshot*>(&session.moment())
             : nullptr;
}

const TwoPlatformsSnapshot* two_platforms_of(Session& session) noexcept {
  // What two platforms publish is one (TwoPlatforms::newest).
  return session.known().apparatus.kind == TwoPlatforms::kKind
             ? static_cast<const TwoPlatformsSnapshot*>(&session.moment())
             : nullptr;
}

}  // namespace isograsp::session
