// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/replay_device.hpp"

#include <utility>

#include "device/recording/recording.hpp"
#include "device/sensors/open_sensors.hpp"
#include "device/sensors/replay_clock.hpp"

namespace isograsp {

namespace {

class ReplayDevice final : public ForceDevice {
 public:
  ReplayDevice(Recording recording, double speed)
      : recording_(std::move(recording)), clock_(speed) {
    health_.state = DeviceState::configured;
  }

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return recording_.info; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return health_; }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_.start(clock);
    next_ = 0;
    health_ = DeviceHealth{};
    health_.state = DeviceState::streaming;
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    if (!clock_.runs()) return ReadStatus::finished;
    if (next_ == recording_.samples.size()) {
      health_.state = DeviceState::finished;
      return ReadStatus::finished;
    }
    const SensorSample& sample = recording_.samples[next_];
    const Timestamp stamp = clock_.at(sample.stamp);
    if (!clock_.wait_for(stamp, deadline)) return ReadStatus::timeout;

    out = sample;
    out.stamp = stamp;
    SensorCounters& counters = health_.sensors[index_of(sample.finger)];
    ++(out.valid ? counters.good : counters.invalid);
    ++next_;
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    return clock_.now(clock);
  }

  void stop() noexcept override {
    clock_.stop();
    health_.state = DeviceState::configured;
  }

 private:
  Recording recording_;
  ReplayClock clock_;
  DeviceHealth health_;
  std::size_t next_ = 0;  ///< sample
};

}  // namespace

Result<std::unique_ptr<ForceDevice>> open_replay_device(const Uri& uri) {
  if (auto known = uri.require_known({"speed", "protocol", "config", "rate"}); !known)
    return known.error();
  const auto speed = replay_speed(uri);
  if (!speed) return speed.error();
  const bool raw = uri.parameters.contains("protocol") || uri.parameters.contains("config");
  auto recording = [&]() -> Result<Recording> {
    if (!raw) return read_csv_recording(uri.target);
    const auto config = config_of(uri);
    if (!config) return config.error();
    return read_log_recording(uri.target, *config, uri.parameters.contains("config"));
  }();
  if (!recording) return recording.error();
  recording->info.uri = uri.text;
  recording->info.recorded = true;
  recording->info.units_per_count.fill(Vec6::Zero());
  recording->info.range.fill(Vec6::Zero());
  return std::unique_ptr<ForceDevice>(
      std::make_unique<ReplayDevice>(*std::move(recording), *speed));
}

}  // namespace isograsp
