// SPDX-License-Identifier: GPL-3.0-or-later
// The cards of the profile that verdicts of change need: which measures get one, and when a
// clinician judged the person stable. What is stored and when is the panel's.
#pragma once

#include <QComboBox>
#include <vector>

#include "gui/look/card.hpp"
#include "gui/look/form_fields.hpp"

namespace isograsp::gui {

/// Primary measures: at most four.
class PrimaryCard final : public Card {
  Q_OBJECT

 public:
  explicit PrimaryCard(QWidget* parent = nullptr);
  void show_primaries(const std::vector<storage::PrimaryMeasure>& primaries);
  /// What can be chosen, chosen ones included.
  void offer(const std::vector<storage::PrimaryMeasure>& choices);
  void clear();  ///< another person; who chooses stays

 Q_SIGNALS:
  void added(const storage::PrimaryMeasure& primary);
  void removed(storage::RowId id);

 private:
  void add();
  void show_state();

  QComboBox* measure_;
  QLineEdit* by_;
  QPushButton* add_;
  Remark* remark_;
  DatedList* list_;
  std::vector<storage::PrimaryMeasure> choices_;  ///< as in the box
  std::vector<storage::PrimaryMeasure> primaries_;
  std::vector<storage::PrimaryMeasure> gone_;  ///< removed while this person is shown
};

/// Times over which the person is judged stable.
class StableCard final : public Card {
  Q_OBJECT

 public:
  explicit StableCard(QWidget* parent = nullptr);
  void show_periods(const std::vector<storage::StablePeriod>& periods);
  void clear();

 Q_SIGNALS:
  void added(const storage::StablePeriod& period);
  void removed(storage::RowId id);

 private:
  void add();

  DateField* from_;
  DateField* until_;
  QLineEdit* by_;
  QLineEdit* text_;
  Remark* remark_;
  DatedList* list_;
  std::vector<storage::StablePeriod> periods_;
  std::vector<storage::StablePeriod> gone_;
};

}  // namespace isograsp::gui
