// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/moment.hpp"

#include <array>

namespace isograsp::session {

std::string_view name_of(Stage stage) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"idle", "zeroing", "trial", "paused",
                                                   "finished"};
  return kNames[static_cast<std::size_t>(stage)];
}

Words words_of(PauseCause cause) noexcept {
  switch (cause) {
    case PauseCause::none: break;
    case PauseCause::therapist: return "Paused by the therapist."_text;
    case PauseCause::missing_samples:
      return "Paused: samples are missing. Check the cables, check the zero, then resume."_text;
    case PauseCause::device_fault:
      return "Paused: the device has a fault. Mend it, check the zero, then resume."_text;
    case PauseCause::occluded:
      return "Out of sight: turn towards the cameras. The trial goes on by itself."_text;
    case PauseCause::object_lost:
      return "The object has left the hand: give it back. The trial goes on by itself."_text;
  }
  return ""_text;
}

}  // namespace isograsp::session
