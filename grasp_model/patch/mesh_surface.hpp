// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of triangles that rays walk along, and its reader (Wavefront OBJ: v and f). SI units.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grasp_model/patch/contact_patch.hpp"

namespace isograsp {

class MeshSurface final : public PatchSurface {
 public:
  static constexpr std::size_t kMostTriangles = 2'000'000;

  /// Lines `v x y z` and `f a b c …` (polygons become fans; `a/b/c` and negative numbers as the
  /// format has them); other lines are passed over. The outside is where a face runs
  /// counterclockwise. Vertices at one place are one. Errors name line and remedy: no number, a
  /// vertex that is not there, an edge of more than two faces or that two faces run alike.
  [[nodiscard]] static Result<MeshSurface> parse(std::string_view obj, const std::string& file);

  [[nodiscard]] std::size_t triangles() const noexcept { return triangles_.size(); }
  [[nodiscard]] Vec3 middle_of(std::size_t triangle) const;
  [[nodiscard]] Vec3 inward_of(std::size_t triangle) const { return triangles_[triangle].inward; }
  [[nodiscard]] Result<std::vector<PatchRay>> rays(const PatchFrame& frame,
                                                   const Pad& pad) const override;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    /// Beyond the edge from vertex i to the next one; kNone: the mesh ends there.
    std::array<std::uint32_t, 3> beside{kNone, kNone, kNone};
    Vec3 inward;  ///< unit normal into the object
  };

  /// A ray's half plane cuts an edge: where, and of which triangle it is which edge.
  struct Crossing {
    std::uint32_t triangle = kNone;
    std::size_t edge = 0;
    double along_m = 0.0;  ///< in the direction of the ray
    double deep_m = 0.0;   ///< along the normal of the contact
  };
  struct Section;

  [[nodiscard]] static Result<MeshSurface> connect(std::vector<Vec3> vertices,
                                                   std::vector<Triangle> triangles,
                                                   const std::vector<int>& lines,
                                                   const std::string& file);
  [[nodiscard]] double distance_m(const Triangle& triangle, const Vec3& p) const;
  /// Those that the point lies on, with a normal into the object. Errors as rays().
  [[nodiscard]] Result<std::vector<std::uint32_t>> under(const PatchFrame& frame) const;
  [[nodiscard]] PatchRay ray(const Section& section, std::span<const std::uint32_t> under,
                             double limit_m, const Pad& pad) const;
  [[nodiscard]] std::optional<Crossing> forward_edge(const Section& section, std::uint32_t triangle,
                                                     std::size_t entry) const;
  [[nodiscard]] std::optional<Crossing> first_edge(const Section& section,
                                                   std::span<const std::uint32_t> under) const;

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
};

}  // namespace isograsp
