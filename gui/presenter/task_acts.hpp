// SPDX-License-Identifier: GPL-3.0-or-later
// What the therapist decides about the next task: which one, as practice or not, how hard it is,
// and that the patient watches it first. An act that the flow does not allow is ignored. GUI
// thread.
#pragma once

#include <optional>

#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"

namespace isograsp::gui {

class TaskActs {
 public:
  TaskActs(const ActContext& with, NextWork& next);

  /// Place in the library. By hand; in a protocol that stands by until it is followed again.
  void choose(int index);
  void set_practice(bool practice);
  /// Of the next task, 0 (easiest) … 1; nothing: it has none that may be chosen now.
  [[nodiscard]] std::optional<double> difficulty() const;
  /// -1 easier, +1 harder; for this session.
  void adjust_difficulty(int direction);
  /// The patient's screen shows how the next task is done. Called again, it stops; any other act
  /// stops it, too.
  void show_how();
  /// A demonstration is being made or is on the patient's screen.
  [[nodiscard]] bool showing_how() const noexcept { return example_.showing(); }

  /// Once a poll: the demonstration goes on.
  void look();

 private:
  SessionState& state_;
  SessionFlow& flow_;
  ExamplePlayer& example_;
  NextWork& next_;
};

}  // namespace isograsp::gui
