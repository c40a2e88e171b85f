// SPDX-License-Identifier: GPL-3.0-or-later
// All eighteen channels in numbers: force and moment of every finger in its contact frame.
#pragma once

#include <QTableWidget>

#include "session/platform/snapshot.hpp"

namespace isograsp::gui {

class ChannelTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit ChannelTable(QWidget* parent = nullptr);
  /// Numbers that change faster than twice a second cannot be read.
  void show_channels(const session::Snapshot& snapshot);
};

}  // namespace isograsp::gui
