// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/protocol_run.hpp"

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

Result<TaskSpec> read_task(const std::string& name, const std::string& protocol_file,
                           const std::string& library) {
  const auto path = find_in_library(library, "tasks", name, protocol_file);
  if (!path) return path.error();
  const auto text = read_text(*path);
  if (!text) return text.error();
  auto spec = parse_task(*text, *path);
  if (!spec || spec->scene().empty()) return spec;
  if (const auto scene = find_in_library(library, "scenes", spec->scene(), *path); !scene)
    return scene.error();
  return spec;
}

class Run {
 public:
  Run(Session& session, const std::function<void(const ProtocolProgress&)>& progress, bool serviced)
      : session_(session), progress_(progress), serviced_(serviced) {}

  Result<ProtocolResult> all(const ReadyProtocol& protocol) {
    for (const auto& step : protocol.spec.steps) position_.steps += step.repetitions;
    for (std::size_t i = 0; i < protocol.spec.steps.size(); ++i) {
      const ProtocolStep& step = protocol.spec.steps[i];
      const bool zero = step.kind == ProtocolStep::Kind::instrument_zero;
      if (auto done = zero ? zero_step() : task_step(step, protocol.tasks[i]); !done)
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
          ++position_.step;
          return {};
        }
        reason = news.zero->reason;
        remedy =
            news.zero->only_changed ? "after a service or remounting run it with --serviced" : "";
      }
    }
    return failure("the instrument zero was refused: " + reason, remedy);
  }

  Result<void> task_step(const ProtocolStep& step, const TaskSpec& spec) {
    for (int repetition = 1; repetition <= step.repetitions; ++repetition) {
      std::string doing = spec.name;
      if (step.practice) doing += ", practice";
      if (step.repetitions > 1)
        doing +=
            " (" + std::to_string(repetition) + " of " + std::to_string(step.repetitions) + ")";
      report(doing);
      if (auto done = trial(spec, step.practice); !done) return done;
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
        if (item.fault && !session_.device().recorded)
          session_.abort("Stopped after a device fault.");
      }
    }
  }

  Session& session_;
  const std::function<void(const ProtocolProgress&)>& progress_;
  bool serviced_;
  ProtocolProgress position_;
  ProtocolResult result_;
};

}  // namespace

Result<ReadyProtocol> read_protocol(const std::string& path, const std::string& library) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto spec = parse_protocol(*text, path);
  if (!spec) return spec.error();
  ReadyProtocol ready{std::move(*spec), {}};
  bool rested = false;
  bool maximum = false;
  for (const auto& step : ready.spec.steps) {
    ready.tasks.emplace_back();
    if (step.kind != ProtocolStep::Kind::task) continue;
    auto task = read_task(step.task, path, library);
    if (!task) return task.error();
    const auto out_of_order = [&](const char* what, const char* remedy) {
      return Error{Error::Code::bad_input,
                   what,
                   remedy,
                   path,
                   0,
                   "step[" + std::to_string(ready.tasks.size()) + "].task"};
    };
    const bool is_maximum = std::holds_alternative<MaximumSpec>(task->kind);
    if (is_maximum && !rested)
      return out_of_order(
          "a maximum is measured above the resting force, which no earlier step measures",
          "put a resting-force task before it");
    if (task->needs_maximum() && !maximum)
      return out_of_order("the target is a share of a maximum that no earlier step measures",
                          "put a maximum task before it");
    rested = rested || std::holds_alternative<RestSpec>(task->kind);
    maximum = maximum || is_maximum;
    ready.tasks.back() = std::move(*task);
  }
  return ready;
}

Result<ProtocolResult> run_protocol(Session& session, const ReadyProtocol& protocol,
                                    const std::function<void(const ProtocolProgress&)>& progress,
                                    bool serviced) {
  return Run(session, progress, serviced).all(protocol);
}

}  // namespace isograsp
