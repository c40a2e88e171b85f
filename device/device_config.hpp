// SPDX-License-Identifier: GPL-3.0-or-later
// Which sensor sits under which finger and how it is mounted: files of format "isograsp-device-1"
// (docs/devices.md). Frames: S sensor, C contact of the finger. SI units.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/finger.hpp"
#include "core/result.hpp"
#include "core/spatial.hpp"
#include "device/rft_codec.hpp"

namespace isograsp {

/// How a sensor is mounted. The default is the half turn about the sensor's x axis: an RFT sensor
/// is positive in tension, so a finger that presses (negative Fz) presses along +z of C.
struct Mounting {
  Quat q_CS = Quat(0.0, 1.0, 0.0, 0.0);  ///< turns S components into C components
  Vec3 p_SC_S = Vec3::Zero();            ///< contact point, measured from the sensor's origin [m]

  /// The wrench about the contact point, in C: f_C = R f_S, tau_C = R (tau_S - p x f_S). Exact
  /// inverse of to_sensor().
  [[nodiscard]] Wrench to_contact(const Wrench& wrench_S) const noexcept;
  [[nodiscard]] Wrench to_sensor(const Wrench& wrench_C) const noexcept;
};

struct RftSensorConfig {
  RftIds ids;
  std::string serial_number;  ///< empty: any sensor is accepted
  RftDivisors divisors;
  Vec6 range = (Vec6() << 150, 150, 200, 4, 4, 4).finished();  ///< rating [N, N m], sensor axes
  Mounting mounting;
};

struct RftConfig {
  double filter_Hz = 30.0;  ///< low-pass in the sensor; 0: none
  RftFilterTable filter_table = RftFilterTable::manual;
  std::array<RftSensorConfig, kFingerCount> sensors;

  /// Sensors with the identifiers of kRftIds, any serial number, mounted the default way.
  [[nodiscard]] static RftConfig standard();
  /// Errors name file, line and key.
  [[nodiscard]] static Result<RftConfig> parse(std::string_view text, const std::string& file);
  [[nodiscard]] static Result<RftConfig> read(const std::string& path);
};

}  // namespace isograsp
