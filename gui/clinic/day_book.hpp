// SPDX-License-Identifier: GPL-3.0-or-later
// The day of the clinic as the start page shows it: people in their order, what is read of each
// when it is looked at, and who fits a search. Read anew when the clinic changes. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/day.hpp"

namespace isograsp::gui {

class DayBook final : public QObject {
  Q_OBJECT

 public:
  /// Of a clinic that is open, or will be.
  explicit DayBook(Clinic& clinic, QObject* parent = nullptr);

  /// Sessions were added: everything is read anew -> changed(). Until then all stays as it is.
  void renew();
  /// What was read for somebody who is no longer logged in.
  void forget();
  /// The cards of these are looked at: what is missing is read, in this order -> card_read().
  void look_at(const std::vector<storage::PatientRecord>& patients);
  /// What finds people beside code and name is read of all -> searchable() by and by.
  void prepare_search();

  [[nodiscard]] const std::vector<PersonOfDay>& people() const noexcept { return people_; }
  /// Null: not read yet.
  [[nodiscard]] const DayCard* card(const std::string& code) const;
  /// A part of the words by which a person can be found, in the language of the screen: protocols,
  /// treatments.
  [[nodiscard]] bool found_by(const std::string& code, const QString& wanted) const;

 Q_SIGNALS:
  void changed();
  void card_read(const QString& code);
  void searchable();  ///< more people can be found than before

 private:
  void begin_anew();
  void read_next();
  void read_next_words();

  Clinic& clinic_;
  std::vector<PersonOfDay> people_;
  std::map<std::string, DayCard> cards_;  ///< by code
  std::deque<storage::PatientRecord> wanted_;
  bool reading_ = false;
  std::map<std::string, QStringList> words_;  ///< by code
  std::deque<storage::PatientRecord> without_words_;
  bool searched_ = false;  ///< somebody has searched: words are wanted
  int edition_ = 0;        ///< what was asked for an earlier one is not kept
};

}  // namespace isograsp::gui
