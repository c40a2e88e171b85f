// SPDX-License-Identifier: GPL-3.0-or-later
// From one row of markers to the frames of a rig. W is the world of the cameras; for a left arm its
// reflection, so pass mirrored() rig and markers. Positions in m.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/result.hpp"
#include "kinematics/rig.hpp"
#include "kinematics/rigid_body.hpp"
#include "kinematics/seen_markers.hpp"

namespace isograsp {

/// One frame of a rig in one row.
struct FramePose {
  FrameState state = FrameState::missing;
  int used = 0;  ///< cluster: markers in the fit, or seen; points: its points that are there;
                 ///< point: 0 or 1
  std::optional<std::size_t> rejected;  ///< of a cluster: which of its markers
  double residual_m = kMissing;         ///< missing where nothing was fitted
  Pose X_W = missing_pose();            ///< the sign of its quaternion is continuous in time
};

/// "ok", "ok+rejected_NAME", "few", …
[[nodiscard]] std::string name_of(const FramePose& pose, const RigFrame& frame);

class ArmFrames {
 public:
  ArmFrames() = default;
  /// `markers` are the labels of the columns of a row; what they show is judged by SeenMarkers. A
  /// marker of the rig that is not among them is never seen. Errors: none of them is, or two are
  /// one.
  [[nodiscard]] static Result<ArmFrames> compile(const Rig& rig,
                                                 std::span<const std::string> markers);

  [[nodiscard]] std::size_t frames() const noexcept { return frames_.size(); }
  /// Markers that the rig names and the rows do not have.
  [[nodiscard]] const std::vector<std::string>& absent() const noexcept { return absent_; }
  /// Real-time: nothing is allocated. `p_W`: as many as labels, missing ones NaN; rows in the order
  /// of time. @pre frames.size() == frames()
  void solve(std::span<const Vec3> p_W, std::span<FramePose> frames) noexcept;

 private:
  /// A marker, or a landmark in a frame that is solved before.
  struct Named {
    std::optional<std::size_t> marker;
    std::optional<std::size_t> frame;
    Vec3 p_F = Vec3::Zero();
  };
  using Mean = std::vector<Named>;
  struct Axis {
    int axis = 0;
    bool negative = false;
    Mean from;
    Mean to;
  };
  struct Points {
    Mean origin;
    Axis primary;
    Axis secondary;
    Mean distinct;  ///< every name of them once
  };
  struct Cluster {
    RigidBody body;
    Mean markers;
  };
  struct Point {
    Mean origin;
    std::size_t orientation = 0;
  };
  using Method = std::variant<Cluster, Points, Point>;
  class Compiler;
  struct Solver;
  explicit ArmFrames(SeenMarkers seen) : seen_(std::move(seen)) {}

  SeenMarkers seen_;
  std::vector<Method> frames_;
  std::vector<Quat> last_;  ///< attitude of each frame in the last row that had one
  std::vector<std::string> absent_;
};

/// Row by row: one frame built from three directions, as PointsFrame says. Missing points give a
/// missing pose; directions within 5 degrees of each other give nothing.
[[nodiscard]] std::optional<Quat> attitude_from_axes(const Vec3& primary, int a,
                                                     const Vec3& secondary, int b) noexcept;

}  // namespace isograsp
