// SPDX-License-Identifier: GPL-3.0-or-later
// What a pad covers of a surface: closed forms, laws, values made independently
// (tests/data/bimanual) and meshes that are none.
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/random.hpp"
#include "grasp_model/limit_surface.hpp"
#include "grasp_model/patch/mesh_surface.hpp"
#include "grasp_model/patch/solid_surface.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::patch_test {
namespace {

using Json = nlohmann::json;
const std::string kData = std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/bimanual";
constexpr double kRounding = 1e-12;

Vec3 vec3_of(const Json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

MeshSurface mesh_of(const std::string& name) {
  const std::string file = kData + "/mesh/" + name;
  return test::must(MeshSurface::parse(test::must(read_text(file)), file));
}

ContactPatch scan(const PatchSurface& surface, const Vec3& p, const Vec3& normal,
                  const Vec3& tangent, const Pad& pad) {
  return test::must(scan_patch(surface, test::must(PatchFrame::along(p, normal, tangent)), pad));
}

TEST(Patch, IsThatOfTheGoldenCases) {
  std::ifstream in(kData + "/patch.json");
  const Json cases = Json::parse(in)["cases"];
  // The same rays and rings: rounding alone, and of the torsion the length of a curved ray.
  constexpr double kAreaAgrees = 1e-9, kTorsionAgrees = 1e-9;
  for (const Json& one : test::every(cases)) {
    SCOPED_TRACE(one["id"].get<std::string>());
    std::unique_ptr<PatchSurface> surface;
    if (one["shape"] == "mesh")
      surface = std::make_unique<MeshSurface>(mesh_of(one["mesh"]));
    else if (one["shape"] == "box")
      surface = std::make_unique<BoxSurface>(vec3_of(one["size_m"]));
    else if (one["shape"] == "sphere")
      surface = std::make_unique<SphereSurface>(one["size_m"][0].get<double>());
    else
      surface = std::make_unique<CylinderSurface>(one["size_m"][0].get<double>(),
                                                  one["size_m"][1].get<double>());
    const Json& axes_m = one["pad_semi_axes_m"];
    const Pad pad{axes_m[0],       axes_m[1],
                  one["rays"],     one["rings"],
                  one["friction"], std::numbers::pi / 180.0 * one["sharp_edge_deg"].get<double>(),
                  one["rough"],    one["depth_m"]};
    const ContactPatch patch = scan(*surface, vec3_of(one["point_m"]), vec3_of(one["normal"]),
                                    vec3_of(one["tangent"]), pad);
    const Json& expected = one["expected"];
    EXPECT_WITHIN(patch.area_m2, expected["area_m2"].get<double>(),
                  kAreaAgrees * expected["area_m2"].get<double>());
    for (const Eigen::Index axis : {0, 1})
      EXPECT_WITHIN(patch.centroid_m[axis],
                    expected["centroid_m"][static_cast<std::size_t>(axis)].get<double>(),
                    kAreaAgrees * pad.semi_x_m);
    EXPECT_WITHIN(patch.torsion_m, expected["torsion_m"].get<double>(),
                  kTorsionAgrees * expected["torsion_m"].get<double>());
    EXPECT_EQ(patch.elements, expected["elements"].get<std::size_t>());
    for (std::size_t k = 0; k < kRayStopNames.size(); ++k)
      EXPECT_EQ(patch.stopped[k], expected["stopped"].value(std::string(kRayStopNames[k]), 0U));
  }
}

TEST(Patch, OfAWideFaceIsThePadAndOfARoundOneTheDiskOfUniformPressure) {
  const BoxSurface box(Vec3(1.0, 1.0, 1.0));
  Pad pad;
  pad.rays = 720;
  const ContactPatch whole = scan(box, {0.5, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad);
  // Sectors of a polygon: second order in the angle between rays.
  constexpr double kSectors = 1e-4;
  const double ellipse_m2 = std::numbers::pi * pad.semi_x_m * pad.semi_y_m;
  EXPECT_WITHIN(whole.area_m2, ellipse_m2, kSectors * ellipse_m2);
  EXPECT_WITHIN(whole.centroid_m.norm(), 0.0, kRounding);
  pad.semi_x_m = pad.semi_y_m = 0.006;
  const ContactPatch round = scan(box, {0.5, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad);
  const double disk_m = disk_torsion_m(Pressure::uniform, pad.friction, pad.semi_x_m);
  EXPECT_WITHIN(round.torsion_m, disk_m, kRounding);
  EXPECT_WITHIN(round.pure_torsion_limit_m, disk_m, kRounding);
}

TEST(Patch, NearAnEdgeIsSmallerAndHoldsLessTorsion) {
  const BoxSurface box(Vec3(0.065, 0.06, 0.08));
  double before_m = 1.0, area_m2 = 1.0;
  for (const double from_edge_m : {0.02, 0.006, 0.004, 0.002, 0.001}) {
    const ContactPatch patch =
        scan(box, {-0.0325, 0.03 - from_edge_m, 0}, Vec3::UnitX(), Vec3::UnitY(), {});
    EXPECT_LT(patch.torsion_m, before_m) << from_edge_m;
    EXPECT_LT(patch.area_m2, area_m2) << from_edge_m;
    EXPECT_LE(patch.pure_torsion_limit_m, patch.torsion_m * (1.0 + kRounding));
    before_m = patch.torsion_m;
    area_m2 = patch.area_m2;
  }
}

/// The same triangles elsewhere.
std::string moved(const std::string& obj, const Mat3& R, const Vec3& t) {
  std::istringstream in(obj);
  std::string out, line;
  while (std::getline(in, line)) {
    Vec3 p;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p.x(), &p.y(), &p.z()) == 3) {
      p = R * p + t;
      char text[120];
      std::snprintf(text, sizeof text, "v %.17g %.17g %.17g", p.x(), p.y(), p.z());
      line = text;
    }
    out += line + "\n";
  }
  return out;
}

TEST(Patch, DoesNotDependOnWhereTheSurfaceStands) {
  Random random(4, 1);
  const std::string file = kData + "/mesh/hills.obj";
  const std::string obj = test::must(read_text(file));
  const Vec3 p(0.00013, 0.00017, 0.00035300000000000045);
  Pad pad;
  pad.friction = 0.4;
  const ContactPatch here =
      scan(test::must(MeshSurface::parse(obj, file)), p, -Vec3::UnitZ(), Vec3::UnitX(), pad);
  for (int k = 0; k < 20; ++k) {
    const Mat3 R = test::random_attitude(random).toRotationMatrix();
    const Vec3 t(0.1 * k, -0.2, 0.3);
    const auto mesh = test::must(MeshSurface::parse(moved(obj, R, t), "moved.obj"));
    const ContactPatch there = scan(mesh, R * p + t, R * -Vec3::UnitZ(), R.col(0), pad);
    constexpr double kMoved = 1e-9;  // coordinates of 2 m are rounded to 2e-16 m
    EXPECT_WITHIN(there.area_m2, here.area_m2, kMoved * here.area_m2);
    EXPECT_WITHIN(there.torsion_m, here.torsion_m, kMoved * here.torsion_m);
    EXPECT_EQ(there.stopped, here.stopped);
  }
}

/// A cylinder about z without its ends, of flat strips cut into triangles.
std::string tube(double radius_m, double half_length_m, int strips, int pieces) {
  std::string obj;
  for (int i = 0; i < strips; ++i)
    for (int k = 0; k <= pieces; ++k) {
      const double angle_rad = 2.0 * std::numbers::pi * i / strips;
      char text[120];
      std::snprintf(text, sizeof text, "v %.17g %.17g %.17g\n", radius_m * std::cos(angle_rad),
                    radius_m * std::sin(angle_rad), half_length_m * (2.0 * k / pieces - 1.0));
      obj += text;
    }
  const auto number = [&](int i, int k) { return (i % strips) * (pieces + 1) + k + 1; };
  for (int i = 0; i < strips; ++i)
    for (int k = 0; k < pieces; ++k)
      obj += "f " + std::to_string(number(i, k)) + " " + std::to_string(number(i + 1, k)) + " " +
             std::to_string(number(i + 1, k + 1)) + " " + std::to_string(number(i, k + 1)) + "\n";
  return obj;
}

TEST(Patch, OfAMeshConvergesToThatOfTheCylinderItStandsFor) {
  Pad pad;
  const CylinderSurface cylinder(0.02, 0.1);
  const ContactPatch exact = scan(cylinder, {0.01, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad);
  for (const int strips : {64, 256, 1024}) {
    const auto mesh = test::must(MeshSurface::parse(tube(0.01, 0.05, strips, 10), "tube.obj"));
    const ContactPatch patch = scan(mesh, {0.01, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad);
    // Where the cone ends a ray, it ends at the side of a strip: half a strip early or late.
    const double strip_rad = 2.0 * std::numbers::pi / strips;
    EXPECT_WITHIN(patch.torsion_m, exact.torsion_m, 0.5 * strip_rad * exact.torsion_m);
  }
}

TEST(Patch, ARayThatRunsAlongEdgesAndThroughVerticesGoesAsFarAsItsNeighbours) {
  // A flat square of 20 x 20 squares, each cut in two: from a vertex rays run along edges.
  std::string obj;
  for (int i = 0; i <= 20; ++i)
    for (int k = 0; k <= 20; ++k)
      obj +=
          "v " + std::to_string(0.001 * (i - 10)) + " " + std::to_string(0.001 * (k - 10)) + " 0\n";
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const int a = 21 * i + k + 1;
      obj += "f " + std::to_string(a) + " " + std::to_string(a + 21) + " " +
             std::to_string(a + 22) + "\nf " + std::to_string(a) + " " + std::to_string(a + 22) +
             " " + std::to_string(a + 1) + "\n";
    }
  const auto mesh = test::must(MeshSurface::parse(obj, "square.obj"));
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.001, 0.002, 0), Vec3(0.0005, 0, 0),
                        Vec3(0.0005, 0.0005, 0), Vec3(0.0003, 0.0001, 0)}) {
    const ContactPatch patch = scan(mesh, p, -Vec3::UnitZ(), Vec3::UnitX(), {});
    const ContactPatch face =
        scan(BoxSurface(Vec3(1, 1, 1)), p + Vec3(0, 0, 0.5), -Vec3::UnitZ(), Vec3::UnitX(), {});
    EXPECT_EQ(patch.stopped[static_cast<std::size_t>(RayStop::length)], 64U) << p.transpose();
    EXPECT_WITHIN(patch.torsion_m, face.torsion_m, kRounding);
  }
  Pad large;
  large.semi_x_m = large.semi_y_m = 0.05;
  const ContactPatch all = scan(mesh, Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitX(), large);
  EXPECT_EQ(all.stopped[static_cast<std::size_t>(RayStop::boundary)], 64U);
}

TEST(Patch, ARoughFlatFaceIsTheFaceAndADepthOfNothingLeavesASphereNothing) {
  Pad pad;
  const BoxSurface box(Vec3(0.065, 0.06, 0.08));
  const Vec3 p(-0.0325, 0.028, 0);
  const double smooth_m2 = scan(box, p, Vec3::UnitX(), Vec3::UnitY(), pad).area_m2;
  pad.rough = true;
  EXPECT_EQ(scan(box, p, Vec3::UnitX(), Vec3::UnitY(), pad).area_m2, smooth_m2);
  const SphereSurface sphere(0.04);
  EXPECT_EQ(scan(sphere, {0.02, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad).area_m2, 0.0);
  double before_m2 = 0.0;
  for (const double depth_m : {1e-4, 5e-4, 1e-3}) {
    pad.depth_m = depth_m;
    const double area_m2 = scan(sphere, {0.02, 0, 0}, -Vec3::UnitX(), Vec3::UnitY(), pad).area_m2;
    EXPECT_GT(area_m2, before_m2);
    before_m2 = area_m2;
  }
}

TEST(Patch, APointBesideTheSurfaceAndANormalOutwardAreRefusedByTheirField) {
  const auto mesh = mesh_of("box.obj");
  const BoxSurface box(Vec3(0.065, 0.06, 0.08));
  const SphereSurface sphere(0.065);
  const CylinderSurface cylinder(0.065, 0.1);
  for (const PatchSurface* surface :
       std::initializer_list<const PatchSurface*>{&mesh, &box, &sphere, &cylinder}) {
    const auto field = [&](const Vec3& p, const Vec3& normal) {
      const auto scanned =
          scan_patch(*surface, test::must(PatchFrame::along(p, normal, Vec3(0, 1, 0.1))), {});
      return scanned ? std::string("none") : scanned.error().field;
    };
    EXPECT_EQ(field({-0.0325, 0, 0}, Vec3::UnitX()), "none");
    EXPECT_EQ(field({-0.0326, 0, 0}, Vec3::UnitX()), "point");
    EXPECT_EQ(field({-0.0324, 0, 0}, Vec3::UnitX()), "point");
    EXPECT_EQ(field({-0.0325, 0, 0}, -Vec3::UnitX()), "normal");
    EXPECT_EQ(field({std::nan(""), 0, 0}, Vec3::UnitX()), "point");
  }
  EXPECT_FALSE(PatchFrame::along(Vec3::Zero(), Vec3::Zero(), Vec3::UnitX()));
  EXPECT_FALSE(PatchFrame::along(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitX()));
}

TEST(MeshReader, NamesTheLineOfWhatIsNoSurface) {
  const auto message = [](const std::string& obj) {
    const auto mesh = MeshSurface::parse(obj, "m.obj");
    return mesh ? std::string() : mesh.error().message();
  };
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  EXPECT_EQ(message(square + "f 1 2 3 4\n"), "");
  EXPECT_EQ(message("# said\n" + square + "vn 0 0 1\nf 1//1 2/2/1 -2 -1\nusemtl x\n"), "");
  EXPECT_EQ(message(""), "m.obj: has no triangle; give a Wavefront OBJ file with lines v and f");
  EXPECT_NE(message("v 0 0\n").find("m.obj:1: a vertex needs three numbers"), std::string::npos);
  EXPECT_NE(message("v 0 nan 0\n").find("m.obj:1:"), std::string::npos);
  for (const char* face : {"f 1 2 5\n", "f 0 1 2\n", "f 1 2 x\n", "f 1 2 2.5\n", "f -5 1 2\n"})
    EXPECT_NE(message(square + face).find("m.obj:5:"), std::string::npos) << face;
  EXPECT_NE(message(square + "f 1 2\n").find("three vertices"), std::string::npos);
  EXPECT_NE(message(square + "f 1 2 3\nf 1 2 4\n").find("m.obj:6: runs along an edge"),
            std::string::npos);
  EXPECT_NE(message("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n").find("no area"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::patch_test
