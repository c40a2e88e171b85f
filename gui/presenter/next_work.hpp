// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/presenter/ only: what comes next in the work, the protocol's act or a task chosen by
// hand. Looked up once per act, choice and measurement: the flow is decided sixty times a second.
// Nothing here tells the windows; the act that calls it does. GUI thread.
#pragma once

#include <optional>

#include "gui/presenter/session_flow.hpp"
#include "gui/presenter/session_state.hpp"

namespace isograsp::gui {

class NextWork {
 public:
  /// Both must outlive it.
  NextWork(SessionState& state, SessionFlow& flow) : state_(state), flow_(flow) {}

  /// A session has opened: the chosen protocol from its beginning, or from where it was
  /// interrupted.
  void begin();
  /// The task of the act at its level. @pre a session is open
  void look_at_act();
  /// What the next task is scaled to and has not been measured.
  void look_at_task();
  /// By hand; nothing: the choice stays as it is.
  void select(std::optional<int> task);
  /// The first task of that kind; where the library has none, the choice stays as it is.
  void select_first(bool (*fits)(const tasks::TaskSpec&));
  /// A target that follows the force just measured.
  void select_after_maximum();
  /// Nothing begins by itself until the next start.
  void hold();

 private:
  SessionState& state_;
  SessionFlow& flow_;
};

}  // namespace isograsp::gui
