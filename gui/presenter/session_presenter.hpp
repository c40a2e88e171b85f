// SPDX-License-Identifier: GPL-3.0-or-later
// Everything behind both windows except their pixels: the state that they show, where it stands in
// the flow, and the acts that change it, each kind in a class of its own. Knows no widget; all slow
// work runs on a worker. GUI thread.
#pragma once

#include <QObject>
#include <QTimer>

#include "gui/presenter/connecting.hpp"
#include "gui/presenter/library_in_use.hpp"
#include "gui/presenter/next_work.hpp"
#include "gui/presenter/patient_view.hpp"
#include "gui/presenter/preparing.hpp"
#include "gui/presenter/protocol_acts.hpp"
#include "gui/presenter/remarks.hpp"
#include "gui/presenter/session_choices.hpp"
#include "gui/presenter/task_acts.hpp"
#include "gui/presenter/trials.hpp"

namespace isograsp::gui {

class SessionPresenter final : public QObject {
  Q_OBJECT

 public:
  /// What it is given must outlive it.
  SessionPresenter(const GuiConfig& config, Clinic& clinic, PersonFile& file,
                   const SettingsFile& settings, QObject* parent = nullptr);
  ~SessionPresenter() override;

  // What windows show.
  [[nodiscard]] const SessionState& state() const noexcept { return state_; }
  [[nodiscard]] SessionFlow& flow() noexcept { return flow_; }
  [[nodiscard]] PatientView& patient_view() noexcept { return patient_view_; }

  // What people do, in the order of a session.
  [[nodiscard]] SessionChoices& choices() noexcept { return choices_; }
  /// How the patient sits and sees; what is said of it is stored with the session.
  [[nodiscard]] Seating& seating() noexcept { return seating_; }
  [[nodiscard]] LibraryInUse& library() noexcept { return library_; }
  [[nodiscard]] Connecting& connecting() noexcept { return connecting_; }
  [[nodiscard]] Preparing& preparing() noexcept { return preparing_; }
  [[nodiscard]] ProtocolActs& protocol() noexcept { return protocol_; }
  [[nodiscard]] TaskActs& tasks() noexcept { return tasks_; }
  [[nodiscard]] Trials& trials() noexcept { return trials_; }
  [[nodiscard]] Remarks& remarks() noexcept { return remarks_; }

  /// Takes the newest snapshot and news -> SessionFlow::frame(). Called by the timer, 60 times a
  /// second.
  void poll();

 private:
  void look_at_session();
  void look_at_device(const std::optional<DeviceFaultSeen>& before);

  SteadyClock clock_;
  SessionState state_;
  SessionFlow flow_;
  Seating seating_;
  Background worker_;  ///< its jobs end before anything above goes away
  ExamplePlayer example_;
  const ActContext context_;
  NextWork next_;
  SessionChoices choices_;
  LibraryInUse library_;
  Connecting connecting_;
  Preparing preparing_;
  ProtocolActs protocol_;
  TaskActs tasks_;
  Remarks remarks_;
  Trials trials_;
  PatientView patient_view_;
  QTimer timer_;
};

}  // namespace isograsp::gui
