// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/emulated_net_ft.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "device/codec/net_ft_codec.hpp"

namespace isograsp {

namespace {

constexpr double kInside_Hz = 7000.0;
constexpr std::uint32_t kOnSince = 60 * 7000;  // measurements before the emulator began
constexpr std::uint32_t kBootTime = 7;         // measurements at the first start after a power dip
constexpr double kGagesEnd = 1.2;              // of the rating
constexpr std::uint32_t kSaturated = 0x80020000;

class EmulatedNetFt final : public EmulatedSensor {
 public:
  EmulatedNetFt(std::size_t finger, const DeviceConfig& config)
      : EmulatedSensor(finger),
        range_(config.sensors[finger].range),
        inside_per_record_(static_cast<std::uint32_t>(
            std::clamp(std::llround(kInside_Hz / config.rate_Hz), 1LL, 7000LL))) {}

  void receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) override {
    if (frame.id != finger() || !frame.is_standard()) return;
    const auto request = decode_net_ft_request(frame.bytes());
    if (!request) return;
    switch (request->command) {
      case NetFtCommand::stop: return halt(now);
      case NetFtCommand::start: return start(request->samples, now, world);
      case NetFtCommand::start_buffered:  // one record in a datagram is all this box can
      case NetFtCommand::reset_latch:
      case NetFtCommand::set_bias: return;
    }
  }
  [[nodiscard]] Timestamp next_measurement() const override {
    if (!streaming_) return Timestamp::max();
    return started_ + from_seconds((static_cast<double>(measured_) + phase_) * period_s() * clock_);
  }
  void measure(EmulatorWorld& world) override {
    const Timestamp when = next_measurement();
    const BusFrame frame = record(static_cast<double>(measured_) * period_s(), world);
    world.send_sample(finger(), when, {&frame, 1});
    ++measured_;
    if (left_ > 0 && --left_ == 0) halt(when);
  }
  /// The box measures from the beginning again and waits for a start.
  void power_dip(Timestamp now, EmulatorWorld&) override {
    streaming_ = false;
    inside_ = kBootTime;
    inside_since_ = now;
  }
  [[nodiscard]] Timestamp play_start() const override { return first_start_; }

 private:
  [[nodiscard]] double period_s() const noexcept { return inside_per_record_ / kInside_Hz; }

  /// The box goes on measuring inside, also while it sends nothing.
  void pass_time(Timestamp now) noexcept {
    const double passed_s = std::max(0.0, to_seconds(now - inside_since_) / clock_);
    inside_ += static_cast<std::uint32_t>(std::llround(passed_s * kInside_Hz));
    inside_since_ = now;
  }
  void halt(Timestamp now) noexcept {
    if (streaming_) inside_since_ = now;
    streaming_ = false;
  }
  void start(std::uint32_t samples, Timestamp now, EmulatorWorld& world) {
    if (inside_since_ == Timestamp::min()) inside_since_ = now;
    clock_ = world.clock_factor(finger());
    phase_ = world.phase(finger());
    if (!streaming_) pass_time(now);
    sent_ = 0;
    if (samples == 1) {  // an answer to a question, no stream
      streaming_ = false;
      const BusFrame frame = record(0.0, world);
      inside_since_ = now;
      return world.send_answer(finger(), now, {&frame, 1});
    }
    streaming_ = true;
    started_ = now;
    measured_ = 0;
    left_ = samples;
    first_start_ = std::min(first_start_, now);
  }
  [[nodiscard]] BusFrame record(double own_s, EmulatorWorld& world) {
    const Wrench wrench_S = world.feel(finger(), own_s);
    const NetFtScale scale;
    NetFtRecord out;
    out.rdt_sequence = ++sent_;
    out.ft_sequence = inside_ += inside_per_record_;
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const auto i = static_cast<int>(axis % 3);
      const double value = axis < 3 ? wrench_S.force[i] : wrench_S.torque[i];
      const double per_unit = axis < 3 ? scale.counts_per_unit_force : scale.counts_per_unit_torque;
      const std::int64_t count = std::llround(value * per_unit) + world.noise_counts();
      out.raw[axis] =
          static_cast<std::int32_t>(std::clamp<std::int64_t>(count, INT32_MIN, INT32_MAX));
      if (std::abs(value) > kGagesEnd * range_[static_cast<int>(axis)]) out.status = kSaturated;
    }
    return encode_net_ft_record(static_cast<std::uint32_t>(finger()), out);
  }

  Vec6 range_;
  std::uint32_t inside_per_record_;
  bool streaming_ = false;
  std::uint32_t left_ = 0;  ///< records of a stream with an end; 0: without
  std::uint32_t sent_ = 0;
  std::uint32_t inside_ = kOnSince;
  Timestamp inside_since_ = Timestamp::min();  ///< when inside_ was right
  double clock_ = 1.0;
  double phase_ = 0.5;
  Timestamp started_{0};
  Timestamp first_start_ = Timestamp::max();
  std::int64_t measured_ = 0;
};

}  // namespace

std::unique_ptr<EmulatedSensor> make_emulated_net_ft(std::size_t finger,
                                                     const DeviceConfig& config) {
  return std::make_unique<EmulatedNetFt>(finger, config);
}

}  // namespace isograsp
