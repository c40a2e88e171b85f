// SPDX-License-Identifier: GPL-3.0-or-later
// Watches a full disk until it has room again, so that a message about a lack of room can be taken
// off the screen. GUI thread; the disk is asked on a worker.
#pragma once

#include <QElapsedTimer>
#include <string>

#include "gui/clinic/background.hpp"

namespace isograsp::gui {

class DiskRoom {
 public:
  /// `file`: on that disk, in a folder that may be written.
  explicit DiskRoom(std::string file) : file_(std::move(file)) {}
  /// Something could not be written: looks at once whether the disk is full.
  void begin();
  /// True once, when it was seen full and has room now. Looks every two seconds.
  [[nodiscard]] bool has_come_back();

 private:
  void look();

  std::string file_;
  bool looking_ = false;
  bool was_full_ = false;
  bool room_ = false;
  QElapsedTimer since_look_;
  Background worker_;
};

}  // namespace isograsp::gui
