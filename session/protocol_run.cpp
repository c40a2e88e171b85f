// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/protocol_run.hpp"

#include <algorithm>

#include "tasks/agenda.hpp"

namespace isograsp {

namespace {

constexpr int kZeroAttempts = 3;
constexpr int kTrialAttempts = 2;  ///< a trial that a fault interrupted is repeated once
/// The hand leaves the device and its sensors settle (filter and hold of well under a second).
constexpr double kSettle_s = 1.0;

Error failure(std::string what, std::string remedy) {
  return {Error::Code::failed, std::move(what), std::move(remedy), "", 0, ""};
}

class Run {
 public:
  Run(Session& session, const std::function<void(const ProtocolProgress&)>& progress, bool serviced)
      : session_(session), progress_(progress), serviced_(serviced) {}

  Result<ProtocolResult> all(const ReadyProtocol& protocol) {
    Agenda agenda(protocol.spec, session_.order_seed());
    tell(agenda, protocol.spec, session_.earlier());
    if (auto ready = set_up_again(protocol, agenda); !ready) return ready.error();
    while (const auto item = agenda.next()) {
      const ProtocolStep& step = protocol.spec.steps[item->step];
      position_.step = agenda.done();
      position_.steps = agenda.done() + agenda.expected();
      wait_until(item->not_before_s);
      Agenda::Outcome outcome;
      switch (step.kind) {
        case ProtocolStep::Kind::instrument_zero:
          if (auto done = zero_step(); !done) return done.error();
          break;
        case ProtocolStep::Kind::pause:
          report("Pause");
          session_.let_pass(step.duration_s);
          break;
        case ProtocolStep::Kind::task: {
          const TaskSpec& spec = protocol.tasks[item->step][item->task];
          if (auto done = task_step(step, spec, *item); !done) return done.error();
          outcome.completed = trial_was_made_;
          if (trial_was_made_ && !result_.trials.back().trial.helped)
            outcome.agreeing = agreeing(step, result_.trials.back().measures);
          break;
        }
      }
      outcome.ended_s = session_.snapshot().session_time_s;
      agenda.record(outcome);
    }
    position_.step = position_.steps;
    report("");
    return std::move(result_);
  }

 private:
  void report(std::string doing) {
    position_.doing = std::move(doing);
    if (progress_) progress_(position_);
  }

  /// A protocol that is taken up again: the device was switched off and the hand taken out, so zero
  /// and resting force are measured anew.
  Result<void> set_up_again(const ReadyProtocol& protocol, const Agenda& agenda) {
    const auto next = agenda.next();
    if (agenda.done() == 0 || !next) return {};
    bool zeroed = false;
    for (std::size_t i = 0; i < next->step; ++i) {
      const bool zero = protocol.spec.steps[i].kind == ProtocolStep::Kind::instrument_zero;
      if (zero && !std::exchange(zeroed, true))
        if (auto done = zero_step(); !done) return done;
      for (const TaskSpec& spec : protocol.tasks[i]) {
        if (!std::holds_alternative<RestSpec>(spec.kind)) continue;
        report(spec.name);
        if (auto done = trial(spec, false, std::nullopt); !done) return done;
      }
    }
    return {};
  }

  Result<void> zero_step() {
    report("Instrument zero");
    std::string reason;
    std::string remedy;
    for (int attempt = 0; attempt < kZeroAttempts; ++attempt) {
      ZeroRequest request;
      request.device_is_empty = true;  // whoever starts a session without a window promises it
      request.settle_s = kSettle_s;
      request.accept_changed = serviced_;
      if (auto started = session_.start_zero(request); !started) return started;
      for (const auto& news : session_.wait_for_news()) {
        if (news.failure) return failure(*news.failure, "");
        if (!news.zero) continue;
        if (news.zero->accepted) {
          serviced_ = false;
          return {};
        }
        reason = news.zero->reason;
        remedy =
            news.zero->only_changed ? "after a service or remounting run it with --serviced" : "";
      }
    }
    return failure("the instrument zero was refused: " + reason, remedy);
  }

  Result<void> task_step(const ProtocolStep& step, const TaskSpec& spec, const Agenda::Item& item) {
    std::string doing = spec.name;
    if (step.practice) doing += ", practice";
    const int planned = std::max(step.repetitions, item.attempt);
    if (planned > 1)
      doing += " (" + std::to_string(item.attempt) + " of " + std::to_string(planned) + ")";
    report(doing);
    const TrialPlace place{static_cast<int>(item.step), static_cast<int>(item.task)};
    if (!step.adaptive) return trial(spec, step.practice, place);
    const auto leveled = at_level(spec, session_.training().level(spec));
    return leveled ? trial(*leveled, step.practice, place) : leveled.error();
  }

  /// Rests go on in the session's own time.
  void wait_until(double session_time_s) {
    const double now_s = session_.snapshot().session_time_s;
    if (session_time_s > now_s) session_.let_pass(session_time_s - now_s);
  }

  Result<void> trial(const TaskSpec& spec, bool practice, std::optional<TrialPlace> place) {
    std::string reason;
    trial_was_made_ = true;
    for (int attempt = 0; attempt < kTrialAttempts; ++attempt) {
      if (auto started = session_.start_trial(spec, practice, place); !started) {
        if (started.error().code != Error::Code::bad_input) return started;
        leave_out(spec, started.error());
        return {};
      }
      const auto outcome = wait_for_trial();
      if (!outcome) return outcome.error();
      result_.trials.push_back(*outcome);
      if (outcome->trial.status == TrialStatus::completed) return {};
      reason = outcome->reason;
      if (session_.snapshot().stage == Stage::finished) break;
    }
    return failure("'" + spec.name + "' could not be completed: " + reason,
                   "mend the device and run the protocol again");
  }

  void leave_out(const TaskSpec& spec, const Error& why) {
    trial_was_made_ = false;
    result_.left_out.push_back(spec.name + ": " + why.what + "; " + why.remedy);
    session_.note("Left out: " + result_.left_out.back());
  }

  Result<TrialOutcome> wait_for_trial() {
    for (;;) {
      const auto news = session_.wait_for_news();
      if (news.empty()) return failure("the device gives no more data", "check the device");
      for (const auto& item : news) {
        if (item.failure) return failure(*item.failure, "");
        if (item.trial) return *item.trial;
        // Resuming is a therapist's act and there is none here; recorded data go on by themselves.
        if (item.fault && !session_.device().recorded)
          session_.abort("Stopped after a device fault.");
      }
    }
  }

  Session& session_;
  const std::function<void(const ProtocolProgress&)>& progress_;
  bool serviced_;
  bool trial_was_made_ = true;
  ProtocolProgress position_;
  ProtocolResult result_;
};

}  // namespace

Result<ProtocolResult> run_protocol(Session& session, const ReadyProtocol& protocol,
                                    const std::function<void(const ProtocolProgress&)>& progress,
                                    bool serviced) {
  return Run(session, progress, serviced).all(protocol);
}

}  // namespace isograsp
