// SPDX-License-Identifier: GPL-3.0-or-later
// Sixty seconds of forces against reference trajectories made by other methods
// (tests/data/dynamics).
#include <cmath>

#include "core/csv.hpp"
#include "hand/finger_forces.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/within.hpp"

namespace isograsp::dynamics_test {
namespace {

constexpr double kHold_s = 0.01;
constexpr int kHolds = 6000;
/// The closed form after 6,000 holds: rounding alone.
constexpr double kRounding = 1e-14;
/// The kept rows miss the peaks of a stiff motion, so its excursion seems smaller.
constexpr double kStiffRounding = 3e-14;
constexpr int kEvery = 20;  // the reference keeps every 20th hold

struct Deviation {
  std::array<double, 4> largest{};    ///< position, attitude, velocity, angular velocity
  std::array<double, 4> excursion{};  ///< of the reference
  [[nodiscard]] double relative() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
      if (excursion[i] > 0.0) worst = std::max(worst, largest[i] / excursion[i]);
    return worst;
  }
};

Deviation follow(const std::string& name) {
  const Plan plan =
      test::plan_of(test::scene_file(test::data_path("dynamics/" + name + ".toml")), kHold_s);
  auto forces = FingerForcesReader::open(test::data_path("dynamics/forces.csv"));
  auto reference = CsvReader::open(test::data_path("dynamics/" + name + "_reference.csv"));
  EXPECT_TRUE(forces.ok() && reference.ok());
  ObjectState state = plan.initial_state();
  FingerForcesRow row;
  std::vector<double> expected(reference->columns().size());
  Deviation deviation;
  int compared = 0;
  for (int hold = 1; hold <= kHolds; ++hold) {
    EXPECT_TRUE(*forces->next(row));
    plan.move(plan.grasp(row.wrench_C, state), state);
    EXPECT_FALSE(state.tolerance_exceeded);
    if (hold % kEvery != 0) continue;
    EXPECT_TRUE(*reference->next(expected));
    const Vec3 w_O = state.X_WO.q.conjugate() * state.w_WO_W;
    const Vec3& p = state.X_WO.p;
    const Vec3 q = state.X_WO.q.vec();
    const Vec3& v = state.v_WO_W;
    const std::array<const Vec3*, 4> values{&p, &q, &v, &w_O};
    const std::array<std::size_t, 4> first{1, 5, 8, 11};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double target = expected[first[i] + axis];
        if (std::isnan(target)) continue;
        const double error = std::abs((*values[i])[static_cast<Eigen::Index>(axis)] - target);
        deviation.largest[i] = std::max(deviation.largest[i], std::isfinite(error) ? error : 1e300);
        deviation.excursion[i] = std::max(deviation.excursion[i], std::abs(target));
        ++compared;
      }
  }
  EXPECT_GE(compared, 300 * 3);
  return deviation;
}

TEST(Dynamics, KnobFollowsTheReference) {
  EXPECT_LE(follow("S1").relative(), kRounding);
}
TEST(Dynamics, PlanarBlockFollowsTheReference) {
  EXPECT_LE(follow("S2").relative(), kRounding);
}
TEST(Dynamics, StiffBlockFollowsTheReference) {
  EXPECT_LE(follow("S4a").relative(), kStiffRounding);
}
TEST(Dynamics, OverdampedBlockFollowsTheReference) {
  EXPECT_LE(follow("S7").relative(), kRounding);
}
TEST(Dynamics, FreeBlockFollowsTheReference) {
  EXPECT_LE(follow("S3").relative(), 1e-8);
}

TEST(Dynamics, TumblingKeepsEnergyAndMomentumAndStaysNearTheReference) {
  const Scene scene = test::scene_file(test::data_path("dynamics/S5.toml"));
  const Plan plan = test::plan_of(scene, kHold_s);
  auto reference = CsvReader::open(test::data_path("dynamics/S5_reference.csv"));
  std::vector<double> expected(reference->columns().size());
  ObjectState state = plan.initial_state();
  const auto momentum = [&]() -> Vec3 {
    const Vec3 w_O = state.X_WO.q.conjugate() * state.w_WO_W;
    return state.X_WO.q * scene.inertia_kg_m2.cwiseProduct(w_O);
  };
  const Vec3 momentum_before = momentum();
  const double energy_before = momentum_before.dot(state.w_WO_W);
  for (int hold = 1; hold <= kHolds; ++hold) {
    plan.move(plan.grasp({}, state), state);
    EXPECT_WITHIN(momentum().dot(state.w_WO_W) / energy_before, 1.0, 1e-10);
    EXPECT_LE((momentum() - momentum_before).norm(), 1e-10 * momentum_before.norm());
    if (hold % kEvery != 0) continue;
    ASSERT_TRUE(*reference->next(expected));
    // Next to a separatrix rounding alone costs 1e-7 rad.
    EXPECT_WITHIN(state.X_WO.q.w(), expected[4], 1e-6);
  }
}

}  // namespace
}  // namespace isograsp::dynamics_test
