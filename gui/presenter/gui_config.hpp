// SPDX-License-Identifier: GPL-3.0-or-later
// What the windows are started with.
#pragma once

#include <span>
#include <string>

#include "session/acquisition/realtime.hpp"
#include "session/open_apparatus.hpp"
#include "session/resting.hpp"

namespace isograsp::gui {

struct GuiConfig {
  std::string database;
  std::string device_uri;  ///< chosen at start; empty: the therapist chooses
  std::string library;     ///< shipped: folder with tasks/, protocols/ and scenes/
  std::string software_version;
  std::string operator_name = {};                          ///< stored with zero and resting force
  session::Realtime realtime = session::Realtime::prefer;  ///< of the acquisition thread
  std::string settings = {};                               ///< file; empty: nothing is read or kept
  bool look_only = false;  ///< another program works with the file: nothing is added or changed
  double settle_after_strapping_s = session::kSettleAfterStrapping_s;
  /// What a device URI opens; others in tests.
  std::span<const session::ApparatusRow> apparatuses = session::all_apparatuses();
};

}  // namespace isograsp::gui
