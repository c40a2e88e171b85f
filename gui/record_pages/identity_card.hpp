// SPDX-License-Identifier: GPL-3.0-or-later
// Name, birth date and contact of the person behind a code: only in a protected database, only for
// whoever may see identities, and only when asked for, because every reading is logged.
#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <string>

#include "gui/clinic/staff.hpp"
#include "gui/look/card.hpp"
#include "gui/look/form_fields.hpp"

namespace isograsp::gui {

class IdentityCard final : public Card {
  Q_OBJECT

 public:
  explicit IdentityCard(Staff& staff, QWidget* parent = nullptr);

  /// Closed again, with nothing of the one before.
  void show_patient(const std::string& code);

 private:
  void read();
  void store();
  void close();
  void refresh();

  Staff& staff_;
  std::string code_;
  bool open_ = false;
  QLineEdit* name_;
  DateField* birth_;
  QLineEdit* contact_;
  QPushButton* show_;
  QPushButton* store_;
  Remark* remark_;
};

}  // namespace isograsp::gui
