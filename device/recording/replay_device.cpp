// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/replay_device.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "device/recording/recording.hpp"
#include "device/sensors/open_sensors.hpp"

namespace isograsp {

namespace {

class ReplayDevice final : public ForceDevice {
 public:
  ReplayDevice(Recording recording, double speed)
      : recording_(std::move(recording)), speed_(speed) {
    health_.state = DeviceState::configured;
  }

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return recording_.info; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return health_; }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    reached_ = start_;
    next_ = 0;
    health_ = DeviceHealth{};
    health_.state = DeviceState::streaming;
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    if (next_ == recording_.samples.size()) {
      health_.state = DeviceState::finished;
      return ReadStatus::finished;
    }
    const SensorSample& sample = recording_.samples[next_];
    const Timestamp stamp = start_ + sample.stamp;
    wait_until(std::min(stamp, deadline));
    if (stamp > deadline) return ReadStatus::timeout;

    out = sample;
    out.stamp = stamp;
    SensorCounters& counters = health_.sensors[index_of(sample.finger)];
    ++(out.valid ? counters.good : counters.invalid);
    ++next_;
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    if (speed_ == 0.0) return reached_;
    return start_ + scaled(clock.now() - start_, speed_);
  }

  void stop() noexcept override {
    clock_ = nullptr;
    health_.state = DeviceState::configured;
  }

 private:
  /// Exact at speed 1.
  [[nodiscard]] static Timestamp scaled(Timestamp span, double factor) noexcept {
    if (factor == 1.0) return span;
    return Timestamp{std::llround(static_cast<double>(span.count()) * factor)};
  }

  /// Waits for recorded time `t`.
  void wait_until(Timestamp t) noexcept {
    reached_ = std::max(reached_, t);
    if (speed_ > 0.0) clock_->wait_until(start_ + scaled(t - start_, 1.0 / speed_));
  }

  Recording recording_;
  double speed_;
  DeviceHealth health_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  Timestamp reached_{0};  ///< recorded time that was waited for
  std::size_t next_ = 0;  ///< sample
};

}  // namespace

Result<std::unique_ptr<ForceDevice>> open_replay_device(const Uri& uri) {
  if (auto known = uri.require_known({"speed", "protocol", "config", "rate"}); !known)
    return known.error();
  if (uri.target.empty())
    return refused("no file is named"_text, "write replay://FILE.csv"_text)
        .at(uri.text)
        .about("file");
  auto speed = uri.number_or("speed", 1.0, 0.0, 1000.0);
  if (!speed) return speed.error();
  if (*speed > 0.0 && *speed < 0.01)
    return refused("is too slow"_text, "give 0 (never wait) or 0.01 to 1000"_text)
        .at(uri.text)
        .about("speed");
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
