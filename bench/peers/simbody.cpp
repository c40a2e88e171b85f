// SPDX-License-Identifier: GPL-3.0-or-later
// Simbody: one body on a pin, planar, ball or free mobilizer; springs and dampers on the
// coordinates or, for three rotations, one custom force element. Integrators with error control at
// several accuracies and with fixed steps. The integrator starts anew at each hold: the wrench
// jumps.
#include <Simbody.h>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

using namespace SimTK;

/// Geodesic spring and viscous damper to ground; the same stiffness about all axes.
class GeodesicSpring : public Force::Custom::Implementation {
 public:
  GeodesicSpring(const MobilizedBody& body, const Case& scene) : body_(body), scene_(scene) {}
  void calcForce(const State& state, Vector_<SpatialVec>& bodies, Vector_<Vec3>& /*particles*/,
                 Vector& /*mobilities*/) const override {
    const Transform& X_WO = body_.getBodyTransform(state);
    const SpatialVec& V_WO_W = body_.getBodyVelocity(state);
    const auto& k = scene_.stiffness;
    const auto& c = scene_.damping;
    const SimTK::Quaternion q = X_WO.R().convertRotationToQuaternion();
    const Triple phi = log({q[0], q[1], q[2], q[3]});
    const Vec3& p = X_WO.p();
    const Vec3& v = V_WO_W[1];
    const Vec3 torque = -k[3] * Vec3(phi[0], phi[1], phi[2]) - c[3] * V_WO_W[0];
    const Vec3 force(-k[0] * p[0] - c[0] * v[0], -k[1] * p[1] - c[1] * v[1],
                     -k[2] * p[2] - c[2] * v[2]);
    body_.applyBodyForce(state, SpatialVec(torque, force), bodies);
  }
  Real calcPotentialEnergy(const State& /*state*/) const override { return 0; }

 private:
  const MobilizedBody& body_;
  const Case& scene_;
};

/// The wrench of the hold.
class Wrench : public Force::Custom::Implementation {
 public:
  Wrench(const MobilizedBody& body, const Case& scene, const Push& push)
      : body_(body), scene_(scene), push_(push) {}
  void calcForce(const State& state, Vector_<SpatialVec>& bodies, Vector_<Vec3>& /*particles*/,
                 Vector& /*mobilities*/) const override {
    SpatialVec wrench(Vec3(push_.torque[0], push_.torque[1], push_.torque[2]),
                      Vec3(push_.force[0], push_.force[1], push_.force[2]));
    if (scene_.follows) {
      const Rotation& R_WO = body_.getBodyRotation(state);
      wrench = SpatialVec(R_WO * wrench[0], R_WO * wrench[1]);
    }
    body_.applyBodyForce(state, wrench, bodies);
  }
  Real calcPotentialEnergy(const State& /*state*/) const override { return 0; }

 private:
  const MobilizedBody& body_;
  const Case& scene_;
  const Push& push_;
};

using Maker = std::function<std::unique_ptr<Integrator>(const System&)>;

class SimbodyBody : public Simulation {
 public:
  SimbodyBody(const Case& scene, const Maker& make)
      : scene_(scene), matter_(system_), forces_(system_) {
    build();
    Force::Custom(forces_, new Wrench(body_, scene_, push_));
    State state = system_.realizeTopology();
    const auto& v = scene.start.v_WO_W;
    const auto& w = scene.start.w_WO_W;
    body_.setUToFitVelocity(state, SpatialVec(Vec3(w[0], w[1], w[2]), Vec3(v[0], v[1], v[2])));
    integrator_ = make(system_);
    integrator_->initialize(state);
  }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      push_ = scene_.pushes[k];
      integrator_->updAdvancedState().invalidateAllCacheAtOrAbove(Stage::Dynamics);
      integrator_->reinitialize(Stage::Dynamics, false);
      const Real end = static_cast<Real>(k + 1) * scene_.hold_s;
      while (integrator_->stepTo(end, end) != Integrator::ReachedReportTime) {
      }
    }
  }
  Motion6 motion() const override {
    const State& state = integrator_->getState();
    system_.realize(state, Stage::Velocity);
    const Transform& X_WO = body_.getBodyTransform(state);
    const SpatialVec& V = body_.getBodyVelocity(state);
    const SimTK::Quaternion q = X_WO.R().convertRotationToQuaternion();
    const auto triple = [](const Vec3& u) { return Triple{u[0], u[1], u[2]}; };
    return {triple(X_WO.p()), {q[0], q[1], q[2], q[3]}, triple(V[1]), triple(V[0])};
  }

 private:
  void build() {
    const auto& inertia = scene_.inertia_kg_m2;
    const Body::Rigid rigid(
        MassProperties(scene_.mass_kg, Vec3(0), Inertia(inertia[0], inertia[1], inertia[2])));
    if (!scene_.linear()) {
      if (scene_.free_translations() > 0)
        body_ = MobilizedBody::Free(matter_.Ground(), rigid);
      else
        body_ = MobilizedBody::Ball(matter_.Ground(), rigid);
      if (scene_.stiffness[3] != 0.0 || scene_.damping[3] != 0.0)
        Force::Custom(forces_, new GeodesicSpring(body_, scene_));
      return;
    }
    std::vector<std::size_t> dofs{5};
    if (scene_.free_translations() > 0) {
      body_ = MobilizedBody::Planar(matter_.Ground(), rigid);
      dofs = {5, 0, 1};
    } else {
      body_ = MobilizedBody::Pin(matter_.Ground(), rigid);
    }
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      const MobilizerQIndex q(static_cast<int>(i));
      const MobilizerUIndex u(static_cast<int>(i));
      if (scene_.stiffness[dofs[i]] != 0.0)
        Force::MobilityLinearSpring(forces_, body_, q, scene_.stiffness[dofs[i]], 0);
      if (scene_.damping[dofs[i]] != 0.0)
        Force::MobilityLinearDamper(forces_, body_, u, scene_.damping[dofs[i]]);
    }
  }
  const Case& scene_;
  MultibodySystem system_;
  SimbodyMatterSubsystem matter_;
  GeneralForceSubsystem forces_;
  MobilizedBody body_;
  Push push_;
  std::unique_ptr<Integrator> integrator_;
};

template <class Kind, class... Choice>
Maker with_accuracy(double accuracy, Choice... choice) {
  return [=](const System& system) {
    auto integrator = std::make_unique<Kind>(system, choice...);
    integrator->setAccuracy(accuracy);
    return integrator;
  };
}

Maker merson_with_step(double step_s) {
  return [=](const System& system) {
    auto integrator = std::make_unique<RungeKuttaMersonIntegrator>(system);
    integrator->setFixedStepSize(step_s);
    return integrator;
  };
}

Maker euler_with_step(double step_s) {
  return [=](const System& system) {
    return std::make_unique<SemiExplicitEulerIntegrator>(system, step_s);
  };
}

std::vector<Method> methods(const Case& scene) {
  const std::string setup = scene.linear()
                                ? "springs and dampers on the coordinates of the mobilizer"
                                : "one custom force element: geodesic spring, damper";
  std::vector<Method> all;
  const auto add = [&](const std::string& name, int substeps, const Maker& make) {
    all.push_back({name, substeps, setup,
                   [make](const Case& c) { return std::make_unique<SimbodyBody>(c, make); }});
  };
  const auto named = [](const std::string& name, double accuracy) {
    char text[80];
    std::snprintf(text, sizeof text, "%s, accuracy %.0e", name.c_str(), accuracy);
    return std::string(text);
  };
  for (const double accuracy : {1e-5, 1e-7, 1e-9})
    add(named("RK-Merson", accuracy), 0, with_accuracy<RungeKuttaMersonIntegrator>(accuracy));
  add(named("RK-Fehlberg", 1e-6), 0, with_accuracy<RungeKuttaFeldbergIntegrator>(1e-6));
  add(named("CPodes BDF", 1e-3), 0, with_accuracy<CPodesIntegrator>(1e-3, CPodes::BDF));
  for (const int n : ladder(4))
    add("RK-Merson, fixed steps", n, merson_with_step(scene.hold_s / n));
  for (const int n : {1, 4, 16})
    add("semi-explicit Euler, fixed steps", n, euler_with_step(scene.hold_s / n));
  return all;
}

std::string version() {
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  return isograsp::bench::run_engine("Simbody", isograsp::bench::version(),
                                     isograsp::bench::methods, argc, argv);
}
