// SPDX-License-Identifier: GPL-3.0-or-later
// DART: one body on a revolute, planar or (translational and ball) joint with the joint's own
// implicit springs and dampers; stepped by its world, or by the skeleton's functions alone.
#include <dart/config.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/TranslationalJoint.hpp>
#include <dart/simulation/World.hpp>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

using namespace dart::dynamics;

enum class Stepping : std::uint8_t { world, skeleton };

/// Of the link between the translational and the ball joint [kg]: as good as nothing.
constexpr double kLinkMass_kg = 1e-12;

class DartBody : public Simulation {
 public:
  DartBody(const Case& scene, Stepping stepping, int substeps)
      : scene_(scene),
        stepping_(stepping),
        substeps_(substeps),
        h_(scene.hold_s / substeps),
        skeleton_(Skeleton::create()) {
    build();
    skeleton_->setGravity(Eigen::Vector3d::Zero());
    skeleton_->setTimeStep(h_);
    if (stepping == Stepping::world) {
      world_ = dart::simulation::World::create();
      world_->setGravity(Eigen::Vector3d::Zero());
      world_->setTimeStep(h_);
      world_->addSkeleton(skeleton_);
    }
  }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      if (scene_.linear())
        push_joint(scene_.pushes[k]);
      else if (scene_.follows)
        push_body_in_object_axes(scene_.pushes[k]);
      for (int i = 0; i < substeps_; ++i) {
        if (!scene_.linear() && !scene_.follows) push_body_in_world_axes(scene_.pushes[k]);
        if (stepping_ == Stepping::world) {
          world_->step(false);
        } else {
          skeleton_->computeForwardDynamics();
          skeleton_->integrateVelocities(h_);
          skeleton_->integratePositions(h_);
        }
      }
    }
  }
  Motion6 motion() const override {
    Motion6 out;
    const Eigen::Isometry3d X = body_->getWorldTransform();
    const Eigen::Vector3d v = body_->getLinearVelocity();
    const Eigen::Vector3d w = body_->getAngularVelocity();
    const Eigen::Quaterniond q(X.linear());
    out.q_WO = {q.w(), q.x(), q.y(), q.z()};
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      out.p_WO[at] = X.translation()[i];
      out.v_WO_W[at] = v[i];
      out.w_WO_W[at] = w[i];
    }
    return out;
  }

 private:
  void build() {
    if (scene_.linear() && scene_.free_translations() == 0) {
      RevoluteJoint::Properties joint;
      joint.mAxis = Eigen::Vector3d::UnitZ();
      add<RevoluteJoint>(joint, {5}, nullptr);
    } else if (scene_.linear()) {
      PlanarJoint::Properties joint;
      joint.setXYPlane();
      add<PlanarJoint>(joint, {0, 1, 5}, nullptr);
    } else {
      BodyNode* link = nullptr;
      if (scene_.free_translations() > 0) {
        link = add<TranslationalJoint>({}, {0, 1, 2}, nullptr);
        link->setInertia(Inertia(kLinkMass_kg, Eigen::Vector3d::Zero(),
                                 kLinkMass_kg * Eigen::Matrix3d::Identity()));
      }
      add<BallJoint>({}, {3, 4, 5}, link);
      for (Eigen::Index i = 0; i < 3; ++i)
        body_->getParentJoint()->setVelocity(static_cast<std::size_t>(i),
                                             scene_.start.w_WO_W[static_cast<std::size_t>(i)]);
    }
    const Eigen::Vector3d inertia(scene_.inertia_kg_m2.data());
    body_->setInertia(
        Inertia(scene_.mass_kg, Eigen::Vector3d::Zero(), Eigen::Matrix3d(inertia.asDiagonal())));
  }
  template <class JointType>
  BodyNode* add(const typename JointType::Properties& properties,
                const std::vector<std::size_t>& dofs, BodyNode* parent) {
    auto [joint, body] = skeleton_->createJointAndBodyNodePair<JointType>(parent, properties);
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      joint->setSpringStiffness(i, scene_.stiffness[dofs[i]]);
      joint->setDampingCoefficient(i, scene_.damping[dofs[i]]);
    }
    body->setCollidable(false);
    body_ = body;
    dofs_ = dofs;
    return body;
  }
  void push_joint(const Push& push) {
    Joint* joint = body_->getParentJoint();
    for (std::size_t i = 0; i < dofs_.size(); ++i)
      joint->setForce(i, dofs_[i] < 3 ? push.force[dofs_[i]] : push.torque[dofs_[i] - 3]);
  }
  void push_body_in_object_axes(const Push& push) {
    body_->setExtForce(Eigen::Vector3d(push.force.data()), Eigen::Vector3d::Zero(), true, true);
    body_->setExtTorque(Eigen::Vector3d(push.torque.data()), true);
  }
  void push_body_in_world_axes(const Push& push) {
    body_->setExtForce(Eigen::Vector3d(push.force.data()), Eigen::Vector3d::Zero(), false, true);
    body_->setExtTorque(Eigen::Vector3d(push.torque.data()), false);
  }
  const Case& scene_;
  Stepping stepping_;
  int substeps_;
  double h_;
  SkeletonPtr skeleton_;
  dart::simulation::WorldPtr world_;
  BodyNode* body_ = nullptr;
  std::vector<std::size_t> dofs_;  ///< of the joint that carries the body
};

std::vector<Method> methods(const Case& scene) {
  std::vector<Method> all;
  const auto add = [&all](const std::string& name, Stepping stepping, const std::string& setup) {
    for (const int n : ladder(32))
      all.push_back({name, n, setup,
                     [=](const Case& c) { return std::make_unique<DartBody>(c, stepping, n); },
                     stepping == Stepping::skeleton});
  };
  std::string joints = "revolute joint";
  if (scene.free_translations() > 0) joints = "planar joint";
  if (!scene.linear())
    joints = scene.free_translations() > 0 ? "translational and ball joint, link of 1e-12 kg"
                                           : "ball joint";
  joints += " with implicit springs and dampers";
  add("world", Stepping::world, joints);
  add("skeleton alone", Stepping::skeleton,
      joints + "; forward dynamics and integration called directly, no world");
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  return isograsp::bench::run_engine("DART", DART_VERSION, isograsp::bench::methods, argc, argv);
}
