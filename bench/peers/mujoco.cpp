// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo: one body on slide, hinge or ball joints that carry springs and dampers themselves (the
// ball's spring is geodesic), everything about contacts and constraints switched off.
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <mujoco/mujoco.h>

#include "bench/harness.hpp"

namespace isograsp::bench {

namespace {

bool failed = false;

std::string model_text(const Case& scene, const std::string& integrator, double step_s) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><compiler angle='radian' inertiafromgeom='false'/>"
      << "<option gravity='0 0 0' integrator='" << integrator << "' timestep='" << step_s << "'>"
      << "<flag constraint='disable' equality='disable' frictionloss='disable' limit='disable'"
      << " contact='disable' gravity='disable' actuation='disable' warmstart='disable'/></option>"
      << "<worldbody><body><inertial pos='0 0 0' mass='" << scene.mass_kg << "' diaginertia='"
      << scene.inertia_kg_m2[0] << ' ' << scene.inertia_kg_m2[1] << ' ' << scene.inertia_kg_m2[2]
      << "'/>";
  const char* const axes[] = {"1 0 0", "0 1 0", "0 0 1"};
  const auto joint = [&](const std::string& kind, std::size_t dof) {
    xml << "<joint " << kind << " stiffness='" << scene.stiffness[dof] << "' damping='"
        << scene.damping[dof] << "'/>";
  };
  for (std::size_t dof = 0; dof < 3; ++dof)
    if (scene.free[dof]) joint(std::string("type='slide' axis='") + axes[dof] + "'", dof);
  if (scene.linear() && scene.free[5]) joint("type='hinge' axis='0 0 1'", 5);
  if (!scene.linear()) joint("type='ball'", 3);
  xml << "</body></worldbody></mujoco>";
  return xml.str();
}

class MujocoBody : public Simulation {
 public:
  MujocoBody(const Case& scene, const std::string& integrator, int substeps)
      : scene_(scene), substeps_(substeps) {
    const std::string text = model_text(scene, integrator, scene.hold_s / substeps);
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
    std::memcpy(files->filedata[0], text.data(), text.size());
    char error[500] = "";
    model_ = mj_loadXML("scene.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (model_ == nullptr) throw std::runtime_error(error);
    data_ = mj_makeData(model_);
    int at = 0;
    for (std::size_t dof = 0; dof < 3; ++dof)
      if (scene.free[dof]) {
        slides_.push_back(dof);
        data_->qvel[at++] = scene.start.v_WO_W[dof];
      }
    turn_ = at;
    if (!scene.linear())  // starts at the identity: world axes are object axes
      for (std::size_t i = 0; i < 3; ++i)
        data_->qvel[turn_ + static_cast<int>(i)] = scene.start.w_WO_W[i];
    else if (scene.free[5])
      data_->qvel[turn_] = scene.start.w_WO_W[2];
    failed = false;
    mju_user_warning = [](const char*) { failed = true; };
    // A force that turns with the object is part of the dynamics, also within a Runge-Kutta step.
    following_ = this;
    mjcb_passive = scene.follows ? push_along : nullptr;
  }
  ~MujocoBody() override {
    mjcb_passive = nullptr;
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  void run(std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Push& push = scene_.pushes[k];
      if (scene_.follows)
        force_O_ = push.force;
      else
        for (std::size_t i = 0; i < slides_.size(); ++i)
          data_->qfrc_applied[i] = push.force[slides_[i]];
      if (scene_.linear()) {
        if (scene_.free[5]) data_->qfrc_applied[turn_] = push.torque[2];
      } else {
        // World axes: on the body; object axes: on the ball joint, whose axes are the object's.
        mjtNum* torque = scene_.follows ? data_->qfrc_applied + turn_ : data_->xfrc_applied + 9;
        for (std::size_t i = 0; i < 3; ++i) torque[i] = push.torque[i];
      }
      for (int i = 0; i < substeps_; ++i) mj_step(model_, data_);
    }
  }
  Motion6 motion() const override {
    Motion6 out;
    // The engine puts a state that blew up back to the start; say so instead.
    if (failed) out.p_WO[0] = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < slides_.size(); ++i) {
      out.p_WO[slides_[i]] += data_->qpos[i];
      out.v_WO_W[slides_[i]] = data_->qvel[i];
    }
    const mjtNum* q = data_->qpos + turn_;
    const mjtNum* w = data_->qvel + turn_;
    if (!scene_.linear()) {
      out.q_WO = {q[0], q[1], q[2], q[3]};
      out.w_WO_W = turn(out.q_WO, {w[0], w[1], w[2]});
    } else if (scene_.free[5]) {
      out.q_WO = {std::cos(0.5 * q[0]), 0, 0, std::sin(0.5 * q[0])};
      out.w_WO_W[2] = w[0];
    }
    return out;
  }

 private:
  static void push_along(const mjModel* /*model*/, mjData* data) {
    const auto& self = *following_;
    mjtNum force_W[3];
    mju_rotVecMat(force_W, self.force_O_.data(), data->xmat + 9);
    for (std::size_t i = 0; i < self.slides_.size(); ++i)
      data->qfrc_passive[i] += force_W[self.slides_[i]];
  }
  inline static const MujocoBody* following_ = nullptr;
  const Case& scene_;
  int substeps_;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  std::vector<std::size_t> slides_;
  int turn_ = 0;  ///< first coordinate and first speed of the rotation
  Triple force_O_{};
};

std::vector<Method> methods(const Case& /*scene*/) {
  std::vector<Method> all;
  const auto add = [&all](const std::string& name, const std::string& integrator, int most,
                          const std::string& setup) {
    for (const int n : ladder(most))
      all.push_back({name, n, setup, [integrator, n](const Case& c) {
                       return std::make_unique<MujocoBody>(c, integrator, n);
                     }});
  };
  const std::string joints = "slide, hinge, ball joints with their own springs and dampers; ";
  add("Euler, implicit damping", "Euler", 64, joints + "damping implicit");
  add("implicit", "implicit", 32, joints + "all velocity terms implicit");
  add("RK4", "RK4", 32, joints + "explicit");
  return all;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  return isograsp::bench::run_engine("MuJoCo", mj_versionString(), isograsp::bench::methods, argc,
                                     argv);
}
