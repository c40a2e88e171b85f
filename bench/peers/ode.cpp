// SPDX-License-Identifier: GPL-3.0-or-later
// Open Dynamics Engine (double precision): one body; locked degrees of freedom by a hinge or the
// plane joint. Springs either as forces per substep, or implicit, as joints with ERP and CFM.
#include <ode/ode.h>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

enum class Springs : std::uint8_t { forces, joints };
enum class Solver : std::uint8_t { direct, quick };

class OdeBody : public Simulation {
 public:
  OdeBody(const Case& scene, Springs springs, Solver solver, int substeps)
      : scene_(scene),
        springs_(springs),
        solver_(solver),
        substeps_(substeps),
        h_(scene.hold_s / substeps) {
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, 0);
    body_ = dBodyCreate(world_);
    dMass mass;
    const auto& inertia = scene.inertia_kg_m2;
    dMassSetParameters(&mass, scene.mass_kg, 0, 0, 0, inertia[0], inertia[1], inertia[2], 0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetGyroscopicMode(body_, 1);
    dBodySetFiniteRotationMode(body_, 1);
    const auto& v = scene.start.v_WO_W;
    const auto& w = scene.start.w_WO_W;
    dBodySetLinearVel(body_, v[0], v[1], v[2]);
    dBodySetAngularVel(body_, w[0], w[1], w[2]);
    lock();
    if (springs == Springs::joints) add_soft_joints();
  }
  ~OdeBody() override { dWorldDestroy(world_); }

  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Push& push = scene_.pushes[k];
      for (int i = 0; i < substeps_; ++i) {
        apply(push);
        if (turning_ != nullptr) dJointSetAMotorAngle(turning_, 0, angle());
        if (solver_ == Solver::direct)
          dWorldStep(world_, h_);
        else
          dWorldQuickStep(world_, h_);
      }
    }
  }
  Motion6 motion() const override {
    const dReal* p = dBodyGetPosition(body_);
    const dReal* q = dBodyGetQuaternion(body_);
    const dReal* v = dBodyGetLinearVel(body_);
    const dReal* w = dBodyGetAngularVel(body_);
    return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}};
  }

 private:
  void lock() {
    if (scene_.linear() && scene_.free_translations() == 0) {
      hinge_ = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge_, body_, nullptr);
      dJointSetHingeAnchor(hinge_, 0, 0, 0);
      dJointSetHingeAxis(hinge_, 0, 0, 1);
    } else if (scene_.linear()) {
      dJointAttach(dJointCreatePlane2D(world_, nullptr), body_, nullptr);
    }
  }
  /// ERP and CFM of a spring k and damper c, as the engine's manual gives them.
  [[nodiscard]] dReal erp(std::size_t dof) const {
    const double k = scene_.stiffness[dof];
    return h_ * k / (h_ * k + scene_.damping[dof]);
  }
  [[nodiscard]] dReal cfm(std::size_t dof) const {
    return 1.0 / (h_ * scene_.stiffness[dof] + scene_.damping[dof]);
  }
  void add_soft_joints() {
    if (hinge_ != nullptr) {
      dJointSetHingeParam(hinge_, dParamLoStop, 0);
      dJointSetHingeParam(hinge_, dParamHiStop, 0);
      dJointSetHingeParam(hinge_, dParamStopERP, erp(5));
      dJointSetHingeParam(hinge_, dParamStopCFM, cfm(5));
      return;
    }
    // The ball pulls along x, y (and z, locked anyway); the motor turns back about z.
    dJointID ball = dJointCreateBall(world_, nullptr);
    dJointAttach(ball, body_, nullptr);
    dJointSetBallAnchor(ball, 0, 0, 0);
    dJointSetBallParam(ball, dParamERP, erp(0));
    dJointSetBallParam(ball, dParamCFM, cfm(0));
    turning_ = dJointCreateAMotor(world_, nullptr);
    dJointAttach(turning_, body_, nullptr);
    dJointSetAMotorMode(turning_, dAMotorUser);
    dJointSetAMotorNumAxes(turning_, 1);
    dJointSetAMotorAxis(turning_, 0, 0, 0, 0, 1);
    dJointSetAMotorParam(turning_, dParamLoStop, 0);
    dJointSetAMotorParam(turning_, dParamHiStop, 0);
    dJointSetAMotorParam(turning_, dParamStopERP, erp(5));
    dJointSetAMotorParam(turning_, dParamStopCFM, cfm(5));
  }
  [[nodiscard]] double angle() const {
    const dReal* q = dBodyGetQuaternion(body_);
    return 2.0 * std::atan2(q[3], q[0]);
  }
  void apply(const Push& push) {
    if (scene_.follows) {
      dBodyAddRelForce(body_, push.force[0], push.force[1], push.force[2]);
      dBodyAddRelTorque(body_, push.torque[0], push.torque[1], push.torque[2]);
    } else if (scene_.linear()) {
      dBodyAddForce(body_, push.force[0], push.force[1], 0);
      dBodyAddTorque(body_, 0, 0, push.torque[2]);
    } else {
      dBodyAddForce(body_, push.force[0], push.force[1], push.force[2]);
      dBodyAddTorque(body_, push.torque[0], push.torque[1], push.torque[2]);
    }
    if (springs_ == Springs::joints) return;
    const auto& k = scene_.stiffness;
    const auto& c = scene_.damping;
    const dReal* w = dBodyGetAngularVel(body_);
    if (scene_.free_translations() > 0) {
      const dReal* p = dBodyGetPosition(body_);
      const dReal* v = dBodyGetLinearVel(body_);
      dBodyAddForce(body_, -k[0] * p[0] - c[0] * v[0], -k[1] * p[1] - c[1] * v[1],
                    -k[2] * p[2] - c[2] * v[2]);
    }
    if (scene_.linear()) {
      dBodyAddTorque(body_, 0, 0, -k[5] * angle() - c[5] * w[2]);
    } else if (k[3] != 0.0 || c[3] != 0.0) {
      // The same about all axes in these scenes, so world axes will do.
      const dReal* q = dBodyGetQuaternion(body_);
      const Triple phi = log({q[0], q[1], q[2], q[3]});
      dBodyAddTorque(body_, -k[3] * phi[0] - c[3] * w[0], -k[3] * phi[1] - c[3] * w[1],
                     -k[3] * phi[2] - c[3] * w[2]);
    }
  }
  const Case& scene_;
  Springs springs_;
  Solver solver_;
  int substeps_;
  double h_;
  dWorldID world_;
  dBodyID body_;
  dJointID hinge_ = nullptr;
  dJointID turning_ = nullptr;
};

std::vector<Method> methods(const Case& scene) {
  std::vector<Method> all;
  const auto add = [&all](const std::string& name, Springs springs, Solver solver, int most,
                          const std::string& setup) {
    for (const int n : ladder(most))
      all.push_back({name, n, setup, [=](const Case& c) {
                       return std::make_unique<OdeBody>(c, springs, solver, n);
                     }});
  };
  const std::string gyroscopic =
      scene.linear() ? "" : "; implicit gyroscopic torque, finite rotation";
  const std::string forces = "springs and dampers as forces per substep" + gyroscopic;
  add("dWorldStep", Springs::forces, Solver::direct, 128, forces);
  add("dWorldQuickStep", Springs::forces, Solver::quick, 16, forces);
  if (scene.linear())
    add("dWorldStep, implicit springs", Springs::joints, Solver::direct, 128,
        "springs and dampers as soft joints (ERP, CFM)");
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  return isograsp::bench::run_engine("ODE", ODE_VERSION, isograsp::bench::methods, argc, argv);
}
