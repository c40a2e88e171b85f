// SPDX-License-Identifier: GPL-3.0-or-later
// Shows how much of a file is written, with a button Cancel.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

namespace isograsp::gui {

class WorkProgress final : public QWidget {
  Q_OBJECT

 public:
  /// `name` begins the names of its parts: NAME_writing, NAME_doing, NAME_progress, NAME_cancel.
  WorkProgress(const QString& name, const QString& title, QWidget* parent = nullptr);

  void show_fraction(double fraction);  ///< 0 … 1
  void say(const QString& words) { doing_->setText(words); }
  [[nodiscard]] QPushButton& cancel() noexcept { return *cancel_; }

 private:
  QLabel* doing_;
  QProgressBar* progress_;
  QPushButton* cancel_;
};

}  // namespace isograsp::gui
