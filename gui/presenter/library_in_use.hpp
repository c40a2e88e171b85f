// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks and protocols that can be chosen: those of the apparatus that is; and what becomes of the
// choice when their files, or the apparatus, change.
// GUI thread; files are read on the worker.
#pragma once

#include <optional>
#include <string>

#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"
#include "gui/presenter/session_choices.hpp"

namespace isograsp::gui {

class LibraryInUse {
 public:
  /// Reads the library, proposes the usual protocol and the first task.
  LibraryInUse(const ActContext& with, SessionChoices& choices, NextWork& next);

  /// Reads tasks and protocols again; what is new appears as soon as no trial runs and no device is
  /// being opened. What is chosen stays chosen as long as its file is there.
  void reload();
  /// Once a poll.
  void look();
  /// The protocol of that name, as stored with a session; where there is none, the usual one.
  /// Empty: tasks are chosen one by one.
  void propose(const std::string& protocol);

 private:
  void take();
  void keep_tasks(const SessionLibrary& before);
  void keep_protocol(const SessionLibrary& before);

  SessionState& state_;
  SessionFlow& flow_;
  Background& worker_;
  SessionChoices& choices_;
  NextWork& next_;
  SessionLibrary all_;                   ///< of every apparatus
  std::string apparatus_;                ///< whose part of it is in use
  std::optional<SessionLibrary> newer_;  ///< read, waits for the end of a trial
};

}  // namespace isograsp::gui
