// SPDX-License-Identifier: GPL-3.0-or-later
// A white card with a title: the building block of the therapist's window.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QString>
#include <QVBoxLayout>
#include <QVariant>

namespace isograsp::gui {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(const QString& title, QWidget* parent = nullptr) : QFrame(parent) {
    setProperty("card", true);
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(12, 10, 12, 12);
    column_->setSpacing(7);
    title_ = new QLabel(title);
    title_->setProperty("role", "title");
    column_->addWidget(title_);
  }

  void set_title(const QString& title) { title_->setText(title); }
  /// What stands in the card, below its title.
  [[nodiscard]] QVBoxLayout& column() noexcept { return *column_; }

 protected:
  QVBoxLayout* column_;
  QLabel* title_;
};

}  // namespace isograsp::gui
