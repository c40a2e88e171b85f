// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a session with an arm seen by markers, each once (core/column.hpp): poses of its
// segments, the reference that was shown, and how much of it was seen. Poses are those of the
// frames of a rig (docs/markers.md) in the frame W of the cameras, of a left arm in its reflection.
#pragma once

#include "core/spatial.hpp"
#include "hand/arm_links.hpp"
#include "hand/columns.hpp"

namespace isograsp {

/// Segments of an arm that are recorded, from the table to the fingertips.
enum class ArmSegment : std::uint8_t { brace, trunk, elbow, forearm, dorsum, object };
inline constexpr std::size_t kArmSegmentCount = 6;
inline constexpr std::array<std::string_view, kArmSegmentCount> kArmSegmentNames{
    "brace", "trunk", "elbow", "forearm", "dorsum", "object"};
[[nodiscard]] constexpr std::size_t index_of(ArmSegment segment) noexcept {
  return static_cast<std::size_t>(segment);
}

namespace columns {

/// The columns of one segment.
struct OfSegment {
  OfAxes position;
  OfComponents attitude;
  Column residual_m;
  Column state;
};

[[nodiscard]] constexpr OfSegment of_segment(std::string_view name, Phrase<1> position,
                                             Phrase<1> attitude_is, Words residual, Words state) {
  return {along(FixedText<28>(name, "_"), "_m", position, "cameras", name),
          attitude(name, attitude_is, name, "cameras"),
          {FixedText<28>(name, "_residual_m"), ColumnWords(residual), {}, {}, name},
          {FixedText<28>(name, "_state"), ColumnWords(state), {}, {}, name}};
}

/// In the order of ArmSegment.
inline constexpr std::array<OfSegment, kArmSegmentCount> segment_pose = [] {
  std::array<OfSegment, kArmSegmentCount> all;
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    all[s] =
        of_segment(kArmSegmentNames[s], "Position of the segment along %1; empty: not seen"_text,
                   "Attitude of the segment, quaternion %1; empty: not seen"_text,
                   "Root mean square by which its markers miss it; empty: nothing was fitted"_text,
                   "0 ok, 1 ok without one marker, 2 few, 3 collinear, 4 residual, 5 missing"_text);
  return all;
}();

/// The three angles of each link, in the sequence and from the zero of the rig.
inline constexpr std::array<std::array<Column, 3>, kArmLinkCount> link_angle = [] {
  constexpr std::array<std::string_view, 3> kNumbers{"1", "2", "3"};
  std::array<std::array<Column, 3>, kArmLinkCount> all;
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (std::size_t a = 0; a < 3; ++a)
      all[link][a] = {
          FixedText<28>(kArmLinkNames[link], "_a", kNumbers[a], "_rad"),
          ColumnWords("Angle %1 of the link, in the sequence of the rig"_text, kNumbers[a]),
          {},
          {},
          kArmLinkNames[link]};
  return all;
}();

/// The pose to which the object is to be brought.
inline constexpr OfAxes reference_position =
    along("reference_", "_m", "Position of the reference along %1; empty: none is shown"_text,
          "cameras", "reference");
inline constexpr OfComponents reference_attitude =
    attitude("reference", "Attitude of the reference, quaternion %1; empty: none is shown"_text,
             "reference", "cameras");
inline constexpr Column matched =
    plain("matched", "1: the reference is reached and stays in view for a moment"_text);

/// A column of one marker: "marker_", its name, then the axis.
inline constexpr std::string_view kMarker = "marker_";
/// So that it fits a name of a column.
inline constexpr std::size_t kLongestMarkerName = 16;

}  // namespace columns

}  // namespace isograsp
