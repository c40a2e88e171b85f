// SPDX-License-Identifier: GPL-3.0-or-later
// Where the session stands, as both windows hear of it: what may be done now follows from the state
// by the rules of the flow, and everything that the windows are told comes from here. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <string>

#include "core/time.hpp"
#include "gui/clinic/person_file.hpp"
#include "gui/presenter/session_state.hpp"

namespace isograsp::gui {

class SessionFlow final : public QObject {
  Q_OBJECT

 public:
  /// All must outlive it.
  SessionFlow(const SessionState& state, const Clinic& clinic, const PersonFile& file,
              const Clock& clock);

  [[nodiscard]] const FlowView& view() const noexcept { return view_; }
  /// The chosen hand is not on the affected side: a press must confirm it. Looked up whenever it is
  /// asked: what is known of the person may be read, or told, after the hand was chosen. A session
  /// that is open has its hand.
  [[nodiscard]] bool hand_to_confirm() const noexcept;
  /// A trial, a zero or a protocol is running, or will go on by itself.
  [[nodiscard]] bool under_way() const noexcept;

  // For the acts.
  void decide();                    ///< view() anew; nobody is told
  void update();                    ///< decide() -> changed()
  void refuse(const Error& error);  ///< -> failed()

 Q_SIGNALS:
  void changed();          ///< view() or a choice
  void library_changed();  ///< tasks and protocols
  void frame();            ///< a poll is over: the snapshot is as new as it gets
  void score_changed();    ///< of the running or the last trial
  void trial_ended();
  void settled();                   ///< a session was opened, refused, cancelled or closed
  void failed(const QString& why);  ///< an act was refused

 private:
  [[nodiscard]] FlowFacts facts() const;
  void add_session_facts(const OpenSession& open, FlowFacts& facts) const;
  void add_task_facts(FlowFacts& facts) const;

  const SessionState& state_;
  const Clinic& clinic_;
  const PersonFile& file_;
  const Clock& clock_;
  std::string database_error_;
  FlowView view_;
};

}  // namespace isograsp::gui
