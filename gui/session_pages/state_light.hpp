// SPDX-License-Identifier: GPL-3.0-or-later
// A light with words: every mood has its own shape and colour, and its word as accessible name.
#pragma once

#include <QWidget>

#include "gui/rules/flow.hpp"

namespace isograsp::gui {

class StateLight final : public QWidget {
  Q_OBJECT

 public:
  explicit StateLight(int size_px, QWidget* parent = nullptr);
  void show_mood(Mood mood);
  [[nodiscard]] Mood mood() const noexcept { return mood_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Mood mood_ = Mood::off;
};

}  // namespace isograsp::gui
