// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that follows a protocol, and what a therapist does between its trials.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "gui/presenter/session_presenter.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

using Act = session::ProtocolWalk::Act;

/// The protocol that is proposed; any other is one choice away.
constexpr const char* kUsualProtocol = "battery";
/// One press on "easier" or "harder", of the whole range of levels.
constexpr double kLevelStep = 0.1;

bool starts_with(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// "Grip force, sine, practice (2 of 3)"
std::string words_of(const Act& act) {
  if (act.kind != Act::Kind::trial) return shown(act.words()).toStdString();
  auto words = shown(act.task->name);
  if (act.practice) words = SessionPresenter::tr("%1, practice").arg(words);
  if (act.planned > 1)
    words = SessionPresenter::tr("%1 (%2 of %3)").arg(words).arg(act.attempt).arg(act.planned);
  return words.toStdString();
}

/// As far as the work of an earlier session is looked for by it.
storage::SessionRecord session_to_come(storage::RowId patient, Hand hand,
                                       const std::string& device_uri,
                                       const tasks::ProtocolSpec& protocol) {
  storage::SessionRecord session;
  session.patient_id = patient;
  session.hand = hand;
  session.simulated = starts_with(device_uri, "sim://");
  session.started_utc = utc_text(std::time(nullptr));
  session.protocol_name = protocol.name;
  session.protocol_text = protocol.text;
  return session;
}

}  // namespace

void SessionPresenter::reload_library() {
  worker_.run(
      [shipped = config_.library, own = session::own_library_folder(config_.database)] {
        return read_session_library(shipped, own);
      },
      [this](SessionLibrary library) { newer_library_ = std::move(library); });
}

void SessionPresenter::take_library(SessionLibrary library) {
  const bool first = library_.tasks.empty() && library_.protocols.empty();
  const auto task =
      task_ < 0 ? std::string() : library_.tasks[static_cast<std::size_t>(task_)].file;
  std::optional<session::ReadyProtocol> chosen;
  if (protocol_ != kByHand) chosen = library_.protocols[static_cast<std::size_t>(protocol_)];
  library_ = std::move(library);
  task_ = place_of_file(library_.tasks, task);
  if (task_ < 0) select_first(TaskKind::rest);
  look_at_task();
  auto& protocols = library_.protocols;
  if (chosen) {
    protocol_ = place_of_file(protocols, chosen->spec.file);
    // A session that follows a protocol whose file is gone follows it to its end.
    if (protocol_ < 0 && connection_ != Connection::none) {
      protocol_ = static_cast<int>(protocols.size());
      protocols.push_back(*chosen);
    }
    const bool same = protocol_ != kByHand &&
                      protocols[static_cast<std::size_t>(protocol_)].spec.text == chosen->spec.text;
    if (!same) look_for_earlier();
  } else if (first) {
    for (std::size_t i = 0; i < protocols.size(); ++i)
      if (fs::path(protocols[i].spec.file).stem() == kUsualProtocol)
        protocol_ = static_cast<int>(i);
  }
  Q_EMIT library_changed();
}

void SessionPresenter::choose_protocol(int index) {
  if (connection_ != Connection::none || index == protocol_) return;
  forget_failure();
  protocol_ = index;
  look_for_earlier();
  update();
}

void SessionPresenter::answer_screening(const Screening& answers) {
  if (connection_ != Connection::none || answers == screening_) return;
  forget_failure();
  screening_ = answers;
  update();
}

/// Asks the database whether the chosen protocol was interrupted today.
void SessionPresenter::look_for_earlier() {
  const int lookup = ++lookups_;
  looking_ = false;
  earlier_.reset();
  resume_.reset();
  if (patient_.empty() || !hand_ || device_uri_.empty() || !has_protocol()) return;
  looking_ = clinic_.read(
      this,
      [code = patient_, hand = *hand_, uri = device_uri_,
       protocol = library_.protocols[static_cast<std::size_t>(protocol_)]](
          storage::SessionStore& store) -> std::optional<int> {
        const auto patient = store.find_patient(code);
        if (!patient || !*patient) return std::nullopt;
        const auto session = session_to_come((*patient)->id, hand, uri, protocol.spec);
        const auto work = session::read_earlier_work(store, session);
        if (!work) return std::nullopt;  // nothing to resume
        const session::ProtocolWalk walk(protocol, *work, session::order_seed(session, *work));
        return walk.acts_done() > 0 ? std::optional(walk.acts_done()) : std::nullopt;
      },
      [this, lookup](std::optional<int> acts) {
        if (lookup != lookups_) return;  // something else was chosen meanwhile
        looking_ = false;
        earlier_ = acts;
        update();
      });
}

void SessionPresenter::decide_earlier(bool go_on) {
  if (!earlier_ || connection_ != Connection::none) return;
  forget_failure();
  resume_ = go_on;
  update();
}

/// A recording follows none: whatever was done in it is done.
bool SessionPresenter::has_protocol() const noexcept {
  return protocol_ != kByHand && !starts_with(device_uri_, "replay://");
}

void SessionPresenter::begin_protocol() {
  by_hand_ = false;
  if (has_protocol())
    guide_.begin(library_.protocols[static_cast<std::size_t>(protocol_)], session_->earlier(),
                 session_->order_seed());
  look_at_act();
}

/// The task of the act at its level, once per act.
void SessionPresenter::look_at_act() {
  act_task_.reset();
  if (const auto& act = guide_.act(); act && act->kind == Act::Kind::trial) {
    auto spec = session::task_of(*act, session_->training());
    if (spec && act->adaptive) spec = at_chosen_level(*spec);
    if (spec)
      act_task_ = *std::move(spec);
    else
      refuse(spec.error());
  }
  look_at_task();
}

ProtocolFacts SessionPresenter::protocol_facts() const {
  ProtocolFacts facts;
  facts.active = true;
  facts.goes_on = guide_.goes_on();
  facts.by_itself = by_itself_;
  const auto& act = guide_.act();
  if (!act) return facts;
  switch (act->kind) {
    case Act::Kind::instrument_zero: facts.act = ProtocolFacts::Act::zero; break;
    case Act::Kind::pause: facts.act = ProtocolFacts::Act::pause; break;
    case Act::Kind::trial: facts.act = ProtocolFacts::Act::trial; break;
  }
  facts.act_words = words_of(*act);
  facts.wait_s = static_cast<int>(std::ceil(guide_.wait_s(session_time_s())));
  facts.start_in_s = static_cast<int>(std::ceil(guide_.start_in_s(session_time_s())));
  return facts;
}

/// Pauses end, and what begins by itself begins.
void SessionPresenter::follow_time() {
  if (session_ == nullptr || !follows()) return;
  const auto before = guide_.act();
  guide_.tick(session_time_s());
  if (before.has_value() != guide_.act().has_value() ||
      (before && before->step != guide_.act()->step))
    look_at_act();
  if (!guide_.goes_on() || !act_task_) return;
  view_ = decide(facts());
  if (view_.must_stand_by) return guide_.go_on(false);
  // Nothing begins by itself before the word that the hand is in.
  const bool hand_is_in =
      view_.situation != Situation::strap_in && view_.situation != Situation::strap_again;
  if (view_.may_begin && hand_is_in && guide_.start_in_s(session_time_s()) <= 0.0) begin_next();
}

void SessionPresenter::leave_out(const Error& why) {
  const auto words = guide_.act()->task->name + ": " + why.what + "; " + why.remedy;
  session_->note("Left out: " + words);
  Q_EMIT failed(tr("Left out: %1: %2; %3")
                    .arg(shown(guide_.act()->task->name), shown(why.what), shown(why.remedy)));
  guide_.skip(session_time_s());
  look_at_act();
  update();
}

void SessionPresenter::choose_by_hand() {
  if (!guide_.active() || by_hand_ || !view_.may_choose_task) return;
  example_.stop();
  guide_.go_on(false);
  by_hand_ = true;
  look_at_task();
  update();
}

std::string SessionPresenter::next_words() const {
  if (follows()) return guide_.act() ? words_of(*guide_.act()) : std::string();
  const auto* spec = next_task();
  return spec == nullptr ? std::string() : shown(spec->name).toStdString();
}

void SessionPresenter::follow_protocol() {
  if (!guide_.active() || !by_hand_ || !view_.may_choose_task) return;
  example_.stop();
  by_hand_ = false;
  look_at_act();
  update();
}

void SessionPresenter::stand_by() {
  if (!view_.may_stand_by) return;
  guide_.go_on(false);
  update();
}

void SessionPresenter::set_by_itself(bool by_itself) {
  by_itself_ = by_itself;
  if (!by_itself) guide_.go_on(false);
  update();
}

void SessionPresenter::skip() {
  if (!view_.may_skip) return;
  example_.stop();
  session_->note("Left out: " + guide_.act()->words() + ": skipped by the therapist");
  guide_.skip(session_time_s());
  look_at_act();
  update();
}

bool SessionPresenter::may_repeat() const noexcept {
  return view_.may_repeat;
}

void SessionPresenter::repeat() {
  if (!may_repeat()) return;
  guide_.go_on(false);
  const auto spec = *last_task_;
  if (auto begun = begin_trial(spec, last_practice_, std::nullopt); !begun) refuse(begun.error());
}

std::optional<double> SessionPresenter::difficulty() const {
  const auto* spec = next_task();
  if (spec == nullptr || !spec->difficulty) return std::nullopt;
  // An assessment is the same every time; only training becomes easier or harder.
  if (follows() && !guide_.act()->adaptive) return std::nullopt;
  if (const auto chosen = levels_.find(spec->file); chosen != levels_.end()) return chosen->second;
  if (follows()) return spec->difficulty->chosen;
  return session_ == nullptr ? spec->difficulty->start : session_->training().level(*spec);
}

Result<tasks::TaskSpec> SessionPresenter::at_chosen_level(const tasks::TaskSpec& spec) const {
  const auto chosen = levels_.find(spec.file);
  if (chosen == levels_.end() || !spec.difficulty) return spec;
  return tasks::at_level(spec, chosen->second);
}

void SessionPresenter::adjust_difficulty(int direction) {
  const auto now = difficulty();
  if (!now || !view_.may_choose_task) return;
  const double steps = std::round(*now / kLevelStep) + direction;
  levels_[next_task()->file] = std::clamp(kLevelStep * steps, 0.0, 1.0);
  if (follows()) look_at_act();
  update();
}

bool SessionPresenter::may_help() const noexcept {
  return session_ != nullptr && (view_.may_stop || (last_trial_ && !starting_));
}

void SessionPresenter::toggle_helped() {
  if (!may_help()) return;
  helped_ = !helped_;
  session_->mark_helped(helped_);
  const bool ended_before = limits_.reason_to_stop().has_value();
  if (running_ == nullptr) limits_.helped(helped_);
  if (!ended_before && limits_.reason_to_stop()) guide_.go_on(false);
  clinic_.load_history(patient_);
  update();
}

void SessionPresenter::rate_effort(int effort) {
  effort_ = effort;
  store_rating();
}

void SessionPresenter::rate_pain(int pain) {
  pain_ = pain;
  store_rating();
}

void SessionPresenter::store_rating() {
  if (session_ != nullptr && effort_ && pain_) {
    const auto reason = corrects_rating_ ? session_->correct_rating(*effort_, *pain_)
                                         : session_->rate(*effort_, *pain_);
    stop_reason_ = reason.value_or("");
    if (!stop_reason_.empty()) guide_.go_on(false);
    if (!corrects_rating_) guide_.rated();
    rated_ = {*effort_, *pain_};
    corrects_rating_ = true;
  }
  update();
}

void SessionPresenter::ask_rating_anew() {
  effort_.reset();
  pain_.reset();
  corrects_rating_ = false;
}

void SessionPresenter::show_rated() {
  if (!rated_) return;
  effort_ = rated_->effort;
  pain_ = rated_->pain;
  corrects_rating_ = true;
  update();
}

}  // namespace isograsp::gui
