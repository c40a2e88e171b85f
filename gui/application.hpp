// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist application: both windows until the therapist closes them.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "core/result.hpp"
#include "session/acquisition/realtime.hpp"

namespace isograsp::gui {

struct ApplicationConfig {
  std::string database;    ///< made if absent
  std::string device_uri;  ///< chosen at start; empty: the therapist chooses
  std::string library;
  std::string software_version;
  std::string operator_name = {};
  session::Realtime realtime = session::Realtime::prefer;
  /// Set when the program is to end: windows and sessions are closed in good order. May be null.
  const std::atomic<bool>* stop = nullptr;
  /// Makes a clinic of simulated patients and returns its file; called on another thread.
  std::function<Result<std::string>()> make_demonstration = {};
};

/// Returns when the therapist window is closed. Errors: failed, if there is no display or it cannot
/// be reached, or if it was told to end and not all of the last session is in its database. Main
/// thread.
[[nodiscard]] Result<void> run_application(const ApplicationConfig& config);

/// The code that the settings of this workstation have, as they stand in their file.
[[nodiscard]] std::string language_in_settings();

}  // namespace isograsp::gui
