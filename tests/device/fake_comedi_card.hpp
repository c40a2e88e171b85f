// SPDX-License-Identifier: GPL-3.0-or-later
// A JR3 PCI card made of memory: what the driver jr3_pci would show of three sensors.
#pragma once

#include <array>
#include <functional>

#include "device/comedi/comedi_card.hpp"
#include "hand/finger.hpp"

namespace isograsp::test {

/// Outlives the card that shows it.
struct FakeJr3 {
  struct Sensor {
    std::uint32_t serial = 0;
    Vec6 full_scale = (Vec6() << 150, 150, 300, 8, 8, 8).finished();  ///< [N, N m]
    ComediCard::Reading state = ComediCard::Reading::good;
    std::array<std::uint32_t, 64> samples{};  ///< by channel
  };
  std::array<Sensor, kFingerCount> sensors;
  unsigned channels = 58;
  std::uint32_t highest = 0x7FFF;
  bool present = true;
  std::uint64_t reads = 0;
  std::uint64_t opened = 1;
  std::function<void(unsigned subdevice, unsigned channel)> before_read;
};

class FakeComediCard final : public ComediCard {
 public:
  explicit FakeComediCard(FakeJr3& hardware) : hardware_(hardware) { remember_ranges(); }

  Reading read(unsigned subdevice, unsigned channel, std::uint32_t& sample) noexcept override {
    if (!hardware_.present) return Reading::failed;
    if (hardware_.before_read) hardware_.before_read(subdevice, channel);
    ++hardware_.reads;
    const auto& sensor = hardware_.sensors[subdevice];
    if (sensor.state != Reading::good) return sensor.state;
    sample = channel == 57 ? sensor.serial : sensor.samples[channel];
    return Reading::good;
  }
  unsigned subdevices() noexcept override { return kFingerCount; }
  unsigned channels(unsigned) noexcept override { return hardware_.channels; }
  std::uint32_t highest_sample(unsigned, unsigned) noexcept override { return hardware_.highest; }
  /// Forces in kN, moments in kN m, as they were when the card was opened.
  std::optional<Range> range(unsigned subdevice, unsigned channel) noexcept override {
    const double most = full_scale_[subdevice][static_cast<Eigen::Index>(channel % 8)] / 1000.0;
    return Range{-most, most};
  }
  bool reopen() noexcept override {
    ++hardware_.opened;
    remember_ranges();
    return hardware_.present;
  }

 private:
  void remember_ranges() noexcept {
    for (std::size_t f = 0; f < kFingerCount; ++f) full_scale_[f] = hardware_.sensors[f].full_scale;
  }
  FakeJr3& hardware_;
  std::array<Vec6, kFingerCount> full_scale_;
};

}  // namespace isograsp::test
