// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT (Ctrl-C), SIGTERM and SIGHUP (a terminal that closes) end what runs in good order.
#pragma once

#include <atomic>
#include <string>

namespace isograsp::app {

/// While it lives, these signals end nothing by themselves: they set stop(). A second SIGINT ends
/// the program at once. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  [[nodiscard]] static const std::atomic<bool>& stop() noexcept;
  /// "SIGTERM"; empty: none came.
  [[nodiscard]] static std::string name();
};

/// A write beyond RLIMIT_FSIZE, or to a reader that is gone, is an error and not the end of the
/// program.
void let_writes_fail();

}  // namespace isograsp::app
