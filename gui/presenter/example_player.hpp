// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the patient how a task is done: a demonstration is made on the worker, then played on the
// patient's screen at its own pace. GUI thread.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/time.hpp"
#include "gui/clinic/background.hpp"
#include "gui/picture/patient_picture.hpp"
#include "session/demonstration.hpp"

namespace isograsp::gui {

class ExamplePlayer {
 public:
  /// Both must outlive it.
  ExamplePlayer(Background& worker, const Clock& clock) : worker_(worker), clock_(clock) {}

  /// `changed` is called when it begins to play, or with the error why it cannot.
  void show(const tasks::TaskSpec& spec, const session::DemonstrationFor& whom,
            const std::string& library, std::function<void(Result<void>)> changed);
  void stop();
  /// Being made, or played.
  [[nodiscard]] bool showing() const noexcept { return showing_; }
  [[nodiscard]] bool playing() const noexcept { return example_ != nullptr; }
  /// Goes to the frame of this moment; at the end it stops.
  void tick();
  /// What the patient's screen shows. @pre playing()
  [[nodiscard]] PatientFacts facts() const;

 private:
  Background& worker_;
  const Clock& clock_;
  bool showing_ = false;
  int request_ = 0;  ///< the newest one: what older ones made is dropped
  Hand hand_ = Hand::right;
  std::shared_ptr<const session::Demonstration> example_;
  std::shared_ptr<const TargetPreview> preview_;
  std::shared_ptr<const ArmSpace> arm_space_;  ///< null: it is no arm
  std::size_t frame_ = 0;
  Timestamp began_{0};
};

}  // namespace isograsp::gui
