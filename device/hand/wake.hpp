// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. One thread wakes another that waits until a deadline; no lock.
#pragma once

#include "core/result.hpp"
#include "core/time.hpp"

namespace isograsp {

class Wake {
 public:
  Wake() = default;
  ~Wake();
  Wake(const Wake&) = delete;
  Wake& operator=(const Wake&) = delete;

  /// Errors: the system has no descriptor left.
  [[nodiscard]] Result<void> open();
  /// Any thread. Real-time safe.
  void signal() const noexcept;
  /// Until it was signalled since the last wait, or `span` has passed. Real-time safe.
  void wait(Timestamp span) const noexcept;

 private:
  int descriptor_ = -1;
};

}  // namespace isograsp
