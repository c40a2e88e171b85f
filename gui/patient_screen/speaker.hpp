// SPDX-License-Identifier: GPL-3.0-or-later
// Loudspeaker and voice of this computer. Each is opened when the first sound is to be
// played; one that cannot be opened is an error that is shown. GUI thread.
#pragma once

#include <QString>
#include <memory>

#include "gui/picture/tones.hpp"

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
  /// Plays until it is called again.
  QString hear(const HeardForce& force);
  /// Speaks in the language of the application; a sentence that is still being spoken is cut short.
  QString speak(const QString& words);
  void be_silent();

 private:
  [[nodiscard]] QString why_mute();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isograsp::gui
