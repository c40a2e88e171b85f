// SPDX-License-Identifier: GPL-3.0-or-later
// The product itself: from nine finger force components to the new pose and velocity, and, for
// comparison with engines that get the wrench ready-made, the motion alone.
#include <stdexcept>
#include <string>

#include "bench/harness.hpp"
#include "core/csv.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp::bench {

namespace {

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(english(result.error().what));
  return std::move(*result);
}

/// `tolerance_rad` 0: that of the scene.
Plan plan_of(const Case& scene, double tolerance_rad = 0.0) {
  Scene parsed =
      value_or_throw(parse_scene(value_or_throw(read_text(scene.scene_file)), scene.scene_file));
  if (tolerance_rad > 0.0) parsed.tolerance_rad = tolerance_rad;
  if (scene.follows) parsed.wrench_frame = WrenchFrame::object;
  return value_or_throw(Plan::compile(parsed, scene.hold_s));
}

Motion6 motion_of(const ObjectState& state) {
  const auto triple = [](const Vec3& v) { return Triple{v.x(), v.y(), v.z()}; };
  const Quat& q = state.X_WO.q;
  return {triple(state.X_WO.p),
          {q.w(), q.x(), q.y(), q.z()},
          triple(state.v_WO_W),
          triple(state.w_WO_W)};
}

enum class Path : std::uint8_t { step, grasp_and_move };

class FromFingers : public Simulation {
 public:
  FromFingers(const Case& scene, Path path, double tolerance_rad = 0.0)
      : plan_(plan_of(scene, tolerance_rad)), state_(plan_.initial_state()), path_(path) {
    for (const auto& nine : scene.fingers) {
      FingerWrenches& wrench_C = wrenches_C_.emplace_back();
      for (std::size_t f = 0; f < kFingerCount; ++f)
        wrench_C[f].force = Vec3(nine[3 * f], nine[3 * f + 1], nine[3 * f + 2]);
    }
  }
  void run(std::size_t first, std::size_t last) override {
    if (path_ == Path::step)
      for (std::size_t k = first; k < last; ++k) plan_.step(wrenches_C_[k], state_);
    else
      for (std::size_t k = first; k < last; ++k)
        plan_.move(plan_.grasp(wrenches_C_[k], state_), state_);
  }
  Motion6 motion() const override { return motion_of(state_); }

 private:
  Plan plan_;
  ObjectState state_;
  Path path_;
  std::vector<FingerWrenches> wrenches_C_;
};

class MoveOnly : public Simulation {
 public:
  explicit MoveOnly(const Case& scene) : plan_(plan_of(scene)), state_(plan_.initial_state()) {
    for (const Push& push : scene.pushes)
      pushes_.push_back({Vec3(push.force.data()), Vec3(push.torque.data())});
  }
  void run(std::size_t first, std::size_t last) override {
    GraspWrench wrench;
    for (std::size_t k = first; k < last; ++k) {
      wrench.held = pushes_[k];
      plan_.move(wrench, state_);
    }
  }
  Motion6 motion() const override { return motion_of(state_); }

 private:
  Plan plan_;
  ObjectState state_;
  std::vector<Wrench> pushes_;
};

std::vector<Method> methods(const Case& scene) {
  const auto from_fingers = [](Path path) {
    return [path](const Case& c) { return std::make_unique<FromFingers>(c, path); };
  };
  std::vector<Method> all{
      {"plan", 0, "nine finger forces in: hysteresis, friction clamp, grasp map and motion",
       from_fingers(Path::step)},
      {"plan, recorded", 0, "the same in two halves, with all that a session records",
       from_fingers(Path::grasp_and_move)},
      {"plan, motion alone", 0, "wrench in, as the other engines get it",
       [](const Case& c) { return std::make_unique<MoveOnly>(c); }}};
  if (scene.free_rotations() < 3) return all;
  // The whole curve: what a coarser answer costs.
  for (const char* tolerance_rad : {"1e-8", "1e-7", "1e-5", "1e-4", "1e-3", "3e-3", "1e-1"})
    all.push_back({std::string("plan, tolerance ") + tolerance_rad, 0,
                   "as plan, with this tolerance_rad in the scene",
                   [value = std::stod(tolerance_rad)](const Case& c) {
                     return std::make_unique<FromFingers>(c, Path::step, value);
                   }});
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  return isograsp::bench::run_engine("IsoGrasp", ISOGRASP_VERSION, isograsp::bench::methods, argc,
                                     argv);
}
