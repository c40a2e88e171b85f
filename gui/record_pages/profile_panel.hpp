// SPDX-License-Identifier: GPL-3.0-or-later
// A form about one patient that stores itself: a change is stored when its field is left or a
// second after the last key. Wide enough, it stands in two columns; it scrolls by itself.
#pragma once

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <functional>
#include <string>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/person_file.hpp"
#include "gui/record_pages/change_cards.hpp"
#include "gui/record_pages/profile_cards.hpp"

namespace isograsp::gui {

class ProfilePanel final : public QWidget {
  Q_OBJECT

 public:
  ProfilePanel(Clinic& clinic, PersonFile& file, QWidget* parent = nullptr);
  ~ProfilePanel() override;  ///< store_now()

  /// What was typed about the one before is stored first. No code: nobody.
  void show_patient(const std::string& code);
  /// Nobody is shown any more; what was typed is not stored (store_now()).
  void forget();
  /// Waits neither for the second after the last key nor for the field to be left.
  void store_now();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  using Stored = PersonFile::Stored;
  using Change = std::function<void(PersonFile& file, Stored then)>;
  [[nodiscard]] QLayout* make_header();
  [[nodiscard]] QWidget* make_form();
  void watch();
  void load();
  void store();
  /// Changes a list of this person; kept for try_again() where it is not stored.
  void change(const Change& change);
  /// Connects a card of entries that are added and removed.
  template <class Entry, class Card>
  void connect_card(Card* card, PersonFile::Add<Entry> add, PersonFile::Remove remove);
  /// Only a delay for reading: nothing depends on it while the form is hidden.
  void load_choices();
  void try_again();
  void take_answer();
  void refuse(const QString& code, const QString& why);
  void show_state();

  Clinic& clinic_;
  PersonFile& file_;
  std::string code_;
  bool filled_ = false;           ///< the fields show what is stored of code_
  bool changed_ = false;          ///< since the person is shown
  int under_way_ = 0;             ///< changes without an answer
  storage::PatientProfile sent_;  ///< what the database was told last
  storage::PatientProfile stored_;
  std::vector<Change> refused_;  ///< not stored, oldest first
  QString problem_;              ///< why something could not be read or stored
  QTimer delay_;
  QLabel* title_;
  QLabel* state_;
  QPushButton* again_;
  QScrollArea* scroll_;
  QBoxLayout* columns_;
  PersonCard* person_;
  TreatmentCard* treatment_;
  ScoreCard* scores_;
  PrimaryCard* primary_;
  StableCard* stable_;
};

}  // namespace isograsp::gui
