// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen shows a tracked hand and the virtual object that it grasps: what is
// drawn is a function of one frame of the session. SI units; world W of the tracker (x right, y up,
// z to the viewer).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "hand_world/ground.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "tasks/looks/look.hpp"
#include "virtual_hand/assistance_level.hpp"
#include "virtual_hand/capsule.hpp"

namespace isograsp::gui {

struct PatientFacts;
struct PatientPicture;

/// What is drawn in three dimensions.
struct HandPicture {
  enum class Tip : std::uint8_t { bare, touches, tied };
  enum class Target : std::uint8_t {
    none,
    away,   ///< seen through, with a line from the object to it
    within  ///< opaque: the object is there
  };
  /// Where a digit touches the object.
  struct Mark {
    Vec3 p_W = Vec3::Zero();        ///< on the object [m]
    Vec3 normal_W = Vec3::UnitY();  ///< into it
    double radius_m = 0.0;          ///< of the digit there
  };
  /// How far the hand opens, as a bar.
  struct Opening {
    double gap_m = 0.0;  ///< from thumb to index, now
    double share = 0.0;  ///< of the bar, 0 … 1
  };

  /// Nothing: no hand has been seen. The hand that grasps; without an object that which is seen.
  std::optional<virtual_hand::HandInSpace> hand;
  /// The tracked one beside it.
  std::optional<virtual_hand::HandInSpace> tracked;
  double tracked_opacity = 0.0;  ///< 0: they are in the same place
  session::LinkRadii radii_m{};  ///< of both
  std::array<Tip, kDigitCount> tips{};
  std::array<std::optional<Mark>, kDigitCount> marks;
  bool frozen = false;  ///< it is not seen, and stands still: pale

  tasks::Look look = tasks::Look::plain;  ///< of the object
  std::optional<virtual_hand::ObjectShape> object;
  Pose X_WO;
  bool placed = false;  ///< purple: it was held at its target, and the hand is to open
  Target target = Target::none;
  Pose X_WT;
  hand_world::Ground ground;

  std::optional<virtual_hand::AssistanceLevel> assistance;  ///< of this placement
  std::optional<Opening> opening;
};

/// The bar of an opening is full at this gap [m]: more than a large hand spans.
inline constexpr double kFullOpening_m = 0.15;
/// The tracked hand is drawn where it is farther from the virtual one than this [m], and as clearly
/// as it ever is from the second distance on. In between it fades: nothing appears at once.
inline constexpr double kSamePlace_m = 0.008;
inline constexpr double kClearlyApart_m = 0.025;
inline constexpr double kMostOpacity = 0.45;

[[nodiscard]] HandPicture hand_picture(const session::HandSnapshot& now);

/// "Help: full" and the like, as it stands on the patient's screen.
[[nodiscard]] std::string help_words(virtual_hand::AssistanceLevel level);

/// Inside gui/picture/ only. @pre facts.tracked
/// Hand, object and words of a trial. @pre facts.task
void add_hand_trial(const PatientFacts& facts, PatientPicture& picture);
/// Of an entry test, or of a hand that has nothing to do: words that are there already stay.
void add_hand_between(const PatientFacts& facts, PatientPicture& picture);

}  // namespace isograsp::gui
