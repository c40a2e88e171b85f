// SPDX-License-Identifier: GPL-3.0-or-later
// The rig of a session: which of its frames is which segment of the arm, and which marker of the
// cameras is recorded.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "hand/arm_columns.hpp"
#include "hand/finger.hpp"
#include "kinematics/arm_frames.hpp"
#include "kinematics/rig.hpp"

namespace isograsp::session {

/// From elbow to object: the segments of the chain, in order.
inline constexpr std::array<ArmSegment, 4> kArmChain{ArmSegment::elbow, ArmSegment::forearm,
                                                     ArmSegment::dorsum, ArmSegment::object};

struct ArmRig {
  /// Markers that are recorded at most: those that the rig names.
  static constexpr std::size_t kMostMarkers = 58;

  Hand hand = Hand::right;
  Rig rig;           ///< of a left arm mirrored, as everything behind the cameras
  std::string text;  ///< the file as it was: stored with the session
  /// Names of the frames of kArmChain; empty: a rig without frames, whose markers alone are
  /// recorded.
  std::vector<std::string> chain;
  /// The rig's own link for each of the chain: its sequence of angles and its zero.
  std::array<RigLink, kArmLinkCount> links;
  /// Frame of each segment; nothing: the rig has none.
  std::array<std::optional<std::size_t>, kArmSegmentCount> frame_of{};

  /// The rig of a file's text; `source` is named in errors. Errors as those of load().
  [[nodiscard]] static Result<ArmRig> parse(std::string text, const std::string& source, Hand hand);
  /// Reads the rig of the file `path`. Errors as those of load().
  [[nodiscard]] static Result<ArmRig> read(const std::string& path, Hand hand);
  /// Reads the rig `name`: a file, or a name in LIBRARY/rigs. Errors: it has frames but no chain of
  /// elbow, forearm, dorsum and object, or no [score] whose object ends it; `uri` is named in
  /// errors.
  [[nodiscard]] static Result<ArmRig> load(const std::string& name, const std::string& library,
                                           Hand hand, const std::string& uri);
};

/// A marker that is recorded.
struct RecordedMarker {
  std::size_t label = 0;  ///< which of the labels of the cameras
  std::string name;       ///< as the rig calls it
};
/// Those that the rig names. Errors: too many, two are one, or a name too long for a column.
[[nodiscard]] Result<std::vector<RecordedMarker>> recorded_markers(
    const Rig& rig, std::span<const std::string> labels);

}  // namespace isograsp::session
