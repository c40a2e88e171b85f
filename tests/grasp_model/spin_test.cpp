// SPDX-License-Identifier: GPL-3.0-or-later
// A body that turns freely: golden motions, order, conservation, invariance, stiffness.
#include "grasp_model/spin.hpp"

#include <cmath>

#include "grasp_model/rotation.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::so3::spin_test {
namespace {

const double kTolerance_rad = Scene{}.tolerance_rad;

Body body_of(const test::GoldenRow& row) {
  return {row.vec3("Ix_kgm2", "Iy", "Iz"), row.vec3("Cx_Nmsprad", "Cy", "Cz"),
          row.vec3("Kx_Nmprad", "Ky", "Kz")};
}

/// A plan of three free rotations and nothing else, holds of 10 ms, any torques.
class Turntable {
 public:
  Turntable(const Body& body, const Torques& torques, const Spin& start, double hold_s = 0.01)
      : plan_(test::plan_of(scene_of(body, torques, start), hold_s)),
        state_(plan_.initial_state()) {
    push_.held.torque = torques.world + torques.body;
  }
  void turn(double time_s) {
    const int holds = static_cast<int>(std::lround(time_s / plan_.hold_s()));
    for (int i = 0; i < holds; ++i) {
      plan_.move(push_, state_);
      exceeded_ = exceeded_ || state_.tolerance_exceeded;
      worst_error_rad_ = std::max(worst_error_rad_, state_.error_rad);
    }
  }
  [[nodiscard]] const Quat& q_WO() const { return state_.X_WO.q; }
  [[nodiscard]] Vec3 w_O() const { return q_WO().conjugate() * state_.w_WO_W; }
  [[nodiscard]] bool exceeded() const { return exceeded_; }
  [[nodiscard]] double worst_error_rad() const { return worst_error_rad_; }

 private:
  static Scene scene_of(const Body& body, const Torques& torques, const Spin& start) {
    EXPECT_TRUE(torques.world.isZero(0.0) || torques.body.isZero(0.0));
    Scene scene;
    scene.free = {false, false, false, true, true, true};
    scene.inertia_kg_m2 = body.inertia_kg_m2;
    scene.damping.tail<3>() = body.damping;
    scene.stiffness.tail<3>() = body.stiffness;
    scene.wrench_frame = torques.body.isZero(0.0) ? WrenchFrame::hand : WrenchFrame::object;
    scene.initial_X_WO.q = start.q_WO;
    scene.initial_w_WO_W = start.q_WO * start.w_O;
    return scene;
  }
  Plan plan_;
  ObjectState state_;
  GraspWrench push_;
  bool exceeded_ = false;
  double worst_error_rad_ = 0.0;
};

double energy_of(const Body& body, const Quat& q_WO, const Vec3& w_O) {
  const Vec3 phi = log(q_WO);
  return 0.5 * w_O.dot(body.inertia_kg_m2.cwiseProduct(w_O)) +
         0.5 * phi.dot(body.stiffness.cwiseProduct(phi));
}

TEST(ThreeRotations, MatchTheGoldenMotions) {
  for (const auto& row : test::every(test::golden("rotation_dynamics.csv"))) {
    Turntable table(
        body_of(row),
        {row.vec3("tauwx_Nm", "tauwy", "tauwz"), row.vec3("taubx_Nm", "tauby", "taubz")},
        {exp(row.vec3("phi0x_rad", "phi0y", "phi0z")), row.vec3("w0x_radps", "w0y", "w0z")});
    table.turn(row["T_s"]);
    EXPECT_FALSE(table.exceeded()) << row.text("case");
    const Quat q(row["qw"], row["qx"], row["qy"], row["qz"]);
    const double error_rad = 2.0 * (table.q_WO().coeffs() - q.coeffs()).norm();
    // The errors of all holds at worst, and what printing the start in decimals costs.
    EXPECT_LE(error_rad, kTolerance_rad * std::ceil(row["T_s"] / 0.01) + 1e-14) << row.text("case");
  }
}

const Body kUneven{Vec3(1e-4, 2e-4, 3e-4), Vec3::Zero(), Vec3(0.02, 0.05, 0.1)};
const Spin kTumbling{exp(Vec3(1.2, 0.8, -1.0)), Vec3(1.0, -2.0, 0.5)};

/// Error of the attitude after 0.2 s in `steps` equal steps [rad].
template <class Step>
double error_after(const Step& step, const SpinRate& rate, int steps) {
  const auto after = [&](int count) -> SpinVector {
    SpinVector y = pack(kTumbling);
    for (int i = 0; i < count; ++i) y = step(rate, y, 0.2 / count).end;
    return y;
  };
  static const SpinVector exact = [&] {
    SpinVector y = pack(kTumbling);
    for (int i = 0; i < 2048; ++i)
      y = explicit_step(Order::eighth, rate, y, 0.2 / 2048, nullptr).end;
    return y;
  }();
  const SpinVector difference = after(steps) - exact;
  return difference.head<4>().norm();
}

TEST(ThreeRotations, EachExplicitStepIsOfItsOrder) {
  const SpinRate rate(kUneven);
  for (const auto& [order, number] :
       {std::pair{Order::third, 3.0}, {Order::fifth, 5.0}, {Order::eighth, 8.0}}) {
    const auto step = [&](const SpinRate& r, const SpinVector& y, double h) {
      return explicit_step(order, r, y, h, nullptr);
    };
    // In so many steps the next order counts for little and rounding for nothing.
    const int first = order == Order::third ? 64 : order == Order::fifth ? 32 : 8;
    for (const int steps : {first, 2 * first}) {
      const double found =
          std::log2(error_after(step, rate, steps) / error_after(step, rate, 2 * steps));
      EXPECT_GT(found, number - 0.5);
      EXPECT_LT(found, number + 1.0);
    }
  }
}

TEST(ThreeRotations, TheStiffStepIsOfOrderSix) {
  const SpinRate rate(kUneven);
  for (const int steps : {16, 32}) {
    const double order =
        std::log2(error_after(stiff_step, rate, steps) / error_after(stiff_step, rate, 2 * steps));
    EXPECT_GT(order, 5.5);
    EXPECT_LT(order, 7.0);
  }
}

TEST(ThreeRotations, TheStiffStepsEstimateIsNotBelowHalfTheError) {
  const SpinRate rate(kUneven);
  for (const double h_s : {0.002, 0.005, 0.01, 0.02}) {
    const SpinVector start = pack(kTumbling);
    SpinVector exact = start;
    for (int i = 0; i < 64; ++i)
      exact = explicit_step(Order::eighth, rate, exact, h_s / 64, nullptr).end;
    const SpinStep stiff = stiff_step(rate, start, h_s);
    const double rounding_rad = 8 * test::kEpsilon;
    // The difference of two columns estimates the one before the last: near one radian a step the
    // last is not much better.
    EXPECT_LE(2.0 * (stiff.end - exact).head<4>().norm(), 2.0 * stiff.error_rad + rounding_rad);
  }
}

TEST(ThreeRotations, WithoutTorqueEnergyAndMomentumStay) {
  const Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Zero(), Vec3::Zero()};
  const Spin start{Quat::Identity(), Vec3(0.01, 10.0, 0.0)};
  Turntable table(body, {}, start);
  table.turn(60.0);
  const auto momentum = [&](const Quat& q_WO, const Vec3& w_O) -> Vec3 {
    return q_WO * body.inertia_kg_m2.cwiseProduct(w_O);
  };
  const Vec3 before = momentum(start.q_WO, start.w_O);
  EXPECT_WITHIN(energy_of(body, table.q_WO(), table.w_O()) / energy_of(body, start.q_WO, start.w_O),
                1.0, 1e-10);
  EXPECT_LE((momentum(table.q_WO(), table.w_O()) - before).norm(), 1e-10 * before.norm());
}

TEST(ThreeRotations, ASpringKeepsItsEnergyAndADamperTakesIt) {
  Turntable swings(kUneven, {}, kTumbling);
  const double before = energy_of(kUneven, kTumbling.q_WO, kTumbling.w_O);
  swings.turn(60.0);
  // Every hold errs by its tolerance at most; the stiffest axis turns radians into energy.
  EXPECT_WITHIN(energy_of(kUneven, swings.q_WO(), swings.w_O()) / before, 1.0,
                6000 * kTolerance_rad * 2.0);

  Body damped = kUneven;
  damped.damping = Vec3(1e-4, 2e-4, 3e-4);
  Turntable settles(damped, {}, kTumbling);
  double last = before;
  for (int i = 0; i < 500; ++i) {
    settles.turn(0.01);
    const double now = energy_of(damped, settles.q_WO(), settles.w_O());
    EXPECT_LE(now, last * (1.0 + 1e-9));
    last = now;
  }
  EXPECT_LT(last, 0.1 * before);
}

TEST(ThreeRotations, TurnedBackInTimeTheMotionReturns) {
  Turntable there(kUneven, {}, kTumbling);
  there.turn(1.0);
  Turntable back(kUneven, {}, {there.q_WO(), -there.w_O()});
  back.turn(1.0);
  EXPECT_LE(angle_between(back.q_WO(), kTumbling.q_WO), 200 * kTolerance_rad);
  EXPECT_LE((back.w_O() + kTumbling.w_O).norm(), 1e-6);
}

TEST(ThreeRotations, TurningTheWorldTurnsTheMotion) {
  const Quat g = exp(Vec3(0.4, 1.1, -0.3));
  const Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Constant(1e-3), Vec3::Zero()};
  const Vec3 torque(0.01, -0.02, 0.005);
  Turntable plain(body, {torque, Vec3::Zero()}, kTumbling);
  Turntable turned(body, {g * torque, Vec3::Zero()}, {g * kTumbling.q_WO, kTumbling.w_O});
  plain.turn(0.5);
  turned.turn(0.5);
  EXPECT_LE(angle_between(g * plain.q_WO(), turned.q_WO()), 1e-12);
  EXPECT_LE((plain.w_O() - turned.w_O()).norm(), 1e-11);
}

TEST(ThreeRotations, TheSpringPullsOnSmoothlyThroughHalfATurn) {
  // Turned fast just short of pi: the angle grows past pi and the spring pulls
  // back from where it is, not from the other side.
  const Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Zero(), Vec3::Constant(0.05)};
  for (const double angle : {3.14, 3.1415926}) {
    Turntable table(body, {}, {exp(Vec3(angle, 0, 0)), Vec3(20.0, 0, 0)});
    const double energy = energy_of(body, exp(Vec3(angle, 0, 0)), Vec3(20.0, 0, 0));
    double largest = 0.0;
    for (int i = 0; i < 30; ++i) {
      table.turn(0.01);
      largest = std::max(largest, log(table.q_WO()).norm());
      EXPECT_WITHIN(energy_of(body, table.q_WO(), table.w_O()) / energy, 1.0, 1e-8);
    }
    EXPECT_GT(largest, 3.2);
    EXPECT_FALSE(table.exceeded());
  }
}

TEST(ThreeRotations, HowEverStiffNothingDivergesAndWhatIsNotExactIsFlagged) {
  const Spin start{exp(Vec3(0.01, 0.02, -0.01)), Vec3(1.0, -2.0, 0.5)};
  const Vec3 I = Vec3(1, 2, 3) * 1e-4;
  for (const double rate : {1e3, 1e4, 1e5, 1e7, 1e10}) {
    const Body swings{I, Vec3::Zero(), rate * rate * I};
    const Body settles{I, rate * I, Vec3::Zero()};
    for (const Body& body : {swings, settles}) {
      Turntable table(body, {}, start);
      table.turn(1.0);
      EXPECT_TRUE(table.w_O().allFinite());
      EXPECT_LE(energy_of(body, table.q_WO(), table.w_O()),
                energy_of(body, start.q_WO, start.w_O) * 1.01);
    }
    // Over 64 steps of a radian a swing that never ends is not followed to 3e-10 rad; that is said.
    Turntable swing(swings, {}, start);
    swing.turn(0.01);
    EXPECT_EQ(swing.exceeded(), rate > 3e3) << rate;
    // What settles is exact once it has.
    Turntable settled(settles, {Vec3(1e-4, 0, 0), Vec3::Zero()}, {start.q_WO, Vec3::Zero()});
    settled.turn(0.5);
    EXPECT_FALSE(settled.exceeded()) << rate;
  }
}

TEST(ThreeRotations, AStiffDamperAndACriticalSpringFollowTheTorqueExactly) {
  // Against holds of a quarter and a tolerance that makes the steps small.
  for (const auto& [k_per_I, c_per_I] : {std::pair{5e5, 2.0 * std::sqrt(5e5)},
                                         {5e5, 0.1 * std::sqrt(5e5)},
                                         {100.0, 1e4},
                                         {1e6, 1e6},
                                         {1e8, 2e4}}) {
    const Vec3 I = Vec3(1, 2, 3) * 1e-4;
    const Body body{I, c_per_I * I, k_per_I * I};
    const Torques torques{Vec3(0.02, -0.01, 0.03), Vec3::Zero()};
    Turntable coarse(body, torques, {});
    Turntable fine(body, torques, {}, 0.01 / 32);
    coarse.turn(0.1);
    fine.turn(0.1);
    EXPECT_FALSE(coarse.exceeded());
    EXPECT_LE(angle_between(coarse.q_WO(), fine.q_WO()), 1e-8) << k_per_I << ' ' << c_per_I;
  }
}

TEST(ThreeRotations, WithoutInertiaTheDamperFollowsTheTorqueAtOnce) {
  const Body massless{Vec3::Zero(), Vec3(1e-3, 2e-3, 3e-3), Vec3(0.01, 0.02, 0.01)};
  Body light = massless;
  light.inertia_kg_m2 = Vec3::Constant(1e-10);
  const Torques torques{Vec3(0.002, 0, 0.001), Vec3::Zero()};
  Turntable a(massless, torques, {});
  Turntable b(light, torques, {});
  a.turn(0.2);
  b.turn(0.2);
  EXPECT_GT(log(a.q_WO()).norm(), 0.05);
  EXPECT_LE(angle_between(a.q_WO(), b.q_WO()), 1e-6);  // I / c = 1e-7 s
}

}  // namespace
}  // namespace isograsp::so3::spin_test
