// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/disk_room.hpp"

#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace isograsp::gui {

namespace {

/// A few minutes of a session.
constexpr off_t kEnoughRoom_bytes = 4 << 20;
constexpr qint64 kRoomLookEvery_ms = 2000;

/// Reserves the room for a moment in a file without a name.
bool has_room(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (descriptor < 0) return false;
  const bool room = posix_fallocate(descriptor, 0, kEnoughRoom_bytes) == 0;
  ::close(descriptor);
  return room;
}

}  // namespace

void DiskRoom::begin() {
  was_full_ = room_ = false;
  look();
}

bool DiskRoom::has_come_back() {
  if (was_full_ && room_) {
    was_full_ = false;
    return true;
  }
  if (!looking_ && since_look_.isValid() && since_look_.elapsed() > kRoomLookEvery_ms) look();
  return false;
}

void DiskRoom::look() {
  looking_ = true;
  since_look_.start();
  worker_.run(
      [folder = std::filesystem::absolute(file_).parent_path()] { return has_room(folder); },
      [this](bool room) {
        looking_ = false;
        was_full_ = was_full_ || !room;
        room_ = room;
      });
}

}  // namespace isograsp::gui
