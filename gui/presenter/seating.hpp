// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient of this session sits and sees: as last time until the therapist says otherwise.
// GUI thread.
#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "gui/clinic/clinic.hpp"
#include "gui/picture/presentation.hpp"
#include "gui/rules/posture.hpp"
#include "hand/finger.hpp"

namespace isograsp::gui {

class Seating final : public QObject {
  Q_OBJECT

 public:
  explicit Seating(Clinic& clinic, QObject* parent = nullptr);

  /// Looks up how this hand was seated last, and what the patient's screen was like. What was said
  /// for anybody else, or for the other hand, is forgotten.
  void look(const std::string& code, std::optional<Hand> hand);
  void say_posture(const SittingPosture& posture);
  void say_presentation(const Presentation& presentation);

  /// As last time, or as it was said now.
  [[nodiscard]] const SittingPosture& posture() const noexcept { return posture_; }
  /// Of this hand; nothing said: there was none.
  [[nodiscard]] const SittingPosture& last_posture() const noexcept { return last_posture_; }
  [[nodiscard]] const Presentation& presentation() const noexcept { return presentation_; }

 Q_SIGNALS:
  void changed();

 private:
  Clinic& clinic_;
  std::string code_;
  std::optional<Hand> hand_;
  int lookups_ = 0;  ///< the newest one counts
  SittingPosture posture_;
  SittingPosture last_posture_;
  bool posture_said_ = false;
  Presentation presentation_;
  bool presentation_said_ = false;
};

}  // namespace isograsp::gui
