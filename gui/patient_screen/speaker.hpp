// SPDX-License-Identifier: GPL-3.0-or-later
// Loudspeaker and voice of this computer. Nothing is opened before the first sound is wanted; what
// cannot be opened is said, not passed over. GUI thread.
#pragma once

#include <QString>
#include <memory>

#include "gui/rules/tones.hpp"

namespace isograsp::gui {

class Speaker {
 public:
  Speaker();
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void set_volume(int percent);
  // Each returns why nothing is heard, with a remedy; empty: it is.
  QString play(Tone tone);
  /// From now on, until it is told otherwise.
  QString hear(const HeardForce& force);
  /// Speaks in the language of the application; what is being said is cut short.
  QString speak(const QString& words);
  void be_silent();

 private:
  [[nodiscard]] QString why_mute();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isograsp::gui
