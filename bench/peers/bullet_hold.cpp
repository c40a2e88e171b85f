// SPDX-License-Identifier: GPL-3.0-or-later
// The hold of bench/hold_scene.hpp in Bullet (double precision): its world with a sequential
// impulse solver, spinning friction for the torsion of a pad.
#include <memory>

#include <btBulletDynamicsCommon.h>

#include "bench/hold_scene.hpp"

namespace isograsp::bench {

namespace {

btVector3 vector_of(const Eigen::Vector3d& u) {
  return {u.x(), u.y(), u.z()};
}
Eigen::Vector3d vector_of(const btVector3& u) {
  return {u.x(), u.y(), u.z()};
}

void hold(int digits, int iterations, int substeps) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.getSolverInfo().m_numIterations = iterations;
  btBoxShape box_shape({kTipHalf_m, kBoxHalf_y_m, kBoxHalf_z_m});
  constexpr double kMargin_m = 0.001;  // inside the box: its faces stay where they are
  box_shape.setMargin(kMargin_m);
  btSphereShape tip_shape(kTip_m);
  const auto add = [&](double mass_kg, btCollisionShape& shape, const Eigen::Vector3d& p) {
    btVector3 inertia;
    shape.calculateLocalInertia(mass_kg, inertia);
    auto body = std::make_unique<btRigidBody>(mass_kg, nullptr, &shape, inertia);
    body->setWorldTransform(btTransform(btQuaternion::getIdentity(), vector_of(p)));
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setFriction(std::sqrt(kFriction));  // those of both bodies are multiplied
    // Of both, each is multiplied with the other's friction and added; without rolling friction the
    // engine leaves spinning friction out, too.
    body->setSpinningFriction(0.5 * std::sqrt(kFriction) * kTorsion_m);
    body->setRollingFriction(0.5 * std::sqrt(kFriction) * kTorsion_m);
    world.addRigidBody(body.get());
    body->setGravity({0, 0, 0});
    return body;
  };
  const auto box = add(kBoxMass_kg, box_shape, {0.0, 0.0, kBeside_m});
  const std::vector<Tip> tips = tips_of(digits);
  std::vector<std::unique_ptr<btRigidBody>> spheres;
  for (const Tip& tip : tips) {
    spheres.push_back(
        add(kTipMass_kg, tip_shape, {tip.side * (kTipHalf_m + kTip_m), 0.0, tip.z_m}));
    spheres.back()->setAngularFactor({0, 0, 0});
  }
  Hold hold;
  double depth_m = 0.0;
  const double step_s = kStep_s / substeps;
  const int steps = static_cast<int>(kEnd_s / step_s);
  for (int k = 0; k < steps; ++k) {
    const double t_s = (k + 0.5) * step_s;
    const double begin_ns = processor_ns();
    box->applyCentralForce({0, -kBoxMass_kg * kGravity_m_s2 * weight_at(t_s), 0});
    for (std::size_t i = 0; i < tips.size(); ++i)
      spheres[i]->applyCentralForce(
          vector_of(tip_force(tips[i], vector_of(spheres[i]->getWorldTransform().getOrigin()),
                              vector_of(spheres[i]->getLinearVelocity()), t_s)));
    world.stepSimulation(step_s, 0);
    hold.timed(processor_ns() - begin_ns);
    const btQuaternion turn = box->getWorldTransform().getRotation();
    const Eigen::Quaterniond q_WO(turn.w(), turn.x(), turn.y(), turn.z());
    depth_m = 0.0;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Eigen::Vector3d tip_O =
          q_WO.conjugate() * vector_of(spheres[i]->getWorldTransform().getOrigin() -
                                       box->getWorldTransform().getOrigin());
      depth_m = std::max(depth_m, kTipHalf_m + kTip_m - std::abs(tip_O.x()));
      if (i == 0) hold.look(t_s, tip_O, q_WO);
    }
  }
  hold.print("Bullet " + std::to_string(btGetVersion() / 100) + "." +
                 std::to_string(btGetVersion() % 100) + ", " + std::to_string(iterations) +
                 " iterations, " + std::to_string(substeps) + " a millisecond",
             digits, depth_m);
  for (const auto& sphere : spheres) world.removeRigidBody(sphere.get());
  world.removeRigidBody(box.get());
}

}  // namespace

}  // namespace isograsp::bench

int main() {
  for (const int digits : {2, 3})
    for (const auto& [iterations, substeps] : {std::pair{10, 1}, {100, 1}, {10, 10}})
      isograsp::bench::hold(digits, iterations, substeps);
}
