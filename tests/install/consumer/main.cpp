// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a scene, one pose of a rigid body, and one sample of a simulated device that this
// program presses itself.
#include <cstdio>
#include <vector>

#include "device/sensors/force_device.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/scene.hpp"
#include "hand/stimulus.hpp"
#include "kinematics/rigid_body.hpp"

using namespace isograsp;

constexpr const char* kScene = R"(format = "isograsp-scene-1"
[object]
shape = "sphere"
size_m = [0.06]
mass_kg = 1
[dynamics]
free = ["x"]
stiffness = [0, 0, 0, 0, 0, 0]
damping = [0, 0, 0, 0, 0, 0]
[[contact]]
finger = "thumb"
position_m = [-0.03, 0, 0]
normal = [1, 0, 0]
tangent = [0, 1, 0]
model = "point"
friction = 0.5
)";

struct Thumb final : FingerSource {
  void see(const Stimulus&) noexcept override {}
  FingerWrenches press(double) noexcept override {
    FingerWrenches wrench_C;
    wrench_C[index_of(Finger::thumb)].force = {0, 0, 2};
    return wrench_C;
  }
};

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  const auto scene = parse_scene(kScene, "sphere.toml");
  if (!scene) return fail(scene.error());
  const auto plan = Plan::compile(*scene, 0.01);
  if (!plan) return fail(plan.error());
  FingerWrenches wrench_C;
  wrench_C[index_of(Finger::thumb)].force = {0, 0, 1};
  ObjectState state = plan->initial_state();
  plan->step(wrench_C, state);
  std::printf("x = %g m\n", state.X_WO.p.x());

  const RigidBody body({{0, 0, 0}, {0.06, 0, 0}, {0.02, 0.045, 0}}, 0.002);
  const BodyFit fit = body.fit(std::vector<Vec3>{{1, 0, 0}, {1.06, 0, 0}, {1.02, 0.045, 0}});
  std::printf("body at x = %.3f m\n", fit.X_WB.p.x());

  Thumb thumb;
  const auto device = open_device("sim://me?rate=100", {&thumb, nullptr});
  if (!device) return fail(device.error());
  ManualClock clock;
  if (const auto started = (*device)->start(clock); !started) return fail(started.error());
  SensorSample sample;
  while ((*device)->read(clock.now() + from_seconds(1.0), sample) == ReadStatus::sample)
    if (sample.finger == Finger::thumb && sample.wrench_C.force.z() > 1.0) {
      std::printf("%s: thumb %.0f N\n", (*device)->info().uri.c_str(), sample.wrench_C.force.z());
      return 0;
    }
  return 1;
}
