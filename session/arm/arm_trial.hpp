// SPDX-License-Identifier: GPL-3.0-or-later
// One trial of an arm, and what is recorded of a frame; its columns are those of
// hand/arm_columns.hpp and one triple for each marker.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/acquisition/apparatus.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::session {

/// Columns of the markers, in the order of ArmSnapshot::markers_W.
[[nodiscard]] std::vector<columns::OfAxes> marker_columns(std::span<const RecordedMarker> markers);

class ArmTrial final : public TrialSetup {
 public:
  [[nodiscard]] std::vector<storage::SignalGroup> columns() const override;
  [[nodiscard]] std::string health_json() const override;
  /// What the cameras show alone: arm and markers, without task and timing.
  [[nodiscard]] std::vector<storage::SignalGroup> seen_columns() const;
  void write_seen(const ArmSnapshot& seen, TrialRow& row) const noexcept;
  /// One value per column, in that order. Real-time safe.
  void write(const RowFrame& frame, const ArmSnapshot& seen, TrialRow& row) const noexcept;

  std::vector<columns::OfAxes> markers;
  std::array<bool, kArmSegmentCount> has_segment{};  ///< those that the rig makes
  /// The angle that the task is about, if it is about one.
  struct Asked {
    std::size_t link = 0;
    Eigen::Index angle = 0;
  };
  std::optional<Asked> asked;
  MarkerHealth health;  ///< at its end
  /// From the back of the hand to the object in the start posture; nothing: the task is not about
  /// the object.
  std::optional<double> hand_to_object_m;
};

}  // namespace isograsp::session
