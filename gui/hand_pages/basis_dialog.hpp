// SPDX-License-Identifier: GPL-3.0-or-later
// On which lawful basis a person's data are used: what is on record, and one more entry. Nothing is
// filled in beforehand but the day.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <string>
#include <vector>

#include "gui/clinic/staff.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/form_fields.hpp"
#include "storage/person/consent.hpp"

namespace isograsp::gui {

class BasisDialog final : public QDialog {
  Q_OBJECT

 public:
  /// Accepted: an entry was recorded.
  BasisDialog(Staff& staff, std::string code, QWidget* parent = nullptr);

 private:
  void make_fields();
  [[nodiscard]] QLayout* make_form();
  void read();
  void show_recorded(const std::vector<storage::Consent>& recorded);
  void record();
  void refresh();

  Staff& staff_;
  std::string code_;
  QTableWidget* recorded_;
  QLabel* nothing_;
  ChoiceBox* purpose_;
  ChoiceBox* basis_;
  ChoiceBox* state_;
  DateField* date_;
  QLineEdit* text_;
  Remark* remark_;
  QPushButton* record_;
  bool recording_ = false;
};

}  // namespace isograsp::gui
