// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/protocol/protocol_run.hpp"

#include "session/protocol/protocol_walk.hpp"

namespace isograsp::session {

namespace {

constexpr int kPreparations = 3;
constexpr int kTrialAttempts = 2;  ///< a trial that a fault interrupted is repeated once
/// The hand leaves the device and its sensors settle (filter and hold of well under a second).
constexpr double kSettle_s = 1.0;

class Run {
 public:
  Run(Session& session, const std::function<void(const ProtocolProgress&)>& progress, bool serviced)
      : session_(session), progress_(progress), serviced_(serviced) {}

  Result<ProtocolResult> all(const ReadyProtocol& protocol) {
    ProtocolWalk walk(protocol, session_.known().earlier, session_.known().order_seed());
    while (const auto act = walk.next()) {
      if (auto good = may_go_on(); !good) return good.error();
      position_.step = walk.acts_done();
      position_.steps = walk.acts();
      wait_until(act->not_before_s);
      report(act->words());
      switch (act->kind) {
        case ProtocolWalk::Act::Kind::instrument_zero:
        case ProtocolWalk::Act::Kind::start_posture:
          if (auto done = prepare(act->kind); !done) return done.error();
          walk.done(now_s());
          break;
        case ProtocolWalk::Act::Kind::hand_entry:
          if (auto done = test_entry(); !done) return done.error();
          walk.done(now_s());
          break;
        case ProtocolWalk::Act::Kind::pause:
          session_.let_pass(act->duration_s);
          walk.done(now_s());
          break;
        case ProtocolWalk::Act::Kind::trial: {
          const auto made = trial(*act);
          if (!made) return made.error();
          if (*made)
            walk.made(result_.trials.back(), now_s());
          else
            walk.left_out(now_s());
          break;
        }
      }
    }
    position_.step = position_.steps;
    report({});
    return std::move(result_);
  }

 private:
  void report(Text doing) {
    position_.doing = std::move(doing);
    if (progress_) progress_(position_);
  }

  /// Nothing more is measured once it cannot be stored.
  Result<void> may_go_on() {
    if (const auto lost = session_.failure()) return *lost;
    if (session_.is_to_stop())
      return failed("the session was told to end"_text, "run it again with --resume to go on"_text);
    return {};
  }

  Result<void> prepare(ProtocolWalk::Act::Kind kind) {
    const bool zero = kind == ProtocolWalk::Act::Kind::instrument_zero;
    if (!session_.known().asks_for(zero ? PreparationStep::zero : PreparationStep::start_posture))
      return refused(zero ? "this device has no instrument zero"_text
                          : "this device has no start posture"_text,
                     "use a protocol that is made for it"_text);
    Text reason;
    Text remedy;
    for (int attempt = 0; attempt < kPreparations; ++attempt) {
      ZeroRequest request;
      request.device_is_empty = true;  // starting a session without a window confirms it
      request.settle_s = kSettle_s;
      request.accept_changed = serviced_;
      if (auto started = session_.start_zero(request); !started) return started;
      const auto all = session_.wait_for_news();
      if (auto good = may_go_on(); !good) return good;
      for (const auto& news : all) {
        if (!news.prepared) continue;
        if (news.prepared->accepted) {
          serviced_ = false;
          return {};
        }
        reason = news.prepared->reason;
        remedy = news.prepared->only_changed
                     ? Text("after a service or remounting run it with --serviced"_text)
                     : Text();
      }
    }
    if (!zero)
      return failed("there is no start posture: %1"_text(reason),
                    "check markers and cameras, and run the protocol again"_text);
    return failed("the instrument zero was refused: %1"_text(reason), remedy);
  }

  /// A hand that does not pass goes on with the tasks that are for it; the others are left out, and
  /// say why.
  Result<void> test_entry() {
    if (!session_.known().asks_for(PreparationStep::hand_entry))
      return refused("this device has no entry test of a hand"_text,
                     "use a protocol that is made for it"_text);
    ZeroRequest request;
    request.settle_s = kSettle_s;
    if (auto started = session_.start_zero(request); !started) return started;
    const auto news = session_.wait_for_news();
    if (auto good = may_go_on(); !good) return good;
    for (const auto& item : news)
      if (item.prepared) return {};
    return failed("the device gives no more data"_text, "check the device"_text);
  }

  double now_s() { return session_.snapshot().session_time_s; }

  /// Rests go on in the session's own time.
  void wait_until(double session_time_s) {
    if (session_time_s > now_s()) session_.let_pass(session_time_s - now_s());
  }

  /// False: the task was left out.
  Result<bool> trial(const ProtocolWalk::Act& act) {
    const auto spec = task_of(act, session_.known().training);
    if (!spec) return spec.error();
    Text reason;
    for (int attempt = 0; attempt < kTrialAttempts; ++attempt) {
      if (auto started = session_.start_trial(*spec, act.practice, act.place); !started) {
        if (started.error().code != Error::Code::bad_input) return way_on(started.error());
        leave_out(*spec, started.error());
        return false;
      }
      const auto outcome = wait_for_trial();
      if (!outcome) return outcome.error();
      result_.trials.push_back(*outcome);
      if (outcome->trial.status == storage::TrialStatus::completed) return true;
      reason = outcome->reason;
      if (session_.snapshot().stage == Stage::finished) break;
    }
    return failed("'%1' could not be completed: %2"_text(Known{spec->name}, reason),
                  "mend the device and run the protocol again"_text);
  }

  /// Nobody takes the hand out here: what comes next begins with a zero, and with a person.
  static Error way_on(Error error) {
    if (error.field == "zero")
      error.remedy =
          "take the hand out, and run the protocol again with --resume: it begins with a new zero"_text;
    return error;
  }

  void leave_out(const tasks::TaskSpec& spec, const Error& why) {
    result_.left_out.push_back("%1: %2; %3"_text(Known{spec.name}, why.what, why.remedy));
    session_.note("Left out: " + english(result_.left_out.back()));
  }

  Result<TrialOutcome> wait_for_trial() {
    for (;;) {
      const auto news = session_.wait_for_news();
      if (const auto good = may_go_on(); !good) return good.error();
      if (news.empty())
        return failed("the device gives no more data"_text, "check the device"_text);
      for (const auto& item : news) {
        if (item.trial) return *item.trial;
        // Resuming is a therapist's act and there is none here; recorded data go on by themselves.
        if (item.fault && !session_.known().device.recorded)
          session_.abort("Stopped after a device fault."_text);
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

Result<ProtocolResult> run_protocol(Session& session, const ReadyProtocol& protocol,
                                    const std::function<void(const ProtocolProgress&)>& progress,
                                    bool serviced) {
  return Run(session, progress, serviced).all(protocol);
}

}  // namespace isograsp::session
