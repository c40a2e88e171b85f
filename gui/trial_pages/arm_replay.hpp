// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial of an arm at any instant: what the cameras saw, as it was recorded, row by row.
// Nothing is put between two rows, and of what was not seen nothing is drawn but, pale, where the
// object was last. Poses in the frame W of the cameras, of a left arm in its reflection [m].
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/picture/arm_space.hpp"
#include "gui/trial_pages/recorded_values.hpp"
#include "gui/trial_pages/trial_replay.hpp"
#include "session/arm/arm_snapshot.hpp"
#include "storage/records/records.hpp"

namespace isograsp::gui {

class ArmReplay {
 public:
  /// Its rows hold markers.
  [[nodiscard]] static bool is_of_arm(const TrialReplay& replay) noexcept;
  /// Errors: the rig that is stored with the session cannot be read. @pre is_of_arm(replay)
  [[nodiscard]] static Result<ArmReplay> make(const storage::SessionRecord& session,
                                              const TrialReplay& replay);

  /// The rig makes an object, and it was seen.
  [[nodiscard]] bool has_object() const noexcept { return has_object_; }
  [[nodiscard]] const std::shared_ptr<const ArmSpace>& space() const noexcept { return space_; }
  /// What is drawn in the middle: where the object was seen first.
  [[nodiscard]] const Vec3& centre_W() const noexcept { return centre_W_; }

  /// What was recorded at that time. In a gap, and of segments and markers that were not seen,
  /// there is nothing. @pre `state` is of `replay`, which this was made of
  [[nodiscard]] session::ArmSnapshot at(const TrialReplay& replay, const ReplayState& state) const;
  /// Where the middle of the object was, in the frame of the screens; NaN: interrupted. Steps are
  /// `least_step_m` and more.
  [[nodiscard]] std::vector<Vec3> path(const TrialReplay& replay, double least_step_m) const;

 private:
  struct Segment {
    PosePlaces pose;
    Place residual_m;
    Place state;
  };
  void find(const Signals& signals);
  void look_for_object(const Signals& signals);

  std::shared_ptr<const ArmSpace> space_;
  std::array<Segment, kArmSegmentCount> segments_{};
  std::array<std::array<Place, 3>, kArmLinkCount> links_{};
  std::vector<std::array<Place, 3>> markers_;
  PosePlaces reference_;
  Place matched_;
  std::vector<std::optional<std::size_t>> last_seen_;  ///< row of the object, up to each row
  bool has_object_ = false;
  Vec3 centre_W_ = Vec3::Zero();
};

}  // namespace isograsp::gui
