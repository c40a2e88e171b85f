// SPDX-License-Identifier: GPL-3.0-or-later
// What both hands carry in a trial on two platforms: the object of a scene with coupling "proxy",
// bubbles and grasp by what each of these hands can do, and how it answers to their pushes. SI
// units.
#pragma once

#include <string>

#include "bimanual/carrying_hands.hpp"
#include "core/result.hpp"
#include "device/config/platform.hpp"
#include "hand/hands.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"
#include "tasks/carry_forces.hpp"
#include "tasks/task.hpp"
#include "virtual_patient/carry_skill.hpp"

namespace isograsp::session {

/// What a trial takes from these hands.
struct CarrySetup {
  OfHands<tasks::CarryForces> of;
  double left_share = 0.5;  ///< weight of the left hand while bubbles move as one
};

class CarriedByHands {
 public:
  /// That of the scene which the task names, for frames of context.period_s. Refused where the
  /// scene cannot be read or used. While the maximum of a hand is not known its forces are those of
  /// the scene. @pre spec.hands_carry()
  [[nodiscard]] static Result<CarriedByHands> read(const tasks::TaskSpec& spec,
                                                   const tasks::TaskContext& context,
                                                   const std::string& library);
  /// The same from the text of a scene, forces given. For replays and tests.
  [[nodiscard]] static Result<CarriedByHands> make(const std::string& scene,
                                                   const std::string& file,
                                                   const tasks::HandsCarry& carry,
                                                   const CarrySetup& setup, double period_s);

  [[nodiscard]] const CarrySetup& setup() const noexcept { return setup_; }
  [[nodiscard]] const bimanual::HandsScene& scene() const noexcept { return hands_.scene(); }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

  // Every frame, in this order. Real-time safe.
  void begin(CarriedView& view) noexcept;
  /// The hands do this from now on: pushes in the axes of the view [N].
  void press(const OfHands<Vec3>& push_W, bool clutch, CarriedView& view) noexcept;
  /// Until the next frame.
  void move(CarriedView& view) noexcept;
  /// Likewise, but the object stands at `X_WO` in no hand; `home`: the hands begin anew, too.
  void stay(const Pose& X_WO, bool home, CarriedView& view) noexcept;

  /// What a simulated person learns of it by handling it.
  [[nodiscard]] virtual_patient::CarryKnown known_to(Hand hand, const Platform& platform) const;

 private:
  CarriedByHands(bimanual::CarryingHands hands, const CarrySetup& setup, std::string text);
  void show(CarriedView& view) const noexcept;

  bimanual::CarryingHands hands_;
  CarrySetup setup_;
  std::string text_;
};

}  // namespace isograsp::session
