// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the work: effort and pains by the patient, help and notes by the therapist.
// Without a session it is ignored. GUI thread.
#pragma once

#include <optional>
#include <string>

#include "gui/presenter/act_context.hpp"

namespace isograsp::gui {

class Remarks {
 public:
  explicit Remarks(const ActContext& with);

  /// What the patient says of the work, 0 to 10 each; nothing is stored before all that is asked is
  /// known: of a tracked hand shoulder pain, too.
  void rate_effort(int effort);
  void rate_pain(int pain);
  void rate_shoulder_pain(int pain);
  /// The answer to a question about the last trial, kept at once; no number: none was wanted.
  void answer_question(std::size_t question, std::optional<int> number);
  void show_rated();  ///< shows the last answer again, so that it can be corrected
  /// Another block of work begins: the last answer is no longer shown.
  void ask_rating_anew();
  /// The therapist helps, or helped in the last trial; called again it takes that back.
  void toggle_helped();
  [[nodiscard]] bool may_help() const noexcept;
  /// A remark at this moment, kept with the session.
  void note(const std::string& text);

 private:
  void store_rating();

  SessionState& state_;
  SessionFlow& flow_;
  Clinic& clinic_;
};

}  // namespace isograsp::gui
