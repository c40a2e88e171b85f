// SPDX-License-Identifier: GPL-3.0-or-later
// A surface between closed rings of points.
#pragma once

#include <vector>

#include <Inventor/SbLinear.h>

class SoIndexedTriangleStripSet;

namespace isograsp::gui::scene_nodes {

/// Points and their normals, ring after ring of so many sectors. From each of these rings there is
/// a strip to the next one.
[[nodiscard]] SoIndexedTriangleStripSet* make_ring_mesh(const std::vector<SbVec3f>& points,
                                                        const std::vector<SbVec3f>& normals,
                                                        const std::vector<int>& rings, int sectors);
/// From each ring but the last one.
[[nodiscard]] SoIndexedTriangleStripSet* make_ring_mesh(const std::vector<SbVec3f>& points,
                                                        const std::vector<SbVec3f>& normals,
                                                        int sectors);

}  // namespace isograsp::gui::scene_nodes
