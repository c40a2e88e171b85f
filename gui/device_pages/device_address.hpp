// SPDX-License-Identifier: GPL-3.0-or-later
// From what people know of a device (its kind, where it is plugged in) to its address, and what
// could be asked where they do not know it. No widgets.
#pragma once

#include <QString>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isograsp::gui {

/// How it is reached.
enum class DeviceKind : std::uint8_t {
  can,       ///< three sensors on a CAN bus
  network,   ///< three boxes in the network
  serial,    ///< three serial lines
  qualisys,  ///< cameras: Qualisys Track Manager
  motive,    ///< cameras: OptiTrack Motive
  leap,      ///< a tracked hand: Leap service
  script     ///< a tracked hand: a program that sends datagrams
};
inline constexpr std::array kDeviceKinds{
    DeviceKind::can,    DeviceKind::network, DeviceKind::serial, DeviceKind::qualisys,
    DeviceKind::motive, DeviceKind::leap,    DeviceKind::script};
[[nodiscard]] QString words_of(DeviceKind kind);
[[nodiscard]] bool is_force(DeviceKind kind) noexcept;
[[nodiscard]] bool is_cameras(DeviceKind kind) noexcept;

/// A family of sensors that can be reached so.
struct FamilyChoice {
  std::string name;   ///< "rft"
  std::string title;  ///< "Robotous RFT"
};
[[nodiscard]] std::vector<FamilyChoice> families_of(DeviceKind kind);

/// What somebody has filled in.
struct DeviceDraft {
  DeviceKind kind = DeviceKind::can;
  std::string family;  ///< of force sensors
  /// Interface, address, or three of them with commas; of boxes the first of three in a row does.
  std::string where;
  std::string setup;  ///< file that says how force sensors are mounted and set; empty: as delivered
  std::string rig;    ///< of cameras
};
/// The device URI; empty: something is missing.
[[nodiscard]] std::string uri_of(const DeviceDraft& draft);

/// What this computer has.
struct Surroundings {
  std::vector<std::string> can;           ///< interfaces
  std::vector<std::string> serial_ports;  ///< by what is plugged in, else by number
};
[[nodiscard]] Surroundings look_around(const std::string& network_folder = "/sys/class/net",
                                       const std::string& device_folder = "/dev");

/// The rigs that the library describes, by name.
[[nodiscard]] std::vector<std::string> rigs_in(const std::string& library);
/// TOML files of a folder, in alphabetical order; none where it cannot be read.
[[nodiscard]] std::vector<std::string> toml_files_in(const std::string& folder);

/// What is asked to find a device of that kind, each complete: every interface and family, what
/// stands at the address, or on this computer where none was given.
[[nodiscard]] std::vector<DeviceDraft> candidates(const DeviceDraft& draft,
                                                  const Surroundings& here);

/// With the characters escaped that a URI keeps for itself.
[[nodiscard]] std::string escaped_for_uri(const std::string& text);

}  // namespace isograsp::gui
