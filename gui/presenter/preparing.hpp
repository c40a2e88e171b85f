// SPDX-License-Identifier: GPL-3.0-or-later
// Device and hand before the work: the zero of the empty device, and the straps. An act that the
// flow does not allow is ignored. GUI thread.
#pragma once

#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"

namespace isograsp::gui {

class Preparing {
 public:
  Preparing(const ActContext& with, NextWork& next);

  /// The operator has confirmed that the device is empty, and perhaps that it was serviced or
  /// remounted since its last zero. Of an arm: its start posture is measured, it is held still.
  void set_zero(bool accept_changed = false);
  /// Begins to look whether the picture of an arm moves as the arm does; called again, it stops.
  void check_picture();
  /// Of both hands: begins to find out whether one empty platform moves the other; called again, it
  /// stops.
  void check_platforms();
  void skip_platforms_check();
  /// Of both hands: the therapist stays where they can free them; or takes it back.
  void stay_within_reach(bool stays);
  /// Of both hands: the less affected one is strapped, too, or lies in its supports.
  void other_hand_strapped(bool strapped);
  void mark_strapped();  ///< the hand is in and strapped, or the straps were looked at again

  // @pre a session is open
  void take(const session::PreparationOutcome& zero);
  /// Called in every poll. Where a finger has moved on its pad, a note is stored with the session,
  /// once: from then on its forces mean something else.
  void look();

 private:
  void look_at_picture();
  void look_at_platforms();
  void store_platforms_check();

  SessionState& state_;
  SessionFlow& flow_;
  const Seating& seating_;
  ExamplePlayer& example_;
  const Clock& clock_;
  NextWork& next_;
};

}  // namespace isograsp::gui
