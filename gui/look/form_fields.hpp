// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a form: a choice as a row of buttons, a date that is typed, a list of dated entries
// from which one can be removed and brought back.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <functional>
#include <optional>
#include <vector>

#include "gui/words/profile_words.hpp"

namespace isograsp::gui {

/// One of a few, or none: pressing the chosen one again takes the choice back.
class SegmentedChoice final : public QWidget {
  Q_OBJECT

 public:
  struct Segment {
    QString object_name;
    QString text;
    QString name;  ///< for assistive technology
    QString key;   ///< a shortcut while the focus is in `keys_of`
  };
  SegmentedChoice(const std::vector<Segment>& segments, QWidget* keys_of);
  [[nodiscard]] std::optional<int> chosen() const { return chosen_; }
  void choose(std::optional<int> index);  ///< without chosen_by_user()

 Q_SIGNALS:
  void chosen_by_user();

 private:
  void press(int index);

  std::optional<int> chosen_;
  std::vector<QPushButton*> buttons_;
};

/// A day as text. Up and Down go to the next and the previous day.
class DateField final : public QLineEdit {
  Q_OBJECT

 public:
  explicit DateField(Ahead ahead);
  [[nodiscard]] Typed<Date> typed() const;
  void show_date(std::optional<Date> date);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Ahead ahead_;
};

/// A remark under a field: quiet, or a problem with a sign in front of it. Without words it takes
/// no room.
class Remark final : public QLabel {
  Q_OBJECT

 public:
  Remark();
  void say(const QString& words);
  void warn(const QString& problem);
  [[nodiscard]] bool warns() const { return warns_; }

 private:
  void show_words(const QString& words, bool warns);
  bool warns_ = false;
};

/// Entries with a day; each can be removed, and what was removed last comes back first.
class DatedList final : public QWidget {
  Q_OBJECT

 public:
  /// `name` begins the names of the widgets inside: "NAME_list", "NAME_remove", "NAME_undo".
  DatedList(const QString& name, const QString& title, const QStringList& columns,
            const QString& empty, QWidget* keys_of);
  /// One row each; the last column gets the room that is left.
  void show_rows(const std::vector<QStringList>& rows);
  /// What was removed last, in words; empty: nothing is to be brought back.
  void offer_undo(const QString& removed);

 Q_SIGNALS:
  void remove_pressed(int row);
  void undo_pressed();

 private:
  void remove();

  QTableWidget* table_;
  QLabel* empty_;
  QPushButton* remove_;
  QLabel* removed_;
  QPushButton* undo_;
};

// Fields for a new entry of a DatedList.
/// Today, until another day is typed. `key` gives it the focus while that is in `card`.
[[nodiscard]] DateField* entry_date(const QString& object_name, const QString& name,
                                    const QString& key, Ahead ahead, QWidget* card);
[[nodiscard]] QLineEdit* entry_text(const QString& object_name, const QString& name,
                                    const QString& hint);
/// Also pressed by Ctrl+Enter while the focus is in `card`.
[[nodiscard]] QPushButton* add_button(const QString& object_name, const QString& name,
                                      QWidget* card);
/// For DatedList::offer_undo().
[[nodiscard]] QString removed_words(const std::string& date, const QString& what);

/// A label that names a field: over it, and for assistive technology.
[[nodiscard]] QLabel* caption(const QString& text, QWidget* field = nullptr);
/// "Ctrl+Shift+T" as the keyboard of the language names it.
[[nodiscard]] QString key_words(const QString& key);
/// Calls `act` on `key` while the focus is in `widget`.
void add_key(QWidget* widget, const QString& key, const std::function<void()>& act);

}  // namespace isograsp::gui
