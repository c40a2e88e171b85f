// SPDX-License-Identifier: GPL-3.0-or-later
// A rig: which markers and landmarks make which frames, which frames make links, and what of them
// is scored (isograsp-rig-1, docs/markers.md). Positions in m as cameras see them, quaternions
// (w, x, y, z) of unit length.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp {

/// The mean of markers and landmarks.
using RigPoint = std::vector<std::string>;

/// A direction, and the axis of the frame along it.
struct RigAxis {
  int axis = 0;  ///< 0 x, 1 y, 2 z
  bool negative = false;
  RigPoint from;
  RigPoint to;
};

/// A frame built from points: `primary` lies along its direction, `secondary` in the half plane of
/// its own.
struct PointsFrame {
  RigPoint origin;
  RigAxis primary;
  RigAxis secondary;
};
/// A rigid body (kinematics/rigid_body.hpp).
struct ClusterFrame {
  std::vector<std::string> markers;
  std::vector<Vec3> template_m;
  std::optional<double> max_residual_m;    ///< else that of the rig
  std::optional<PointsFrame> calibration;  ///< the frame that templates are measured in
  /// Its markers have no labels: they are found by their distances (kinematics/cloud_match.hpp).
  bool unlabelled = false;
};
/// A point with the attitude of another frame.
struct PointFrame {
  RigPoint origin;
  std::string orientation;
};

struct RigFrame {
  std::string name;
  std::variant<ClusterFrame, PointsFrame, PointFrame> method;
};

/// A point that moves with a frame.
struct RigLandmark {
  std::string name;
  std::string frame;
  Vec3 position_m = Vec3::Zero();
};

inline constexpr std::string_view kWorld = "world";

struct RigLink {
  std::string name;
  std::string parent;  ///< a frame, or kWorld
  std::string child;
  AngleSequence sequence = AngleSequence::rpy;
  std::optional<Quat> zero;  ///< the attitude whose angles are 0
};

/// What measures of a movement are taken from: names of links, and of frames.
struct RigScore {
  std::string forearm;
  std::string sync;
  std::string object;
  // Frames that tell how somebody helps out with the rest of the body; nothing: not measured.
  std::optional<std::string> trunk = {};
  std::optional<std::string> brace = {};
  std::optional<std::string> elbow = {};
};

/// Camera axes to the right and up, for drawing: "x", "-z".
struct RigView {
  std::string right = "x";
  std::string up = "y";
};

/// What cameras call a marker of the rig.
struct RigAlias {
  std::string label;
  std::string marker;
};

struct Rig {
  std::string name;
  double max_residual_m = 0.003;
  /// Of no frame: their places alone are recorded.
  std::vector<std::string> markers;
  std::vector<RigFrame> frames;  ///< each uses only those before it
  std::vector<RigLandmark> landmarks;
  std::vector<RigLink> links;
  std::optional<RigScore> score;
  std::optional<RigView> view;
  std::vector<RigAlias> alias;

  /// Index of the frame, or nothing.
  [[nodiscard]] std::optional<std::size_t> frame(std::string_view name) const noexcept;
  [[nodiscard]] std::optional<std::size_t> link(std::string_view name) const noexcept;
};

/// Labels of cameras as the rig calls its markers; others stay. Errors: two of them are one marker.
[[nodiscard]] Result<std::vector<std::string>> aliased(const Rig& rig,
                                                       std::span<const std::string> labels);
/// Markers that the rig names, each once.
[[nodiscard]] std::vector<std::string> markers_of(const Rig& rig);

/// Reads and checks a rig: names known, each once, frames in order of dependence. `file` is used in
/// errors.
[[nodiscard]] Result<Rig> parse_rig(std::string_view text, const std::string& file);
/// As a file that parse_rig() reads to the same rig.
[[nodiscard]] std::string rig_text(const Rig& rig);

/// For a left hand: templates and landmarks reflected, x -> -x. Zeros of links are those of the
/// reflected world and stay.
[[nodiscard]] Rig mirrored(Rig rig);

}  // namespace isograsp
