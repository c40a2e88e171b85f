// SPDX-License-Identifier: GPL-3.0-or-later
// A list of names and values to read, row by row with the arrow keys: the first column takes the
// room that is left, the last one holds the values.
#pragma once

#include <QStringList>
#include <QTableWidget>

namespace isograsp::gui {

/// Takes the height that is left, down to scaled(`least_px`).
[[nodiscard]] QTableWidget* make_value_table(const char* name, const QStringList& columns,
                                             int least_px);

}  // namespace isograsp::gui
