// SPDX-License-Identifier: GPL-3.0-or-later
// Random scenes and forces, 100,000 frames, against a slow reference that shares no formula with
// the plan: the equations of motion as they stand in docs/grasp_model.md, in extended precision and
// small steps, contacts by the letter of the table.
#include <cmath>

#include "grasp_model/dormand_prince.hpp"
#include "tests/grasp_model/grasps.hpp"

namespace isograsp::random_scenes_test {
namespace {

using Real = long double;
using RealVec3 = Eigen::Matrix<Real, 3, 1>;
using RealQuat = Eigen::Quaternion<Real>;
/// p_WO, v_WO_W, q (w x y z), w_O
using RealState = Eigen::Matrix<Real, 13, 1>;

class Dice : public test::RandomGrasps {
 public:
  using RandomGrasps::RandomGrasps;
  /// Of any size between the two.
  double spread(double least, double most) {
    return least * std::pow(most / least, uniform(0.0, 1.0));
  }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }
};

enum class Turning { none, one_axis, three };

Scene random_scene(Dice& dice, Turning turning, WrenchFrame frame) {
  Scene scene;
  scene.wrench_frame = frame;
  scene.mass_kg = dice.spread(0.1, 2.0);
  const Vec3 size_m(dice.uniform(0.03, 0.1), dice.uniform(0.03, 0.1), dice.uniform(0.03, 0.1));
  const Vec3 squares = size_m.cwiseAbs2();
  scene.inertia_kg_m2 =
      scene.mass_kg / 12.0 *
      Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  for (std::size_t i = 0; i < 3; ++i) scene.free[i] = dice.chance(0.6);
  if (turning == Turning::three)
    scene.free[3] = scene.free[4] = scene.free[5] = true;
  else if (turning == Turning::one_axis)
    scene.free[3 + static_cast<std::size_t>(dice.uniform(0, 3))] = true;
  if (turning == Turning::none) scene.free[0] = true;
  for (Eigen::Index i = 0; i < 3; ++i) {
    scene.stiffness[i] = dice.chance(0.2) ? 0.0 : scene.mass_kg * dice.spread(1.0, 1e4);
    scene.damping[i] = scene.mass_kg * dice.spread(0.3, 100.0);
    // Stiff enough to stay far from the spring's pole at a whole turn, or no spring at all.
    scene.stiffness[i + 3] = dice.uniform(0.2, 0.8);
    scene.damping[i + 3] = scene.inertia_kg_m2[i] * dice.spread(10.0, 100.0);
  }
  if (dice.chance(0.3)) scene.stiffness.tail<3>().setConstant(scene.stiffness[3]);
  if (dice.chance(0.2)) scene.stiffness.tail<3>().setZero();
  if (dice.chance(0.3)) scene.gravity_m_s2 = 3.0 * dice.direction();
  scene.anchor_m = 0.1 * dice.direction();
  scene.initial_X_WO.p = scene.anchor_m;
  for (const Finger finger : kFingers) {
    if (dice.chance(0.15)) continue;
    Contact contact;
    contact.finger = finger;
    contact.p_OC = dice.uniform(0.0, 0.04) * dice.direction();
    contact.R_OC.col(2) = dice.direction();
    contact.R_OC.col(0) = contact.R_OC.col(2).unitOrthogonal();
    contact.R_OC.col(1) = contact.R_OC.col(2).cross(contact.R_OC.col(0));
    contact.model = static_cast<ContactModel>(static_cast<int>(dice.uniform(0, 3)));
    contact.friction = dice.uniform(0.1, 1.3);
    contact.torsion_m = contact.model == ContactModel::soft ? dice.uniform(0.0, 0.01) : 0.0;
    contact.threshold_N = dice.chance(0.5) ? 0.0 : dice.uniform(0.05, 0.5);
    scene.contacts.push_back(contact);
  }
  return scene;
}

/// Forces that wander as people press.
class Presses {
 public:
  explicit Presses(Dice& dice) : dice_(dice) {}
  const FingerWrenches& next() {
    for (auto& wrench : now_)
      for (Eigen::Index i = 0; i < 3; ++i) {
        const double mean = i == 2 ? 0.6 : 0.0;
        wrench.force[i] += 0.1 * (mean - wrench.force[i]) + dice_.uniform(-0.3, 0.3);
        wrench.torque[i] += -0.1 * wrench.torque[i] + dice_.uniform(-2e-3, 2e-3);
      }
    return now_;
  }

 private:
  Dice& dice_;
  FingerWrenches now_;
};

class Reference {
 public:
  explicit Reference(const Scene& scene) : scene_(scene) {
    at_.setZero();
    at_.head<3>() = scene.initial_X_WO.p.cast<Real>();
    at_[6] = 1;
  }

  void hold(const FingerWrenches& forces, double hold_s) {
    push(forces);
    Real fastest = 0;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const Real inertia = i < 3 ? scene_.mass_kg : scene_.inertia_kg_m2[i - 3];
      fastest =
          std::max(fastest, std::sqrt(scene_.stiffness[i] / inertia) + scene_.damping[i] / inertia);
    }
    fastest += at_.tail<3>().norm() + torque_.norm() / scene_.inertia_kg_m2.minCoeff() * hold_s;
    constexpr Real kTurn_rad = 0.3L;  // a step: error of order 8 below 1e-11 of the motion
    const int steps = 1 + static_cast<int>(fastest * hold_s / kTurn_rad);
    const Real h = Real(hold_s) / steps;
    for (int i = 0; i < steps; ++i) {
      std::array<RealState, 12> k;
      dormand_prince::stages(
          at_, h, [this](std::size_t, const RealState& y) { return rate(y); }, k);
      at_ += h * dormand_prince::increment(k);
      at_.segment<4>(6).normalize();
    }
  }
  [[nodiscard]] Vec3 p_WO() const { return at_.head<3>().cast<double>(); }
  [[nodiscard]] Quat q_WO() const {
    return RealQuat(at_[6], at_[7], at_[8], at_[9]).cast<double>();
  }

 private:
  void push(const FingerWrenches& forces) {
    force_.setZero();
    torque_.setZero();
    for (const Contact& contact : scene_.contacts) {
      const std::size_t f = index_of(contact.finger);
      const Wrench& measured = forces[f];
      const double fz = measured.force.z();
      touching_[f] = fz > (touching_[f] ? contact.threshold_N / 2 : contact.threshold_N);
      if (!touching_[f] || !(fz > 0.0)) continue;
      RealVec3 f_C(0, 0, fz);
      Real tz = 0;
      if (contact.model != ContactModel::frictionless) {
        f_C = measured.force.cast<Real>();
        Real asked = f_C.head<2>().norm() / (Real(contact.friction) * fz);
        if (contact.model == ContactModel::soft && contact.torsion_m > 0.0) {
          tz = measured.torque.z();
          const Real turning = tz / (Real(contact.torsion_m) * fz);
          asked = std::sqrt(asked * asked + turning * turning);
        }
        if (asked > 1) {
          f_C.head<2>() /= asked;
          tz /= asked;
        }
      }
      const RealVec3 force = contact.R_OC.cast<Real>() * f_C;
      force_ += force;
      torque_ += contact.p_OC.cast<Real>().cross(force) + tz * contact.R_OC.col(2).cast<Real>();
    }
  }

  [[nodiscard]] RealState rate(const RealState& y) const {
    const RealQuat q(y[6], y[7], y[8], y[9]);
    const RealVec3 w = y.tail<3>();
    const bool follows = scene_.wrench_frame == WrenchFrame::object;
    const RealVec3 force = follows ? RealVec3(q * force_) : force_;
    RealVec3 torque = follows ? torque_ : RealVec3(q.conjugate() * torque_);
    const RealVec3 I = scene_.inertia_kg_m2.cast<Real>();
    torque -= scene_.damping.tail<3>().cast<Real>().cwiseProduct(w);
    torque -= w.cross(I.cwiseProduct(w).eval());
    // Gradient of phi^T K phi / 2 by its definition, Jr^-T as a matrix.
    const Real s = q.vec().norm();
    if (s > 0) {
      const RealVec3 phi = 2 * std::atan2(s, q.w()) / s * q.vec();
      const Real t = phi.norm();
      const RealVec3 u = scene_.stiffness.tail<3>().cast<Real>().cwiseProduct(phi);
      const Real d =
          t < 1e-3L ? 1 / 12.0L + t * t / 720.0L : (1 - t / 2 / std::tan(t / 2)) / (t * t);
      torque -= u - phi.cross(u) / 2 + d * phi.cross(phi.cross(u));
    }
    RealState out = RealState::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (scene_.free[static_cast<std::size_t>(i)]) {
        out[i] = y[3 + i];
        out[3 + i] = (force[i] - scene_.damping[i] * y[3 + i] -
                      scene_.stiffness[i] * (y[i] - scene_.anchor_m[i])) /
                         Real(scene_.mass_kg) +
                     scene_.gravity_m_s2[i];
      }
      if (scene_.free[static_cast<std::size_t>(i) + 3]) out[10 + i] = torque[i] / I[i];
    }
    const RealQuat turn = q * RealQuat(0, w.x(), w.y(), w.z());
    out.segment<4>(6) << turn.w() / 2, turn.x() / 2, turn.y() / 2, turn.z() / 2;
    return out;
  }

  const Scene& scene_;
  RealState at_;
  RealVec3 force_ = RealVec3::Zero();
  RealVec3 torque_ = RealVec3::Zero();
  std::array<bool, kFingerCount> touching_{};
};

struct Worst {
  double position = 0.0;  ///< relative to the largest excursion of its run
  double angle_rad = 0.0;
  int exceeded = 0;
};

constexpr int kFrames = 125;
constexpr double kHold_s = 0.01;

Worst compare(Turning turning, WrenchFrame frame, int scenes, std::uint64_t seed,
              double tolerance_rad = Scene{}.tolerance_rad) {
  Dice dice(seed);
  Worst worst;
  for (int i = 0; i < scenes; ++i) {
    Scene scene = random_scene(dice, turning, frame);
    scene.tolerance_rad = tolerance_rad;
    const Plan plan = test::plan_of(scene, kHold_s);
    ObjectState state = plan.initial_state();
    Reference reference(scene);
    Presses presses(dice);
    double error_m = 0.0;
    double excursion_m = 1e-6;
    for (int frame_number = 0; frame_number < kFrames; ++frame_number) {
      const FingerWrenches& forces = presses.next();
      plan.step(forces, state);
      reference.hold(forces, kHold_s);
      error_m = std::max(error_m, (state.X_WO.p - reference.p_WO()).norm());
      excursion_m = std::max(excursion_m, (reference.p_WO() - scene.anchor_m).norm());
      worst.angle_rad = std::max(worst.angle_rad, angle_between(state.X_WO.q, reference.q_WO()));
      worst.exceeded += state.tolerance_exceeded ? 1 : 0;
    }
    worst.position = std::max(worst.position, error_m / excursion_m);
  }
  std::printf("%d frames: worst position %.1e of the excursion, worst angle %.1e rad, %d flagged\n",
              scenes * kFrames, worst.position, worst.angle_rad, worst.exceeded);
  ::testing::Test::RecordProperty("worst_position_relative", std::to_string(worst.position));
  ::testing::Test::RecordProperty("worst_angle_rad", std::to_string(worst.angle_rad));
  return worst;
}

/// The reference's own error, and rounding over the run.
constexpr double kClosedForm = 1e-10;
/// Errors of all holds added up, none forgotten.
const double kSummed_rad = kFrames * Scene{}.tolerance_rad;

TEST(RandomScenes, TranslationsFollowTheEquations) {
  const Worst worst = compare(Turning::none, WrenchFrame::hand, 160, 1);
  EXPECT_LE(worst.position, kClosedForm);
  EXPECT_EQ(worst.angle_rad, 0.0);
}
TEST(RandomScenes, OneAxisFollowsTheEquations) {
  const Worst worst = compare(Turning::one_axis, WrenchFrame::hand, 160, 2);
  EXPECT_LE(worst.position, kClosedForm);
  EXPECT_LE(worst.angle_rad, kClosedForm);
}
TEST(RandomScenes, OneAxisAndAForceThatTurnsWithItFollowTheEquations) {
  const Worst worst = compare(Turning::one_axis, WrenchFrame::object, 160, 3);
  EXPECT_LE(worst.position, kClosedForm);
  EXPECT_LE(worst.angle_rad, kClosedForm);
  EXPECT_EQ(worst.exceeded, 0);
}
TEST(RandomScenes, ThreeRotationsFollowTheEquations) {
  const Worst worst = compare(Turning::three, WrenchFrame::hand, 160, 4);
  EXPECT_LE(worst.position, kClosedForm);
  EXPECT_LE(worst.angle_rad, kSummed_rad);
  EXPECT_EQ(worst.exceeded, 0);
}
TEST(RandomScenes, ThreeRotationsAndAForceThatTurnsWithThemFollowTheEquations) {
  const Worst worst = compare(Turning::three, WrenchFrame::object, 160, 5);
  EXPECT_LE(worst.position, kSummed_rad);  // a wrong angle is a wrong force
  EXPECT_LE(worst.angle_rad, kSummed_rad);
  EXPECT_EQ(worst.exceeded, 0);
}

TEST(RandomScenes, AtCoarserTolerancesErrorsStayWithinThemAddedUp) {
  for (const WrenchFrame frame : {WrenchFrame::hand, WrenchFrame::object})
    for (const double tolerance_rad : {1e-8, 1e-6, 1e-4, 1e-3}) {
      const Worst worst = compare(Turning::three, frame, 40, 6, tolerance_rad);
      EXPECT_LE(worst.position, kFrames * tolerance_rad);
      EXPECT_LE(worst.angle_rad, kFrames * tolerance_rad);
      EXPECT_EQ(worst.exceeded, 0);
    }
}

}  // namespace
}  // namespace isograsp::random_scenes_test
