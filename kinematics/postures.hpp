// SPDX-License-Identifier: GPL-3.0-or-later
// Postures of an arm as a chain of links, and their adaptation to an arm of another size (Kurillo
// et al., eq. 1-5; docs/markers.md). X_L of a link is the pose of its child in its parent.
#pragma once

#include <array>
#include <optional>
#include <span>
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

/// The same row by row. Real-time: nothing is allocated.
class StartPostureMean {
 public:
  static constexpr std::size_t kMostFrames = 17;

  /// @pre 2 <= frames <= kMostFrames
  explicit StartPostureMean(std::size_t frames) noexcept : frames_(frames) {}
  /// Poses of the chain's frames in one row; a row in which one is missing does not count.
  /// @pre X_W.size() is the number of frames
  void add(std::span<const Pose> X_W) noexcept;
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  /// Standard deviation (n - 1) of the position of the first frame and of each link, norm over the
  /// axes, the largest of them [m]; missing with fewer than two rows.
  [[nodiscard]] double largest_sd_m() const noexcept;
  /// @pre rows() > 0
  [[nodiscard]] StartPosture mean() const;

 private:
  /// Of the first frame in the world, then of each link.
  struct Sum {
    Vec3 p = Vec3::Zero();
    Vec3 first = Vec3::Zero();  ///< the first position: squares are of differences from it
    Vec3 square = Vec3::Zero();
    MeanAttitude attitude;
  };
  std::size_t frames_;
  std::size_t rows_ = 0;
  std::array<Sum, kMostFrames> sums_{};
};

/// The chain of links of a rig, from the first link whose parent is a frame: E, F, D, O. Empty:
/// there is none.
[[nodiscard]] std::vector<std::string> chain_of(const Rig& rig);

/// The same library with each posture only this part of the way from the initial one, 0 … 1: of
/// each change of a link the translation is shortened and the rotation turned that far about its
/// axis.
[[nodiscard]] Postures part_of_the_way(Postures library, double way);
/// One posture of it. @pre both have the same links
[[nodiscard]] Posture part_of_the_way(const Posture& initial, Posture posture, double way);

/// How far a person's own angle of a link goes (kinematics/range_of_motion.hpp).
struct OwnRange {
  std::string link;
  int angle = 0;  ///< 0, 1, 2: a1, a2, a3
  double min_rad = 0.0;
  double max_rad = 0.0;
};

/// Names of the postures of own_range_postures(); the initial one is the start posture.
inline constexpr std::string_view kStartOfRange = "start";
inline constexpr std::string_view kLeastOfRange = "least";
inline constexpr std::string_view kLargestOfRange = "largest";
/// A person's own postures: the start posture, and the same arm with one angle of link `l` of the
/// chain at either end of its range. Positions of links stay. @pre start has the links of the chain
[[nodiscard]] Postures own_range_postures(const StartPosture& start,
                                          const std::vector<std::string>& chain, std::size_t l,
                                          const RigLink& link, const OwnRange& range);

/// What is done with translations of a posture change: left as they are, or made longer and shorter
/// as the patient's link is.
enum class SizeScale { none, length };

/// M_L: how link `l` of posture `index` has moved from the initial posture, as this arm is sized.
/// @pre start has the links of the library
[[nodiscard]] Pose change_of_link(const Postures& library, std::size_t index, std::size_t l,
                                  const StartPosture& start, SizeScale scale);

/// Where the last frame of the chain is in posture `index` of the library, for the arm that started
/// so. @pre start has the links of the library
[[nodiscard]] Pose adapted(const Postures& library, std::size_t index, const StartPosture& start,
                           SizeScale scale);

}  // namespace isograsp
