// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files: what is read, what is left out, what is refused and where.
#include "grasp_model/scene.hpp"

#include "tests/grasp_model/support.hpp"
#include "tests/support/within.hpp"

namespace isograsp::scene_test {
namespace {

const std::string kFree =
    "free = [\"x\", \"y\", \"rz\"]\nstiffness = [30,30,30,0.3,0.3,0.3]\ndamping = "
    "[1,1,1,0,0,0.003]\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

std::string refused_field(const std::string& text) {
  const auto scene = parse_scene(text, "test.toml");
  if (scene.ok()) return "accepted";
  EXPECT_EQ(scene.error().file, "test.toml");
  EXPECT_FALSE(scene.error().remedy.empty());
  return scene.error().field;
}

TEST(Scene, ReadsWhatTheFileSaysAndFillsInTheRest) {
  const Scene scene = test::scene_of(test::block(kFree));
  EXPECT_EQ(scene.shape, Shape::box);
  EXPECT_EQ(scene.mass_kg, 0.3);
  EXPECT_EQ(scene.inertia_kg_m2, Vec3(1e-4, 2e-4, 3e-4));
  EXPECT_EQ(scene.free, (std::array<bool, 6>{true, true, false, false, false, true}));
  EXPECT_EQ(scene.wrench_frame, WrenchFrame::hand);
  EXPECT_EQ(scene.grasp_rule, GraspRule::any);
  EXPECT_EQ(scene.gravity_m_s2, Vec3::Zero());
  EXPECT_EQ(scene.initial_X_WO.q.coeffs(), Quat::Identity().coeffs());
  ASSERT_EQ(scene.contacts.size(), 3u);
  EXPECT_EQ(scene.contacts[1].finger, Finger::index);
  EXPECT_EQ(scene.contacts[1].p_OC, Vec3(0.0325, 0.0125, 0));
  EXPECT_EQ(scene.contacts[1].threshold_N, 0.0);
  Mat3 thumb;  // columns tangent, z x x, normal
  thumb << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_EQ(scene.contacts[0].R_OC, thumb);
}

TEST(Scene, InertiaLeftOutIsThatOfTheSolid) {
  const auto without = replaced(test::block(kFree), "inertia_kg_m2 = [1e-4, 2e-4, 3e-4]\n", "");
  const Vec3 box = test::scene_of(without).inertia_kg_m2;
  EXPECT_WITHIN(box.z(), 0.3 / 12 * (0.065 * 0.065 + 0.06 * 0.06), 1e-18);
  const auto shaped = [&](const std::string& shape, const std::string& size) {
    return test::scene_of(
               replaced(replaced(without, "\"box\"", shape), "[0.065, 0.06, 0.08]", size))
        .inertia_kg_m2;
  };
  EXPECT_WITHIN((shaped("\"sphere\"", "[0.06]") - Vec3::Constant(0.4 * 0.3 * 0.03 * 0.03)).norm(),
                0, 1e-18);
  EXPECT_WITHIN(shaped("\"cylinder\"", "[0.06, 0.1]").z(), 0.5 * 0.3 * 0.03 * 0.03, 1e-18);
  EXPECT_WITHIN(shaped("\"cylinder\"", "[0.06, 0.1]").x(), 0.3 * (3 * 0.03 * 0.03 + 0.01) / 12,
                1e-18);
}

TEST(Scene, ContactFramesAreOrthonormalAndRightHandedWhateverTheFileGives) {
  const auto text =
      replaced(replaced(test::block(kFree), "normal = [1, 0, 0]", "normal = [2, 0.3, -0.1]"),
               "tangent = [0, 1, 0]", "tangent = [0.5, 3, 1]");
  const Mat3 R = test::scene_of(text).contacts[0].R_OC;
  EXPECT_LE((R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff(), 4e-16);
  EXPECT_WITHIN(R.determinant(), 1.0, 1e-15);
  EXPECT_LE((R.col(2) - Vec3(2, 0.3, -0.1).normalized()).norm(), 2e-16);
}

TEST(Scene, TheInitialPositionIsTheAnchorUnlessGiven) {
  EXPECT_EQ(test::scene_of(test::block(kFree + "anchor_m = [0.1, 0, 0]")).initial_X_WO.p,
            Vec3(0.1, 0, 0));
}

TEST(Scene, RefusesWithTheNameOfTheField) {
  const std::string good = test::block(kFree);
  const auto with = [&good](const std::string& what, const std::string& by) {
    return refused_field(replaced(good, what, by));
  };
  EXPECT_EQ(with("isograsp-scene-1", "isograsp-scene-2"), "format");
  EXPECT_EQ(with("mass_kg = 0.3", ""), "object.mass_kg");
  EXPECT_EQ(with("mass_kg = 0.3", "mass_kg = -0.3"), "object.mass_kg");
  EXPECT_EQ(with("mass_kg = 0.3", "mass_kg = nan"), "object.mass_kg");
  EXPECT_EQ(with("mass_kg = 0.3", "mass_kg = \"0.3\""), "object.mass_kg");
  EXPECT_EQ(with("mass_kg = 0.3", "mass_kg = 0.3\ncolour = 3"), "object.colour");
  EXPECT_EQ(with("[0.065, 0.06, 0.08]", "[0.065, 0.06]"), "object.size_m");
  EXPECT_EQ(with("\"box\"", "\"cone\""), "object.shape");
  EXPECT_EQ(with("\"rz\"", "\"rw\""), "dynamics.free");
  EXPECT_EQ(with("\"rz\"", "\"x\""), "dynamics.free");
  EXPECT_EQ(with("stiffness = [30", "stiffness = [-30"), "dynamics.stiffness");
  EXPECT_EQ(with("model = \"point\"", "model = \"glue\""), "contact[1].model");
  EXPECT_EQ(with("friction = 0.8", ""), "contact[1].friction");
  EXPECT_EQ(with("\"index\"", "\"thumb\""), "contact[2].finger");
  EXPECT_EQ(with("tangent = [0, 1, 0]", "tangent = [1, 0, 0]"), "contact[1].tangent");
  EXPECT_EQ(with("normal = [1, 0, 0]", "normal = [0, 0, 0]"), "contact[1].normal");
  EXPECT_EQ(refused_field(replaced(replaced(good, "mass_kg = 0.3", "mass_kg = 0"), "damping = [1",
                                   "damping = [0")),
            "dynamics.damping");
}

TEST(Scene, RefusesAStartThatTheFreeAxesCannotReach) {
  const auto initial = [](const std::string& line) {
    return refused_field(test::block(kFree, "[initial]\n" + line + "\n" + test::kDeviceContacts));
  };
  EXPECT_EQ(initial("velocity_m_s = [0, 0, 0.1]"), "initial.velocity_m_s");
  EXPECT_EQ(initial("velocity_m_s = [0.1, 0.1, 0]"), "accepted");
  EXPECT_EQ(initial("angular_velocity_rad_s = [0.1, 0, 0]"), "initial.angular_velocity_rad_s");
  EXPECT_EQ(initial("quaternion_wxyz = [0.8, 0.6, 0, 0]"), "initial.quaternion_wxyz");
  EXPECT_EQ(initial("quaternion_wxyz = [0.8, 0, 0, -0.6]"), "accepted");
  EXPECT_EQ(initial("quaternion_wxyz = [0, 0, 0, 0]"), "initial.quaternion_wxyz");
  EXPECT_EQ(
      refused_field(test::block(kFree + "limits = [{dof = \"x\", min_m = 0.1, max_m = 0.2}]")),
      "initial.position_m");
}

TEST(Scene, LimitsAreInTheUnitOfTheirAxis) {
  EXPECT_EQ(refused_field(test::block(kFree + "limits = [{dof = \"x\", min_rad = -1}]")),
            "dynamics.limits[1].");
  EXPECT_EQ(
      refused_field(test::block(kFree + "limits = [{dof = \"rz\", min_rad = 1, max_rad = -1}]")),
      "dynamics.limits[1].min_rad");
  const Scene scene =
      test::scene_of(test::block(kFree + "limits = [{dof = \"rz\", min_rad = -1, max_rad = 1}]"));
  ASSERT_EQ(scene.limits.size(), 1u);
  EXPECT_EQ(scene.limits[0].dof, Dof::rz);
  EXPECT_EQ(scene.limits[0].most, 1.0);
}

TEST(Scene, TheLeftHandIsTheDeviceTurnedByPiAboutY) {
  const Scene right = test::scene_of(test::block(kFree));
  const Scene left = for_hand(right, Hand::left);
  const Mat3 turn = Vec3(-1, 1, -1).asDiagonal();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(left.contacts[i].p_OC, Vec3(turn * right.contacts[i].p_OC));
    EXPECT_EQ(left.contacts[i].R_OC, Mat3(turn * right.contacts[i].R_OC));
    EXPECT_WITHIN(left.contacts[i].R_OC.determinant(), 1.0, 1e-15);
  }
  EXPECT_EQ(for_hand(left, Hand::left).contacts[0].p_OC, right.contacts[0].p_OC);
  EXPECT_EQ(for_hand(right, Hand::right).contacts[0].p_OC, right.contacts[0].p_OC);
}

}  // namespace
}  // namespace isograsp::scene_test
