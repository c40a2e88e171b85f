// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind both windows, by lifetime: what the therapist chose stays, a connection, a
// session and a trial are made anew as a whole. What exists only while one of them lives is a
// member of it, so that nothing of an earlier one can be shown. Screens read it, acts change it.
// Data, and what follows from them at once; GUI thread.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/histogram.hpp"
#include "gui/library/session_library.hpp"
#include "gui/look/force_history.hpp"
#include "gui/look/hands_history.hpp"
#include "gui/look/marker_history.hpp"
#include "gui/picture/arm_space.hpp"
#include "gui/picture/presentation.hpp"
#include "gui/presenter/gui_config.hpp"
#include "gui/rules/arm_live.hpp"
#include "gui/rules/arm_screening.hpp"
#include "gui/rules/crosstalk_check.hpp"
#include "gui/rules/flow.hpp"
#include "gui/rules/hand_live.hpp"
#include "gui/rules/hand_screening.hpp"
#include "gui/rules/picture_check.hpp"
#include "gui/rules/practice_clock.hpp"
#include "gui/rules/protocol_guide.hpp"
#include "gui/rules/screening.hpp"
#include "gui/rules/still_watch.hpp"
#include "gui/rules/two_hands_rules.hpp"
#include "session/compensation.hpp"
#include "session/rest_watch.hpp"
#include "session/session.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "session/work_limits.hpp"

namespace isograsp::gui {

/// What the therapist chose. It stays for the next session, but for what is asked anew.
struct Choices {
  std::string operator_name;  ///< who has logged in; empty: as the settings say
  std::string patient;        ///< code; empty: nobody
  std::string device_uri;     ///< empty: none
  /// Of both hands, each chosen on its own; `device_uri` is that of both as soon as they fit.
  OfHands<std::string> platforms;
  /// What it is, as far as the URI tells: tasks and protocols of that are offered.
  std::string apparatus;
  /// Places in the library. No protocol: tasks are chosen by hand, one by one.
  std::optional<int> protocol;
  std::optional<int> task;  ///< by hand, while no session is open
  bool practice = false;
  bool by_itself = true;  ///< acts of the protocol begin by themselves

  /// Asked before every session.
  struct Today {
    std::optional<Hand> hand;
    bool both = false;  ///< hands work at once, each on a platform; `hand` is nothing then
    bool hand_confirmed = false;  ///< by a press
    /// It follows the other one on the same device, which is connected again by itself.
    bool follows_other_hand = false;
    Screening screening;
    BothScreenings screenings;     ///< of both hands, in its place
    ArmScreening arm_screening;    ///< of an arm seen by cameras, in its place
    HandScreening hand_screening;  ///< of a tracked hand, in its place
    bool size_of_other = false;  ///< a tracked hand that cannot open has the size of the other one
  } today;

  /// A protocol that was interrupted today, for all that is chosen above.
  struct Interrupted {
    bool sought = false;  ///< the answer has not come
    std::optional<int> acts;
    std::optional<bool> go_on;
  } interrupted;

  /// The database holds no session of this hand with this apparatus.
  bool first_time = false;
  /// Day of the entry test in which a tracker measured the other hand of the patient; empty: there
  /// was none.
  std::string other_hand_measured_on;
};

/// The connection to the device. Made anew by every attempt to connect.
struct ConnectionState {
  struct Failure {
    std::string happened;
    std::string remedy;            ///< may be empty
    std::string stored_until_utc;  ///< of a session that was broken off: up to when all is safe
    bool broken_off = false;       ///< a session could not go on
    bool asks_clock = false;       ///< whether the clock is right; connecting again says yes
    bool asks_basis = false;       ///< a lawful basis is to be recorded first

    [[nodiscard]] static Failure of(Error error);
  };

  Connection phase = Connection::none;
  std::stop_source opening;
  std::optional<Failure> failure;  ///< until the next act, so that it can be read
  std::optional<Error> lost;       ///< why not all of the session is in the database
};

struct DeviceFaultSeen {
  double session_time_s = 0.0;
  Words words;
  std::optional<Hand> side = std::nullopt;  ///< of two platforms: whose
};

/// What can still be shown after a session has ended: until the next one begins or another patient
/// is chosen.
struct SessionTraces {
  ForceHistory forces{};
  HandsHistory hands{};  ///< of both, in its place
  MarkerHistory markers{};
  LinkTurns turns{};                    ///< of an arm, since its target appeared
  PracticeClock practice{};             ///< of an arm, in this session
  TrackerWatch tracker{};               ///< of a hand
  std::vector<DeviceFaultSeen> faults;  ///< oldest first
  double worst_lateness_s = 0.0;
  std::optional<session::TrialOutcome> last_trial;
};

/// From the press of Start until the trial's outcome is stored.
struct RunningTrial {
  std::shared_ptr<const tasks::TaskSpec> task;
  bool practice = false;
  bool arrived = false;  ///< its first frame
  bool helped = false;
  std::shared_ptr<const TargetPreview> preview;
  std::shared_ptr<const Scene> scene;
  tasks::TaskProgress view;                  ///< as it was seen last
  session::RestWatch rest_watch;             ///< while it is paused
  OfHands<session::RestWatch> rest_watches;  ///< of both hands, in its place
  std::vector<Measure> score;                ///< so far
  Timestamp scored{0};                       ///< when that was renewed
  Histogram picture_age;                     ///< of its pictures on the patient's screen
};

/// The last trial of a session that is open.
struct EndedTrial {
  std::shared_ptr<const tasks::TaskSpec> task;
  bool practice = false;
  bool helped = false;
  bool completed = false;
  bool missed = false;  ///< completed, but not all its targets were reached
};

/// Device and hand before the work: zero, straps, rest.
struct Preparation {
  bool zero_asked = false;  ///< and its outcome has not come: the session takes nothing else
  Text zero_refusal;
  bool zero_only_changed = false;
  Text zero_remark;
  std::optional<Timestamp> zeroed_at;  ///< the last zero; the hand goes in after it
  bool strapped = false;
  std::array<bool, kFingerCount> shift_noted{};  ///< since the strapping
  Text rest_words;
  bool rest_done = false;
  HandsSafety safety;  ///< of both hands: holds for the session
};

/// What the fingers of both hands press at rest: mean of the last resting trial, as far as it was
/// looked at.
class HandsAtRest {
 public:
  void begin() noexcept { *this = {}; }
  /// Takes the snapshot if it is a new frame.
  void add(const session::TwoPlatformsSnapshot& now) noexcept;
  [[nodiscard]] std::optional<FingerWrenches> mean(Hand hand) const noexcept;

 private:
  OfHands<FingerWrenches> sum_C_;
  int frames_ = 0;
  double last_s_ = -1.0;
};

/// What is asked about the last trial.
struct TrialQuestions {
  const tasks::Questionnaire* asked = nullptr;  ///< null: nothing is
  /// By question: nothing: not said yet; no number: no answer was wanted.
  std::vector<std::optional<std::optional<int>>> said;

  /// Something has not been said: nothing begins by itself.
  [[nodiscard]] bool due() const noexcept;
};

/// What the patient says of the work.
struct Rating {
  struct Answer {
    int effort = 0;
    int pain = 0;
    std::optional<int> shoulder_pain;  ///< of a tracked hand
  };
  std::optional<int> effort;
  std::optional<int> pain;
  std::optional<int> shoulder_pain;
  bool corrects = false;       ///< all are the last answer: another number corrects it
  std::optional<Answer> last;  ///< of this session
  Text stop_reason;            ///< why work should end
  TrialQuestions questions;
};

/// What is to be done next in a session.
struct Work {
  ProtocolGuide guide;
  bool by_hand = false;                     ///< tasks are chosen beside the protocol
  std::optional<tasks::TaskSpec> act_task;  ///< of the next act, at its level
  std::optional<int> task;                  ///< by hand: place in the library
  std::string task_lacks;                   ///< what it is scaled to and has not been measured
  std::map<std::string, double> levels;     ///< that the therapist chose, by task file
  int maximum_attempts = 0;
  bool task_done = false;  ///< one after the maximum

  /// The protocol, not the therapist, says what comes.
  [[nodiscard]] bool follows() const noexcept { return guide.active() && !by_hand; }
  /// At the difficulty that the therapist chose; otherwise unchanged.
  [[nodiscard]] Result<tasks::TaskSpec> at_chosen_level(const tasks::TaskSpec& spec,
                                                        std::optional<tasks::Look> look = {}) const;
};

/// Exists as long as the session is open.
struct OpenSession {
  /// `numb_skin`: the screening says so. `stored`: how the patient's screen is, as the session
  /// knows it. `task`: the first by hand.
  OpenSession(std::unique_ptr<session::Session> of, Timestamp now, bool numb_skin,
              const Presentation& stored, std::optional<int> task)
      : session(std::move(of)), opened(now), stored_presentation(stored) {
    limits.begin(numb_skin);
    work.task = task;
    const session::SessionKnowledge& known = session->known();
    if (known.arm)
      arm_space =
          std::make_shared<const ArmSpace>(*known.arm, known.record.hand.value_or(Hand::right));
  }
  /// The newest frame.
  void look();

  std::unique_ptr<session::Session> session;
  Timestamp opened;
  session::Snapshot snapshot;               ///< of an arm or a tracked hand: what every session has
  std::optional<session::ArmSnapshot> arm;  ///< nothing: it is no arm, or nothing has come
  std::shared_ptr<const ArmSpace> arm_space;  ///< null: it is no arm
  std::optional<session::HandSnapshot> hand;  ///< nothing: it is no tracked hand, or as above
  std::optional<session::TwoPlatformsSnapshot> both;  ///< of two platforms, or as above
  HandsAtRest hands_at_rest;
  CrossTalkCheck crosstalk;  ///< of two platforms
  StillWatch still;
  PictureCheck picture_check;
  Preparation preparation;
  Work work;
  Rating rating;
  session::Compensation compensation;
  session::WorkLimits limits;
  SessionTraces traces;
  Presentation stored_presentation;
  std::optional<RunningTrial> trial;
  std::optional<EndedTrial> ended;

  [[nodiscard]] double time_s() const noexcept { return snapshot.session_time_s; }
  /// Where the object of an arm, or a tracked hand, is drawn, from a point that stays; nothing: it
  /// is not seen.
  [[nodiscard]] std::optional<Vec3> moved_on_screen() const;
  /// A trial was asked for, and no frame of it has come.
  [[nodiscard]] bool starting() const noexcept { return trial && !trial->arrived; }
};

/// One of two platforms, as if it were alone.
[[nodiscard]] session::Snapshot side_of(const session::TwoPlatformsSnapshot& both, Hand hand);
/// Whose health is the worse one; nothing: both are well.
[[nodiscard]] std::optional<Hand> fault_side(const session::TwoPlatformsSnapshot& both) noexcept;
/// Whose sensor has started anew since the zeros were set; nothing: none has.
[[nodiscard]] std::optional<Hand> restarted_side(
    const session::TwoPlatformsSnapshot& both) noexcept;

/// By its address: of software, whether of one hand or of both.
[[nodiscard]] bool is_simulated(const std::string& uri);

/// All of it.
struct SessionState {
  GuiConfig config;
  SessionLibrary library;
  Choices choices;
  ConnectionState connection;
  std::optional<OpenSession> open;
  SessionTraces left;  ///< by the last session

  [[nodiscard]] bool session_open() const noexcept { return open.has_value(); }
  /// A session is open, or being opened or closed.
  [[nodiscard]] bool busy() const noexcept { return connection.phase != Connection::none; }
  /// The last session could not go on.
  [[nodiscard]] bool broken_off() const noexcept {
    return connection.failure && connection.failure->broken_off;
  }
  [[nodiscard]] bool simulated() const noexcept;
  [[nodiscard]] bool recorded() const noexcept;
  /// That is connected; null: none.
  [[nodiscard]] const DeviceInfo* device() const noexcept;
  /// What the acquisition thread was given; empty: not asked for.
  [[nodiscard]] Text realtime() const;

  /// An arm seen by cameras is connected, or chosen.
  [[nodiscard]] bool measures_arm() const noexcept;
  /// A tracker that sees a hand is.
  [[nodiscard]] bool measures_hand() const noexcept;
  /// … with a camera that looks at the person.
  [[nodiscard]] bool watches_hand() const noexcept;

  // Of the session that is open; else as if nothing had happened yet.
  [[nodiscard]] const session::Snapshot& snapshot() const noexcept;
  /// What it measures beside the hand.
  [[nodiscard]] const session::Compensation& compensation() const noexcept;
  [[nodiscard]] const ProtocolGuide& guide() const noexcept;
  [[nodiscard]] const Rating& rating() const noexcept;
  /// What the resting force suggests; empty: not measured yet.
  [[nodiscard]] const Text& rest_words() const noexcept;
  /// Of the running or the last trial: the therapist helps, or helped.
  [[nodiscard]] bool helped() const noexcept;

  /// Of the session that is open, or of the last one.
  [[nodiscard]] const SessionTraces& traces() const noexcept { return open ? open->traces : left; }
  /// Of the running trial so far, or of the last one.
  [[nodiscard]] const std::vector<Measure>& live_score() const noexcept;

  /// The session follows, or will follow, the chosen protocol. A recording follows none: whatever
  /// was done in it is done.
  [[nodiscard]] bool has_protocol() const noexcept;
  /// @pre choices.protocol
  [[nodiscard]] const session::ReadyProtocol& chosen_protocol() const {
    return library.protocols[static_cast<std::size_t>(*choices.protocol)];
  }
  /// The protocol, not the therapist, says what comes.
  [[nodiscard]] bool follows() const noexcept { return open && open->work.follows(); }
  /// Chosen by hand, place in the library; nothing: none is, or the protocol says what comes.
  [[nodiscard]] std::optional<int> task() const noexcept {
    return follows() ? std::nullopt : task_by_hand();
  }
  /// Of a protocol that stands by, too.
  [[nodiscard]] std::optional<int> task_by_hand() const noexcept {
    return open ? open->work.task : choices.task;
  }
  /// The task that Start begins, at its level in the protocol; null: none.
  [[nodiscard]] const tasks::TaskSpec* next_task() const noexcept;
  /// The protocol asks for a zero of the empty device.
  [[nodiscard]] bool zero_is_next() const noexcept;
};

/// Both hands are measured, each on a platform, or will be.
[[nodiscard]] bool measures_both(const SessionState& state) noexcept;

}  // namespace isograsp::gui
