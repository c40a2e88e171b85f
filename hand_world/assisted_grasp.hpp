// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand that grasps one virtual object, with or without help: frames of the tracker in,
// everything that happens to hand and object out. It owns the world, the virtual hand and what
// drags it, the search for feasible grasps and the states of the digits (docs/virtual_hand.md, "A
// grasp, frame by frame"). The same calls give the same bits. SI units, world y up. One thread.
//
// Real-time safe but for the constructor: frame(), place() and all others neither allocate nor
// throw.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hand_world/tracked_target.hpp"
#include "hand_world/world.hpp"
#include "virtual_hand/assistance_level.hpp"
#include "virtual_hand/grasp_criteria.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::hand_world {

using virtual_hand::assistance_level;
using virtual_hand::AssistanceLevel;

/// Ties of an object of this mass; of `off`: those of `full`, which nothing uses.
[[nodiscard]] virtual_hand::TieGains tie_gains(AssistanceLevel level, double mass_kg,
                                               const WorldRules& rules) noexcept;

/// What is grasped.
struct GraspObject {
  ObjectBody body;
  virtual_hand::GraspLimits limits;  ///< of a feasible grasp of it
};
[[nodiscard]] GraspObject grasp_object(const virtual_hand::StudyObject& object) noexcept;
/// Where an object of the study stands at first, about (x, z) of the table: upright, on its block
/// or on the table; a slim one lies along x.
struct StartPlace {
  Ground ground;
  Pose X_WO;
};
[[nodiscard]] StartPlace start_place(const virtual_hand::StudyObject& object, double table_m,
                                     double x_m, double z_m) noexcept;

/// One digit after a frame.
struct DigitGrasp {
  virtual_hand::DigitState state = virtual_hand::DigitState::free;
  bool touching = false;
  /// Of its tie once it is 2 mm away; in the frame in which it lets go that at which it did; 0:
  /// it is not tied.
  double pull_N = 0.0;
  double normal_N = 0.0;  ///< largest of its links
  double gap_m = 0.0;     ///< from the object; World::kMargin_m stands for more
};

/// Everything that a row of a recording, a page of the therapist and a replay need of one frame.
struct GraspState {
  bool hand_there = false;    ///< a hand was seen, and a virtual one moves
  bool object_there = false;  ///< between place() and clear()
  bool frozen = false;        ///< the hand was not seen in this frame: nothing moved
  AssistanceLevel level = AssistanceLevel::off;
  bool releasing = false;  ///< nothing new is tied: the person is to let go
  bool helped = false;     ///< the object was let go for the person

  ObjectMotion object;
  virtual_hand::HandPose hand;               ///< the virtual one: palm and angles
  std::array<Vec3, kHandJointCount> joints;  ///< of the virtual hand [m]; without one: NaN
  std::array<DigitGrasp, kDigitCount> digits;
  bool supported = false;  ///< it is less than 5 mm above table or block
  bool held = false;       ///< a digit is tied to it, or two touch it

  virtual_hand::GraspChoice choice;  ///< best set of the digits that touch, against its limits
  /// Largest distance between the middles of palm and links and those of the tracked hand [m].
  double tracked_gap_m = 0.0;
  SolverReport solver;  ///< most sweeps and largest residual of the frame's steps
};

class AssistedGrasp {
 public:
  static constexpr double kStep_s = 0.001;  ///< of the world; a frame has as many as fit in it
  /// Where the tracked hand was lost, or its palm jumps faster than a hand moves
  /// (kMostTracked_m_s), the virtual one is led to it on a path of least jerk, whose acceleration
  /// is that for which the ties are made.
  static constexpr double kCatchUp_m_s2 = virtual_hand::TieDesign{}.acceleration_m_s2;
  static constexpr double kPlacedPull = 1.0 / 3.0;  ///< a stretch of 2 mm in place of 6 mm
  /// Contacts that move so little on the object, or whose normals turn so little, are the same
  /// ones: the best grasp is not looked for again.
  static constexpr double kSamePlace_m = 0.001;
  static constexpr double kSameNormal_rad = 0.05;

  /// `frame_s`: between two frames of the session, a whole number of steps.
  AssistedGrasp(const virtual_hand::HandModel& hand, double frame_s, const WorldRules& rules = {});

  /// A placement begins: the object stands still there, nothing is tied, the hand stays where it
  /// is.
  void place(const GraspObject& object, const StartPlace& at, AssistanceLevel level) noexcept;
  /// The object of this placement again where it was at first: after a drop.
  void reset() noexcept;
  /// From now on nothing new is tied, the first digit that lets go takes the others with it, and a
  /// pull of kPlacedPull times what it was is enough: the object was placed and the hand is to
  /// open. Ties hold a virtual hand back that follows one which opens little.
  void release() noexcept;
  /// Helps: ties end, and the object falls through the hand until the next place() or reset().
  void let_go() noexcept;
  /// No object any more; the hand goes on.
  void clear() noexcept;

  /// One frame of the session. `held`: the hand is not seen and stands still; so does everything
  /// else, ties and running times stay as they are. So it is with a frame of which a joint is
  /// missing. Before a first frame shows a hand the object alone moves.
  void frame(const HandFrame& hand, bool held) noexcept;

  /// After the last frame, or as placed.
  [[nodiscard]] const GraspState& state() const noexcept { return state_; }
  [[nodiscard]] const virtual_hand::HandModel& model() const noexcept { return model_; }
  /// Ties as they are in this placement.
  [[nodiscard]] const virtual_hand::TieGains& gains() const noexcept { return gains_; }

 private:
  using Contacts = std::array<std::optional<virtual_hand::DigitContact>, kDigitCount>;
  /// The way on which the virtual hand is led to the tracked one after a jump.
  struct CatchUp {
    HandTarget from;
    double since_s = 0.0;
    double lasts_s = 0.0;
  };

  void stand_object() noexcept;
  /// Where the hand is to be led to in the end of a frame that shows it there.
  [[nodiscard]] HandTarget led_to(const HandTarget& seen) noexcept;
  void step(const HandTarget& target) noexcept;
  /// A digit lets go now, and what the others are tied at does not close without it, or is to be
  /// let go anyway.
  [[nodiscard]] bool lets_go_in_part() const noexcept;
  [[nodiscard]] bool as_chosen(const Contacts& now) const noexcept;
  void choose() noexcept;
  void publish() noexcept;
  [[nodiscard]] double t_s() const noexcept { return static_cast<double>(ticks_) * kStep_s; }

  virtual_hand::HandModel model_;
  double hand_scale_m_;
  double frame_s_;
  int steps_;
  WorldRules rules_;
  World world_;
  virtual_hand::Assistance assistance_{0.0};
  virtual_hand::TieGains gains_;
  GraspObject object_;
  StartPlace start_;
  AssistanceLevel level_ = AssistanceLevel::off;
  bool object_there_ = false;
  bool releasing_ = false;
  bool helped_ = false;
  Contacts chosen_of_;  ///< where the digits touched when the choice was made
  virtual_hand::GraspChoice choice_;

  HandTarget seen_;  ///< the tracked hand as it was seen last
  HandTarget led_;   ///< where the virtual one is led to now
  std::optional<CatchUp> catch_up_;
  bool lost_ = false;
  std::int64_t ticks_ = 0;  ///< steps of the world: its time stands still while the hand is lost
  SolverReport report_;     ///< worst of the frame
  std::array<double, kDigitCount> let_go_at_N_{};  ///< in this frame; 0: it did not
  GraspState state_;
};

}  // namespace isograsp::hand_world
