// SPDX-License-Identifier: GPL-3.0-or-later
// What both hands lift in a trial on two platforms: the object of a scene with coupling "force", as
// heavy as the task makes it for these hands, and how it answers to their pushes. SI units.
#pragma once

#include <optional>
#include <string>

#include "bimanual/lift_demand.hpp"
#include "bimanual/pressed_by_hands.hpp"
#include "core/result.hpp"
#include "device/config/platform.hpp"
#include "hand/hands.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

class LiftedObject {
 public:
  /// That of the scene which the task names, for holds of context.period_s. Refused where the scene
  /// cannot be read, compiled or lifted. While the maximum of a hand is not known it is as heavy as
  /// the scene says. @pre spec.hands_load()
  [[nodiscard]] static Result<LiftedObject> read(const tasks::TaskSpec& spec,
                                                 const tasks::TaskContext& context,
                                                 const std::string& library);
  /// The same from the text of a scene, its strength given. For replays and tests.
  [[nodiscard]] static Result<LiftedObject> make(const std::string& scene, const std::string& file,
                                                 double strength, double period_s);

  [[nodiscard]] const Scene& scene() const noexcept { return scene_.object; }
  /// Masses, springs and dampers of the scene were multiplied by this.
  [[nodiscard]] double strength() const noexcept { return strength_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

  // Every frame, in this order. Real-time safe.
  /// It stands where the scene says, untouched.
  void begin(LiftedView& view) noexcept;
  /// The hands press like this from now on, in the axes of the view [N].
  void press(const OfHands<Vec3>& push_W, LiftedView& view) noexcept;
  /// Until the next frame.
  void move(LiftedView& view) noexcept;
  /// Likewise; the hands do nothing to it, it is at rest at `X_WO`.
  void stay(const Pose& X_WO, LiftedView& view) noexcept;

  /// The object as one hand meets it: half of it, which its three fingers push on their platform,
  /// and which pushes back by what the hand is to squeeze at `height_m`.
  [[nodiscard]] Scene half_of(Hand hand, const Platform& platform, double height_m) const;

 private:
  LiftedObject(bimanual::HandsScene scene, bimanual::PressedByHands pressed, double strength,
               std::string text);

  bimanual::HandsScene scene_;
  bimanual::PressedByHands pressed_;
  bimanual::PressedState state_;
  bimanual::PressedWrench wrench_;
  double strength_;
  std::string text_;
};

}  // namespace isograsp::session
