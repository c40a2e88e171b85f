// SPDX-License-Identifier: GPL-3.0-or-later
// The far end of a CAN bus behind a software adapter, on a thread of its own: the adapter must be
// served all the time, also while the test waits for the kernel.
#pragma once

#include <atomic>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <pthread.h>

#include "device/emulator/slcan_adapter.hpp"

namespace isograsp::test {

constexpr Timestamp kRecovery = std::chrono::seconds(1);  ///< required of the driver
/// The kernel needs up to 2 s to notice an unplugged adapter.
constexpr Timestamp kLong = std::chrono::seconds(3);

/// Time is over only for who has looked so often: a computer that stands still proves nothing.
inline constexpr int kLeastLooks = 400;

/// The name that the adapter's interface gets; empty: this computer cannot have one.
inline std::string slcan_interface() {
  const char* name = std::getenv("ISOGRASP_SLCAN_INTERFACE");
  return name == nullptr ? "" : name;
}

inline bool ip_link(const std::string& arguments) {
  return std::system(("ip link " + arguments).c_str()) == 0;
}

/// A frame that carries a number.
inline BusFrame numbered(std::uint32_t id, std::uint32_t number) {
  BusFrame frame;
  frame.id = id;
  frame.length = 8;
  for (std::size_t k = 0; k < 4; ++k) frame.data[k] = static_cast<std::uint8_t>(number >> (8 * k));
  return frame;
}
inline std::uint32_t number_of(const BusFrame& frame) {
  std::uint32_t number = 0;
  for (std::size_t k = 4; k-- > 0;) number = number << 8U | frame.data[k];
  return number;
}

class AdapterSide {
 public:
  /// What else the far end does each time: emulated sensors. Returns when it wants to run again.
  using Work = std::function<Timestamp(SlcanAdapter&, Timestamp now)>;

  explicit AdapterSide(const std::string& interface) {
    auto opened = SlcanAdapter::open(interface);
    if (!opened) {
      ADD_FAILURE() << opened.error().message();
      return;
    }
    adapter_ = *std::move(opened);
    EXPECT_TRUE(adapter_->start(clock_).ok());
    thread_ = std::thread([this] { run(); });
  }
  ~AdapterSide() {
    running_ = false;
    if (thread_.joinable()) thread_.join();
  }
  AdapterSide(const AdapterSide&) = delete;
  AdapterSide& operator=(const AdapterSide&) = delete;

  [[nodiscard]] bool ok() const { return adapter_ != nullptr; }
  /// On the adapter's thread, between two frames; returns when it is done.
  void ask(const std::function<void(SlcanAdapter&)>& what) {
    std::atomic<bool> done{false};
    {
      const std::lock_guard lock(mutex_);
      asked_ = [&] {
        what(*adapter_);
        done = true;
      };
    }
    while (!done) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  void inject(AdapterFault fault) {
    ask([fault](SlcanAdapter& adapter) { adapter.inject(fault); });
  }
  void set_work(Work work, std::function<void(const ReceivedFrame&)> hear) {
    ask([&](SlcanAdapter&) {
      work_ = std::move(work);
      hear_ = std::move(hear);
    });
  }
  /// Forgets what was heard and numbers from 0 again.
  void begin_anew() {
    ask([&](SlcanAdapter&) {
      stream_id_.reset();
      next_number_ = 0;
      heard_.clear();
    });
  }
  /// From now on one numbered frame each millisecond.
  void stream(std::uint32_t id) {
    ask([&](SlcanAdapter&) { stream_id_ = id; });
  }
  /// The number of numbered frames that the adapter took.
  std::uint32_t end_stream() {
    ask([&](SlcanAdapter&) { stream_id_.reset(); });
    return next_number_;
  }
  /// Every frame from the computer until now.
  std::vector<BusFrame> heard() {
    std::vector<BusFrame> all;
    ask([&](SlcanAdapter&) { all = heard_; });
    return all;
  }
  /// The interface is switched on.
  bool is_open() {
    bool open = false;
    ask([&](SlcanAdapter& adapter) { open = adapter.is_open(); });
    return open;
  }
  /// Frames of the far end that the adapter could not take.
  std::uint64_t unsent() {
    std::uint64_t number = 0;
    ask([&](SlcanAdapter& adapter) { number = adapter.counters().unsent; });
    return number;
  }

 private:
  void run() {
    // As an adapter of its own would: not held up by what the test does.
    const sched_param urgent{20};
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &urgent);
    using namespace std::chrono_literals;
    Timestamp next_frame = clock_.now();
    ReceivedFrame in;
    while (running_) {
      {
        const std::lock_guard lock(mutex_);
        if (asked_) asked_();
        asked_ = nullptr;
      }
      Timestamp wake_up = clock_.now() + 1ms;
      if (work_) wake_up = std::min(wake_up, work_(*adapter_, clock_.now()));
      if (stream_id_ && clock_.now() >= next_frame) {
        next_frame = clock_.now() + 1ms;
        if (adapter_->send(numbered(*stream_id_, next_number_))) ++next_number_;
      }
      const BusEvent event = adapter_->receive(wake_up, in);
      EXPECT_NE(event, BusEvent::interface_gone) << "the interface could not be switched on";
      if (event != BusEvent::frame) continue;
      heard_.push_back(in.frame);
      if (hear_) hear_(in);
    }
  }

  SteadyClock clock_;
  std::unique_ptr<SlcanAdapter> adapter_;
  std::thread thread_;
  std::atomic<bool> running_{true};
  std::mutex mutex_;
  std::function<void()> asked_;
  Work work_;
  std::function<void(const ReceivedFrame&)> hear_;
  std::optional<std::uint32_t> stream_id_;
  std::uint32_t next_number_ = 0;
  std::vector<BusFrame> heard_;
};

}  // namespace isograsp::test
