// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "device/hand/hand_csv.hpp"
#include "device/hand/hand_intake.hpp"
#include "device/hand/hand_play.hpp"
#include "device/hand/hand_schemes.hpp"

namespace isograsp {

namespace {

class HandReplay final : public HandDevice {
 public:
  HandReplay(HandDeviceInfo info, std::optional<Hand> side, HandPlay play, double speed)
      : info_(std::move(info)), play_(std::move(play)), intake_(side), speed_(speed) {}

  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] HandHealth health() const noexcept override {
    if (clock_ != nullptr && !finished_) return intake_.reception().health(now(*clock_));
    HandHealth health;
    health.state = finished_ ? DeviceState::finished : DeviceState::configured;
    health.counters = intake_.reception().counters;
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    reached_ = start_ = clock.now();
    next_ = 0;
    rows_ = {};
    finished_ = false;
    intake_.begin(start_, info_.period_s);
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    while (rows_.empty()) {
      if (next_ == play_.shots.size()) {
        finished_ = true;
        return ReadStatus::finished;
      }
      const HandShot& shot = play_.shots[next_];
      const Timestamp stamp = start_ + from_seconds(shot.t_s);
      wait_until(std::min(stamp, deadline));
      if (stamp > deadline) return ReadStatus::timeout;
      rows_ = intake_.take(shot.t_s, play_.hands_of(shot), stamp);
      ++next_;
    }
    out = rows_.front();
    rows_ = rows_.subspan(1);
    return ReadStatus::sample;
  }

  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept override {
    if (speed_ == 0.0) return reached_;
    return start_ + scaled(clock.now() - start_, speed_);
  }
  void stop() noexcept override { clock_ = nullptr; }

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

  HandDeviceInfo info_;
  HandPlay play_;
  HandIntake intake_;
  double speed_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  Timestamp reached_{0};  ///< recorded time that was waited for
  std::size_t next_ = 0;  ///< shot
  std::span<const HandSample> rows_;
  bool finished_ = false;
};

}  // namespace

Result<std::unique_ptr<HandDevice>> open_hand_replay(const Uri& uri, std::optional<Hand> side) {
  if (auto known = uri.require_known({"speed"}); !known) return known.error();
  if (uri.target.empty())
    return refused("no file is named"_text, "write replay://FILE.csv"_text)
        .at(uri.text)
        .about("file");
  const auto speed = uri.number_or("speed", 1.0, 0.0, 1000.0);
  if (!speed) return speed.error();
  if (*speed > 0.0 && *speed < 0.01)
    return refused("is too slow"_text, "give 0 (never wait) or 0.01 to 1000"_text)
        .at(uri.text)
        .about("speed");
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
