// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the start page as one list: arrow keys go from card to card, Enter begins.
#pragma once

#include <QListWidget>
#include <map>
#include <string>
#include <vector>

#include "gui/clinic/day_book.hpp"
#include "gui/start_pages/visit_card.hpp"

namespace isograsp::gui {

class VisitCards final : public QListWidget {
  Q_OBJECT

 public:
  /// More are found by the search: nobody scrolls through hundreds.
  static constexpr int kMost = 60;

  explicit VisitCards(const DayBook& book, QWidget* parent = nullptr);

  struct Shown {
    PersonOfDay person;
    QString name;
  };
  /// At most kMost. Cards are made anew only where others, or another order, are to be shown.
  void show_people(const std::vector<Shown>& people);
  /// What was read of one of them.
  void renew(const QString& code);
  /// Who is chosen, without a signal; empty: nobody.
  void choose(const QString& code);
  void allow(bool begin, bool open);
  /// Begin of the one who is chosen is the next thing to press, or nothing here is.
  void mark_begin(bool next);

 Q_SIGNALS:
  void chosen(const QString& code);
  void begin_pressed(const QString& code);
  void open_pressed(const QString& code);
  void remove_pressed(const QString& code);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] VisitCard* card_at(int row) const;
  void say(int row);
  void arrange();
  void show_chosen();

  const DayBook& book_;
  std::vector<Shown> people_;
  bool may_begin_ = true;
  bool may_open_ = true;
};

}  // namespace isograsp::gui
