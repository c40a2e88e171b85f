// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes: what is accepted can be scanned from the middle of its first faces, smooth and rough, and
// no ray goes farther than the pad.
#include <cmath>

#include "grasp_model/patch/mesh_surface.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

void scan_from(const MeshSurface& mesh, const Vec3& p, const Vec3& normal, bool rough) {
  const auto frame = PatchFrame::along(p, normal, Vec3(0.3, 0.5, 0.8));
  if (!frame) return;
  Pad pad;
  pad.rays = 16;
  pad.rough = rough;
  pad.depth_m = 0.001;
  const auto patch = scan_patch(mesh, *frame, pad);
  if (!patch) return;  // the middle is rounded beside a small face
  constexpr double kRounding = 1.0 + 1e-9;
  for (const Vec2& end : patch->outline_m)
    fuzz::require(end.norm() <= kRounding * pad.semi_x_m, "a ray ends with the pad");
  fuzz::require(patch->area_m2 >= 0.0 && std::isfinite(patch->torsion_m) &&
                    patch->pure_torsion_limit_m <= kRounding * patch->torsion_m,
                "the torsional limit is a length");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto mesh = MeshSurface::parse(text, "mesh.obj");
  if (!mesh) {
    fuzz::require_helpful(mesh.error(), text);
    return 0;
  }
  constexpr std::size_t kMost = 4;
  for (std::size_t t = 0; t < std::min(kMost, mesh->triangles()); ++t)
    for (const bool rough : {false, true})
      scan_from(*mesh, mesh->middle_of(t), mesh->inward_of(t), rough);
  return 0;
}
