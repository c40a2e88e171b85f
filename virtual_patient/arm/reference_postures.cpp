// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/arm/reference_postures.hpp"

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/arm_frames.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

namespace {

/// A way from the start posture, in degrees.
struct Turn {
  const char* name;
  double pronation = 0.0;  ///< supination is negative
  double flexion = 0.0;    ///< extension is negative
  double ulnar = 0.0;      ///< radial deviation is negative
  double fingers = 0.0;    ///< twirl, as pronation
};

Result<Postures> postures_of(const Rig& rig, const char* name, std::span<const Turn> turns) {
  const ArmBody body = average_arm();
  Postures library;
  library.name = name;
  library.chain = chain_of(rig);
  for (const Turn& turn : turns) {
    Joints q = body.rest;
    q[joint::pronation] += kDegree_rad * turn.pronation;
    q[joint::flexion] += kDegree_rad * turn.flexion;
    q[joint::ulnar] += kDegree_rad * turn.ulnar;
    q[joint::turn_z] += kDegree_rad * turn.fingers;
    const auto X_W = measured_frames(rig, body, q);
    if (!X_W) return X_W.error();
    Posture posture{turn.name, {}};
    for (std::size_t l = 0; l + 1 < library.chain.size(); ++l)
      posture.X_L.push_back(compose(inverse((*X_W)[*rig.frame(library.chain[l])]),
                                    (*X_W)[*rig.frame(library.chain[l + 1])]));
    for (Pose& X_L : posture.X_L) X_L.q = canonical(X_L.q.normalized());
    library.postures.push_back(std::move(posture));
  }
  return library;
}

}  // namespace

ArmBody average_arm() noexcept {
  ArmTraits average;
  average.placement_m = 0.0;
  average.start_sd_rad = 0.0;
  Random unused(0);
  return {average, unused, Hand::right};
}

Result<std::vector<Pose>> measured_frames(const Rig& rig, const ArmBody& body, const Joints& q) {
  const ArmPoses X_W = body.poses_W(q);
  std::vector<std::string> labels;
  std::vector<Vec3> p_W;
  for (const ArmMarker& marker : body.markers) {
    labels.emplace_back(marker.label);
    const Pose& X_WS = X_W[index_of(marker.segment)];
    p_W.push_back(X_WS.p + X_WS.q * marker.p_S);
  }
  auto frames = ArmFrames::compile(rig, labels);
  if (!frames) return frames.error();
  std::vector<FramePose> poses(frames->frames());
  frames->solve(p_W, poses);
  std::vector<Pose> measured;
  for (const FramePose& pose : poses) measured.push_back(pose.X_W);
  return measured;
}

Result<Postures> forearm_and_wrist_postures(const Rig& rig) {
  constexpr Turn kTurns[] = {
      {"initial"},
      {"pronation", 40.0},
      {"supination", -50.0},
      {"flexion", 0.0, 40.0},
      {"extension", 0.0, -30.0},
      {"ulnar deviation", 0.0, 0.0, 25.0},
      {"radial deviation", 0.0, 0.0, -15.0},
      {"pronation and flexion", 30.0, 30.0},
      {"supination and extension", -40.0, -20.0},
      {"supination and ulnar deviation", -40.0, 0.0, 15.0},
  };
  return postures_of(rig, "Forearm and wrist (made by calculation, not recorded from a person)",
                     kTurns);
}

Result<Postures> screw_postures(const Rig& rig) {
  constexpr Turn kTurns[] = {
      {"initial"},
      {"unscrew", 30.0, 5.0, -3.0, 18.0},
      {"screw", -40.0, -5.0, 5.0, -22.0},
  };
  return postures_of(rig, "Turning a light bulb (made by calculation, not recorded from a person)",
                     kTurns);
}

}  // namespace isograsp::virtual_patient
