// SPDX-License-Identifier: GPL-3.0-or-later
// What the therapist does with the protocol of an open session: it is followed or stands by, an act
// is left out. An act that the flow does not allow is ignored. GUI thread.
#pragma once

#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"

namespace isograsp::gui {

class ProtocolActs {
 public:
  ProtocolActs(const ActContext& with, NextWork& next);

  /// A task is chosen now, the protocol stands by.
  void choose_by_hand();
  /// The next act of the protocol again, after tasks that were chosen by hand.
  void follow();
  /// Nothing begins by itself any more until the next start.
  void stand_by();
  /// Acts begin by themselves after a start (as it is at first), or wait for a key.
  void set_by_itself(bool by_itself);
  /// The next act is not wanted.
  void skip();
  /// The next act cannot be done: why. @pre it is a trial
  void leave_out(const Error& why);

 private:
  SessionState& state_;
  SessionFlow& flow_;
  ExamplePlayer& example_;
  NextWork& next_;
};

}  // namespace isograsp::gui
