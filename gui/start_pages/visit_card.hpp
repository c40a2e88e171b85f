// SPDX-License-Identifier: GPL-3.0-or-later
// One person on the start page: who it is, what comes next, how the first primary measure goes, and
// the way to a session.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "gui/clinic/day.hpp"
#include "gui/look/sparkline.hpp"

namespace isograsp::gui {

/// What stands on a card; empty lines are left out.
struct CardWords {
  QString code;
  QString name;
  QString mark;     ///< "TODAY"
  QString next;     ///< "Next: Battery, right hand"
  QString last;     ///< "Last session …"
  QString seen;     ///< the same as short as the card needs it
  QString verdict;  ///< of the first primary measure
  QString measure;  ///< which one that is
  /// All of it in one sentence after the other, to be read aloud.
  [[nodiscard]] QString aloud() const;
};
/// `card`: null: not read yet.
[[nodiscard]] CardWords words_of(const PersonOfDay& person, const QString& name,
                                 const DayCard* card);

class VisitCard final : public QFrame {
  Q_OBJECT

 public:
  explicit VisitCard(QWidget* parent = nullptr);

  void show_person(const PersonOfDay& person, const CardWords& words, const DayCard* card);
  void show_chosen(bool chosen);
  /// A session can be begun; looking at the person can be done at any time.
  void allow(bool begin, bool open);
  [[nodiscard]] QPushButton& begin() noexcept { return *begin_; }

 Q_SIGNALS:
  void begin_pressed();
  void open_pressed();
  void remove_pressed();  ///< added by mistake

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  CardWords words_;
  bool chosen_ = false;
  QLabel* code_;
  QLabel* mark_;
  QLabel* next_;
  QLabel* last_;
  QLabel* verdict_;
  Sparkline* spark_;
  QPushButton* begin_;
  QPushButton* open_;
  QPushButton* remove_;  ///< while nothing is stored of the person
};

}  // namespace isograsp::gui
