// SPDX-License-Identifier: GPL-3.0-or-later
// The hold of bench/hold_scene.hpp in Simbody: compliant contact of spheres with the faces of the
// box, Stribeck friction without torsion, its implicit integrator with error control (1e-3):
// explicit ones take a hundred times as long.
#include <Simbody.h>

#include "bench/hold_scene.hpp"

namespace isograsp::bench {

namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

/// Leads the tips and lets the box weigh.
class Leading : public SimTK::Force::Custom::Implementation {
 public:
  Leading(const MobilizedBody& box, const std::vector<MobilizedBody>& spheres,
          const std::vector<Tip>& tips)
      : box_(box), spheres_(spheres), tips_(tips) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodies,
                 SimTK::Vector_<Vec3>& /*particles*/,
                 SimTK::Vector& /*mobilities*/) const override {
    const double t_s = state.getTime();
    const auto push = [&](const MobilizedBody& body, const Vec3& force) {
      body.applyBodyForce(state, SimTK::SpatialVec(Vec3(0), force), bodies);
    };
    push(box_, Vec3(0, -kBoxMass_kg * kGravity_m_s2 * weight_at(t_s), 0));
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      const Vec3 p = spheres_[i].getBodyOriginLocation(state);
      const Vec3 v = spheres_[i].getBodyOriginVelocity(state);
      const Eigen::Vector3d force =
          tip_force(tips_[i], {p[0], p[1], p[2]}, {v[0], v[1], v[2]}, t_s);
      push(spheres_[i], Vec3(force.x(), force.y(), force.z()));
    }
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0; }

 private:
  const MobilizedBody& box_;
  const std::vector<MobilizedBody>& spheres_;
  const std::vector<Tip>& tips_;
};

void hold(int digits, double transition_m_s) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  SimTK::ContactTrackerSubsystem tracker(system);
  SimTK::CompliantContactSubsystem contact(system, tracker);
  contact.setTransitionVelocity(transition_m_s);
  constexpr double kStiffness_Pa = 1e6, kDissipation_s_m = 1.0;
  const SimTK::ContactMaterial pad(kStiffness_Pa, kDissipation_s_m, kFriction, kFriction, 0.0);
  const Vec3 size_m(2 * kTipHalf_m, 2 * kBoxHalf_y_m, 2 * kBoxHalf_z_m);
  const SimTK::UnitInertia inertia = SimTK::UnitInertia::brick(0.5 * size_m);
  SimTK::Body::Rigid box_body(SimTK::MassProperties(kBoxMass_kg, Vec3(0), inertia));
  // A half-space has what is at x > 0 inside: a tip and the face of the other side, which has it
  // inside, are of one clique and never touch.
  const SimTK::ContactCliqueId left = SimTK::ContactSurface::createNewContactClique();
  const SimTK::ContactCliqueId right = SimTK::ContactSurface::createNewContactClique();
  box_body.addContactSurface(
      SimTK::Transform(Vec3(-kTipHalf_m, 0, 0)),
      SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), pad).joinClique(right));
  box_body.addContactSurface(
      SimTK::Transform(SimTK::Rotation(SimTK::Pi, SimTK::ZAxis), Vec3(kTipHalf_m, 0, 0)),
      SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), pad).joinClique(left));
  MobilizedBody::Free box(matter.Ground(), SimTK::Transform(Vec3(0, 0, kBeside_m)), box_body,
                          SimTK::Transform());
  const std::vector<Tip> tips = tips_of(digits);
  std::vector<MobilizedBody> spheres;
  for (const Tip& tip : tips) {
    SimTK::Body::Rigid body(
        SimTK::MassProperties(kTipMass_kg, Vec3(0), SimTK::UnitInertia::sphere(kTip_m)));
    SimTK::ContactSurface surface(SimTK::ContactGeometry::Sphere(kTip_m), pad);
    surface.joinClique(tip.side < 0.0 ? left : right);
    body.addContactSurface(SimTK::Transform(), surface);
    spheres.push_back(
        MobilizedBody::Translation(matter.Ground(), SimTK::Transform(), body, SimTK::Transform()));
  }
  SimTK::Force::Custom(forces, new Leading(box, spheres, tips));
  SimTK::State state = system.realizeTopology();
  for (std::size_t i = 0; i < tips.size(); ++i)
    spheres[i].setQFromVector(
        state, SimTK::Vector(Vec3(tips[i].side * (kTipHalf_m + kTip_m), 0, tips[i].z_m)));
  SimTK::CPodesIntegrator integrator(system);
  integrator.setAccuracy(1e-3);
  integrator.initialize(state);
  Hold hold;
  double depth_m = 0.0;
  constexpr double kLook_s = 0.01;
  for (int k = 1; k <= static_cast<int>(kEnd_s / kLook_s); ++k) {
    const double begin_ns = processor_ns();
    integrator.stepTo(k * kLook_s);
    hold.timed(processor_ns() - begin_ns);
    const SimTK::State& now = integrator.getState();
    const SimTK::Transform X_WO = box.getBodyTransform(now);
    const SimTK::Quaternion q = X_WO.R().convertRotationToQuaternion();
    depth_m = 0.0;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const Vec3 p = ~X_WO * spheres[i].getBodyOriginLocation(now);
      depth_m = std::max(depth_m, kTipHalf_m + kTip_m - std::abs(p[0]));
      if (i == 0) hold.look(k * kLook_s, {p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]});
    }
  }
  int major = 0, minor = 0, build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  char text[80];
  std::snprintf(text, sizeof text, "Simbody %d.%d, transition %g mm/s", major, minor,
                1e3 * transition_m_s);
  hold.print(text, digits, depth_m);
}

}  // namespace

}  // namespace isograsp::bench

int main() {
  for (const int digits : {2, 3})
    for (const double transition_m_s : {0.01, 0.001}) isograsp::bench::hold(digits, transition_m_s);
}
