// SPDX-License-Identifier: GPL-3.0-or-later
// `isograsp simulate` of scenes with two hands.
#pragma once

#include <string>

#include "core/result.hpp"

namespace isograsp::bimanual {
struct HandsScene;
}

namespace isograsp::app {

struct HandsSimulation {
  std::string scene;
  std::string text;    ///< of the scene
  std::string forces;  ///< or proxies
  std::string out;
};
/// Pushes move the hands (app/bimanual/simulate_hands.cpp).
[[nodiscard]] Result<void> simulate_hands(const HandsSimulation& options);
/// Of scenes whose coupling is "force", and "none" (app/bimanual/simulate_pressed.cpp).
[[nodiscard]] Result<void> simulate_pressed(const bimanual::HandsScene& scene,
                                            const HandsSimulation& options);
[[nodiscard]] Result<void> simulate_uncoupled(const HandsSimulation& options);
/// Proxies lead pads (app/bimanual/simulate_pads.cpp).
[[nodiscard]] Result<void> simulate_pads(const HandsSimulation& options, const std::string& solver);

}  // namespace isograsp::app
