// SPDX-License-Identifier: GPL-3.0-or-later
#include <span>
#include <utility>

#include "device/hand/hand_intake.hpp"
#include "device/hand/hand_schemes.hpp"
#include "hand/hands.hpp"

namespace isograsp {

namespace {

/// A tracker that sees the hand of a person in software, on whatever clock it is started.
class SimulatedHand final : public HandDevice {
 public:
  SimulatedHand(HandDeviceInfo info, std::optional<Hand> side, HandSource& person, double rate_Hz)
      : info_(std::move(info)), person_(person), rate_Hz_(rate_Hz), intake_(side) {}

  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] HandHealth health() const noexcept override {
    if (clock_ != nullptr) return intake_.reception().health(clock_->now());
    HandHealth health;
    health.state = DeviceState::configured;
    health.counters = intake_.reception().counters;
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    next_ = 0;
    rows_ = {};
    intake_.begin(start_, info_.period_s);
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    while (rows_.empty()) {
      const double t_s = static_cast<double>(next_) / rate_Hz_;
      const Timestamp stamp = start_ + from_seconds(t_s);
      if (stamp > deadline) {
        clock_->wait_until(deadline);
        return ReadStatus::timeout;
      }
      clock_->wait_until(stamp);
      seen_ = person_.at(t_s);
      rows_ = intake_.take(t_s, std::span(&seen_, 1), stamp);
      ++next_;
    }
    out = rows_.front();
    rows_ = rows_.subspan(1);
    return ReadStatus::sample;
  }

  void stop() noexcept override { clock_ = nullptr; }

 private:
  HandDeviceInfo info_;
  HandSource& person_;
  double rate_Hz_;
  HandIntake intake_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  std::int64_t next_ = 0;
  HandFrame seen_;
  std::span<const HandSample> rows_;
};

}  // namespace

Result<std::unique_ptr<HandDevice>> open_simulated_hand(const Uri& uri, std::optional<Hand> side,
                                                        HandSource* person) {
  if (auto known = uri.require_known({"user", "seed", "rate", "hand", "size"}); !known)
    return known.error();
  constexpr double kLeastRate_Hz = 20.0;  // of trackers
  constexpr double kMostRate_Hz = 200.0;
  const auto rate_Hz = uri.number_or("rate", 90.0, kLeastRate_Hz, kMostRate_Hz);
  if (!rate_Hz) return rate_Hz.error();
  if (person == nullptr)
    return refused("nobody moves the simulated hand"_text,
                   "open it in a session, which brings the simulated person"_text)
        .at(uri.text);
  HandDeviceInfo info;
  info.uri = uri.text;
  info.description = "Simulated hand tracker, %1"_text(uri.text_or("user", "healthy"));
  info.simulated = true;
  info.period_s = 1.0 / *rate_Hz;
  info.mounting = "desk";
  info.service = "simulated";
  info.provenance = {"simulated: " + uri.text};
  return std::unique_ptr<HandDevice>(
      std::make_unique<SimulatedHand>(std::move(info), side, *person, *rate_Hz));
}

}  // namespace isograsp
