// SPDX-License-Identifier: GPL-3.0-or-later
// Trials of an open session: begun by a press or by themselves, paused, ended, repeated; and what
// follows from one that is over. An act that the flow does not allow is ignored. GUI thread.
#pragma once

#include <optional>

#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"
#include "gui/presenter/protocol_acts.hpp"
#include "gui/presenter/remarks.hpp"

namespace isograsp::gui {

class Trials {
 public:
  /// What is not in the context outlives it, too.
  Trials(const ActContext& with, NextWork& next, ProtocolActs& protocol, Remarks& remarks);

  /// Starts the trial; a protocol that waits goes on by itself from now on.
  void start();
  void pause();
  void resume();
  void stop();                  ///< before both hands go in: its test
  void let_go();                ///< the object on the screen, for the hand: helped, no drop
  void hold_clutch(bool held);  ///< of hands that are points: pressed, or let go
  void start_pause_resume();    ///< what the one large key does, by the state
  void repeat();                ///< the last trial once more, beside the protocol

  /// Pauses of the protocol end, and what begins by itself begins. Once a poll.
  void follow_time();
  // @pre a session is open
  void look();  ///< at the running one in the newest snapshot
  void take(const session::TrialOutcome& outcome);
  void renew_score();  ///< of the running one, when it is old

 private:
  /// The pedal, or a stop key, before both hands go in. False: there is nothing to be tested.
  bool test_stop();
  void begin_next();
  Result<void> begin(const tasks::TaskSpec& spec, bool practice,
                     std::optional<storage::TrialPlace> place);
  void prepare_picture(const tasks::TaskSpec& spec, const tasks::TaskContext& context);
  void look_at_both(const session::TwoPlatformsSnapshot& now, RunningTrial& trial);
  void take_rest_of_both();
  void take_progress(const tasks::TaskSpec& task);
  void watch_limits(const session::TrialOutcome& outcome);

  SessionState& state_;
  SessionFlow& flow_;
  Clinic& clinic_;
  ExamplePlayer& example_;
  const Clock& clock_;
  NextWork& next_;
  ProtocolActs& protocol_;
  Remarks& remarks_;
};

}  // namespace isograsp::gui
