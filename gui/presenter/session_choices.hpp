// SPDX-License-Identifier: GPL-3.0-or-later
// What the therapist chooses before a session: who works, with which hand and device, after which
// answers, along which protocol. A choice that the flow does not allow is ignored. GUI thread.
#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "gui/presenter/act_context.hpp"

namespace isograsp::gui {

class SessionChoices final : public QObject {
  Q_OBJECT

 public:
  explicit SessionChoices(const ActContext& with);

  void choose_patient(const std::string& code);
  void choose_hand(Hand hand);
  /// Both work at once, each on a platform of its own.
  void choose_both_hands();
  /// The chosen hand is not the affected one, and that is meant.
  void confirm_hand();
  /// `of`: of which of both hands; nothing: one works.
  void answer_screening(const Screening& answers, std::optional<Hand> of = std::nullopt);
  void answer_screening(const ArmScreening& answers);
  void answer_screening(const HandScreening& answers);
  void choose_device(const std::string& uri);
  /// Of both hands. A simulated person has two: either choice is that of both.
  void choose_platform(Hand hand, const std::string& uri);
  /// A tracked hand that cannot open has the size of the other one, or its own again.
  void take_size_of_other(bool take);
  /// Place in the library; nothing: tasks are chosen one by one.
  void choose_protocol(std::optional<int> place);
  /// An interrupted protocol may be taken up: go on with it, or begin anew.
  void decide_earlier(bool go_on);
  /// Who works at this station, from the next session on; empty: as the settings say.
  void name_operator(const std::string& name);

  /// Before every session: hand and screening.
  void ask_anew();
  /// The other hand of the same person, after a session of one: all else is asked as before any.
  void follow_with(Hand hand);
  /// Asks the database whether the chosen protocol was interrupted today, whether this hand has
  /// worked with such a device before, and whether the other one was measured.
  void look_for_earlier();

 private:
  SessionState& state_;
  SessionFlow& flow_;
  Clinic& clinic_;
  PersonFile& file_;
  Seating& seating_;
  void leave_both_hands();
  void look_whether_first_time();
  void look_for_other_hand();

  int lookups_ = 0;  ///< the newest one counts
};

}  // namespace isograsp::gui
