// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers 0 to 10 as a row of buttons: one press answers. Left and right arrows move.
#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QWidget>
#include <optional>

namespace isograsp::gui {

class ScoreRow final : public QWidget {
  Q_OBJECT

 public:
  struct Scale {
    int least = 0;
    int most = 10;
  };
  /// Its buttons are called `name`_0 … `name`_10.
  ScoreRow(const QString& name, const QString& question, QWidget* parent = nullptr);
  ScoreRow(const QString& name, const QString& question, Scale scale, QWidget* parent = nullptr);
  void show_value(std::optional<int> value);

 Q_SIGNALS:
  void chosen(int value);

 private:
  QButtonGroup* numbers_;
};

}  // namespace isograsp::gui
