// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/ only: what a session consists of.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "session/acquisition/acquisition.hpp"
#include "session/platform/force_platform.hpp"
#include "session/recorder.hpp"
#include "session/session.hpp"
#include "session/session_threads.hpp"
#include "session/two_platforms/two_platforms.hpp"

namespace isograsp::session {

struct Session::Parts {
  SessionConfig config;
  SessionKnowledge known;
  std::unique_ptr<Clock> clock;
  std::unique_ptr<Apparatus> apparatus;
  ForcePlatform* platform = nullptr;      ///< null: it is another apparatus
  TwoPlatforms* two_platforms = nullptr;  ///< likewise
  Snapshot blank;                         ///< of another apparatus: its moment, without forces
  std::unique_ptr<Acquisition> acquisition;
  std::unique_ptr<Recorder> recorder;
  std::vector<std::unique_ptr<TrialSetup>> setups;         ///< live as long as the threads
  std::vector<std::unique_ptr<Preparation>> preparations;  ///< as long
  SessionThreads threads;                                  ///< none in virtual time
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
    if (apparatus) apparatus->stop();
  }

  [[nodiscard]] bool virtual_time() const { return clock->is_virtual(); }

  /// Virtual time: one frame, recorded at once.
  void step() {
    if (!finished) finished = !acquisition->tick();
    recorder->pump();
  }

  Result<void> send(const Command& command) {
    if (acquisition->commands().push(command)) return {};
    return failed("the session does not answer"_text, "close it and start again"_text);
  }

  /// What the news say about references, zero and training. Trials that were helped are marked.
  void learn(std::vector<SessionNews>& news);
  void learn(const TrialOutcome& outcome);
};

}  // namespace isograsp::session
