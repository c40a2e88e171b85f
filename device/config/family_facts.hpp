// SPDX-License-Identifier: GPL-3.0-or-later
// What is special about a family of sensors: one FamilyFacts each, made in
// device/family/<family>_family.cpp and listed in device/family/families.cpp. Everything that is
// not said here is the same for all families. Nothing here is called between the arrival of a frame
// and the published state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"

namespace isograsp {

class Bus;
class EmulatedSensor;
class LogDecoder;
class SensorSession;
class TomlReader;
struct DecodedSample;
struct DeviceConfig;
struct LogReport;
struct SensorConfig;
struct Uri;

/// Identifiers on CAN.
struct CanIds {
  std::vector<std::uint32_t> sent;   ///< by the sensors
  std::vector<std::uint32_t> heard;  ///< by the sensors: commands to them
};

/// A kind of bus that a family speaks over.
struct FamilyBus {
  std::string_view scheme;  ///< of the device URI: "can"
  /// Opens it for three sensors. Errors name interface, address or card. Not real-time safe.
  Result<std::unique_ptr<Bus>> (*open)(const Uri& uri, const DeviceConfig& config) = nullptr;
  // For people who look for what can be connected; empty: not listed.
  std::string_view devices;  ///< "three ATI Net F/T boxes"
  std::string_view needs;    ///< "a network to the boxes, their web page reachable"
};

/// @pre everywhere: the configuration is one of this family
struct FamilyFacts {
  std::string_view name;   ///< in device files and URIs: "rft"
  std::string_view title;  ///< for people: "Robotous RFT"
  std::span<const FamilyBus> buses;

  // The configuration (docs/devices.md).
  /// Low-pass in the sensors that is used if none is named [Hz]; 0: none.
  double filter_Hz = 0.0;
  /// A sensor as its maker or this program recommends it: `connection` and `range`.
  SensorConfig (*standard)(std::size_t finger) = nullptr;
  /// Reads the keys that hold for all three sensors; nullptr: there are none.
  void (*read_device)(TomlReader& root, DeviceConfig& config) = nullptr;
  /// Reads the keys of one sensor that other families do not have.
  void (*read_sensor)(TomlReader& keys, SensorConfig& sensor) = nullptr;
  /// Identifiers or addresses of a sensor: no other one may have them.
  std::vector<std::string> (*identities)(const SensorConfig& sensor) = nullptr;
  /// How a sensor is reached, for people: "node 1".
  std::string (*place)(const SensorConfig& sensor) = nullptr;
  /// Whether the sensors can be set to this rate or filter. Default: 10 to 1000 Hz, no filter.
  bool (*has_rate)(double rate_Hz) = [](double rate_Hz) {
    return rate_Hz >= 10.0 && rate_Hz <= 1000.0;
  };
  bool (*has_filter)(double cutoff_Hz) = [](double cutoff_Hz) { return cutoff_Hz == 0.0; };

  // Where the sensors are on their bus; nullptr: on none of this kind.
  void (*add_can_ids)(const SensorConfig& sensor, CanIds& ids) = nullptr;
  /// "HOST:PORT"; empty: not known.
  std::string (*udp_address)(const SensorConfig& sensor) = nullptr;
  /// Sets the address of the sensor from a device URI.
  void (*set_address)(SensorConfig& sensor, const std::string& address) = nullptr;

  // The conversation.
  /// @pre rate and filter of the configuration exist
  std::unique_ptr<SensorSession> (*make_session)(const DeviceConfig& config,
                                                 std::size_t finger) = nullptr;
  /// The same, after asking the sensor for what its frames do not contain; nullptr: nothing to ask.
  Result<std::unique_ptr<SensorSession>> (*ask_session)(const DeviceConfig& config,
                                                        std::size_t finger) = nullptr;

  // Emulated sensors and logs of raw frames; all nullptr for a card in this computer: it has no
  // wire.
  std::unique_ptr<EmulatedSensor> (*make_emulated)(std::size_t finger,
                                                   const DeviceConfig& config) = nullptr;
  /// Opens a bus of three emulated sensors at the address `on`; `uri` becomes the device URI that
  /// connects to them. nullptr: they are emulated on a CAN bus.
  Result<std::unique_ptr<Bus>> (*open_emulated)(const std::string& on, const DeviceConfig& config,
                                                std::string& uri) = nullptr;
  /// Of a log of CAN frames (candump).
  std::unique_ptr<LogDecoder> (*make_log_decoder)(const DeviceConfig& config) = nullptr;
  /// read_log() of a log that is no candump; nullptr: there is a decoder.
  Result<LogReport> (*read_log)(
      const std::string& path, const DeviceConfig& config, bool addresses_known,
      const std::function<void(const std::string&, Timestamp, const DecodedSample&)>& take) =
      nullptr;

  // What to do about a rate or filter that the sensors do not have.
  Words rate_remedy = "use 10 to 1000"_text;
  Words filter_remedy = "leave filter_Hz out"_text;

  /// Its sensors can be emulated and their frames logged.
  [[nodiscard]] constexpr bool on_wire() const noexcept { return make_emulated != nullptr; }
};

/// The table: every family that this program knows.
[[nodiscard]] std::span<const FamilyFacts* const> all_families() noexcept;
/// nullptr: no family has this name.
[[nodiscard]] const FamilyFacts* family_named(std::string_view name) noexcept;
/// Of those on a wire: "rft, ati-netcanoem, jr3-can or net-ft".
[[nodiscard]] std::string family_names();
/// The same in words.
[[nodiscard]] Text any_family();

}  // namespace isograsp
