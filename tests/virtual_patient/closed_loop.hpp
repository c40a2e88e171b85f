// SPDX-License-Identifier: GPL-3.0-or-later
// The person, the sensors and the screen in a loop, without a session: 100 frames a second.
#pragma once

#include <algorithm>
#include <array>

#include "device/simulated/sensor_model.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::test {

inline constexpr double kFrame_s = 0.01;

/// Presses the sensors at 1 kHz and hands over a frame every 10 ms, late and quantised as they are.
class SensedPatient {
 public:
  SensedPatient(const virtual_patient::PatientTraits& traits, std::uint64_t seed)
      : patient(traits, seed) {}

  FingerWrenches next_frame() noexcept {
    const int last_ms = 10 * frame_++;
    for (; ms_ <= last_ms; ++ms_) {
      pressed = patient.press(0.001 * ms_);
      for (std::size_t f = 0; f < kFingerCount; ++f) sensors_[f].step(pressed[f]);
    }
    FingerWrenches wrench_C;
    for (std::size_t f = 0; f < kFingerCount; ++f) wrench_C[f] = sensors_[f].read().wrench_C;
    return wrench_C;
  }
  /// Time of the frame handed over last [s].
  [[nodiscard]] double t_s() const noexcept { return kFrame_s * (frame_ - 1); }

  virtual_patient::VirtualPatient patient;
  FingerWrenches pressed;  ///< by the fingertips, at t_s()

 private:
  std::array<SensorModel, kFingerCount> sensors_{SensorModel(1, 0), SensorModel(1, 1),
                                                 SensorModel(1, 2)};
  int frame_ = 0;
  int ms_ = 0;
};

/// Grip on the screen: the smaller of the thumb and the two fingers together [N].
inline double grip_N(const FingerWrenches& wrench_C) noexcept {
  return std::min(wrench_C[0].force.z(), wrench_C[1].force.z() + wrench_C[2].force.z());
}

}  // namespace isograsp::test
