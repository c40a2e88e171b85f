// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient of this session sits and sees: as last time until the therapist says otherwise.
// GUI thread.
#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "gui/picture/presentation.hpp"
#include "gui/rules/posture.hpp"
#include "hand/hands.hpp"

namespace isograsp::gui {

class Seating final : public QObject {
  Q_OBJECT

 public:
  explicit Seating(Clinic& clinic, QObject* parent = nullptr);

  /// Looks up how this hand was seated last, and what the patient's screen was like; without a hand
  /// how each was when both worked. What was said for anybody else, or for other hands, is
  /// forgotten.
  void look(const std::string& code, std::optional<Hand> hand);
  /// Of both hands the seat is that of either.
  void say_posture(Hand hand, const SittingPosture& posture);
  void say_presentation(const Presentation& presentation);

  /// As last time, or as it was said now.
  [[nodiscard]] const SittingPosture& posture(Hand hand) const noexcept { return postures_[hand]; }
  /// Nothing said: there was none.
  [[nodiscard]] const SittingPosture& last_posture(Hand hand) const noexcept {
    return last_postures_[hand];
  }
  /// As they are stored: of the one hand, or of both.
  [[nodiscard]] std::vector<storage::SessionAnswer> posture_answers() const;
  [[nodiscard]] const Presentation& presentation() const noexcept { return presentation_; }

 Q_SIGNALS:
  void changed();

 private:
  Clinic& clinic_;
  std::string code_;
  std::optional<Hand> hand_;
  int lookups_ = 0;                   ///< the newest one counts
  OfHands<SittingPosture> postures_;  ///< of one hand alone the other says nothing
  OfHands<SittingPosture> last_postures_;
  bool posture_said_ = false;
  Presentation presentation_;
  bool presentation_said_ = false;
};

}  // namespace isograsp::gui
