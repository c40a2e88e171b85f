// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands that are points take an object and carry it, frame by frame: bubbles or clutch, the
// grasp, and what holds the object, a magnetic pinch or soft pads (docs/bimanual.md, "Carrying in a
// session"). What nobody holds stands still. SI units, world axes.
#pragma once

#include <memory>

#include "bimanual/carried_object.hpp"
#include "bimanual/pads/held_by_pads.hpp"
#include "bimanual/read_hands.hpp"
#include "bimanual/two_hands.hpp"
#include "core/result.hpp"

namespace isograsp::bimanual {

/// How hands explore and hold (Talvas et al.: the four conditions of their study).
struct Technique {
  bool clutch = false;  ///< else bubbles that move beyond their edges
  bool pinch = false;   ///< magnetic pinch and joint control; else pads hold by friction
  bool operator==(const Technique&) const = default;
};

/// The scene with this technique. Refused: no coupling "proxy", no [grasp_detection], a pinch
/// without [magnet], no pinch without a [[pad]] for each hand, an object that leaves the plane of
/// the screen (so the view never turns), or that turns while pads hold it.
[[nodiscard]] Result<HandsScene> with_technique(HandsScene scene, const Technique& technique);

class CarryingHands {
 public:
  /// For frames of `period_s`. @pre with_technique()
  [[nodiscard]] static Result<CarryingHands> compile(const HandsScene& scene, double period_s);
  CarryingHands(CarryingHands&&) noexcept;
  CarryingHands& operator=(CarryingHands&&) noexcept;
  ~CarryingHands();

  // Every frame, in this order. Real-time safe.
  /// Hands and bubbles stand where the scene says, untouched.
  void begin_hands() noexcept;
  /// The object stands here, at rest, in no hand.
  void put(const Pose& X_WO) noexcept;
  /// What the hands do from now on; pushes along axes that the object cannot move in do nothing.
  void see(const HandsInput& input) noexcept;
  /// Until the next frame. @pre see()
  void move() noexcept;

  [[nodiscard]] const HandsScene& scene() const noexcept;
  [[nodiscard]] const HandsState& hands() const noexcept;
  /// Push of each hand towards the other [N].
  [[nodiscard]] const std::array<double, kSides>& squeeze_N() const noexcept;
  [[nodiscard]] const ObjectState& object() const noexcept;
  /// Both hands hold the object.
  [[nodiscard]] bool held() const noexcept;
  /// Their bubbles move as one.
  [[nodiscard]] bool joint() const noexcept;

 private:
  struct Parts;
  explicit CarryingHands(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace isograsp::bimanual
