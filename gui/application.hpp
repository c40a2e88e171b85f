// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist application: both windows until the therapist closes them.
#pragma once

#include <functional>
#include <string>

#include "core/result.hpp"
#include "session/realtime.hpp"

namespace isograsp {

struct ApplicationConfig {
  std::string database;    ///< made if absent
  std::string device_uri;  ///< chosen at start; empty: the therapist chooses
  std::string library;
  std::string software_version;
  std::string operator_name = {};
  Realtime realtime = Realtime::prefer;
  /// Makes a clinic of simulated patients and returns its file; called on another thread.
  std::function<Result<std::string>()> make_demonstration = {};
};

/// Returns when the therapist window is closed. Errors: failed, if there is no display or
/// it cannot be reached. Main thread.
[[nodiscard]] Result<void> run_application(const ApplicationConfig& config);

}  // namespace isograsp
