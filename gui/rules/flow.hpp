// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a session for the therapist: its state, which step comes next, what may be pressed
// now, and one sentence that says so. Light, sentence, steps and the one button that
// is filled all follow from one Situation. Pure: same facts, same view (in the language that is
// set). No widget, no clock, no thread.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "device/cameras/marker_device.hpp"
#include "session/platform/snapshot.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"

namespace isograsp::gui {

/// The steps of a session, in order.
enum class Step : std::uint8_t { patient, hand, screening, device, zero, rest, work };
inline constexpr std::size_t kStepCount = 7;

enum class StepState : std::uint8_t {
  open,  ///< still to come
  next,  ///< the sensible thing to do now
  done,
  absent  ///< the device asks for none
};

/// How a state light looks: each mood has its own shape and word, colour is only an addition.
enum class Mood : std::uint8_t {
  off,
  busy,
  ready,
  turn,  ///< nothing is wrong: the therapist is to do something
  attention,
  fault
};
[[nodiscard]] std::string word_for(Mood mood);

enum class Connection : std::uint8_t { none, opening, open, closing };

/// The protocol of the session as far as the flow depends on it; `active` false: tasks are chosen
/// by hand.
struct ProtocolFacts {
  enum class Act : std::uint8_t { none, zero, pause, trial };
  bool active = false;
  Act act = Act::none;     ///< next; none: the protocol is over
  std::string act_words;   ///< "Grip force, sine (1 of 2)"
  int wait_s = 0;          ///< until it may begin; 0: now
  int start_in_s = 0;      ///< until it begins by itself
  bool goes_on = false;    ///< acts begin by themselves
  bool by_itself = false;  ///< … or will after a press of Start: it is wanted
};

/// All that the flow depends on.
struct FlowFacts {
  bool database_open = false;
  std::string database_error;  ///< why the database could not be opened
  bool look_only = false;      ///< another program works with the file: no session can begin
  bool patient_chosen = false;
  bool hand_chosen = false;
  bool follows_other_hand = false;  ///< on the same device, which is connected by itself
  bool hand_to_confirm = false;     ///< it is not the affected one: nobody has confirmed it yet
  bool screened = false;            ///< questions answered, decision made
  bool earlier_sought = false;      ///< whether there is an interrupted protocol is being looked up
  bool earlier_undecided = false;   ///< an interrupted protocol may go on: nobody has said yet
  bool device_chosen = false;
  Connection connection = Connection::none;
  std::string connection_error;   ///< why the last attempt failed, or why the session ends or ended
  std::string connection_remedy;  ///< what to do about it
  bool broken_off = false;        ///< … and it was a session that could not go on
  /// Of the trial that runs, or of that session: all is durable up to this time of the day; empty:
  /// it is not known.
  std::string stored_until;
  bool basis_missing = false;  ///< … because no lawful basis is on record for a camera
  bool recorded = false;       ///< a replayed recording: nobody takes a hand out
  bool frozen = false;         ///< no new frame for longer than kFrozenAfter_s
  bool anything_arrived = false;
  session::Stage stage = session::Stage::idle;
  session::PauseCause pause_cause = session::PauseCause::none;
  /// While paused by a fault: the hand has let go, forces look as at rest; cameras send pictures.
  bool at_rest = false;
  DeviceHealth health;
  /// Both hands work, each on a platform: what is said here of the device is said of both.
  bool both_hands = false;
  std::optional<Hand> health_side;     ///< whose platform `health` is about; nothing: of neither
  std::optional<Hand> restarted_side;  ///< whose `restarted` is
  bool platforms_checked = false;      ///< both hands: whether one moves the other; or skipped
  bool platforms_pressed = false;      ///< … is being found out
  bool stop_tested = false;            ///< both hands: the stop was pressed once as a test
  bool within_reach = false;           ///< … and the therapist said that they stay there
  bool asks_zero = true;               ///< the device does, before the work
  /// It is cameras that see an arm: what it asks for is the start posture, held still, and all that
  /// is said here of a zero is said of that. A recording asks for it, too.
  bool start_posture = false;
  MarkerFault camera_fault = MarkerFault::none;
  /// Nobody has seen yet that the picture moves as a live arm or hand does (PictureCheck).
  bool picture_unsure = false;
  bool picture_watched = false;  ///< it is being looked at
  bool task_in_picture = false;  ///< the task is done by what that picture shows
  bool last_in_picture = false;  ///< the last trial was
  /// It is a tracker that sees a hand: what it asks for is the entry test, and all that is said
  /// here of a zero is said of that. A recording asks for it, too.
  bool hand_entry = false;
  HandFault hand_fault = HandFault::none;
  std::optional<session::EntryShown> entry;  ///< while that test runs
  bool object_there = false;  ///< on the screen, for the hand; not one that was let go for it
  /// Virtual objects are for a hand that has passed it; its other tasks are for every hand.
  bool task_needs_entry = false;
  bool asks_rest = true;  ///< and for a hand that rests in it
  bool zeroed = false;
  std::optional<Finger> restarted;  ///< whose sensor started anew after that zero
  Text zero_refusal;                ///< why the last zero was refused
  bool zero_only_changed = false;   ///< … only because it differs from the last empty zero
  Text zero_remark;                 ///< what is to be known about the accepted one
  int settling_s = 0;               ///< until the strapped hand may rest; 0: now
  bool strapped = false;            ///< the therapist said so
  bool straps_due = false;          ///< and has to look at them again
  bool hand_out = false;            ///< for a zero, after it had rested: it has to go in again
  Text rest_words;                  ///< what the resting force suggests
  bool rest_done = false;
  int maximum_attempts = 0;
  std::optional<double> maximum_force_N;
  bool task_done = false;  ///< a task after the maximum was completed
  ProtocolFacts protocol;
  Text stop_reason;         ///< why work should end for today; empty: it may go on
  bool zero_asked = false;  ///< and its outcome has not come
  bool starting = false;  ///< a start was asked for, no frame of it has come; or its end is stored
  bool task_chosen = false;
  bool task_rests = true;  ///< the resting force is measured
  Text task_not_shown;     ///< why the patient cannot watch it; empty: it can be shown
  std::string task_name;
  std::string task_lacks;  ///< a force that the task is scaled to and that was not measured: why
  /// Of the last trial in this session, which may be repeated; nothing: there was none.
  std::optional<bool> last_rested;

  /// Cameras see an arm or a hand: nobody holds a device.
  [[nodiscard]] bool is_seen() const noexcept { return start_posture || hand_entry; }
};

/// Age of the newest frame from which nothing is believed to arrive any more [s]. Single silent
/// sensors are noticed by the session after 50 ms; this catches whatever else may stand still.
inline constexpr double kFrozenAfter_s = 0.5;
/// The same for the first frame of a session: devices need a moment to start [s].
inline constexpr double kFirstFrameWithin_s = 3.0;

/// How the device stands; its light and its words follow from it.
enum class DeviceCondition : std::uint8_t {
  absent,
  failed,  ///< the last attempt to connect, or the session
  connecting,
  saving,
  recording_over,
  gone,     ///< it will send nothing any more
  faulted,  ///< a fault that stops forces
  frozen,
  waiting,   ///< for its first forces
  outdated,  ///< a sensor started anew after the zero
  degraded,  ///< a fault with which forces still arrive
  gap,       ///< it works, but the trial waits because samples were missing
  zeroing,
  no_zero,
  ready
};

/// Where the session stands. Whatever the therapist sees follows from this one word.
enum class Situation : std::uint8_t {
  // Before a session.
  database_failed,
  database_opening,
  look_only,
  session_failed,  ///< connecting or the session has failed: why
  connecting,
  saving,
  choose_patient,
  confirm_hand,
  choose_hand,
  screen,
  seek_earlier,
  ask_earlier,
  choose_device,
  connect,
  // The device, and what runs.
  device_fault,
  device_gone,
  recording_over,
  wait_for_forces,
  zeroing,
  in_trial,
  paused,
  paused_by_fault,
  let_go,             ///< the device works again, the hand does not rest yet
  goes_on_by_itself,  ///< the trial waits until the hand is seen, or holds the object, again
  starting,
  // Between trials.
  zero_refused,
  zero_outdated,
  zero_missing,
  straps_due,
  stop_work,
  protocol_over,
  protocol_zero,
  check_platforms,  ///< both empty, before hands go in: does one move the other?
  test_stop,        ///< both hands are to go in: the stop is pressed as a test before
  promise_reach,    ///< … and the therapist says that they stay within reach
  strap_in,
  strap_again,  ///< after a zero in the middle of the work
  settle,
  rest_ready,
  rest_left_out,  ///< another task was chosen before it
  pause,
  next_by_itself,
  next_after_rest,
  next_act,
  check_picture,  ///< before the first trial that is done by the picture of a live arm or hand
  no_act,         ///< the protocol's next task cannot be made
  recording_ready,
  first_maximum,
  next_maximum,
  choose_task,
  trial_stored
};
inline constexpr std::size_t kSituationCount =
    static_cast<std::size_t>(Situation::trial_stored) + 1;

/// The one button, or list, that is filled: the sensible thing to press now.
enum class NextPress : std::uint8_t {
  none,
  patient,
  hand,
  confirm_hand,
  screening,
  earlier,
  device,
  basis,  ///< to record on which a camera may look at this person
  connect,
  zero,
  platforms,  ///< whether one moves the other
  reach,      ///< "I stay within reach"
  strap,
  picture,
  start,
  resume,
  again,  ///< what failed
  end     ///< the session, and who comes next
};

/// A fault, told to the therapist.
struct FaultStory {
  std::string happened;
  std::string safe;    ///< "All up to 08:46:51 is stored."
  std::string remedy;  ///< what to do; may be empty
  bool operator==(const FaultStory&) const = default;
};

struct FlowView {
  Situation situation = Situation::database_opening;
  DeviceCondition device = DeviceCondition::absent;
  std::array<StepState, kStepCount> steps{};
  bool device_known = false;   ///< what measures is chosen, or connected
  bool start_posture = false;  ///< it is cameras that see an arm: Step::zero is its start posture
  bool hand_entry = false;     ///< it is a tracker of a hand: Step::zero is its entry test
  bool both_hands = false;     ///< each on a platform: Step::zero is that of both
  std::string sentence;        ///< state and next step, in plain words
  Mood mood = Mood::off;       ///< of the whole
  Mood device_mood = Mood::off;
  std::string device_words;    ///< beside the device's light
  bool device_speaks = false;  ///< the sentence begins with them
  NextPress press = NextPress::none;
  bool may_change_patient = false;
  bool may_change_hand = false;
  bool may_change_device = false;
  bool may_connect = false;
  bool may_cancel_connecting = false;
  bool may_try_again = false;  ///< what has failed
  bool may_disconnect = false;
  bool may_take_other_hand = false;  ///< after this one, on the same device
  bool may_zero = false;
  bool may_accept_changed = false;  ///< the refused zero may be repeated as "serviced or remounted"
  bool may_check = false;           ///< the supports, with the hand out
  bool may_check_platforms = false;  ///< empty, whether one moves the other
  bool may_test_stop = false;        ///< the pedal, before both hands go in
  bool may_promise_reach = false;    ///< … and what is said then
  bool may_strap = false;
  bool may_watch_picture = false;  ///< whether it moves as the arm or hand does
  bool may_choose_task = false;
  bool may_show_how = false;  ///< the patient may watch how the chosen task is done
  Text not_shown;             ///< why nobody can show it on a screen; empty: it can be shown
  bool may_start = false;     ///< the trial, or in a pause the going on by itself
  bool may_begin = false;     ///< a trial could begin at this moment
  bool may_repeat = false;    ///< the last trial
  bool may_skip = false;      ///< the next act of the protocol
  bool may_pause = false;     ///< the running trial
  bool may_stand_by = false;  ///< between trials: nothing begins by itself
  /// Nothing may begin by itself any more: after a fault, without a zero, or when straps are to be
  /// looked at, the therapist says that work goes on.
  bool must_stand_by = false;
  bool may_resume = false;
  bool may_let_go = false;  ///< of the object on the screen, for the hand
  bool may_stop = false;
  bool steps_fold = false;  ///< the work has begun, and none of what was prepared is to be done now
  bool offers_end = false;  ///< the work is done: report and disconnecting are at hand
  bool closes = false;      ///< … and what came of it is shown in the place of the curve
  std::optional<FaultStory> fault;  ///< with the words
  std::string start_hint;           ///< why Start is not possible, or what it starts
  [[nodiscard]] std::optional<Step> next() const;
  bool operator==(const FlowView&) const = default;
};

/// All but the words: sentence, device_words and start_hint stay empty.
[[nodiscard]] FlowView judge(const FlowFacts& facts);
/// With the words.
[[nodiscard]] FlowView decide(const FlowFacts& facts);

}  // namespace isograsp::gui
