// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol of a session as the windows follow it: which act is next, how long it must wait,
// when effort and pain are asked. Pure: times come from the caller. No Qt.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session/library/library.hpp"
#include "session/protocol/protocol_walk.hpp"

namespace isograsp::gui {

class ProtocolGuide {
 public:
  enum class RowState : std::uint8_t { open, current, done };
  /// One step of the protocol, for the list beside the session.
  struct Row {
    std::string title;  ///< name of its task, of its group of tasks, of a pause, or of the zero
    int count = 1;      ///< acts that it plans
    RowState state = RowState::open;
    bool practice = false;
    bool operator==(const Row&) const = default;
  };

  /// From the beginning, or from where `earlier` ended. Stands by until go_on(true).
  void begin(const session::ReadyProtocol& protocol, const session::EarlierWork& earlier,
             std::uint64_t order_seed);
  void end();

  [[nodiscard]] bool active() const noexcept { return walk_ != nullptr; }
  /// Nothing: the protocol is over, or there is none.
  [[nodiscard]] const std::optional<session::ProtocolWalk::Act>& act() const noexcept {
    return act_;
  }
  [[nodiscard]] bool over() const noexcept { return active() && !act_; }
  /// The next trial is the resting force.
  [[nodiscard]] bool rest_is_next() const;
  /// The resting force is still to be measured.
  [[nodiscard]] bool asks_rest() const;
  [[nodiscard]] int acts_done() const { return active() ? walk_->acts_done() : 0; }
  [[nodiscard]] int acts() const { return active() ? walk_->acts() : 0; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::vector<Row> rows() const;

  /// Acts begin by themselves when their time has come; anything unexpected ends this.
  void go_on(bool by_itself) noexcept { goes_on_ = by_itself; }
  [[nodiscard]] bool goes_on() const noexcept { return goes_on_ && act_; }
  /// Until the act may begin [s]: a rest, a recurrence, the rest of a pause; 0: now.
  [[nodiscard]] double wait_s(double session_time_s) const;
  /// Until it begins by itself [s]: in addition a new instruction wants to be read.
  [[nodiscard]] double start_in_s(double session_time_s) const;

  // What happened, with the session time [s].
  void zeroed(double session_time_s);  ///< an accepted instrument zero
  /// Of the act; other trials (chosen by hand) do not count. One that was not completed is asked
  /// again, and nothing begins by itself until somebody says so.
  void trial_ended(const session::TrialOutcome& outcome, double session_time_s);
  void skip(double session_time_s);  ///< the act, with all further attempts at its task
  void tick(double session_time_s);  ///< pauses end by time

  /// A block of work, or a bout of placements, is over and the patient has not been asked yet.
  [[nodiscard]] bool rating_due() const noexcept { return rating_due_; }
  void rated() noexcept { rating_due_ = false; }

 private:
  void look(double session_time_s);

  std::unique_ptr<const session::ReadyProtocol> protocol_;
  std::unique_ptr<session::ProtocolWalk> walk_;
  std::optional<session::ProtocolWalk::Act> act_;
  std::string name_;
  std::vector<std::string> instructed_;  ///< tasks whose instruction was read
  double act_since_s_ = 0.0;
  bool goes_on_ = false;
  bool worked_ = false;  ///< since the last rating
  bool rating_due_ = false;
};

}  // namespace isograsp::gui
