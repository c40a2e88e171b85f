// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/ only: the two threads of a session in real time.
#pragma once

#include <atomic>
#include <latch>
#include <thread>

#include "core/result.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/acquisition/realtime.hpp"
#include "session/recorder.hpp"

namespace isograsp::session {

class SessionThreads {
 public:
  SessionThreads() = default;
  ~SessionThreads() { stop(); }
  SessionThreads(const SessionThreads&) = delete;
  SessionThreads& operator=(const SessionThreads&) = delete;

  /// The acquisition thread asks for real time and waits for start(): before anything is written,
  /// so that a refusal leaves no trace.
  [[nodiscard]] Result<RealtimeGrant> make(Realtime wish);
  /// Both outlive the threads. @pre make() succeeded
  void start(Acquisition& acquisition, Recorder& recorder);
  /// Waits for their end; also for threads that were never made.
  void stop();

 private:
  void acquire() noexcept;
  void record();
  /// The acquisition thread may begin, or end if there is nothing to begin with.
  void release();

  std::atomic<bool> stop_{false};
  std::latch released_{1};
  Acquisition* acquisition_ = nullptr;
  Recorder* recorder_ = nullptr;
  std::thread acquiring_;
  std::thread recording_;
};

}  // namespace isograsp::session
