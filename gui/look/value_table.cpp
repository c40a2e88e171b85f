// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/value_table.hpp"

#include <QHeaderView>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kValueRow_px = 24;

}  // namespace

QTableWidget* make_value_table(const char* name, const QStringList& columns, int least_px) {
  auto* table = new QTableWidget(0, columns.size());
  table->setObjectName(QLatin1String(name));
  table->setHorizontalHeaderLabels(columns);
  for (int column = 0; column < columns.size(); ++column) {
    const bool last = column + 1 == columns.size();
    table->horizontalHeader()->setSectionResizeMode(
        column, column == 0 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    table->horizontalHeaderItem(column)->setTextAlignment((last ? Qt::AlignRight : Qt::AlignLeft) |
                                                          Qt::AlignVCenter);
  }
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(scaled(kValueRow_px));
  table->setShowGrid(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setTabKeyNavigation(false);  // Tab leaves the list
  take_rest(*table, least_px);
  return table;
}

}  // namespace isograsp::gui
