// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/session_choices.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "gui/words/texts.hpp"
#include "session/open_hand.hpp"
#include "session/open_two_platforms.hpp"
#include "session/tracked_hand/hand_size.hpp"

namespace isograsp::gui {

namespace {

/// As far as the work of an earlier session is looked for by it.
storage::SessionRecord session_to_come(storage::RowId patient, std::optional<Hand> hand,
                                       const std::string& device_uri,
                                       const tasks::ProtocolSpec& protocol) {
  storage::SessionRecord session;
  session.patient_id = patient;
  session.hand = hand;
  session.simulated = is_simulated(device_uri);
  session.started_utc = utc_text(std::time(nullptr));
  session.protocol_name = protocol.name;
  session.protocol_text = protocol.text;
  return session;
}

/// The hands of one person in software.
bool is_pair(const std::string& uri) {
  return uri.starts_with("sim://");
}

}  // namespace

// Someone who begins the next session has read why the last one ended.

SessionChoices::SessionChoices(const ActContext& with)
    : state_(with.state),
      flow_(with.flow),
      clinic_(with.clinic),
      file_(with.file),
      seating_(with.seating) {}

void SessionChoices::choose_patient(const std::string& code) {
  if (state_.busy() || code == state_.choices.patient) return;
  state_.choices.patient = code;
  ask_anew();
  state_.connection.failure.reset();
  state_.left = {};
  clinic_.load_history(code);
  file_.load(code);
  seating_.look(code, state_.choices.today.hand);
  flow_.update();
}

void SessionChoices::choose_hand(Hand hand) {
  if (!flow_.view().may_change_hand) return;
  state_.connection.failure.reset();
  leave_both_hands();
  auto& today = state_.choices.today;
  if (today.hand != hand) {  // its outcome is that of one hand
    today.screening = {};
    today.arm_screening = {};
    today.hand_screening = {};
    today.size_of_other = false;
  }
  today.hand = hand;
  today.hand_confirmed = false;
  today.follows_other_hand = false;
  look_for_earlier();
  seating_.look(state_.choices.patient, hand);
  flow_.update();
}

void SessionChoices::choose_both_hands() {
  if (!flow_.view().may_change_hand) return;
  state_.connection.failure.reset();
  Choices& choices = state_.choices;
  if (!choices.today.both) choices.today = {};  // what was asked was asked of one hand
  choices.today.both = true;
  choices.apparatus = kTwoPlatforms;
  const auto address = session::two_platforms_uri(choices.platforms);
  const bool chosen = !choices.platforms.left.empty() && !choices.platforms.right.empty();
  choices.device_uri = chosen && address ? *address : std::string();
  look_for_earlier();
  seating_.look(choices.patient, std::nullopt);
  flow_.update();
}

/// One hand has another device than both have.
void SessionChoices::leave_both_hands() {
  Choices& choices = state_.choices;
  if (!std::exchange(choices.today.both, false)) return;
  choices.today.screenings = {};
  choices.device_uri.clear();
  choices.apparatus.clear();
}

void SessionChoices::choose_platform(Hand hand, const std::string& uri) {
  if (!flow_.view().may_change_device || !state_.choices.today.both) return;
  state_.connection.failure.reset();
  Choices& choices = state_.choices;
  std::string& other = choices.platforms[other_than(hand)];
  choices.platforms[hand] = uri;
  if (is_pair(uri)) other = uri;
  if (!is_pair(uri) && is_pair(other)) other.clear();
  choices.device_uri.clear();
  if (!other.empty()) {
    if (const auto address = session::two_platforms_uri(choices.platforms))
      choices.device_uri = *address;
    else
      state_.connection.failure = ConnectionState::Failure::of(address.error());
  }
  look_for_earlier();
  flow_.update();
}

void SessionChoices::confirm_hand() {
  if (!flow_.hand_to_confirm()) return;
  state_.choices.today.hand_confirmed = true;
  flow_.update();
}

void SessionChoices::answer_screening(const Screening& answers, std::optional<Hand> of) {
  auto& today = state_.choices.today;
  Screening& kept = of ? today.screenings[*of] : today.screening;
  if (state_.busy() || answers == kept) return;
  state_.connection.failure.reset();
  kept = answers;
  flow_.update();
}

void SessionChoices::answer_screening(const ArmScreening& answers) {
  if (state_.busy() || answers == state_.choices.today.arm_screening) return;
  state_.connection.failure.reset();
  state_.choices.today.arm_screening = answers;
  flow_.update();
}

void SessionChoices::answer_screening(const HandScreening& answers) {
  if (state_.busy() || answers == state_.choices.today.hand_screening) return;
  state_.connection.failure.reset();
  state_.choices.today.hand_screening = answers;
  flow_.update();
}

void SessionChoices::choose_device(const std::string& uri) {
  if (!flow_.view().may_change_device) return;
  state_.choices.device_uri = uri;
  state_.choices.today.size_of_other = false;
  state_.choices.today.follows_other_hand = false;
  state_.choices.apparatus = session::kind_of_apparatus(uri, state_.config.apparatuses);
  state_.connection.failure.reset();
  look_for_earlier();
  flow_.update();
}

void SessionChoices::take_size_of_other(bool take) {
  if (!flow_.view().may_change_device || take == state_.choices.today.size_of_other) return;
  if (take && state_.choices.other_hand_measured_on.empty()) return;
  state_.connection.failure.reset();
  state_.choices.today.size_of_other = take;
  flow_.update();
}

void SessionChoices::choose_protocol(std::optional<int> place) {
  if (state_.busy() || place == state_.choices.protocol) return;
  state_.connection.failure.reset();
  state_.choices.protocol = place;
  look_for_earlier();
  flow_.update();
}

void SessionChoices::decide_earlier(bool go_on) {
  if (!state_.choices.interrupted.acts || state_.busy()) return;
  state_.connection.failure.reset();
  state_.choices.interrupted.go_on = go_on;
  flow_.update();
}

void SessionChoices::name_operator(const std::string& name) {
  state_.choices.operator_name = name;
}

void SessionChoices::ask_anew() {
  leave_both_hands();
  state_.choices.today = {};
  look_for_earlier();  // for nobody yet: what was asked before counts no more
}

void SessionChoices::follow_with(Hand hand) {
  flow_.decide();  // the session before is closed
  choose_hand(hand);
  state_.choices.today.follows_other_hand = state_.choices.today.hand == hand;
  flow_.update();
}

void SessionChoices::look_for_earlier() {
  const int lookup = ++lookups_;
  look_whether_first_time();
  look_for_other_hand();
  Choices& choices = state_.choices;
  choices.interrupted = {};
  const auto& hand = choices.today.hand;
  const bool asked = hand || choices.today.both;
  if (choices.patient.empty() || !asked || choices.device_uri.empty() || !state_.has_protocol())
    return;
  choices.interrupted.sought = clinic_.read(
      this,
      [code = choices.patient, hand, uri = choices.device_uri,
       protocol = state_.chosen_protocol()](storage::SessionStore& store) -> std::optional<int> {
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
        state_.choices.interrupted.sought = false;
        state_.choices.interrupted.acts = acts;
        flow_.update();
      });
}

void SessionChoices::look_whether_first_time() {
  Choices& choices = state_.choices;
  choices.first_time = false;
  const auto& hand = choices.today.hand;
  if (choices.patient.empty() || !hand || choices.apparatus.empty()) return;
  (void)clinic_.read(
      this,
      [code = choices.patient, hand = *hand, apparatus = choices.apparatus,
       simulated = state_.simulated(),
       rows = state_.config.apparatuses](storage::SessionStore& store) {
        const auto patient = store.find_patient(code);
        if (!patient || !*patient) return true;
        const auto sessions = store.sessions((*patient)->id);
        return sessions && std::ranges::none_of(*sessions, [&](const auto& session) {
                 return session.hand == hand && session.simulated == simulated &&
                        session::kind_of_apparatus(session.device_uri, rows) == apparatus;
               });
      },
      [this, lookup = lookups_](bool first_time) {
        if (lookup != lookups_) return;
        state_.choices.first_time = first_time;
        flow_.update();
      });
}

/// What a tracker measured of the other hand; a simulated tracker tells it of simulated hands.
void SessionChoices::look_for_other_hand() {
  Choices& choices = state_.choices;
  choices.other_hand_measured_on.clear();
  const auto& hand = choices.today.hand;
  if (choices.patient.empty() || !hand || !state_.measures_hand()) return;
  if (session::says_size(choices.device_uri)) return;  // nothing to choose
  (void)clinic_.read(
      this,
      [code = choices.patient, hand = *hand,
       simulated = state_.simulated()](storage::SessionStore& store) -> std::string {
        const auto patient = store.find_patient(code);
        if (!patient || !*patient) return {};
        const auto measured = session::other_hand_measured(store, (*patient)->id, hand, simulated);
        return measured && *measured ? (*measured)->on_date : std::string();
      },
      [this, lookup = lookups_](std::string on_date) {
        if (lookup != lookups_) return;
        state_.choices.other_hand_measured_on = std::move(on_date);
        if (state_.choices.other_hand_measured_on.empty())
          state_.choices.today.size_of_other = false;
        flow_.update();
      });
}

}  // namespace isograsp::gui
