// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "core/random.hpp"
#include "device/cameras/marker_schemes.hpp"
#include "device/cameras/picture_watch.hpp"
#include "hand/hands.hpp"

namespace isograsp {

namespace {

constexpr std::uint64_t kLostPictureStream =
    17;  ///< apart from what draws on the same seed elsewhere

class SimulatedMarkers final : public MarkerDevice {
 public:
  SimulatedMarkers(MarkerDeviceInfo info, MarkerSource& source, double rate_Hz, std::uint64_t seed,
                   double drop)
      : info_(std::move(info)),
        source_(source),
        rate_Hz_(rate_Hz),
        seed_(seed),
        drop_(drop),
        p_W_(info_.labels.size()) {}

  [[nodiscard]] const MarkerDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] MarkerHealth health() const noexcept override {
    MarkerHealth health;
    health.counters = counters_;
    health.state = DeviceState::configured;
    if (clock_ != nullptr) PictureWatch::set(health, watch_.fault(clock_->now()));
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    dropping_ = Random(seed_, kLostPictureStream);
    counters_ = {};
    next_ = 0;
    lost_ = 0;
    watch_.begin(start_, info_.period_s);
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    while (true) {
      const double t_s = static_cast<double>(next_) / rate_Hz_;
      const Timestamp stamp = start_ + from_seconds(t_s);
      if (stamp > deadline) {
        clock_->wait_until(deadline);
        return ReadStatus::timeout;
      }
      clock_->wait_until(stamp);
      source_.markers(t_s, p_W_);
      const std::int64_t number = next_++;
      if (dropping_.uniform() < drop_) {
        ++lost_;
        continue;
      }
      ++counters_.good;
      counters_.lost += lost_;
      watch_.picture(stamp, std::exchange(lost_, 0));
      out = {stamp, number, p_W_};
      return ReadStatus::sample;
    }
  }

  void stop() noexcept override { clock_ = nullptr; }

 private:
  MarkerDeviceInfo info_;
  MarkerSource& source_;
  double rate_Hz_;
  std::uint64_t seed_;
  double drop_;
  std::vector<Vec3> p_W_;
  Random dropping_{0};
  PictureWatch watch_;
  MarkerCounters counters_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  std::int64_t next_ = 0;
  std::uint64_t lost_ = 0;  ///< since the last picture
};

}  // namespace

Result<std::unique_ptr<MarkerDevice>> open_simulated_markers(const Uri& uri, MarkerSource* source) {
  if (auto known =
          uri.require_known({"patient", "seed", "rate", "rig", "hand", "drop", "recovery", "day"});
      !known)
    return known.error();
  if (uri.target != "arm")
    return refused("'%1' is nothing that cameras could see"_text(uri.target),
                   "write sim://arm?patient=healthy"_text)
        .at(uri.text);
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
  const auto rate_Hz = uri.number_or("rate", 100.0, 50.0, 500.0);
  if (!rate_Hz) return rate_Hz.error();
  const auto drop = uri.number_or("drop", 0.0, 0.0, 1.0);
  if (!drop) return drop.error();
  if (source == nullptr)
    return refused("nobody moves the simulated arm"_text,
                   "open it in a session, which brings the simulated patient"_text)
        .at(uri.text);

  MarkerDeviceInfo info;
  info.uri = uri.text;
  info.description = "Simulated cameras, %1 patient"_text(uri.text_or("patient", "healthy"));
  info.simulated = true;
  info.period_s = 1.0 / *rate_Hz;
  const auto labels = source->labels();
  info.labels.assign(labels.begin(), labels.end());
  info.provenance = {"simulated: " + uri.text};
  return std::unique_ptr<MarkerDevice>(std::make_unique<SimulatedMarkers>(
      std::move(info), *source, *rate_Hz, static_cast<std::uint64_t>(*seed), *drop));
}

}  // namespace isograsp
