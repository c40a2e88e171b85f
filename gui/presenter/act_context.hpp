// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/presenter/ only: what the acts change, and what they work with. GUI thread.
#pragma once

#include "core/time.hpp"
#include "gui/clinic/background.hpp"
#include "gui/clinic/clinic.hpp"
#include "gui/clinic/person_file.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/presenter/example_player.hpp"
#include "gui/presenter/seating.hpp"
#include "gui/presenter/session_flow.hpp"
#include "gui/presenter/session_state.hpp"

namespace isograsp::gui {

/// All of it outlives the acts.
struct ActContext {
  SessionState& state;
  SessionFlow& flow;
  Clinic& clinic;
  PersonFile& file;
  const SettingsFile& settings;
  Seating& seating;
  Background& worker;      ///< for what takes long
  ExamplePlayer& example;  ///< on the patient's screen; it ends with any act
  const Clock& clock;
};

}  // namespace isograsp::gui
