// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/ only: what a session consists of.
#pragma once

#include <atomic>
#include <future>
#include <latch>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "session/acquisition/acquisition.hpp"
#include "session/acquisition/zeroing.hpp"
#include "session/recorder.hpp"
#include "session/session.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::session {

struct Session::Parts {
  SessionConfig config;
  storage::SessionRecord record;
  std::unique_ptr<Clock> clock;
  std::unique_ptr<virtual_patient::VirtualPatient> viewer;
  std::unique_ptr<ForceDevice> device;
  std::unique_ptr<Acquisition> acquisition;
  std::unique_ptr<Recorder> recorder;
  std::vector<std::unique_ptr<TrialSetup>> setups;  ///< live as long as the threads
  std::atomic<bool> stop{false};
  std::thread acquisition_thread;
  std::thread recorder_thread;
  bool pending = false;   ///< a zero or a trial was asked for and has not ended
  bool in_trial = false;  ///< it is a trial
  bool finished = false;  ///< virtual time: the device has finished
  bool closed = false;
  bool patient_is_new = false;
  EarlierWork earlier;
  /// What the trials so far teach.
  struct Lesson {
    tasks::ForceReferences references;
    Training training;
  };
  Lesson lesson;
  Lesson before_last;                                 ///< the same without the last trial
  std::optional<TrialOutcome> last;                   ///< the last trial that ended
  bool helped = false;                                ///< the running trial, or the last one
  std::vector<storage::RatingRecord> ratings;         ///< of this session
  std::optional<storage::InstrumentZeroRecord> zero;  ///< in force
  std::optional<double> strapped_at_s;                ///< session time
  RealtimeGrant realtime;
  std::latch go{1};  ///< the acquisition thread may begin
  bool gone = false;
  bool streaming = false;  ///< the device is started

  ~Parts() {
    stop_threads();
    stop_device();
  }

  void stop_device() {
    if (std::exchange(streaming, false)) device->stop();
  }

  [[nodiscard]] bool virtual_time() const { return clock->is_virtual(); }

  /// Virtual time: one frame, recorded at once.
  void step() {
    if (!finished) finished = !acquisition->tick();
    recorder->pump();
  }

  /// The acquisition thread asks for real time and waits; before anything is written, so that a
  /// refusal leaves no trace.
  Result<void> make_acquisition_thread() {
    std::promise<Result<RealtimeGrant>> granted;
    auto grant = granted.get_future();
    acquisition_thread = std::thread([this, granted = std::move(granted)]() mutable {
      granted.set_value(enter_realtime(config.realtime));
      go.wait();
      while (!stop.load(std::memory_order_relaxed) && acquisition->tick()) {
      }
    });
    auto got = grant.get();
    if (!got) return got.error();
    realtime = *std::move(got);
    return {};
  }

  void let_go() {
    if (!std::exchange(gone, true)) go.count_down();
  }

  void start_threads() {
    let_go();
    recorder_thread = std::thread([this] {
      constexpr auto kPoll = std::chrono::milliseconds(10);
      constexpr int kPollsPerLook = 100;
      for (int polls = 1; !stop.load(std::memory_order_relaxed); ++polls) {
        recorder->pump();
        if (polls % kPollsPerLook == 0) recorder->look();
        std::this_thread::sleep_for(kPoll);
      }
    });
  }

  void stop_threads() {
    stop = true;
    let_go();
    if (acquisition_thread.joinable()) acquisition_thread.join();
    if (recorder_thread.joinable()) recorder_thread.join();
  }

  Result<void> send(const Command& command) {
    if (acquisition->commands().push(command)) return {};
    return failed("the session does not answer", "close it and start again");
  }

  /// An outdated zero would be subtracted from the forces of a sensor that it does not belong to.
  /// Trials without any zero are the owner's affair.
  Result<void> check_zero_is_fresh() {
    const Snapshot& now = acquisition->snapshots().read();
    if (standing_of_zero(device->info().recorded, now.zeroed, now.restarted.has_value()) !=
        ZeroStanding::outdated)
      return {};
    return failed("since the zero was set a sensor started anew (" +
                      std::string(name_of(*now.restarted)) + ")",
                  "take the hand out and set the zero again")
        .about("zero");
  }

  /// What the news say about references, zero and training. Trials that were helped are marked.
  void learn(std::vector<SessionNews>& news);
  void learn(const TrialOutcome& outcome);
};

/// Maxima and comfortable forces that a trial measured raise the references of their channels.
void learn_maxima(const std::vector<Measure>& measures, tasks::ForceReferences& references);

}  // namespace isograsp::session
