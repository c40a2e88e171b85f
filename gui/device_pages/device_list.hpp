// SPDX-License-Identifier: GPL-3.0-or-later
// The devices a therapist can choose from: what is present now, in plain words.
#pragma once

#include <string>
#include <vector>

#include "gui/clinic/settings.hpp"

namespace isograsp::gui {

/// Instead of a URI: it is to be asked for.
inline constexpr const char* kAskRecording = "";
inline constexpr const char* kAskCameras = "cameras";
inline constexpr const char* kAddDevice = "add";

struct DeviceChoice {
  std::string words;  ///< "Simulated patient, healthy"
  std::string uri;    ///< or one of those above
};

/// Devices that were added here, CAN interfaces of this computer, the simulated patients, "a
/// recording", "add a device". `preset` (may be empty) stands first. Reads `network_folder`
/// (/sys/class/net) and nothing else.
[[nodiscard]] std::vector<DeviceChoice> list_devices(
    const std::string& preset, const std::vector<NamedDevice>& added,
    const std::string& network_folder = "/sys/class/net");

/// The platforms of one of two hands: CAN interfaces, and people in software (`library` knows
/// them), which have both. `preset` (may be empty) stands first.
[[nodiscard]] std::vector<DeviceChoice> list_platforms(
    const std::string& preset, const std::vector<NamedDevice>& added, const std::string& library,
    const std::string& network_folder = "/sys/class/net");

/// replay://… of a file, with the characters escaped that a URI keeps for itself.
[[nodiscard]] std::string recording_uri(const std::string& path);

}  // namespace isograsp::gui
