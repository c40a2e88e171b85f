// SPDX-License-Identifier: GPL-3.0-or-later
// What a person in front of the device can see, and what their fingers answer. This is all that a
// person (real or virtual) gets to know of the task. What is not on the screen is not in it: a
// hidden force or target is 0 here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/spatial.hpp"
#include "hand/arm_links.hpp"
#include "hand/cue.hpp"
#include "hand/finger.hpp"
#include "hand/force_channel.hpp"
#include "hand/hands.hpp"

namespace isograsp {

/// Forces asked of single digits, contact frames [N]; `shown[f]`: there is one for finger f.
struct DigitTargets {
  std::array<bool, kFingerCount> shown{};
  std::array<Vec3, kFingerCount> force_C{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  [[nodiscard]] bool any() const noexcept { return shown[0] || shown[1] || shown[2]; }
};

/// How far the task on the screen has come.
struct ShownProgress {
  bool getting_ready = false;  ///< nothing counts yet
  bool holding = false;        ///< what was reached is to be kept
  double task_time_s = 0.0;    ///< stands still in a pause
  double duration_s = 0.0;     ///< expected; 0: no bar
  int segment = 0;             ///< which part of the task, from 0
  int target_index = -1;       ///< which of target_count
  int target_count = 0;
  int targets_reached = 0;
  double hold_fraction = 0.0;  ///< 0 … 1: the ring of a hold
};

/// How cameras see the object that is on the screen. Whoever is not seen draws nothing new: what is
/// shown is the last pose, pale where that is too old to stand in.
enum class ObjectSight : std::uint8_t {
  unknown,  ///< no cameras look at it, or they have not seen it yet
  seen,
  held,   ///< for a moment its last pose stands in
  unseen  ///< for longer
};

/// An angle of the own body that is asked for: its range is drawn as it grows.
struct ShownAngle {
  bool shown = false;
  bool seen = false;  ///< now
  double now_rad = 0.0;
  bool ranged = false;  ///< the next two are there
  double least_rad = 0.0;
  double largest_rad = 0.0;
};

/// An object that exists on the screen alone, as it is drawn: its shape, and what its colour says.
struct ShownObject {
  enum class Shape : std::uint8_t {
    box,
    cylinder  ///< along z of the object
  };
  Shape shape = Shape::box;
  Vec3 size_m = Vec3::Zero();  ///< edges; of a cylinder diameter, diameter, length
  bool let_go = false;         ///< purple: it was placed, and the hand is to open
};

/// What the screen shows of one of two hands; what is not shown is 0.
struct ShownHand {
  Cue cue = Cue::relax;
  bool target_shown = false;
  double target_force_N = 0.0;
  bool force_shown = false;
  double force_N = 0.0;
};
/// An object that both hands lift. World axes; a turn is about z.
struct ShownTray {
  Vec3 size_m = Vec3::Zero();
  Pose X_WO;
  Vec3 v_WO_W = Vec3::Zero();                       ///< [m/s]; used to draw it where it is now
  Vec3 w_WO_W = Vec3::Zero();                       ///< [rad/s]
  OfHands<Vec3> end_O{Vec3::Zero(), Vec3::Zero()};  ///< where the hands are on it, object axes
  OfHands<bool> touches;
  OfHands<bool> slips;        ///< the hand is about to slide off
  bool target_shown = false;  ///< false: X_WT is that of its rest
  Pose X_WT;
  Pose X_WR;              ///< where it rests
  double band_m = 0.0;    ///< to either side of the height of X_WT
  double band_rad = 0.0;  ///< to either side of level
  bool fetched = false;   ///< it was dropped and is brought back
};
/// A hand that is a point on the screen, in its bubble.
struct ShownPoint {
  Vec3 p_W = Vec3::Zero();
  Vec3 bubble_W = Vec3::Zero();  ///< its middle
  bool beyond = false;           ///< pressed beyond its edge, the bubble moves
};
/// An object that both hands, as points, take and carry. World axes.
struct ShownCarry {
  Vec3 size_m = Vec3::Zero();
  Pose X_WO;
  Vec3 v_WO_W = Vec3::Zero();       ///< [m/s]; used to draw it where it is now
  Vec3 half_size_m = Vec3::Zero();  ///< of the bubbles
  OfHands<ShownPoint> of;
  bool held = false;    ///< by both hands
  bool clutch = false;  ///< the clutch is held: the points stay
  bool target_shown = false;
  Pose X_WT;
  double tolerance_m = 0.0;
  bool fetched = false;  ///< it was dropped and is brought back
};
/// Of two hands at once, and of their sum.
struct ShownHands {
  OfHands<ShownHand> of;
  ShownHand sum;                                   ///< its cue says nothing
  std::optional<ShownTray> tray = std::nullopt;    ///< nothing: they lift nothing
  std::optional<ShownCarry> carry = std::nullopt;  ///< nothing: they carry nothing
};

/// One picture of the patient's screen.
struct Stimulus {
  double t_s = 0.0;              ///< session time of the picture [s]
  Cue cue = Cue::hand_out;       ///< what is to be done now; in a pause: relax
  Cue page_cue = Cue::hand_out;  ///< of the page on which a pause shows its notice
  ShownProgress progress;
  ForceChannel channel;  ///< which force the cue is about
  bool force_target_shown = false;
  double target_force_N = 0.0;
  bool force_shown = true;     ///< false: feedback is off, the next value is not on the screen
  double shown_force_N = 0.0;  ///< the force of the channel
  DigitTargets digit_targets;
  /// Own force of the digits that one is asked of, contact frames [N].
  std::array<Vec3, kFingerCount> digit_force_C{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::optional<ShownHands> hands;            ///< a task of both; nothing: one hand is asked
  bool object_shown = false;                  ///< the object and what follows are on the screen
  std::optional<ShownObject> virtual_object;  ///< a hand is to grasp it; nothing: another object
  ObjectSight sight = ObjectSight::unknown;
  Pose X_WO;                   ///< of a real object that is out of sight: where it was seen last
  Vec3 v_WO_W = Vec3::Zero();  ///< [m/s]; used to draw it where it is now
  Vec3 w_WO_W = Vec3::Zero();  ///< [rad/s]
  bool pose_target_shown = false;  ///< false: X_WT is that of the object
  Pose X_WT;
  /// Of an arm: this angle is to be turned to and fro, as far as it goes.
  std::optional<LinkAngle> turn;
  bool pose_matched = false;  ///< the target is reached; it stays in view for a moment
  ShownAngle angle;
  std::array<bool, kFingerCount> contact{};    ///< virtual finger touches (drawn green)
  std::array<double, kFingerCount> press_N{};  ///< >= 0, by which a virtual finger approaches
};

/// A source of finger forces that reacts to what it sees. One thread uses it.
class FingerSource {
 public:
  virtual ~FingerSource() = default;
  /// A new picture; called once per frame with increasing time. Real-time safe.
  virtual void see(const Stimulus& stimulus) noexcept = 0;
  /// The wrenches [N, N m] of the fingertips on the contacts at time t_s, contact frames. Called
  /// with non-decreasing time, at 1 kHz by the simulated device. Real-time safe.
  [[nodiscard]] virtual FingerWrenches press(double t_s) noexcept = 0;
};

}  // namespace isograsp
