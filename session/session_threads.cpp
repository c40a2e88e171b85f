// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_threads.hpp"

#include <chrono>
#include <future>
#include <utility>

namespace isograsp::session {

Result<RealtimeGrant> SessionThreads::make(Realtime wish) {
  std::promise<Result<RealtimeGrant>> granted;
  auto grant = granted.get_future();
  acquiring_ = std::thread([this, wish, granted = std::move(granted)]() mutable {
    granted.set_value(enter_realtime(wish));
    released_.wait();
    acquire();
  });
  return grant.get();
}

void SessionThreads::acquire() noexcept {
  while (!stop_.load(std::memory_order_relaxed) && acquisition_->tick()) {
  }
}

void SessionThreads::record() {
  constexpr auto kPoll = std::chrono::milliseconds(10);
  constexpr int kPollsPerLook = 100;
  for (int polls = 1; !stop_.load(std::memory_order_relaxed); ++polls) {
    recorder_->pump();
    if (polls % kPollsPerLook == 0) recorder_->look();
    std::this_thread::sleep_for(kPoll);
  }
}

void SessionThreads::start(Acquisition& acquisition, Recorder& recorder) {
  acquisition_ = &acquisition;
  recorder_ = &recorder;
  release();
  recording_ = std::thread([this] { record(); });
}

void SessionThreads::release() {
  if (!released_.try_wait()) released_.count_down();
}

void SessionThreads::stop() {
  stop_ = true;
  release();
  if (acquiring_.joinable()) acquiring_.join();
  if (recording_.joinable()) recording_.join();
}

}  // namespace isograsp::session
