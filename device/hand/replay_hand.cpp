// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "device/hand/hand_csv.hpp"
#include "device/hand/hand_intake.hpp"
#include "device/hand/hand_play.hpp"
#include "device/hand/hand_schemes.hpp"
#include "device/sensors/replay_clock.hpp"

namespace isograsp {

namespace {

class HandReplay final : public HandDevice {
 public:
  HandReplay(HandDeviceInfo info, std::optional<Hand> side, HandPlay play, double speed)
      : info_(std::move(info)), play_(std::move(play)), intake_(side), clock_(speed) {}

  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] HandHealth health() const noexcept override {
    if (clock_.runs() && !finished_) return intake_.reception().health(clock_.now());
    HandHealth health;
    health.state = finished_ ? DeviceState::finished : DeviceState::configured;
    health.counters = intake_.reception().counters;
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_.start(clock);
    next_ = 0;
    rows_ = {};
    finished_ = false;
    intake_.begin(clock_.at(Timestamp{0}), info_.period_s);
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    if (!clock_.runs()) return ReadStatus::finished;
    while (rows_.empty()) {
      if (next_ == play_.shots.size()) {
        finished_ = true;
        return ReadStatus::finished;
      }
      const HandShot& shot = play_.shots[next_];
      const Timestamp stamp = clock_.at(from_seconds(shot.t_s));
      if (!clock_.wait_for(stamp, deadline)) return ReadStatus::timeout;
      rows_ = intake_.take(shot.t_s, play_.hands_of(shot), stamp);
      ++next_;
    }
    out = rows_.front();
    rows_ = rows_.subspan(1);
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    return clock_.now(clock);
  }
  void stop() noexcept override { clock_.stop(); }

 private:
  HandDeviceInfo info_;
  HandPlay play_;
  HandIntake intake_;
  ReplayClock clock_;
  std::size_t next_ = 0;  ///< shot
  std::span<const HandSample> rows_;
  bool finished_ = false;
};

}  // namespace

Result<std::unique_ptr<HandDevice>> open_hand_replay(const Uri& uri, std::optional<Hand> side) {
  if (auto known = uri.require_known({"speed", "hand", "size"}); !known) return known.error();
  const auto speed = replay_speed(uri);
  if (!speed) return speed.error();
  auto play = HandPlay::read(uri.target);
  if (!play) return play.error();
  HandDeviceInfo info;
  info.uri = uri.text;
  info.description = "Recorded hands, %1"_text(uri.target);
  info.recorded = true;
  info.period_s = play->period_s;
  info.provenance = {"recorded hands"};
  return std::unique_ptr<HandDevice>(
      std::make_unique<HandReplay>(std::move(info), side, *std::move(play), *speed));
}

}  // namespace isograsp
