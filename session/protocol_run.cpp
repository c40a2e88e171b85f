// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/protocol_run.hpp"

#include <numeric>

#include "core/csv.hpp"

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
  Run(Session& session, const std::string& library,
      const std::function<void(const ProtocolProgress&)>& progress)
      : session_(session), library_(library), progress_(progress) {}

  Result<ProtocolResult> all(const ProtocolSpec& protocol) {
    position_.steps =
        std::accumulate(protocol.steps.begin(), protocol.steps.end(), 0,
                        [](int sum, const ProtocolStep& step) { return sum + step.repetitions; });
    for (const auto& step : protocol.steps) {
      const bool zero = step.kind == ProtocolStep::Kind::instrument_zero;
      if (auto done = zero ? zero_step() : task_step(step, protocol.file); !done)
        return done.error();
    }
    report("");
    return std::move(result_);
  }

 private:
  void report(std::string doing) {
    position_.doing = std::move(doing);
    if (progress_) progress_(position_);
  }

  Result<void> zero_step() {
    report("Instrument zero");
    std::string reason;
    for (int attempt = 0; attempt < kZeroAttempts; ++attempt) {
      session_.let_pass(kSettle_s);
      if (auto started = session_.start_zero(); !started) return started;
      for (const auto& news : session_.wait_for_news()) {
        if (news.failure) return failure(*news.failure, "");
        if (!news.zero) continue;
        if (news.zero->accepted) {
          ++position_.step;
          return {};
        }
        reason = news.zero->reason;
      }
    }
    return failure("the instrument zero was refused: " + reason, "");
  }

  Result<void> task_step(const ProtocolStep& step, const std::string& protocol_file) {
    const auto path = find_in_library(library_, "tasks", step.task, protocol_file);
    if (!path) return path.error();
    const auto text = read_text(*path);
    if (!text) return text.error();
    const auto spec = parse_task(*text, *path);
    if (!spec) return spec.error();
    for (int repetition = 1; repetition <= step.repetitions; ++repetition) {
      std::string doing = spec->name;
      if (step.practice) doing += ", practice";
      if (step.repetitions > 1)
        doing +=
            " (" + std::to_string(repetition) + " of " + std::to_string(step.repetitions) + ")";
      report(doing);
      if (auto done = trial(*spec, step.practice); !done) return done;
      ++position_.step;
      session_.let_pass(step.rest_s);
    }
    return {};
  }

  Result<void> trial(const TaskSpec& spec, bool practice) {
    std::string reason;
    for (int attempt = 0; attempt < kTrialAttempts; ++attempt) {
      if (auto started = session_.start_trial(spec, practice); !started) return started;
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

  Result<TrialOutcome> wait_for_trial() {
    for (;;) {
      const auto news = session_.wait_for_news();
      if (news.empty()) return failure("the device gives no more data", "check the device");
      for (const auto& item : news) {
        if (item.failure) return failure(*item.failure, "");
        if (item.trial) return *item.trial;
        // Resuming is a therapist's act and there is none here; recorded data go on by themselves.
        if (item.fault && !session_.device().recorded) session_.abort();
      }
    }
  }

  Session& session_;
  const std::string& library_;
  const std::function<void(const ProtocolProgress&)>& progress_;
  ProtocolProgress position_;
  ProtocolResult result_;
};

}  // namespace

Result<ProtocolResult> run_protocol(Session& session, const ProtocolSpec& protocol,
                                    const std::string& library,
                                    const std::function<void(const ProtocolProgress&)>& progress) {
  return Run(session, library, progress).all(protocol);
}

}  // namespace isograsp
