// SPDX-License-Identifier: GPL-3.0-or-later
// Commands about two hands and soft pads.
#pragma once

#include <string>

#include "app/command_line.hpp"
#include "core/result.hpp"

namespace isograsp::app {

/// `simulate` of a scene with two hands (app/bimanual/simulate_hands.cpp).
struct HandsSimulation {
  std::string scene;
  std::string text;    ///< of the scene
  std::string forces;  ///< or proxies
  std::string out;
};
[[nodiscard]] Result<void> simulate_hands(const HandsSimulation& options);
/// The same of pads that proxies lead: `forces` are these (app/bimanual/simulate_pads.cpp).
[[nodiscard]] Result<void> simulate_pads(const HandsSimulation& options, const std::string& solver);

/// pad-bench (app/bimanual/pad_bench.cpp).
void add_pad_bench(CommandLine& line);

}  // namespace isograsp::app
