// SPDX-License-Identifier: GPL-3.0-or-later
// What can be relied on of the database that is open, and what not; and what the last login found.
#pragma once

#include <QLabel>

#include "gui/clinic/staff.hpp"
#include "gui/look/card.hpp"

namespace isograsp::gui {

class RecordsCard final : public Card {
  Q_OBJECT

 public:
  explicit RecordsCard(const Staff& staff, QWidget* parent = nullptr);

 private:
  void refresh();

  const Staff& staff_;
  QLabel* found_;
};

}  // namespace isograsp::gui
