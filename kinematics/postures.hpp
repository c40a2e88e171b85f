// SPDX-License-Identifier: GPL-3.0-or-later
// Postures of an arm as a chain of links, and their adaptation to an arm of another size (Kurillo
// et al., eq. 1-5; docs/markers.md). X_L of a link is the pose of its child in its parent.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "hand/finger.hpp"
#include "kinematics/pose_series.hpp"

namespace isograsp {

struct Posture {
  std::string name;
  std::vector<Pose> X_L;  ///< one for each link of the chain
};

/// A posture library of one reference subject (isograsp-postures-1).
struct Postures {
  std::string name;
  Hand hand = Hand::right;
  std::vector<std::string> chain;  ///< frames; link k goes from frame k to k + 1
  std::vector<Posture> postures;   ///< the first one is initial
};

[[nodiscard]] Result<Postures> parse_postures(std::string_view text, const std::string& file);
/// As a file that parse_postures() reads to the same postures.
[[nodiscard]] std::string postures_text(const Postures& postures);

/// An arm held still: means over the rows in which the whole chain is there.
struct StartPosture {
  std::size_t rows = 0;
  Pose X_W;               ///< of the first frame of the chain
  std::vector<Pose> X_L;  ///< mean position and mean attitude of each link
};
/// Errors: a frame of the chain is not in the series, or no row has all of them.
[[nodiscard]] Result<StartPosture> start_posture(const PoseSeries& series,
                                                 const std::vector<std::string>& chain);

/// The chain of links of a rig, from the first link whose parent is a frame: E, F, D, O. Empty:
/// there is none.
[[nodiscard]] std::vector<std::string> chain_of(const Rig& rig);

/// What is done with translations of a posture change: left as they are, or made longer and shorter
/// as the patient's link is.
enum class SizeScale { none, length };

/// Where the last frame of the chain is in posture `index` of the library, for the arm that started
/// so. @pre start has the links of the library
[[nodiscard]] Pose adapted(const Postures& library, std::size_t index, const StartPosture& start,
                           SizeScale scale);

}  // namespace isograsp
