// SPDX-License-Identifier: GPL-3.0-or-later
// How postures of a file are drawn: on an arm of average size, with a rig of the library that has
// the same chain. For looking at: no session takes anything from here.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gui/picture/arm_space.hpp"
#include "gui/picture/patient_picture.hpp"
#include "kinematics/postures.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class PostureScene {
 public:
  /// The rig is the first of LIBRARY/rigs, by name, with that chain. Without one the object is
  /// drawn in a size of its own, and the axes are those of the first segment.
  PostureScene(const std::string& library, std::vector<std::string> chain);

  [[nodiscard]] const std::vector<std::string>& chain() const noexcept { return chain_; }
  /// Not null.
  [[nodiscard]] const std::shared_ptr<const ArmSpace>& space() const noexcept { return space_; }

  /// Poses of the segments of the chain [m]. @pre postures.chain == chain()
  [[nodiscard]] std::vector<Pose> segments_W(const Posture& posture) const;
  /// The arm in the posture at `index`; the target is the object of the initial one.
  [[nodiscard]] session::ArmSnapshot arm_in(const Postures& postures, std::size_t index) const;
  /// What a patient of that size sees when that posture is the target and the arm is still in the
  /// initial one.
  [[nodiscard]] PatientPicture picture_of(const Postures& postures, std::size_t index) const;

 private:
  std::vector<std::string> chain_;
  Pose X_WE_;  ///< of the first segment
  std::shared_ptr<const ArmSpace> space_;
};

}  // namespace isograsp::gui
