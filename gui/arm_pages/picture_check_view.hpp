// SPDX-License-Identifier: GPL-3.0-or-later
// The check of the picture, in the card of what is moved before cameras or a tracker: a button that
// begins and ends it, and what is to be moved now, or what came of it.
#pragma once

#include <QLabel>
#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class PictureCheckView final : public QObject {
  Q_OBJECT

 public:
  enum class Moves : std::uint8_t { object, hand };

  /// The card puts button() and words() where they belong.
  PictureCheckView(SessionPresenter& presenter, Moves moves, QWidget* card);

  [[nodiscard]] QPushButton* button() const noexcept { return button_; }
  [[nodiscard]] QLabel* words() const noexcept { return words_; }
  void refresh();

 private:
  [[nodiscard]] QString way_words(PictureCheck::Way way) const;
  [[nodiscard]] QString words_of(const PictureCheck& check) const;

  SessionPresenter& presenter_;
  Moves moves_;
  QPushButton* button_;
  QLabel* words_;
};

}  // namespace isograsp::gui
