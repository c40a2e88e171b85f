// SPDX-License-Identifier: GPL-3.0-or-later
// Everything behind both windows except their pixels: the choices made, the open session, the
// running trial, the newest snapshot. Knows no widget; all slow work runs on a worker. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "gui/background.hpp"
#include "gui/clinic.hpp"
#include "gui/flow.hpp"
#include "gui/force_history.hpp"
#include "gui/patient_picture.hpp"
#include "session/demonstration.hpp"
#include "session/session.hpp"

namespace isograsp {

struct GuiConfig {
  std::string database;
  std::string device_uri;  ///< chosen at start; empty: the therapist chooses
  std::string library;     ///< folder with tasks/ and scenes/
  std::string software_version;
  std::string operator_name = {};        ///< stored with zero and resting force
  Realtime realtime = Realtime::prefer;  ///< of the acquisition thread
};

class SessionPresenter final : public QObject {
  Q_OBJECT

 public:
  SessionPresenter(const GuiConfig& config, Clinic& clinic, QObject* parent = nullptr);
  ~SessionPresenter() override;

  // Choices. Ignored while the flow does not allow them.
  void choose_patient(const std::string& code);
  void choose_hand(Hand hand);
  void choose_device(const std::string& uri);
  void choose_task(int index);
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
  void start_pause_resume();  ///< the one big key
  /// The patient's screen shows how the chosen task is done; again: it stops. So does any act.
  void show_how();
  void note(const std::string& text);

  [[nodiscard]] const FlowView& view() const noexcept { return view_; }
  [[nodiscard]] const Snapshot& snapshot() const noexcept { return snapshot_; }
  [[nodiscard]] const ForceHistory& forces() const noexcept { return forces_; }
  [[nodiscard]] const std::string& patient() const noexcept { return patient_; }
  [[nodiscard]] std::optional<Hand> hand() const noexcept { return hand_; }
  [[nodiscard]] const std::string& device_uri() const noexcept { return device_uri_; }
  [[nodiscard]] std::string device_description() const;
  [[nodiscard]] const std::vector<TaskSpec>& tasks() const noexcept { return tasks_; }
  /// Task files that could not be read, in words.
  [[nodiscard]] const std::vector<std::string>& library_problems() const noexcept {
    return library_problems_;
  }
  [[nodiscard]] int task() const noexcept { return task_; }
  [[nodiscard]] bool practice() const noexcept { return practice_; }
  [[nodiscard]] bool simulated() const noexcept;
  [[nodiscard]] bool recorded() const noexcept;
  [[nodiscard]] bool session_open() const noexcept { return session_ != nullptr; }
  /// A session is open, or being opened or closed.
  [[nodiscard]] bool busy() const noexcept { return connection_ != Connection::none; }
  [[nodiscard]] const std::vector<Measure>& live_score() const noexcept { return live_score_; }
  /// The last trial of this session; nothing: none yet.
  [[nodiscard]] const std::optional<TrialOutcome>& last_trial() const noexcept {
    return last_trial_;
  }
  [[nodiscard]] double worst_lateness_s() const noexcept { return worst_lateness_s_; }
  /// What the acquisition thread was given; empty: not asked for.
  [[nodiscard]] std::string realtime() const;
  /// A demonstration is being made or is on the patient's screen.
  [[nodiscard]] bool showing_how() const noexcept { return showing_how_; }
  /// What the patient's screen shows now.
  [[nodiscard]] PatientPicture picture() const;

  /// Takes the newest snapshot and news; called by the timer, 60 times a second.
  void poll();

 Q_SIGNALS:
  void changed();        ///< view() or a choice
  void frame();          ///< a poll is over: snapshot() is as new as it gets
  void score_changed();  ///< live_score()
  void trial_ended();    ///< last_trial()
  void settled();        ///< busy() has ended in one way or the other: connected, refused, closed
  void failed(const QString& why);  ///< an act was refused

 private:
  [[nodiscard]] FlowFacts facts() const;
  void update();
  void load_tasks();
  void select_first(TaskKind kind);
  void select_task_after_maximum();
  void look_at_task();
  void take(const SessionNews& news);
  void take_trial(const TrialOutcome& outcome);
  void begin_session(std::unique_ptr<Session> session);
  void close_session(const std::string& why);
  template <class Closed>
  void close_on_worker(std::unique_ptr<Session> session, Closed closed);
  void prepare_picture(const TaskSpec& spec, const TaskContext& context);
  void stop_showing();
  [[nodiscard]] PatientFacts facts_of_example() const;
  void refuse(const Error& error);

  GuiConfig config_;
  Clinic& clinic_;
  QTimer timer_;
  SteadyClock clock_;
  std::string database_error_;
  std::string patient_;
  std::optional<Hand> hand_;
  std::string device_uri_;
  std::vector<TaskSpec> tasks_;
  std::vector<std::string> library_problems_;
  int task_ = -1;
  std::string task_lacks_;  ///< what the chosen task is scaled to and has not been measured
  bool practice_ = false;

  Connection connection_ = Connection::none;
  std::string connection_error_;
  std::stop_source opening_;  ///< of the newest connect_device()
  std::unique_ptr<Session> session_;
  Timestamp opened_{0};
  Snapshot snapshot_;
  ForceHistory forces_;
  double worst_lateness_s_ = 0.0;
  std::string zero_refusal_;
  bool zero_only_changed_ = false;
  std::string zero_remark_;
  bool strapped_ = false;
  std::string rest_words_;
  bool realtime_said_ = false;  ///< on standard error, once
  bool rest_done_ = false;
  int maximum_attempts_ = 0;
  bool task_done_ = false;
  bool zero_asked_ = false;  ///< and its outcome has not come: the session takes nothing else
  bool starting_ = false;
  bool just_completed_ = false;
  std::shared_ptr<const TaskSpec> running_;
  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<const TargetPreview> preview_;
  bool showing_how_ = false;
  std::shared_ptr<const Demonstration> example_;  ///< null: none, or it is being made
  std::shared_ptr<const TargetPreview> example_preview_;
  std::size_t example_frame_ = 0;
  Timestamp example_began_{0};
  std::vector<Measure> live_score_;
  Timestamp scored_{0};
  std::optional<TrialOutcome> last_trial_;
  FlowView view_;
  Background worker_;  ///< last: its jobs end before anything else goes away
};

}  // namespace isograsp
