// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/ only: what a session consists of.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "session/acquisition/acquisition.hpp"
#include "session/recorder.hpp"
#include "session/session.hpp"
#include "session/session_threads.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::session {

struct Session::Parts {
  SessionConfig config;
  SessionKnowledge known;
  std::unique_ptr<Clock> clock;
  std::unique_ptr<virtual_patient::VirtualPatient> viewer;
  std::unique_ptr<ForceDevice> device;
  std::unique_ptr<Acquisition> acquisition;
  std::unique_ptr<Recorder> recorder;
  std::vector<std::unique_ptr<TrialSetup>> setups;  ///< live as long as the threads
  SessionThreads threads;                           ///< none in virtual time
  bool streaming = false;                           ///< the device is started
  bool pending = false;   ///< a zero or a trial was asked for and has not ended
  bool in_trial = false;  ///< it is a trial
  bool finished = false;  ///< virtual time: the device has finished
  bool closed = false;
  Lessons before_last;                         ///< without the last trial
  std::optional<TrialOutcome> last;            ///< the last trial that ended
  bool helped = false;                         ///< the running trial, or the last one
  std::vector<storage::RatingRecord> ratings;  ///< of this session
  std::optional<double> strapped_at_s;         ///< session time

  ~Parts() {
    threads.stop();
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

  Result<void> send(const Command& command) {
    if (acquisition->commands().push(command)) return {};
    return failed("the session does not answer", "close it and start again");
  }

  /// An outdated zero would be subtracted from the forces of a sensor that it does not belong to.
  /// Trials without any zero are the owner's affair.
  Result<void> check_zero_is_fresh();
  /// What the news say about references, zero and training. Trials that were helped are marked.
  void learn(std::vector<SessionNews>& news);
  void learn(const TrialOutcome& outcome);
};

}  // namespace isograsp::session
