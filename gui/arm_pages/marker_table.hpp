// SPDX-License-Identifier: GPL-3.0-or-later
// Segments of an arm and their markers: how much of the last seconds each was seen, how well its
// markers fit, what became of it in the newest picture.
#pragma once

#include <QTableWidget>

#include "gui/look/marker_history.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class MarkerTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit MarkerTable(QWidget* parent = nullptr);
  /// Rows for this rig: its segments, then its markers.
  void show_setup(const session::ArmSetup& setup);
  void show_arm(const session::ArmSnapshot& now, const MarkerHistory& history);
  void show_nothing();

 private:
  void put(int row, int column, const QString& text, bool problem = false);

  std::vector<ArmSegment> segments_;
  std::vector<std::string> markers_;
};

}  // namespace isograsp::gui
