// SPDX-License-Identifier: GPL-3.0-or-later
// Many states at once move as each would by itself, to the last bit.
#include "grasp_model/batch/batch.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/grasp_model/presses.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::batch_test {
namespace {

const std::string kTurning = "\"rx\", \"ry\", \"rz\"";
const std::string kAll = "\"x\", \"y\", \"z\", " + kTurning;

Scene scene_with(const std::string& free, const std::string& more = "") {
  Scene scene = test::scene_of(test::block("free = [" + free +
                                           "]\nstiffness = [30, 40, 50, 0.2, 0.2, 0.2]\n"
                                           "damping = [1, 1, 1, 0.001, 0.002, 0.001]\n" +
                                           more));
  for (auto& contact : scene.contacts) contact.threshold_N = 0.3;
  scene.gravity_m_s2 = {0.3, -9.81, 0.1};
  return scene;
}

/// Numbers of a state, as bits: NaN equals itself, 0 not -0.
std::vector<std::uint64_t> bits_of(const ObjectState& state) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const double x : state.X_WO.p) add(x);
  for (const double x : state.X_WO.q.coeffs()) add(x);
  for (const double x : state.v_WO_W) add(x);
  for (const double x : state.w_WO_W) add(x);
  add(state.angle_rad);
  add(state.error_rad);
  for (const bool on : state.contact) bits.push_back(on ? 1 : 0);
  bits.push_back(state.tolerance_exceeded ? 1 : 0);
  bits.push_back(static_cast<std::uint64_t>(state.level + 100));
  return bits;
}

/// Steps a batch of these plans and each state by itself; every press its own.
template <class Press>
void expect_the_same(const std::vector<const Plan*>& plans, const std::string& what,
                     int frames = 150) {
  const std::size_t n = plans.size();
  Batch wide(plans);
  Batch narrow(plans);
  std::vector<ObjectState> alone;
  std::vector<Press> presses;
  for (std::size_t i = 0; i < n; ++i) {
    alone.push_back(plans[i]->initial_state());
    presses.emplace_back(100 + i);
  }
  std::vector<FingerWrenches> forces(n);
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t i = 0; i < n; ++i) {
      forces[i] = presses[i].next();
      plans[i]->step(forces[i], alone[i]);
    }
    wide.step(forces);
    narrow.step_narrow(forces);
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(bits_of(wide.state(i)), bits_of(alone[i]))
          << what << ": state " << i << ", frame " << frame;
      ASSERT_EQ(bits_of(narrow.state(i)), bits_of(alone[i]))
          << what << ": state " << i << ", frame " << frame << ", narrow";
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NE(bits_of(alone[i]), bits_of(plans[i]->initial_state())) << what << ": nothing moved";
}

TEST(Batch, EveryKindOfAxesGivesTheBitsOfSingleStepsAlsoForForcesThatNoSensorSends) {
  constexpr std::array<const char*, 3> kAxes{"\"x\"", "\"y\"", "\"z\""};
  for (unsigned along = 0; along < 8; ++along)
    for (const std::string& turning :
         {std::string(), std::string("\"rx\""), std::string("\"rz\""), kTurning}) {
      std::string free;
      for (unsigned axis = 0; axis < 3; ++axis)
        if ((along >> axis & 1) != 0) free += (free.empty() ? "" : ", ") + std::string(kAxes[axis]);
      if (!turning.empty()) free += (free.empty() ? "" : ", ") + turning;
      if (free.empty()) continue;
      Scene scene = scene_with(free);
      const Plan soft = test::plan_of(scene);
      expect_the_same<test::HardPresses>(std::vector<const Plan*>(7, &soft), free);
      scene.stiffness.head<3>() *= 1e4;
      const Plan stiff = test::plan_of(scene);
      expect_the_same<test::Presses>(std::vector<const Plan*>(7, &stiff), free + ", stiff");
    }
}

TEST(Batch, EveryWayOfTurningGivesTheBitsOfSingleSteps) {
  const std::vector<std::pair<std::string, void (*)(Scene&)>> ways{
      {"as it is", [](Scene&) {}},
      {"object axes", [](Scene& s) { s.wrench_frame = WrenchFrame::object; }},
      {"uneven springs", [](Scene& s) { s.stiffness[4] = 0.35; }},
      {"no springs", [](Scene& s) { s.stiffness.tail<3>().setZero(); }},
      {"coarse", [](Scene& s) { s.tolerance_rad = 1e-2; }},
      {"between orders", [](Scene& s) { s.tolerance_rad = 1e-5; }},
      {"exact", [](Scene& s) { s.tolerance_rad = 1e-12; }},
      {"steps in parts", [](Scene& s) { s.stiffness.tail<3>().setConstant(8.0); }},
      {"too stiff to follow", [](Scene& s) { s.stiffness.tail<3>().setConstant(4e4); }},
      {"overdamped", [](Scene& s) { s.damping.tail<3>().setConstant(2.0); }},
      {"massless", [](Scene& s) { s.inertia_kg_m2[1] = 0.0; }},
      {"half a turn away",
       [](Scene& s) { s.initial_X_WO.q = Quat(0.02, 0.6, 0.8, 0.0).normalized(); }},
      {"nearly a whole turn away",
       [](Scene& s) { s.initial_X_WO.q = Quat(-0.98, 0.1, 0.1, 0.1).normalized(); }},
      {"spinning fast", [](Scene& s) {
         s.initial_w_WO_W = {40.0, -90.0, 30.0};
       }}};
  for (const auto& [name, change] : ways)
    for (const std::string& free : {kTurning, kAll}) {
      Scene scene = scene_with(free);
      change(scene);
      const Plan plan = test::plan_of(scene);
      expect_the_same<test::Presses>(std::vector<const Plan*>(6, &plan), name + ", " + free);
      expect_the_same<test::HardPresses>(std::vector<const Plan*>(5, &plan), name + ", hard");
    }
}

TEST(Batch, WhatDoesNotGoSideBySideMovesOneByOne) {
  Scene limited = scene_with("\"x\", \"rz\"");
  limited.limits = {{Dof::x, -0.01, 0.01}};
  Scene twisted = scene_with(kAll);
  twisted.contacts[1].model = ContactModel::soft;
  twisted.contacts[1].torsion_m = 0.004;
  Scene turned_force = scene_with("\"x\", \"y\", \"rz\"", "wrench_frame = \"object\"\n");
  for (const Scene& scene : {limited, twisted, turned_force}) {
    const Plan plan = test::plan_of(scene);
    expect_the_same<test::Presses>(std::vector<const Plan*>(5, &plan), "one by one");
  }
}

TEST(Batch, PlansOfOneKindAndOfSeveralGoThroughOneBatch) {
  std::vector<Plan> plans;
  for (int i = 0; i < 6; ++i) {
    Scene scene = scene_with(kAll);
    scene.mass_kg *= 1.0 + 0.3 * i;
    scene.inertia_kg_m2 *= 1.0 + 0.2 * i;
    scene.stiffness *= 1.0 + 0.5 * i;
    scene.anchor_m = {0.01 * i, 0.0, -0.01};
    scene.contacts[0].friction = 0.3 + 0.1 * i;
    scene.tolerance_rad = i < 4 ? 1e-9 : 1e-4;
    if (i == 5) scene.wrench_frame = WrenchFrame::object;
    plans.push_back(test::plan_of(scene, i == 2 ? 0.004 : 0.01));
  }
  plans.push_back(test::plan_of(scene_with("\"x\", \"rz\"")));
  plans.push_back(test::plan_of(scene_with("\"y\", \"rz\"")));
  std::vector<const Plan*> all;
  for (const Plan& plan : plans) all.push_back(&plan);
  expect_the_same<test::Presses>(all, "each its plan");
  expect_the_same<test::HardPresses>({all[0], all[3], all[1], all[2]}, "of one kind");
}

TEST(Batch, AStateThatIsSetIsTheOneThatGoesOn) {
  const Plan plan = test::plan_of(scene_with(kAll));
  test::Presses presses;
  ObjectState state = plan.initial_state();
  for (int i = 0; i < 20; ++i) plan.step(presses.next(), state);
  for (const std::size_t n : {1U, 3U, 4U, 9U}) {
    Batch batch(plan, n);
    EXPECT_EQ(batch.size(), n);
    EXPECT_EQ(bits_of(batch.state(n - 1)), bits_of(plan.initial_state()));
    batch.set_state(n - 1, state);
    EXPECT_EQ(bits_of(batch.state(n - 1)), bits_of(state));
    const FingerWrenches forces = presses.next();
    ObjectState next = state;
    plan.step(forces, next);
    batch.step(std::vector<FingerWrenches>(n, forces));
    EXPECT_EQ(bits_of(batch.state(n - 1)), bits_of(next));
  }
  Batch none(plan, 0);
  none.step({});
  EXPECT_EQ(none.size(), 0U);
}

TEST(Batch, AStepAllocatesNothing) {
  for (const double tolerance_rad : {1e-12, 1e-9, 1e-2}) {
    Scene scene = scene_with(kAll);
    scene.tolerance_rad = tolerance_rad;
    const Plan plan = test::plan_of(scene);
    Batch batch(plan, 10);
    std::vector<test::HardPresses> presses;
    std::vector<FingerWrenches> forces(10);
    for (std::size_t i = 0; i < 10; ++i) presses.emplace_back(i);
    for (int frame = 0; frame < 100; ++frame) {
      for (std::size_t i = 0; i < 10; ++i) forces[i] = presses[i].next();
      const auto before = test::allocations();
      batch.step(forces);
      EXPECT_EQ(test::allocations(), before);
    }
  }
}

}  // namespace
}  // namespace isograsp::batch_test
