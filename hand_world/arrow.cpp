// SPDX-License-Identifier: GPL-3.0-or-later
// A = [H, E; E^T, D] with D of blocks: S = H - E D^-1 E^T is the hub's share, and rows J = (J_h,
// J_d) see it as J_h - J_d D^-1 E^T.
#include "hand_world/arrow.hpp"

namespace isograsp::hand_world {

Eigen::Vector4d ArrowRows::times(const ArrowVector& velocity) const noexcept {
  Eigen::Vector4d sum = hub * velocity.hub;
  if (leaf != kNoLeaf) sum += on_leaf * velocity.leaves[static_cast<std::size_t>(leaf)];
  return sum;
}

void ArrowRows::add_transposed(const Eigen::Vector4d& force, ArrowVector& to) const noexcept {
  to.hub += hub.transpose() * force;
  if (leaf != kNoLeaf) to.leaves[static_cast<std::size_t>(leaf)] += on_leaf.transpose() * force;
}

void FactoredArrow::factor(const Arrow& matrix) noexcept {
  HubMatrix share = matrix.hub;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    inverses_[d] = Eigen::LLT<LeafMatrix>(matrix.leaves[d]).solve(LeafMatrix::Identity());
    edges_[d] = matrix.edges[d];
    const EdgeMatrix through = edges_[d] * inverses_[d];
    share.noalias() -= through * edges_[d].transpose();
  }
  hub_.compute(share);
}

ArrowVector FactoredArrow::solved(const ArrowVector& right) const noexcept {
  ArrowVector x;
  HubVector hub = right.hub;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    x.leaves[d] = inverses_[d] * right.leaves[d];
    hub -= edges_[d] * x.leaves[d];
  }
  x.hub = hub_.solve(hub);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    x.leaves[d] -= inverses_[d] * (edges_[d].transpose() * x.hub);
  return x;
}

FactoredArrow::Reduced FactoredArrow::reduced(const ArrowRows& rows) const noexcept {
  Reduced reduced;
  reduced.hub = rows.hub.transpose();
  reduced.leaf.setZero();
  if (rows.leaf != ArrowRows::kNoLeaf) {
    const auto d = static_cast<std::size_t>(rows.leaf);
    reduced.leaf.noalias() = inverses_[d] * rows.on_leaf.transpose();
    reduced.hub.noalias() -= edges_[d] * reduced.leaf;
  }
  hub_.matrixL().solveInPlace(reduced.hub);
  return reduced;
}

Eigen::Matrix4d FactoredArrow::compliance(const ArrowRows& rows, const Reduced& reduced,
                                          const ArrowRows& other_rows,
                                          const Reduced& other) noexcept {
  Eigen::Matrix4d sum = reduced.hub.transpose() * other.hub;
  if (rows.leaf != ArrowRows::kNoLeaf && rows.leaf == other_rows.leaf)
    sum += rows.on_leaf * other.leaf;
  return sum;
}

}  // namespace isograsp::hand_world
