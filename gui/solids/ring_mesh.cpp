// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/solids/ring_mesh.hpp"

#include <cstdint>
#include <numeric>

#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoVertexProperty.h>

namespace isograsp::gui::scene_nodes {

SoIndexedTriangleStripSet* make_ring_mesh(const std::vector<SbVec3f>& points,
                                          const std::vector<SbVec3f>& normals,
                                          const std::vector<int>& rings, int sectors) {
  std::vector<int32_t> strips;
  for (const int ring : rings) {
    for (int j = 0; j <= sectors; ++j) {
      strips.push_back(ring * sectors + j % sectors);
      strips.push_back((ring + 1) * sectors + j % sectors);
    }
    strips.push_back(SO_END_STRIP_INDEX);
  }
  auto* vertices = new SoVertexProperty;
  vertices->vertex.setValues(0, static_cast<int>(points.size()), points.data());
  vertices->normal.setValues(0, static_cast<int>(normals.size()), normals.data());
  vertices->normalBinding.setValue(SoVertexProperty::PER_VERTEX_INDEXED);
  auto* surface = new SoIndexedTriangleStripSet;
  surface->vertexProperty.setValue(vertices);
  surface->coordIndex.setValues(0, static_cast<int>(strips.size()), strips.data());
  return surface;
}

SoIndexedTriangleStripSet* make_ring_mesh(const std::vector<SbVec3f>& points,
                                          const std::vector<SbVec3f>& normals, int sectors) {
  std::vector<int> rings(points.size() / static_cast<std::size_t>(sectors) - 1);
  std::iota(rings.begin(), rings.end(), 0);
  return make_ring_mesh(points, normals, rings, sectors);
}

}  // namespace isograsp::gui::scene_nodes
