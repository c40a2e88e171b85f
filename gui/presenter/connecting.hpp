// SPDX-License-Identifier: GPL-3.0-or-later
// Connects to the device and disconnects: sessions are opened and closed on the worker. An act that
// the flow does not allow is ignored. GUI thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gui/clinic/disk_room.hpp"
#include "gui/presenter/act_context.hpp"
#include "gui/presenter/next_work.hpp"
#include "gui/presenter/session_choices.hpp"

namespace isograsp::gui {

class Connecting {
 public:
  /// What is not in the context outlives it, too.
  Connecting(const ActContext& with, SessionChoices& choices, NextWork& next);

  // -> SessionFlow::settled()
  /// Opens a session with what is chosen.
  void connect_device();
  /// For the therapist it is over at once; a session that the worker has opened meanwhile is closed
  /// there.
  void cancel();
  void disconnect_device();
  /// The session of one hand ends and that of the other begins, on the same device: it is connected
  /// by itself as soon as everything that is asked before has been said.
  void take_other_hand();
  /// After a fault: what failed is tried again, or the session whose device is gone is ended; what
  /// is asked before every session is asked.
  void try_again();
  /// At once, whatever is running or being opened: the program is about to end.
  void end_session();
  /// A lawful basis was recorded: what was refused for want of one may be tried again.
  void basis_recorded();
  /// It cannot go on: why. @pre a session is open
  void break_off(const Error& why);
  /// Once a poll: the device of a hand that follows the other one is connected; a full disk is no
  /// reason any more when it has room again.
  void look();

 private:
  [[nodiscard]] session::SessionConfig session_config(bool clock_is_right) const;
  void take(Result<std::unique_ptr<session::Session>> opened, const Presentation& stored);
  void begin(std::unique_ptr<session::Session> session, const Presentation& stored);
  void take_earlier_work();
  void keep_broken_trial(const std::string& why);
  void close();
  template <class Closed>
  void close_on_worker(std::unique_ptr<session::Session> session, Closed closed);

  SessionState& state_;
  SessionFlow& flow_;
  Clinic& clinic_;
  const SettingsFile& settings_;
  const Seating& seating_;
  Background& worker_;
  ExamplePlayer& example_;
  const Clock& clock_;
  SessionChoices& choices_;
  NextWork& next_;
  std::optional<Hand> follows_;  ///< when the session has been closed
  DiskRoom room_;                ///< after a session that could not be opened or go on
  bool realtime_said_ = false;   ///< on standard error, once
};

}  // namespace isograsp::gui
