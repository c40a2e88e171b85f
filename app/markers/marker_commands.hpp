// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `isograsp markers`, and what they share.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/command_line.hpp"
#include "core/result.hpp"
#include "hand/finger.hpp"
#include "kinematics/calibration.hpp"
#include "kinematics/rig.hpp"

namespace isograsp::app {

/// convert, decode, poses, links (app/markers/marker_poses.cpp).
void add_marker_poses(Subcommand markers);
/// calibrate, landmark (app/markers/marker_rig.cpp).
void add_marker_rig(Subcommand markers);
/// postures, adapt, task (app/markers/marker_task.cpp).
void add_marker_task(Subcommand markers);
/// score, rom (app/markers/marker_scores.cpp).
void add_marker_scores(Subcommand markers);
/// quality, drinking (app/markers/marker_quality.cpp).
void add_marker_quality(Subcommand markers);
/// box (app/markers/marker_box.cpp).
void add_marker_box(Subcommand markers);

[[nodiscard]] Result<Rig> load_rig(const std::string& path);
/// A whole recording of markers, of any format.
[[nodiscard]] Result<MarkerRows> load_markers(const std::string& path);
/// The error, with the file that it is about if it does not name one.
[[nodiscard]] Error about_file(const Error& error, const std::string& path);
[[nodiscard]] nlohmann::ordered_json number_or_null(const std::optional<double>& value);
/// "right" or "left", checked by the command line.
[[nodiscard]] inline Hand hand_of(const std::optional<Hand>& hand) noexcept {
  return hand.value_or(Hand::right);
}

}  // namespace isograsp::app
