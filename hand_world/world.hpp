// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual hand and one object, stepped at 1 kHz: coupling, contacts, ties, a table
// (docs/virtual_hand.md, "The step"). The same calls give the same bits. A step neither allocates
// nor throws. World: y up. SI units. One thread.
#pragma once

#include <array>
#include <optional>

#include "hand_world/contact_solver.hpp"
#include "hand_world/ground.hpp"
#include "hand_world/hand_body.hpp"
#include "hand_world/rigid_object.hpp"
#include "hand_world/tie.hpp"

namespace isograsp::hand_world {

struct WorldRules {
  Vec3 gravity_W{0.0, -9.81, 0.0};
  virtual_hand::PadFriction pad;  ///< of the hand on the object
  double ground_friction = 0.5;   ///< of the object on what it stands on
  HandDynamics dynamics;
};

/// What a pad gives: a spring of kGiving_1_s / kSoftness_m_N_s = 20 kN/m and a damper beside it.
struct PadLaw {
  static constexpr double kSoftness_m_N_s = 0.01;
  /// A depth that is left closes at this rate: a fifth in 1 ms …
  static constexpr double kGiving_1_s = 200.0;
  static constexpr double kMost_m_s = 0.5;  ///< … but no faster than this
  /// Bias of the normal velocity of a contact whose gap is `gap_m`; negative: what overlaps.
  [[nodiscard]] static double bias_m_s(double gap_m, double step_s) noexcept;
};

/// A pad that stands still and presses with a given force (`isograsp hand squeeze`).
struct FixedPad {
  Vec3 p_W = Vec3::Zero();
  Vec3 normal_W = Vec3::UnitX();  ///< into the object
  double force_N = 0.0;
};

/// What one digit does.
struct DigitTouch {
  bool contact = false;
  double normal_N = 0.0;  ///< largest of its links
  double gap_m = 0.0;     ///< from the object; kMargin_m stands for more
  TouchPoint at;          ///< where that force acts; of the last contact if there is none now
};

class World {
 public:
  /// Gaps above this are not looked at.
  static constexpr double kMargin_m = 0.005;
  /// A digit that lets go does not touch for this time: it would push away what it held.
  static constexpr double kSilent_s = 0.15;
  static constexpr std::size_t kPads = 2;
  static constexpr std::size_t kLed = 5;

  World(const ObjectBody& object, const WorldRules& rules) noexcept;

  /// A hand that stands still there.
  void place_hand(const virtual_hand::HandModel& model,
                  const virtual_hand::HandPose& pose) noexcept;
  void place_object(const ObjectMotion& motion) noexcept;
  /// Another object takes the place of this one: it stands still at the origin, nothing touches it
  /// and nothing is tied.
  void take_object(const ObjectBody& object) noexcept;
  /// The hand goes through the object as if it were air; ties stay.
  void let_through(bool through) noexcept { through_ = through; }
  /// The largest force that drags a link of the hand [N].
  void set_link_most(double most_N) noexcept;
  void place_ground(const Ground& ground) noexcept { ground_ = ground; }
  /// Pads press from now on. @pre fewer than kPads do
  void add_pad(const FixedPad& pad) noexcept { pads_[pad_count_++] = pad; }
  /// The object hangs on a point that is led. Returns its number. @pre fewer than kLed do
  std::size_t hang(const Vec3& p_O, double stiffness_N_m, double damping_N_s_m) noexcept;
  /// Where that point is in the middle of the coming step.
  void lead(std::size_t number, const Vec3& p_W, const Vec3& v_W) noexcept {
    led_[number]->lead(p_W, v_W);
  }

  /// One step. `target`: the tracked hand in the middle of it; without a hand it is not read.
  void step(double step_s, const HandTarget& target) noexcept;
  /// Without a hand.
  void step(double step_s) noexcept { step(step_s, HandTarget()); }

  /// Ties and lets go as the states of the digits say; a digit that never touched is not tied.
  void tie(const std::array<virtual_hand::DigitState, kDigitCount>& states,
           const virtual_hand::TieGains& gains) noexcept;

  /// Null: there is none.
  [[nodiscard]] const HandBody* hand() const noexcept { return hand_ ? &*hand_ : nullptr; }
  [[nodiscard]] const RigidObject& object() const noexcept { return object_; }
  [[nodiscard]] const std::array<DigitTouch, kDigitCount>& touches() const noexcept {
    return touches_;
  }
  [[nodiscard]] bool tied(Digit digit) const noexcept { return ties_[index_of(digit)].has_value(); }
  /// Where a digit is tied to the object; nothing: it is not.
  [[nodiscard]] std::optional<virtual_hand::DigitContact> tie_of(Digit digit) const noexcept;
  /// It stands on table or block, or is less than kMargin_m above them: what hops under a finger
  /// was not lifted.
  [[nodiscard]] bool supported() const noexcept { return supported_; }
  /// Row of the assistance at a time, without its feasible grasp. The pull of a digit is the effort
  /// of its spring once it is Assistance::kReleaseGap_m away, or, once the object is `placed`, does
  /// not touch; who touches does not let go.
  [[nodiscard]] virtual_hand::AssistanceRow assistance_row(double t_s,
                                                           bool placed = false) const noexcept;
  /// Where a digit touches, for the criteria; nothing: it does not.
  [[nodiscard]] std::optional<virtual_hand::DigitContact> contact_of(Digit digit) const noexcept;
  [[nodiscard]] const SolverReport& solver_report() const noexcept { return report_; }
  [[nodiscard]] std::span<const ContactBlock> contacts() const noexcept { return solver_.blocks(); }

 private:
  // Numbers of what may touch: links of the digits, metacarpals, points on the ground, base, pads.
  static constexpr std::size_t kLinks = kDigitCount * kLinkCount;
  static constexpr std::size_t kHandParts = kLinks + kDigitCount - 1;
  static constexpr std::size_t kBase = kHandParts + SupportPoints::kNumbers;
  static constexpr std::size_t kSlots = kBase + 1 + kPads;
  /// Contacts of the hand, the deepest ones; the ground has its points, a base and the pads.
  static constexpr std::size_t kHandContacts =
      ContactSolver::kMost - SupportPoints::kMost - 1 - kPads;

  /// What a contact did in the last step: where this one begins.
  struct Memory {
    bool there = false;
    double normal_N = 0.0;
    Vec3 tangential_W = Vec3::Zero();
    double torque = 0.0;
    double slip_angle = 0.5;
  };
  struct Frame {
    std::size_t slot = 0;
    Vec3 p_W;
    Mat3 R_WC;  ///< columns: normal into the object, two tangents
  };
  struct Near {
    std::size_t part = 0;
    double gap_m = 0.0;
    Vec3 p_W;
    Vec3 normal_W;
  };

  void find_hand_contacts(const Pose& X_WO, const ArrowVector& now, double step_s) noexcept;
  void find_ground_contacts(const Pose& X_WO, const ArrowVector& now, double step_s) noexcept;
  void press_pads(const Pose& X_WO) noexcept;
  ContactBlock& add_contact(std::size_t slot, const Vec3& p_W, const Vec3& normal_W,
                            const Pose& X_WO) noexcept;
  void add_hand_rows(ContactBlock& block, std::size_t part, const Vec3& p_W) const noexcept;
  void remember(const Pose& X_WO) noexcept;

  WorldRules rules_;
  RigidObject object_;
  std::optional<HandBody> hand_;
  std::optional<Ground> ground_;
  std::array<FixedPad, kPads> pads_;
  std::size_t pad_count_ = 0;
  std::array<std::optional<Tie>, kLed> led_;
  std::array<std::optional<Tie>, kDigitCount> ties_;
  std::array<double, kDigitCount> silent_s_{};
  std::array<DigitTouch, kDigitCount> touches_;
  std::array<bool, kDigitCount> touched_{};
  bool through_ = false;
  bool supported_ = false;

  FactoredArrow matrix_;
  ContactSolver solver_;
  SolverReport report_;
  std::array<Memory, kSlots> memory_;
  std::array<Frame, ContactSolver::kMost> frames_;
};

}  // namespace isograsp::hand_world
