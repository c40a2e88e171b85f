// SPDX-License-Identifier: GPL-3.0-or-later
// The matrix of one step: palm and object are the hub, the four angles of each digit a leaf that
// knows only the hub. It is symmetric and positive definite, and is solved without its 32 columns
// (docs/virtual_hand.md, "The step"). Real-time safe.
#pragma once

#include <array>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "hand/tracked_hand.hpp"

namespace isograsp::hand_world {

/// Velocity of the palm's origin, angular velocity of the palm (world axes), velocity of the
/// object's centre (world axes), angular velocity of the object (object axes).
inline constexpr int kHubSize = 12;
inline constexpr int kPalmPart = 0;    ///< first of the six of the palm
inline constexpr int kObjectPart = 6;  ///< first of the six of the object
inline constexpr int kLeafSize = 4;    ///< rates of a digit's angles

using HubVector = Eigen::Matrix<double, kHubSize, 1>;
using HubMatrix = Eigen::Matrix<double, kHubSize, kHubSize>;
using LeafVector = Eigen::Matrix<double, kLeafSize, 1>;
using LeafMatrix = Eigen::Matrix<double, kLeafSize, kLeafSize>;
using EdgeMatrix = Eigen::Matrix<double, kHubSize, kLeafSize>;

struct ArrowVector {
  HubVector hub = HubVector::Zero();
  std::array<LeafVector, kDigitCount> leaves;
  ArrowVector() { leaves.fill(LeafVector::Zero()); }
};

struct Arrow {
  HubMatrix hub = HubMatrix::Identity();
  std::array<LeafMatrix, kDigitCount> leaves;
  std::array<EdgeMatrix, kDigitCount> edges;
  /// The unit matrix.
  Arrow() {
    leaves.fill(LeafMatrix::Identity());
    edges.fill(EdgeMatrix::Zero());
  }
};

/// Rows of a contact: velocities of it from those of the hub and of one leaf.
struct ArrowRows {
  static constexpr int kNoLeaf = -1;
  int leaf = kNoLeaf;
  Eigen::Matrix<double, 4, kHubSize> hub = Eigen::Matrix<double, 4, kHubSize>::Zero();
  Eigen::Matrix<double, 4, kLeafSize> on_leaf = Eigen::Matrix<double, 4, kLeafSize>::Zero();

  [[nodiscard]] Eigen::Vector4d times(const ArrowVector& velocity) const noexcept;
  /// Adds rows^T force.
  void add_transposed(const Eigen::Vector4d& force, ArrowVector& to) const noexcept;
};

/// An arrow that can be solved.
class FactoredArrow {
 public:
  /// @pre the matrix is symmetric and positive definite; the lower triangle of the hub counts
  void factor(const Arrow& matrix) noexcept;
  [[nodiscard]] ArrowVector solved(const ArrowVector& right) const noexcept;

  /// Rows seen by the inverse: rows_i A^-1 rows_j^T is reduced_i^T reduced_j, plus what both have
  /// in one leaf.
  struct Reduced {
    Eigen::Matrix<double, kHubSize, 4> hub;
    Eigen::Matrix<double, kLeafSize, 4> leaf;  ///< A_leaf^-1 rows^T
  };
  [[nodiscard]] Reduced reduced(const ArrowRows& rows) const noexcept;
  [[nodiscard]] static Eigen::Matrix4d compliance(const ArrowRows& rows, const Reduced& reduced,
                                                  const ArrowRows& other_rows,
                                                  const Reduced& other) noexcept;

 private:
  std::array<LeafMatrix, kDigitCount> inverses_;
  std::array<EdgeMatrix, kDigitCount> edges_;
  Eigen::LLT<HubMatrix> hub_;
};

}  // namespace isograsp::hand_world
