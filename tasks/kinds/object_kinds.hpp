// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tasks with an object, as a task file says them (docs/file_formats.md). SI units,
// radians.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/kinds/force_kinds.hpp"

namespace isograsp::tasks {

/// The object is brought to a series of poses, each held inside its tolerance.
struct PoseTarget {
  Vec3 p_WT = Vec3::Zero();  ///< [m]
  double angle_rad = 0.0;    ///< about world z
  double hold_s = 0.0;       ///< uninterrupted time inside the tolerance that counts as reached
  bool level = false;        ///< a transport: tilt on the way here is measured
};
struct PoseTargetsSpec {
  std::string scene;  ///< name of a scene file, beside the task file or in the library
  double position_tolerance_m = 0.02;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  double time_limit_s = 60.0;                       ///< per target
  std::vector<PoseTarget> targets;
};

/// Free handling of an object for a fixed time: recorded data, familiarisation.
struct ObserveSpec {
  std::string scene;
  double duration_s = 30.0;
};

/// The target moves, or jumps, in one to six degrees of freedom.
struct PoseTrackingSpec {
  struct Axis {
    int axis = 0;  ///< 0 … 5: x y z [m], turns about world x y z [rad]
    double least = 0.0;
    double most = 0.0;
    Waveform waveform;
  };
  std::string scene;
  std::vector<Axis> axes;
  double lead_in_s = 2.0;
  double duration_s = 30.0;
};

/// The object appears, is picked up, carried to its target, held there and let go.
struct PickPlaceSpec {
  struct Item {
    Vec3 p_WO = Vec3::Zero();  ///< where it appears [m]
    Vec3 p_WT = Vec3::Zero();  ///< where it is to be [m]
    double angle_rad = 0.0;    ///< of the target about world z
  };
  std::string scene;
  double position_tolerance_m = 0.02;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  double hold_s = 1.0;
  double time_limit_s = 30.0;     ///< per object
  double drop_distance_m = 0.02;  ///< further than this without a touch: dropped
  std::vector<Item> items;
};

}  // namespace isograsp::tasks
