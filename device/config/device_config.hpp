// SPDX-License-Identifier: GPL-3.0-or-later
// Which sensor sits under which finger, how it is reached, set and mounted: files of format
// "isograsp-device-1" (docs/devices.md). Frames: S sensor, C contact of the finger, P platform.
// SI units.
#pragma once

#include <any>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "device/config/platform.hpp"
#include "hand/finger.hpp"

namespace isograsp {

using Mat6 = Eigen::Matrix<double, 6, 6>;

struct FamilyFacts;

/// How a sensor is mounted. The default is the half turn about the sensor's x axis: a sensor that
/// is positive in tension has a negative Fz when a finger presses, and that is +z of C.
struct Mounting {
  Quat q_CS = Quat(0.0, 1.0, 0.0, 0.0);  ///< turns S components into C components
  Vec3 p_SC_S = Vec3::Zero();            ///< contact point, measured from the sensor's origin [m]
  double sign = 1.0;  ///< -1: the sensor gives the force on the finger, not the force on itself

  /// The wrench about the contact point, in C: f_C = s R f_S, tau_C = s R (tau_S - p x f_S). Exact
  /// inverse of to_sensor().
  [[nodiscard]] Wrench to_contact(const Wrench& wrench_S) const noexcept;
  [[nodiscard]] Wrench to_sensor(const Wrench& wrench_C) const noexcept;
};

/// A correction measured by the clinic: the true wrench is matrix times the sensor's own.
struct ClinicCalibration {
  std::string file;
  std::string serial_number;  ///< of the sensor that it was measured with
  std::string date;
  Mat6 matrix = Mat6::Identity();  ///< Fx Fy Fz [N], Tx Ty Tz [N m]; sensor frame

  /// Format "isograsp-calibration-1" (docs/devices.md). Errors name file, line and key.
  [[nodiscard]] static Result<ClinicCalibration> read(const std::string& path);
};

struct SensorConfig {
  std::any
      connection;  ///< how it is reached and set: RftSensor, AtiSensor, …, as its family has it
  std::string serial_number;                                   ///< empty: any sensor is accepted
  Vec6 range = (Vec6() << 150, 150, 200, 4, 4, 4).finished();  ///< rating [N, N m], sensor axes
  std::optional<ClinicCalibration> calibration;
  Mounting mounting;

  /// @pre the family of the sensor has this type
  template <class Connection>
  [[nodiscard]] const Connection& as() const {
    return std::any_cast<const Connection&>(connection);
  }
  template <class Connection>
  [[nodiscard]] Connection& as() {
    return std::any_cast<Connection&>(connection);
  }
  /// By the clinic's calibration, if there is one; sensor frame. Real-time safe.
  [[nodiscard]] Wrench corrected(const Wrench& wrench_S) const noexcept;
};

struct DeviceConfig {
  const FamilyFacts* family = nullptr;  ///< of the three sensors; never null if made below
  std::string name;
  std::string interface;     ///< "can0"; a URI goes before it
  std::optional<Hand> hand;  ///< the platform serves this hand only
  double rate_Hz = 100.0;    ///< of each sensor
  double filter_Hz = 30.0;   ///< low-pass in the sensor; 0: none
  int fir_taps = 0;          ///< of the low-pass on this computer, odd; 0: none
  double fir_cutoff_Hz = 31.25;
  std::array<SensorConfig, kFingerCount> sensors;
  Platform platform;

  /// Addresses as the makers or this program recommend them, any serial number, mounted the default
  /// way.
  [[nodiscard]] static DeviceConfig standard(const FamilyFacts& family);
  /// Calibration files are looked for beside `file`. Errors name file, line and key.
  [[nodiscard]] static Result<DeviceConfig> parse(std::string_view text, const std::string& file);
  [[nodiscard]] static Result<DeviceConfig> read(const std::string& path);
};

}  // namespace isograsp
