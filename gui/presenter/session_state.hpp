// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind both windows, by lifetime: what the therapist chose stays, a connection, a
// session and a trial are made anew as a whole. What exists only while one of them lives is a
// member of it, so that nothing of an earlier one can be shown. Data only; GUI thread.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/histogram.hpp"
#include "gui/look/force_history.hpp"
#include "gui/rules/flow.hpp"
#include "gui/rules/presentation.hpp"
#include "gui/rules/protocol_guide.hpp"
#include "gui/rules/screening.hpp"
#include "session/compensation.hpp"
#include "session/rest_watch.hpp"
#include "session/session.hpp"
#include "session/work_limits.hpp"

namespace isograsp::gui {

/// What the therapist chose. It stays for the next session, but for what is asked anew.
struct Choices {
  static constexpr int kByHand = -1;

  std::string patient;     ///< code; empty: nobody
  std::string device_uri;  ///< empty: none
  int protocol = kByHand;  ///< place in the library
  int task = -1;           ///< by hand, while no session is open: place in the library
  bool practice = false;
  bool by_itself = true;  ///< acts of the protocol begin by themselves

  /// Asked before every session.
  struct Today {
    std::optional<Hand> hand;
    bool hand_confirmed = false;  ///< by a press
    Screening screening;
  } today;

  /// A protocol that was interrupted today, for all that is chosen above.
  struct Interrupted {
    bool sought = false;  ///< the answer has not come
    std::optional<int> acts;
    std::optional<bool> go_on;
  } interrupted;
};

/// The way to the device and back. Made anew by every attempt to connect.
struct ConnectionState {
  struct Failure {
    std::string words;
    bool broken_off = false;  ///< a session could not go on
    bool asks_clock = false;  ///< whether the clock is right; connecting again says yes
  };

  Connection phase = Connection::none;
  std::stop_source opening;
  std::optional<Failure> failure;  ///< until whoever goes on has read it
  std::optional<Error> lost;       ///< why not all of the session is in the database
};

struct DeviceFaultSeen {
  double session_time_s = 0.0;
  std::string words;
};

/// What is to be seen of a session, also after its end: until the next one begins or another
/// patient is chosen.
struct SessionTraces {
  ForceHistory forces{};
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
  tasks::TaskView view;           ///< as it was seen last
  session::RestWatch rest_watch;  ///< while it is paused
  std::vector<Measure> score;     ///< so far
  Timestamp scored{0};            ///< when that was renewed
  Histogram picture_age;          ///< of its pictures on the patient's screen
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
  std::string zero_refusal;
  bool zero_only_changed = false;
  std::string zero_remark;
  std::optional<Timestamp> zeroed_at;  ///< the last zero; the hand goes in after it
  bool strapped = false;
  std::array<bool, kFingerCount> shift_noted{};  ///< since the strapping
  std::string rest_words;
  bool rest_done = false;
};

/// What the patient says of the work.
struct Rating {
  struct Answer {
    int effort = 0;
    int pain = 0;
  };
  std::optional<int> effort;
  std::optional<int> pain;
  bool corrects = false;       ///< both are the last answer: another number corrects it
  std::optional<Answer> last;  ///< of this session
  std::string stop_reason;     ///< why work should end
};

/// What is to be done next in a session.
struct Work {
  ProtocolGuide guide;
  bool by_hand = false;                     ///< beside the protocol
  std::optional<tasks::TaskSpec> act_task;  ///< of the next act, at its level
  int task = -1;                            ///< by hand: place in the library
  std::string task_lacks;                   ///< what it is scaled to and has not been measured
  std::map<std::string, double> levels;     ///< that the therapist chose, by task file
  int maximum_attempts = 0;
  bool task_done = false;  ///< one after the maximum
};

/// Dies with the session.
struct OpenSession {
  /// `numb_skin`: the screening says so. `stored`: how the patient's screen is, as the session
  /// knows it. `task`: the first by hand.
  OpenSession(std::unique_ptr<session::Session> of, Timestamp now, bool numb_skin,
              const Presentation& stored, int task)
      : session(std::move(of)), opened(now), stored_presentation(stored) {
    limits.begin(numb_skin);
    work.task = task;
  }

  std::unique_ptr<session::Session> session;
  Timestamp opened;
  session::Snapshot snapshot;
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
};

}  // namespace isograsp::gui
