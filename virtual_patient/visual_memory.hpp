// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures on their way from the eye to the decision: a queue with the visual delay.
#pragma once

#include <cstddef>
#include <vector>

#include "hand/stimulus.hpp"

namespace isograsp::virtual_patient {

class VisualMemory {
 public:
  VisualMemory();

  /// A new picture. One with an earlier time than the last starts a new session: older pictures are
  /// forgotten, and true is returned. Real-time safe.
  bool see(const Stimulus& stimulus) noexcept;
  /// The next picture that was on the screen at or before `until_s`, or null. Real-time safe.
  [[nodiscard]] const Stimulus* next(double until_s) noexcept;

 private:
  static constexpr std::size_t kPictures = 1024;  ///< one second at the fastest frame rate
  std::vector<Stimulus> ring_;
  std::size_t written_ = 0;  ///< pictures so far; the ring holds the last kPictures
  std::size_t taken_ = 0;
};

}  // namespace isograsp::virtual_patient
