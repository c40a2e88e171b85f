// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet (double precision): one rigid body without collision shape; locked degrees of freedom by
// its linear and angular factors. With the world's stepSimulation, or with the body's own functions
// and no world at all.
#include <btBulletDynamicsCommon.h>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

enum class Springs : std::uint8_t {
  forces,          ///< springs and dampers as forces per substep
  native_damping,  ///< springs as forces, dampers as the body's exponential damping
  constraint       ///< btGeneric6DofSpring2Constraint
};
enum class Stepping : std::uint8_t { world, bare_body };

struct Options {
  Springs springs = Springs::forces;
  Stepping stepping = Stepping::world;
  int gyroscopic = 0;  ///< a BT_ENABLE_GYROSCOPIC_… flag
};

btVector3 vector_of(const Triple& a) {
  return {a[0], a[1], a[2]};
}

class BulletBody : public Simulation {
 public:
  BulletBody(const Case& scene, const Options& options, int substeps)
      : scene_(scene),
        options_(options),
        substeps_(substeps),
        h_(scene.hold_s / substeps),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        body_(btRigidBody::btRigidBodyConstructionInfo(scene.mass_kg, nullptr, &shape_,
                                                       vector_of(scene.inertia_kg_m2))) {
    const auto free = [&scene](std::size_t dof) { return scene.free[dof] ? 1.0 : 0.0; };
    body_.setLinearFactor({free(0), free(1), free(2)});
    body_.setAngularFactor({free(3), free(4), free(5)});
    body_.setLinearVelocity(vector_of(scene.start.v_WO_W));
    body_.setAngularVelocity(vector_of(scene.start.w_WO_W));
    body_.setActivationState(DISABLE_DEACTIVATION);
    body_.setFlags(options.gyroscopic);
    if (options.springs == Springs::native_damping)
      body_.setDamping(-std::expm1(-scene.damping[0] / scene.mass_kg),
                       -std::expm1(-scene.damping[5] / scene.inertia_kg_m2[2]));
    if (options.stepping == Stepping::bare_body) return;
    world_.setGravity({0, 0, 0});
    world_.setForceUpdateAllAabbs(false);
    world_.getDispatchInfo().m_useContinuous = false;
    world_.addRigidBody(&body_, 0, 0);
    body_.setGravity({0, 0, 0});
    if (options.springs == Springs::constraint) add_constraint();
  }
  ~BulletBody() override {
    if (spring_) world_.removeConstraint(spring_.get());
    if (options_.stepping == Stepping::world) world_.removeRigidBody(&body_);
  }

  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const btVector3 force = vector_of(scene_.pushes[k].force);
      const btVector3 torque = vector_of(scene_.pushes[k].torque);
      for (int i = 0; i < substeps_; ++i) {
        apply(force, torque);
        if (options_.stepping == Stepping::world)
          world_.stepSimulation(h_, 0);
        else
          step_body();
      }
    }
  }
  Motion6 motion() const override {
    const btTransform& X_WO = body_.getWorldTransform();
    const btQuaternion q = X_WO.getRotation();
    const auto triple = [](const btVector3& u) { return Triple{u.x(), u.y(), u.z()}; };
    return {triple(X_WO.getOrigin()),
            {q.w(), q.x(), q.y(), q.z()},
            triple(body_.getLinearVelocity()),
            triple(body_.getAngularVelocity())};
  }

 private:
  void add_constraint() {
    spring_ = std::make_unique<btGeneric6DofSpring2Constraint>(body_, btTransform::getIdentity());
    for (int dof = 0; dof < 6; ++dof) {
      spring_->setLimit(dof, 1, -1);  // free
      const auto i = static_cast<std::size_t>(dof);
      if (!scene_.free[i]) continue;
      spring_->enableSpring(dof, true);
      spring_->setStiffness(dof, scene_.stiffness[i]);
      spring_->setDamping(dof, scene_.damping[i]);
      spring_->setEquilibriumPoint(dof, 0);
    }
    world_.addConstraint(spring_.get());
  }
  void apply(const btVector3& force, const btVector3& torque) {
    const btMatrix3x3& R_WO = body_.getWorldTransform().getBasis();
    btVector3 total = scene_.follows ? R_WO * force : force;
    btVector3 moment = scene_.follows ? R_WO * torque : torque;
    const auto& k = scene_.stiffness;
    const auto& c = scene_.damping;
    if (options_.springs != Springs::constraint) {
      const btVector3& p = body_.getWorldTransform().getOrigin();
      total -= btVector3(k[0], k[1], k[2]) * p;
      if (scene_.linear()) {
        moment[2] -= k[5] * std::atan2(R_WO[1][0], R_WO[0][0]);
      } else if (k[3] != 0.0) {
        const btQuaternion q = body_.getWorldTransform().getRotation();
        moment -= k[3] * vector_of(log({q.w(), q.x(), q.y(), q.z()}));
      }
    }
    if (options_.springs == Springs::forces) {
      total -= btVector3(c[0], c[1], c[2]) * body_.getLinearVelocity();
      moment -= c[5] * body_.getAngularVelocity();  // the same about all axes in these scenes
    }
    body_.applyCentralForce(total);
    body_.applyTorque(moment);
  }
  void step_body() {
    if (options_.gyroscopic != 0)
      body_.setAngularVelocity(body_.getAngularVelocity() +
                               body_.computeGyroscopicImpulseImplicit_Body(h_));
    body_.integrateVelocities(h_);
    body_.applyDamping(h_);
    btTransform next;
    body_.predictIntegratedTransform(h_, next);
    body_.proceedToTransform(next);
    body_.clearForces();
  }
  const Case& scene_;
  Options options_;
  int substeps_;
  double h_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btEmptyShape shape_;
  btRigidBody body_;
  std::unique_ptr<btGeneric6DofSpring2Constraint> spring_;
};

std::vector<Method> methods(const Case& scene) {
  std::vector<Method> all;
  const auto add = [&all](const std::string& name, Options options, const std::string& setup) {
    const bool parts = options.stepping == Stepping::bare_body;
    const int most = options.springs == Springs::constraint ? 16 : parts ? 256 : 64;
    for (const int n : ladder(most))
      all.push_back({name, n, setup,
                     [=](const Case& c) { return std::make_unique<BulletBody>(c, options, n); },
                     parts});
  };
  const std::string forces = "springs and dampers as forces per substep";
  const std::string bare = "; the body's own functions called directly, no world";
  if (!scene.linear()) {
    add("world, gyroscopic implicit (body)",
        {Springs::forces, Stepping::world, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY}, forces);
    add("world, gyroscopic implicit (world)",
        {Springs::forces, Stepping::world, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD}, forces);
    add("world, gyroscopic explicit",
        {Springs::forces, Stepping::world, BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT}, forces);
    add("bare body",
        {Springs::forces, Stepping::bare_body, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY},
        forces + bare + "; gyroscopic implicit (body)");
    return all;
  }
  add("world", {}, forces);
  add("world, spring constraint", {Springs::constraint, Stepping::world, 0},
      "btGeneric6DofSpring2Constraint, the engine's own spring");
  add("bare body", {Springs::forces, Stepping::bare_body, 0}, forces + bare);
  // The engine's damping is given as 1 - exp(-c/m), which is 1 in double beyond 36.
  constexpr double kMostRate = 30.0;
  if (scene.damping[0] <= kMostRate * scene.mass_kg &&
      scene.damping[5] <= kMostRate * scene.inertia_kg_m2[2])
    add("bare body, native damping", {Springs::native_damping, Stepping::bare_body, 0},
        "springs as forces per substep, dampers as the body's exponential damping" + bare);
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  const int version = btGetVersion();
  return isograsp::bench::run_engine(
      "Bullet", std::to_string(version / 100) + "." + std::to_string(version % 100),
      isograsp::bench::methods, argc, argv);
}
