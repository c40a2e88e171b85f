// SPDX-License-Identifier: GPL-3.0-or-later
// Everything behind both windows except their pixels: what the therapist does, and the state that
// comes of it (session_state.hpp). Knows no widget; all slow work runs on a worker. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/clinic/background.hpp"
#include "gui/clinic/clinic.hpp"
#include "gui/clinic/disk_room.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/library/session_library.hpp"
#include "gui/presenter/example_player.hpp"
#include "gui/presenter/seating.hpp"
#include "gui/presenter/session_state.hpp"
#include "gui/rules/patient_picture.hpp"

namespace isograsp::gui {

struct GuiConfig {
  std::string database;
  std::string device_uri;  ///< chosen at start; empty: the therapist chooses
  std::string library;     ///< shipped: folder with tasks/, protocols/ and scenes/
  std::string software_version;
  std::string operator_name = {};                          ///< stored with zero and resting force
  session::Realtime realtime = session::Realtime::prefer;  ///< of the acquisition thread
  std::string settings = {};                               ///< file; empty: nothing is read or kept
  bool look_only = false;                                  ///< another program works with the file
  double settle_after_strapping_s = session::kSettleAfterStrapping_s;
};

class SessionPresenter final : public QObject {
  Q_OBJECT

 public:
  SessionPresenter(const GuiConfig& config, Clinic& clinic, const SettingsFile& settings,
                   QObject* parent = nullptr);
  ~SessionPresenter() override;

  // Choices. Ignored while the flow does not allow them.
  void choose_patient(const std::string& code);
  void choose_hand(Hand hand);
  /// The chosen hand is not the affected one, and that is meant.
  void confirm_hand();
  void choose_device(const std::string& uri);
  void answer_screening(const Screening& answers);
  /// A number in protocols(); kByHand: none, tasks are chosen one by one.
  void choose_protocol(int index);
  /// An interrupted protocol may be taken up: go on with it, or begin anew.
  void decide_earlier(bool go_on);
  /// By hand; in a protocol it stands by until follow_protocol().
  void choose_task(int index);
  /// In a protocol: a task is chosen now, the protocol stands by.
  void choose_by_hand();
  /// The next act of the protocol again, after tasks that were chosen by hand.
  void follow_protocol();
  void set_practice(bool practice);

  // Acts. Each is ignored while the flow does not allow it.
  void connect_device();
  /// At once for the therapist; what the worker has opened meanwhile is closed there.
  void cancel_connecting();
  void disconnect_device();
  /// At once, whatever is running or being opened: the program is about to end.
  void end_session();
  /// The operator has confirmed that the device is empty, and perhaps that it was serviced or
  /// remounted since its last zero.
  void set_zero(bool accept_changed = false);
  void mark_strapped();  ///< the hand is in and strapped
  void start();
  void pause();
  void resume();
  void stop();
  /// Nothing begins by itself any more until the next start.
  void stand_by();
  void skip();                ///< the next act of the protocol
  void repeat();              ///< the last trial once more, beside the protocol
  void start_pause_resume();  ///< the one big key
  /// Acts of the protocol begin by themselves after a start (as it is at first), or wait for a key.
  void set_by_itself(bool by_itself);
  /// Of the chosen task, if it has a difficulty that may be chosen: -1 easier, +1 harder.
  void adjust_difficulty(int direction);
  /// The therapist helps, or did in the last trial; again: takes it back.
  void toggle_helped();
  /// What the patient says of the work, 0 to 10 each; nothing is stored before both are known.
  void rate_effort(int effort);
  void rate_pain(int pain);
  /// The patient's screen shows how the chosen task is done; again: it stops. So does any act.
  void show_how();
  void note(const std::string& text);
  /// Who works at this station, from the next session on; empty: as the settings say.
  void name_operator(const std::string& name) { operator_ = name; }
  /// Reads tasks and protocols again; what is new appears as soon as no trial runs and no device is
  /// being opened. What is chosen stays chosen as long as its file is there.
  void reload_library();
  [[nodiscard]] const GuiConfig& config() const noexcept { return config_; }
  /// Another program works with the file: nothing is added or changed here.
  [[nodiscard]] bool look_only() const noexcept { return config_.look_only; }

  [[nodiscard]] const FlowView& view() const noexcept { return view_; }
  [[nodiscard]] const session::Snapshot& snapshot() const noexcept {
    return open_ ? open_->snapshot : nothing_.snapshot;
  }
  [[nodiscard]] const ForceHistory& forces() const noexcept { return traces().forces; }
  [[nodiscard]] const std::string& patient() const noexcept { return choices_.patient; }
  [[nodiscard]] std::optional<Hand> hand() const noexcept { return choices_.today.hand; }
  /// The chosen hand is not on the affected side: a press must confirm it.
  [[nodiscard]] bool hand_to_confirm() const noexcept;
  [[nodiscard]] const std::string& device_uri() const noexcept { return choices_.device_uri; }
  /// What the session measures beside the hand.
  [[nodiscard]] const session::Compensation& compensation() const noexcept {
    return open_ ? open_->compensation : nothing_.compensation;
  }
  /// Today's maximum grip, if it is known and forces are to be shown as a share of it; else 0 [N].
  [[nodiscard]] double shown_maximum_N() const noexcept;
  /// Of the connected device; null: none.
  [[nodiscard]] const DeviceInfo* device_info() const noexcept;
  /// Of the device in this session, oldest first.
  [[nodiscard]] const std::vector<DeviceFaultSeen>& faults() const noexcept {
    return traces().faults;
  }
  [[nodiscard]] const std::vector<tasks::TaskSpec>& tasks() const noexcept {
    return library_.tasks;
  }
  /// Files that could not be read, in words.
  [[nodiscard]] const std::vector<std::string>& library_problems() const noexcept {
    return library_.problems;
  }
  /// Chosen by hand; -1: the protocol says what comes.
  [[nodiscard]] int task() const noexcept { return follows() ? -1 : task_by_hand(); }
  /// The task that Start begins, at its level; null: none.
  [[nodiscard]] const tasks::TaskSpec* next_task() const noexcept;
  /// "Grip force, sine (1 of 2)" of the protocol, or the name of the chosen task.
  [[nodiscard]] std::string next_words() const;
  static constexpr int kByHand = Choices::kByHand;
  [[nodiscard]] const std::vector<session::ReadyProtocol>& protocols() const noexcept {
    return library_.protocols;
  }
  [[nodiscard]] int protocol() const noexcept { return choices_.protocol; }
  /// The session follows, or will follow, protocol().
  [[nodiscard]] bool has_protocol() const noexcept;
  [[nodiscard]] const ProtocolGuide& guide() const noexcept {
    return open_ ? open_->work.guide : nothing_.guide;
  }
  /// The protocol, not the therapist, says what comes.
  [[nodiscard]] bool follows() const noexcept { return guide().active() && !open_->work.by_hand; }
  [[nodiscard]] bool by_itself() const noexcept { return choices_.by_itself; }
  [[nodiscard]] const Screening& screening() const noexcept { return choices_.today.screening; }
  /// Acts that an interrupted session did of the chosen protocol today; nothing: there is none.
  [[nodiscard]] std::optional<int> earlier() const noexcept { return choices_.interrupted.acts; }
  [[nodiscard]] std::optional<bool> goes_on_earlier() const noexcept {
    return choices_.interrupted.go_on;
  }
  /// Level of the chosen task, 0 (easiest) … 1; nothing: it has none that may be chosen now.
  [[nodiscard]] std::optional<double> difficulty() const;
  /// Of the running or the last trial.
  [[nodiscard]] bool helped() const noexcept;
  [[nodiscard]] bool may_help() const noexcept;
  [[nodiscard]] bool may_repeat() const noexcept;
  /// Of this session; nothing said while none is open.
  [[nodiscard]] const Rating& rating() const noexcept {
    return open_ ? open_->rating : nothing_.rating;
  }
  void show_rated();  ///< to correct it, after it was put away for the next answer
  [[nodiscard]] bool practice() const noexcept { return choices_.practice; }
  /// The protocol asks for a zero of the empty device.
  [[nodiscard]] bool zero_is_next() const noexcept {
    return guide().act() &&
           guide().act()->kind == session::ProtocolWalk::Act::Kind::instrument_zero;
  }
  /// What the resting force suggests; empty: not measured yet.
  [[nodiscard]] const std::string& rest_words() const noexcept {
    return open_ ? open_->preparation.rest_words : nothing_.rest_words;
  }
  [[nodiscard]] bool simulated() const noexcept;
  [[nodiscard]] bool recorded() const noexcept;
  [[nodiscard]] bool session_open() const noexcept { return open_.has_value(); }
  /// A trial, a zero or a protocol is running, or will go on by itself.
  [[nodiscard]] bool under_way() const noexcept;
  /// Why not all of the last session is in the database, where it is and what to do.
  [[nodiscard]] const std::optional<Error>& lost() const noexcept { return connection_.lost; }
  /// A session is open, or being opened or closed.
  [[nodiscard]] bool busy() const noexcept { return connection_.phase != Connection::none; }
  [[nodiscard]] const std::vector<Measure>& live_score() const noexcept;
  /// The last trial of this session; nothing: none yet.
  [[nodiscard]] const std::optional<session::TrialOutcome>& last_trial() const noexcept {
    return traces().last_trial;
  }
  [[nodiscard]] double worst_lateness_s() const noexcept { return traces().worst_lateness_s; }
  /// What the acquisition thread was given; empty: not asked for.
  [[nodiscard]] std::string realtime() const;
  /// A demonstration is being made or is on the patient's screen.
  [[nodiscard]] bool showing_how() const noexcept { return example_.showing(); }
  /// How the patient sits and sees; what is said of it is stored with the session.
  [[nodiscard]] Seating& seating() noexcept { return seating_; }
  [[nodiscard]] const Seating& seating() const noexcept { return seating_; }
  /// What the patient's screen shows now, on a content area of that height (0: not known).
  [[nodiscard]] PatientPicture picture(double picture_height_m = 0.0) const;
  /// A picture has appeared on the patient's screen: its age, and how large a force is on it, are
  /// kept with the trial.
  void picture_shown(const PatientPicture& picture);

  /// Takes the newest snapshot and news; called by the timer, 60 times a second.
  void poll();

 Q_SIGNALS:
  void changed();          ///< view() or a choice
  void library_changed();  ///< tasks() and protocols()
  void frame();            ///< a poll is over: snapshot() is as new as it gets
  void score_changed();    ///< live_score()
  void trial_ended();      ///< last_trial()
  void settled();          ///< busy() has ended in one way or the other: connected, refused, closed
  void failed(const QString& why);  ///< an act was refused

 private:
  // session_presenter.cpp: what is known, and what is new.
  [[nodiscard]] FlowFacts facts() const;
  void add_session_facts(FlowFacts& facts) const;
  void add_task_facts(FlowFacts& facts) const;
  void update();
  void refuse(const Error& error);
  void look_at_session();
  void take(const session::SessionNews& news);
  [[nodiscard]] const SessionTraces& traces() const noexcept {
    return open_ ? open_->traces : left_;
  }
  /// Nothing begins by itself until the next start.
  void hold();

  // session_presenter_choices.cpp
  void take_library(SessionLibrary library);
  void take_protocols(const std::optional<session::ReadyProtocol>& chosen);
  void ask_anew();
  void look_for_earlier();
  [[nodiscard]] int task_by_hand() const noexcept {
    return open_ ? open_->work.task : choices_.task;
  }
  /// The first of that kind; nothing: the library has none.
  [[nodiscard]] std::optional<int> first_task(bool (*fits)(const tasks::TaskSpec&)) const;
  void select(std::optional<int> task);
  void select_task_after_maximum();
  void look_at_task();

  // session_presenter_connection.cpp
  [[nodiscard]] session::SessionConfig session_config(bool clock_is_right) const;
  void take_opened(Result<std::unique_ptr<session::Session>> opened, const Presentation& stored);
  void begin_session(std::unique_ptr<session::Session> session, const Presentation& stored);
  void take_earlier_work();
  void close_session(const std::string& why);
  template <class Closed>
  void close_on_worker(std::unique_ptr<session::Session> session, Closed closed);
  void keep_broken_trial(const std::string& why);
  [[nodiscard]] bool broken_off() const noexcept {
    return connection_.failure && connection_.failure->broken_off;
  }

  // session_presenter_trials.cpp
  void begin_next();
  Result<void> begin_trial(const tasks::TaskSpec& spec, bool practice,
                           std::optional<storage::TrialPlace> place);
  void prepare_picture(const tasks::TaskSpec& spec, const tasks::TaskContext& context);
  void take_trial(const session::TrialOutcome& outcome);
  void take_progress(const tasks::TaskSpec& task);
  void watch_limits(const session::TrialOutcome& outcome);
  void store_rating();
  void ask_rating_anew();

  // session_presenter_protocol.cpp
  [[nodiscard]] ProtocolFacts protocol_facts() const;
  void begin_protocol();
  void look_at_act();
  void follow_time();
  void leave_out(const Error& why);
  [[nodiscard]] Result<tasks::TaskSpec> at_chosen_level(const tasks::TaskSpec& spec) const;

  // session_presenter_patient.cpp
  void take_zero(const session::ZeroOutcome& zero);
  void watch_compensation();
  [[nodiscard]] std::vector<storage::SessionAnswer> screen_answers() const;
  [[nodiscard]] PatientFacts patient_facts() const;
  void store_presentation();
  void say_smaller_gain(std::optional<double> shown);
  [[nodiscard]] Viewing viewing(double picture_height_m) const;

  /// What is shown while no session is open.
  struct Nothing {
    session::Snapshot snapshot;
    session::Compensation compensation;
    ProtocolGuide guide;
    Rating rating;
    std::string rest_words;
    std::vector<Measure> score;
  };

  GuiConfig config_;
  Clinic& clinic_;
  const SettingsFile& settings_;
  Seating seating_;
  QTimer timer_;
  SteadyClock clock_;
  const Nothing nothing_{};
  std::string operator_;  ///< who has logged in
  std::string database_error_;
  SessionLibrary library_;
  std::optional<SessionLibrary> newer_library_;  ///< read, waits for the end of a trial
  int lookups_ = 0;             ///< for an interrupted session: the newest one counts
  bool realtime_said_ = false;  ///< on standard error, once
  Choices choices_;
  ConnectionState connection_;
  std::optional<OpenSession> open_;
  SessionTraces left_;  ///< by the last session
  FlowView view_;
  DiskRoom room_{config_.database};  ///< after a session that broke off
  Background worker_;                ///< its jobs end before anything above goes away
  ExamplePlayer example_{worker_, clock_};
};

}  // namespace isograsp::gui
