// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/simulated/sim_device.hpp"

#include <cmath>

#include "device/simulated/sensor_model.hpp"

namespace isograsp {

namespace {

constexpr std::uint64_t kDropStream = 16;  ///< apart from the streams of the sensors
constexpr std::int64_t kModelPeriod_ns = 1'000'000;

class SimDevice final : public ForceDevice {
 public:
  SimDevice(DeviceInfo info, FingerSource& source, std::uint64_t seed, double drop)
      : info_(std::move(info)), source_(source), seed_(seed), drop_(drop) {
    reset();
  }

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return health_; }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    reset();
    clock_ = &clock;
    start_ = clock.now();
    health_.state = DeviceState::streaming;
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    if (next_finger_ == 0) {
      const std::int64_t since_start_ns =
          std::llround(static_cast<double>(sample_) * info_.sample_period_s * 1e9);
      stamp_ = start_ + Timestamp{since_start_ns};
      if (stamp_ > deadline) {
        clock_->wait_until(deadline);
        return ReadStatus::timeout;
      }
      clock_->wait_until(stamp_);
      press_until(since_start_ns);
      ++sample_;
    }
    out = measure(next_finger_);
    next_finger_ = (next_finger_ + 1) % kFingerCount;
    return ReadStatus::sample;
  }

  void stop() noexcept override {
    clock_ = nullptr;
    health_.state = DeviceState::configured;
  }

 private:
  void reset() {
    for (std::size_t f = 0; f < kFingerCount; ++f)
      sensors_[f] = SensorModel(seed_, f, info_.units_per_count[f]);
    dropping_ = Random(seed_, kDropStream);
    health_ = DeviceHealth{};
    health_.state = DeviceState::configured;
    model_steps_ = 0;
    sample_ = 0;
    next_finger_ = 0;
  }

  void press_until(std::int64_t since_start_ns) noexcept {
    for (; model_steps_ * kModelPeriod_ns <= since_start_ns; ++model_steps_) {
      const double t_s = static_cast<double>(model_steps_) / kSensorModelRate_Hz;
      const FingerWrenches wrench_C = source_.press(t_s);
      for (std::size_t f = 0; f < kFingerCount; ++f) sensors_[f].step(wrench_C[f]);
    }
  }

  [[nodiscard]] SensorSample measure(std::size_t f) noexcept {
    const auto reading = sensors_[f].read();
    SensorSample sample;
    sample.finger = kFingers[f];
    sample.stamp = stamp_;
    sample.valid = dropping_.uniform() >= drop_;
    SensorCounters& counters = health_.sensors[f];
    if (!sample.valid) {
      ++counters.invalid;
      return sample;
    }
    ++counters.good;
    if (reading.flags != 0) ++counters.saturated;
    sample.wrench_C = reading.wrench_C;
    sample.raw_counts = reading.raw_counts;
    sample.flags = reading.flags;
    return sample;
  }

  DeviceInfo info_;
  FingerSource& source_;
  std::uint64_t seed_;
  double drop_;
  std::array<SensorModel, kFingerCount> sensors_{SensorModel(0), SensorModel(0), SensorModel(0)};
  Random dropping_{0};
  DeviceHealth health_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  Timestamp stamp_{0};
  std::int64_t model_steps_ = 0;
  std::int64_t sample_ = 0;
  std::size_t next_finger_ = 0;
};

}  // namespace

Result<std::unique_ptr<ForceDevice>> open_sim_device(const Uri& uri, const DeviceOptions& options) {
  // A pair of hands is described by a file, a person by the parameters.
  const bool pair = uri.target == "pair";
  if (auto known = pair ? uri.require_known({"file", "hand", "seed", "rate", "drop", "resolution"})
                        : uri.require_known({"seed", "hand", "rate", "drop", "recovery", "day",
                                             "course", "strength", "resolution"});
      !known)
    return known.error();
  if (uri.target.empty())
    return refused("no patient is named"_text, "write sim://healthy or sim://paretic"_text)
        .at(uri.text)
        .about("patient");
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every whole number below is exact
  const auto seed = uri.number_or("seed", 1.0, 0.0, kLargestSeed);
  if (!seed) return seed.error();
  if (*seed != std::floor(*seed))
    return refused("is not a whole number"_text, "write a whole number such as seed=7"_text)
        .at(uri.text)
        .about("seed");
  const std::string hand = uri.text_or("hand", "right");
  if (!hand_from_name(hand))
    return refused("'%1' is not a hand"_text(hand), "write hand=right or hand=left"_text)
        .at(uri.text)
        .about("hand");
  const auto rate_Hz = uri.number_or("rate", 100.0, 50.0, 1000.0);
  if (!rate_Hz) return rate_Hz.error();
  const auto drop = uri.number_or("drop", 0.0, 0.0, 1.0);
  if (!drop) return drop.error();
  const auto step_N = uri.number_or("resolution", kSensorStep_N, 1e-4, 1.0);
  if (!step_N) return step_N.error();
  if (options.source == nullptr)
    return refused("nobody presses the simulated device"_text,
                   "open it in a session, which brings the simulated patient"_text)
        .at(uri.text);

  DeviceInfo info;
  info.uri = uri.text;
  info.description = "Simulated sensors, %1 patient"_text(uri.target);
  info.simulated = true;
  info.on_grid = true;
  info.sample_period_s = 1.0 / *rate_Hz;
  info.frame_period_s = info.sample_period_s;
  info.delay_s = kSensorDelay_s;
  info.serial_numbers = {"SIM-THUMB", "SIM-INDEX", "SIM-MIDDLE"};
  info.units_per_count.fill(sensor_resolution(*step_N));
  info.range.fill(sensor_range());
  info.provenance = {"simulated: " + uri.text};
  // The sensors under both hands of a pair are not the same ones.
  auto noise_seed = static_cast<std::uint64_t>(*seed);
  if (pair) noise_seed = 2 * noise_seed + (hand == "left" ? 0 : 1);
  return std::unique_ptr<ForceDevice>(
      std::make_unique<SimDevice>(std::move(info), *options.source, noise_seed, *drop));
}

}  // namespace isograsp
