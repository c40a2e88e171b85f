// SPDX-License-Identifier: GPL-3.0-or-later
// What a coarser answer costs and what it keeps: orders 3, 5 and 8 of three free rotations.
#include <cmath>

#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/plan_words.hpp"
#include "grasp_model/rotation.hpp"
#include "tests/grasp_model/grasps.hpp"
#include "tests/support/every.hpp"

namespace isograsp::so3::orders_test {
namespace {

constexpr double kHold_s = 0.01;
constexpr Order kOrders[] = {Order::third, Order::fifth, Order::eighth};

/// Bodies, torques and motions of all sizes that one explicit step a hold can follow.
class Frames : public test::RandomGrasps {
 public:
  using RandomGrasps::RandomGrasps;
  double spread(double least, double most) {
    return least * std::pow(most / least, uniform(0.0, 1.0));
  }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  Body body() {
    Body body;
    const Vec3 squares =
        Vec3(uniform(0.03, 0.1), uniform(0.03, 0.1), uniform(0.03, 0.1)).cwiseAbs2();
    body.inertia_kg_m2 =
        spread(0.1, 2.0) / 12.0 *
        Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    for (Eigen::Index i = 0; i < 3; ++i) {
      body.stiffness[i] = body.inertia_kg_m2[i] * spread(10.0, 3e4);
      body.damping[i] = chance(0.3) ? 0.0 : body.inertia_kg_m2[i] * spread(0.1, 100.0);
    }
    if (chance(0.3)) body.stiffness.setConstant(body.stiffness.x());
    if (chance(0.2)) body.stiffness.setZero();
    return body;
  }
  Torques torques(const Body& body) {
    Torques torques;
    if (chance(0.2)) return torques;
    const Vec3 torque = body.inertia_kg_m2.minCoeff() * spread(1.0, 5e3) * direction();
    (chance(0.5) ? torques.world : torques.body) = torque;
    return torques;
  }
  Spin spin() {
    if (chance(0.1)) return {};
    return {exp(spread(0.01, 3.0) * direction()), spread(0.01, 100.0) * direction()};
  }
};

/// The same motion in 16 steps: its error is below that of one step of order 8 by 16^8.
SpinVector exact_end(const SpinRate& rate, const SpinVector& start) {
  constexpr int kSteps = 16;
  SpinVector y = start;
  for (int i = 0; i < kSteps; ++i)
    y = explicit_step(Order::eighth, rate, y, kHold_s / kSteps, nullptr).end;
  return y;
}

TEST(Orders, TheEstimateBoundsTheErrorOf100000RandomFrames) {
  Frames dice(1);
  std::array<int, 3> frames{};
  std::array<double, 3> worst{};
  // Rounding of the long way and the short one.
  constexpr double kRounding_rad = 1e-13;
  while (frames[0] < 100'000) {
    const Body body = dice.body();
    SpinRate rate(body);
    rate.load(dice.torques(body));
    const SpinVector start = pack(dice.spin());
    const double turn_rad = rate.fastest(start, kHold_s) * kHold_s;
    if (turn_rad > stable_rad(Order::eighth)) continue;
    const SpinVector end = exact_end(rate, start);
    for (const Order order : kOrders) {
      if (turn_rad > stable_rad(order)) continue;
      const auto i = static_cast<std::size_t>(order);
      ++frames[i];
      const SpinStep step = explicit_step(order, rate, start, kHold_s, nullptr);
      const double error_rad = angle_of(step.end - end) - kRounding_rad;
      if (error_rad > 0.0) worst[i] = std::max(worst[i], error_rad / step.error_rad);
    }
  }
  for (const Order order : kOrders) {
    const auto i = static_cast<std::size_t>(order);
    std::printf("order %zu: %d frames, error at most %.2f times the estimate\n", i, frames[i],
                worst[i]);
    EXPECT_GE(frames[i], 100'000);
    EXPECT_LE(worst[i], estimate_factor(order));
    // The factor is no more generous than it must be.
    EXPECT_GE(worst[i], 0.25 * estimate_factor(order));
  }
}

TEST(Orders, TheStepOfOrderEightHasTheBitsOfItsFormulasOneByOne) {
  Frames dice(2);
  for (int n = 0; n < 2000; ++n) {
    const Body body = dice.body();
    SpinRate rate(body);
    const Torques torques = dice.torques(body);
    rate.load(torques);
    const SpinVector start = pack(dice.spin());
    const Vec3& I = body.inertia_kg_m2;
    const auto rate_of = [&](std::size_t, const SpinVector& y) {
      const Vec3 w = y.segment<3>(4);
      const Vec3 t = rate.drive(y);
      SpinVector k = SpinVector::Zero();
      k[0] = -0.5 * (y[1] * w[0] + y[2] * w[1] + y[3] * w[2]);
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Eigen::Index j = (i + 1) % 3;
        const Eigen::Index l = (i + 2) % 3;
        k[4 + i] = 1.0 / I[i] * (t[i] - body.damping[i] * w[i] - (I[l] - I[j]) * w[j] * w[l]);
      }
      k[1] = 0.5 * (y[0] * w[0] + y[2] * w[2] - y[3] * w[1]);
      k[2] = 0.5 * (y[0] * w[1] + y[3] * w[0] - y[1] * w[2]);
      k[3] = 0.5 * (y[0] * w[2] + y[1] * w[1] - y[2] * w[0]);
      return k;
    };
    std::array<SpinVector, 12> k;
    dormand_prince::stages(start, kHold_s, rate_of, k);
    const SpinVector end = start + kHold_s * dormand_prince::increment(k);
    const SpinStep step = explicit_step(Order::eighth, rate, start, kHold_s, nullptr);
    EXPECT_EQ(end.head<7>(), step.end.head<7>()) << n;
  }
}

TEST(Orders, WideRegistersGiveTheBitsOfNarrowOnes) {
  Frames dice(4);
  for (int n = 0; n < 2000; ++n) {
    SpinRate rate(dice.body());
    rate.load(dice.torques(rate.body()));
    if (dice.chance(0.5)) rate.watch();
    const SpinVector start = pack(dice.spin());
    for (const Order order : kOrders) {
      const SpinStep wide = explicit_step(order, rate, start, kHold_s, nullptr);
      const SpinStep narrow = explicit_step_narrow(order, rate, start, kHold_s);
      EXPECT_EQ(wide.end, narrow.end) << n;
      EXPECT_EQ(wide.error_rad, narrow.error_rad) << n;
      EXPECT_EQ(wide.coarser_rad, narrow.coarser_rad) << n;
    }
  }
}

Scene scene_of(const Body& body, const Spin& start, double tolerance_rad) {
  Scene scene;
  scene.free = {false, false, false, true, true, true};
  scene.inertia_kg_m2 = body.inertia_kg_m2;
  scene.damping.tail<3>() = body.damping;
  scene.stiffness.tail<3>() = body.stiffness;
  scene.initial_X_WO.q = start.q_WO;
  scene.initial_w_WO_W = start.q_WO * start.w_O;
  scene.tolerance_rad = tolerance_rad;
  return scene;
}

TEST(Orders, EnergyNeverGrowsAtAnyTolerance) {
  Frames dice(3);
  // A hold turns the velocity into body axes and back.
  constexpr double kRounding = 1e-14;
  constexpr double kExactGain = 1e-8;
  for (const double tolerance_rad : {3e-10, 2e-9, 1e-6, 1e-4, 1e-2, 1.0, 1e3}) {
    const bool exact = tolerance_rad == Scene{}.tolerance_rad;
    for (int n = 0; n < 60; ++n) {
      Body body = dice.body();
      const bool stiff = n % 4 == 3;
      if (stiff) body.stiffness *= 1e4;
      if (n % 3 == 0) body.damping.setZero();
      const Spin start{exp(dice.spread(0.01, 3.0) * dice.direction()),
                       dice.spread(0.01, 100.0) * dice.direction()};
      const Plan plan = test::plan_of(scene_of(body, start, tolerance_rad), kHold_s);
      const SpinRate rate(body);
      ObjectState state = plan.initial_state();
      const auto energy = [&] {
        return rate.energy(pack({state.X_WO.q, state.X_WO.q.conjugate() * state.w_WO_W}));
      };
      double before_J = energy();
      for (int hold = 0; hold < 100; ++hold) {
        plan.move({}, state);
        const double now_J = energy();
        // As good as exact: what a hold may err by, the error of the speed included, can be gain.
        const double gain = exact && !state.tolerance_exceeded ? kExactGain : kRounding;
        ASSERT_LE(now_J, before_J * (1.0 + gain)) << tolerance_rad << ' ' << n << ' ' << hold;
        before_J = now_J;
      }
    }
  }
}

TEST(Orders, ACoarserToleranceTakesAndSaysALowerOrder) {
  const std::string file = test::data_path("dynamics/S3.toml");
  int last = 0;
  int last_flops = std::numeric_limits<int>::max();
  for (const auto& [tolerance_rad, order] :
       {std::pair{3e-10, Order::eighth}, {1e-4, Order::fifth}, {1e-1, Order::third}}) {
    Scene scene = test::scene_file(file);
    scene.tolerance_rad = tolerance_rad;
    const Plan plan = test::plan_of(scene, kHold_s);
    EXPECT_EQ(order_of(plan.likely_level()), order);
    EXPECT_LE(plan.likely_level(), last);
    EXPECT_LT(flops_per_frame(plan), last_flops);
    last = plan.likely_level();
    last_flops = flops_per_frame(plan);
    std::string said;
    for (const auto& [name, words] : test::every(words_of(plan)))
      if (name == "rotation") said = words;
    constexpr const char* kSaid[] = {"order 3", "order 5", "order 8"};
    const std::string begins = std::string(" rad a hold, ") + kSaid[static_cast<int>(order)];
    EXPECT_NE(said.find(begins), std::string::npos) << said;
  }
}

TEST(Orders, AFastMotionIsTakenByAHigherOrderAndASlowOneByALowerAgain) {
  const Body body{Vec3(1e-4, 2e-4, 3e-4), Vec3::Constant(2e-3), Vec3::Constant(0.05)};
  const Plan plan = test::plan_of(scene_of(body, {}, 1e-5), kHold_s);
  ObjectState state = plan.initial_state();
  GraspWrench push;
  push.held.torque = Vec3(0.2, -0.1, 0.3);
  plan.move(push, state);
  EXPECT_GE(state.level, -1);
  EXPECT_LE(state.error_rad, 1e-5);
  for (int hold = 0; hold < 300; ++hold) plan.move({}, state);
  EXPECT_EQ(order_of(state.level), Order::third);
}

TEST(Orders, TheDefaultToleranceStaysWithOrderEight) {
  for (const char* name : {"S3", "S5"}) {
    const Plan plan = test::plan_of(
        test::scene_file(test::data_path(std::string("dynamics/") + name + ".toml")), kHold_s);
    EXPECT_EQ(plan.coarsest_level(), 0);
    EXPECT_EQ(plan.likely_level(), 0);
  }
}

}  // namespace
}  // namespace isograsp::so3::orders_test
