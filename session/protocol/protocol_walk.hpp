// SPDX-License-Identifier: GPL-3.0-or-later
// Goes through a protocol act by act, for a program without windows or a therapist with them. No
// thread, no clock: it is told the outcome of an act and gives the next one.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "session/session.hpp"
#include "tasks/agenda.hpp"

namespace isograsp::session {

class ProtocolWalk {
 public:
  struct Act {
    enum class Kind : std::uint8_t { instrument_zero, start_posture, hand_entry, pause, trial };
    Kind kind = Kind::trial;
    const tasks::TaskSpec* task = nullptr;     ///< of a trial, as its file says it
    bool practice = false;                     ///< recorded, but no assessment
    bool adaptive = false;                     ///< at the level that training has reached
    std::optional<tasks::Look> look = {};      ///< of that; nothing: as the task says
    std::optional<storage::TrialPlace> place;  ///< nothing: set up again after a break
    std::size_t step = 0;                      ///< of the protocol
    int attempt = 1;
    int planned = 1;            ///< attempts, as far as it is known now
    double not_before_s = 0.0;  ///< session time: rests and recurrences end then
    double duration_s = 0.0;    ///< of a pause

    /// "Grip force, sine, practice (2 of 3)"
    [[nodiscard]] Text words() const;
  };

  /// What is left of `protocol` (which must outlive the walk) after `earlier`. The device was
  /// switched off and the hand taken out since: if anything was done, its zero and resting force
  /// come first once more.
  ProtocolWalk(const ReadyProtocol& protocol, const EarlierWork& earlier, std::uint64_t order_seed);

  /// Nothing: the protocol is over.
  [[nodiscard]] std::optional<Act> next() const;

  // What came of next(), with the session time at its end [s].
  void done(double session_time_s);                             ///< a zero or a pause
  void made(const TrialOutcome& trial, double session_time_s);  ///< a completed trial
  /// The task is not asked again in its step: it was refused for this hand, or is not wanted.
  void left_out(double session_time_s);

  [[nodiscard]] int acts_done() const noexcept { return agenda_.done(); }
  /// Of the whole protocol, if all further attempts agree at once.
  [[nodiscard]] int acts() const { return agenda_.expected(); }

 private:
  void plan_set_up();
  void record(const tasks::Agenda::Outcome& outcome);

  const ReadyProtocol& protocol_;
  tasks::Agenda agenda_;
  std::deque<Act> set_up_;  ///< before the agenda goes on
};

/// The task of a trial at today's level, if it is adaptive.
[[nodiscard]] Result<tasks::TaskSpec> task_of(const ProtocolWalk::Act& act,
                                              const Training& training);

}  // namespace isograsp::session
