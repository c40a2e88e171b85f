// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/live_hand.hpp"

#include <system_error>
#include <thread>
#include <utility>

#include "device/hand/hand_schemes.hpp"

namespace isograsp {

void HandDesk::begin() {
  service_.clear();
  intake_.begin(clock_.now());
  tell();
}

void HandDesk::frame(double tracker_s, std::span<const HandFrame> hands) {
  for (const HandSample& row : intake_.take(tracker_s, hands, clock_.now()))
    if (!rows_.push(row)) intake_.overrun();
  tell();
}
void HandDesk::malformed() {
  intake_.malformed(clock_.now());
  tell();
}
void HandDesk::late() {
  intake_.late(clock_.now());
  tell();
}
void HandDesk::foreign() {
  intake_.foreign(clock_.now());
  tell();
}
void HandDesk::link(HandReception::Link link) {
  intake_.link(link);
  tell();
}
void HandDesk::service(const std::string& version) {
  constexpr std::size_t kLongest = 80;
  if (intake_.reception().counters.frames == 0) service_ = shortened(version, kLongest);
}

void HandDesk::tell() {
  told_.publish(intake_.reception());
  wake_.signal();
}

namespace {

/// Within so long a tracker must send its first frame.
constexpr Timestamp kHandPatience = std::chrono::seconds(5);

class LiveHand final : public HandDevice {
 public:
  LiveHand(HandDeviceInfo info, std::optional<Hand> side,
           std::function<std::unique_ptr<HandReceiver>()> make_receiver)
      : info_(std::move(info)), side_(side), make_receiver_(std::move(make_receiver)) {}
  ~LiveHand() override { LiveHand::stop(); }

  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] HandHealth health() const noexcept override {
    if (clock_ != nullptr) return desk_->reception().health(clock_->now());
    HandHealth health;
    health.state = desk_ ? DeviceState::configured : DeviceState::absent;
    if (desk_) health.counters = desk_->reception().counters;
    return health;
  }

  [[nodiscard]] Result<void> start(Clock& clock) override {
    stop();
    desk_.reset();
    if (clock.is_virtual())
      return refused("a tracker of hands does not run in virtual time"_text,
                     "leave out --fast, or use replay://"_text)
          .at(info_.uri);
    receiver_ = make_receiver_();
    auto desk = std::make_unique<HandDesk>(side_, clock);
    if (auto opened = desk->open(); !opened) return opened;
    if (auto opened = receiver_->open(); !opened) return Error(opened.error()).at(info_.uri);
    desk->begin();
    desk_ = std::move(desk);
    try {
      thread_ = std::thread([this] { receiver_->run(*desk_); });
    } catch (const std::system_error& problem) {
      desk_.reset();
      return failed("no thread can be started: %1"_text(Known{problem.code().message()}),
                    "close other programs and try again"_text)
          .at(info_.uri);
    }
    if (auto came = wait_for_frames(clock); !came) {
      stop();
      desk_.reset();
      return came;
    }
    info_.service = desk_->service();
    if (const double period_s = desk_->reception().period_s; period_s > 0.0)
      info_.period_s = period_s;
    clock_ = &clock;
    return {};
  }

  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    if (clock_ == nullptr) return ReadStatus::finished;
    for (;;) {
      if (desk_->take(out)) return ReadStatus::sample;
      const Timestamp now = clock_->now();
      if (now >= deadline) return ReadStatus::timeout;
      desk_->wait(deadline - now);
    }
  }

  void stop() noexcept override {
    clock_ = nullptr;
    if (!thread_.joinable()) return;
    receiver_->end();
    thread_.join();
  }

 private:
  /// Until the rate is known.
  [[nodiscard]] Result<void> wait_for_frames(Clock& clock) {
    const Timestamp end = clock.now() + kHandPatience;
    for (;;) {
      const HandReception& seen = desk_->reception();
      const Timestamp now = clock.now();
      if (seen.period_s > 0.0) return {};
      const bool hopeless = seen.link != HandReception::Link::open;
      if (now >= end || hopeless) {
        if (seen.counters.frames > 0) return {};
        return receiver_->nothing_came(seen.link).at(info_.uri);
      }
      desk_->wait(end - now);
    }
  }

  HandDeviceInfo info_;
  std::optional<Hand> side_;
  std::function<std::unique_ptr<HandReceiver>()> make_receiver_;
  std::unique_ptr<HandReceiver> receiver_;
  std::unique_ptr<HandDesk> desk_;  ///< null: never started
  std::thread thread_;
  Clock* clock_ = nullptr;  ///< null: stopped
};

}  // namespace

std::unique_ptr<HandDevice> live_hand(
    HandDeviceInfo info, std::optional<Hand> side,
    std::function<std::unique_ptr<HandReceiver>()> make_receiver) {
  return std::make_unique<LiveHand>(std::move(info), side, std::move(make_receiver));
}

Result<HandDeviceInfo> live_hand_info(const Uri& uri) {
  constexpr double kMostDelay_ms = 1000.0;
  HandDeviceInfo info;
  info.uri = uri.text;
  info.mounting = uri.text_or("mounting", "desk");
  if (info.mounting != "desk" && info.mounting != "screen" && info.mounting != "head")
    return refused("'%1' is no place of a camera"_text(info.mounting),
                   "write desk, screen or head"_text)
        .at(uri.text)
        .about("mounting");
  if (uri.parameters.contains("delay_ms")) {
    const auto delay_ms = uri.number_or("delay_ms", 0.0, 0.0, kMostDelay_ms);
    if (!delay_ms) return delay_ms.error();
    info.delay_s = *delay_ms * 1e-3;
  }
  info.provenance = {"live: " + uri.text};
  return info;
}

}  // namespace isograsp
