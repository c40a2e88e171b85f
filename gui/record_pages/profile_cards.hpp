// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the profile: the person, goals and notes, treatment, scores of clinical scales. They
// know fields and words; what is stored and when is the panel's
// (gui/record_pages/profile_panel.hpp).
#pragma once

#include <QComboBox>
#include <QPlainTextEdit>
#include <vector>

#include "gui/look/card.hpp"
#include "gui/look/form_fields.hpp"

namespace isograsp::gui {

/// Affected side, dominant hand, sex, year of birth, onset; goals and notes.
class PersonCard final : public Card {
  Q_OBJECT

 public:
  explicit PersonCard(QWidget* parent = nullptr);
  /// A new person: nothing that was typed before can come back by Ctrl+Z.
  void show_profile(const storage::PatientProfile& profile);
  /// Takes onset and year of birth as they stand there, or says why they make no sense.
  void finish();
  /// As the fields say; a day or year that is being typed or makes no sense is left as it was.
  [[nodiscard]] storage::PatientProfile profile() const;
  /// What is not stored because it makes no sense, as a sentence; empty: nothing.
  [[nodiscard]] QString refused() const;

 Q_SIGNALS:
  void typed();  ///< more may follow
  void left();   ///< the field, or a button was pressed: store it now

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_sex_and_year();
  void make_onset();
  void place_fields();
  void finish_year();
  [[nodiscard]] QPlainTextEdit* text_field(const QString& name, const QString& title,
                                           const QString& tooltip, const QString& key);

  SegmentedChoice* affected_;
  SegmentedChoice* dominant_;
  SegmentedChoice* sex_;
  QLineEdit* born_;
  Remark* born_remark_;
  std::optional<int> birth_year_;  ///< the last one that made sense
  DateField* onset_;
  Remark* onset_remark_;
  std::string onset_iso_;  ///< the last one that made sense
  QPlainTextEdit* goals_;
  QPlainTextEdit* notes_;
};

/// Marks of treatment: what changed, and when.
class TreatmentCard final : public Card {
  Q_OBJECT

 public:
  explicit TreatmentCard(QWidget* parent = nullptr);
  void show_marks(const std::vector<storage::TreatmentMark>& marks);
  void clear();  ///< another person: nothing half-typed, nothing to bring back

 Q_SIGNALS:
  void added(const storage::TreatmentMark& mark);
  void removed(storage::RowId id);

 private:
  void add();

  DateField* date_;
  QComboBox* kind_;
  QLineEdit* text_;
  Remark* remark_;
  DatedList* list_;
  std::vector<storage::TreatmentMark> marks_;
  std::vector<storage::TreatmentMark> gone_;  ///< removed while this person is shown
};

/// Scores of the scales that the clinic uses anyway.
class ScoreCard final : public Card {
  Q_OBJECT

 public:
  explicit ScoreCard(QWidget* parent = nullptr);
  void show_scores(const std::vector<storage::ClinicalScore>& scores);
  void clear();

 Q_SIGNALS:
  void added(const storage::ClinicalScore& score);
  void removed(storage::RowId id);

 private:
  void add();
  void read_value(bool complete);
  [[nodiscard]] const storage::ClinicalScale& scale() const;

  DateField* date_;
  QComboBox* scale_;
  QLineEdit* value_;
  QLineEdit* text_;
  Remark* remark_;
  DatedList* list_;
  std::vector<storage::ClinicalScore> scores_;
  std::vector<storage::ClinicalScore> gone_;
};

}  // namespace isograsp::gui
