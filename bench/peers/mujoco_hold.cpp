// SPDX-License-Identifier: GPL-3.0-or-later
// The hold of bench/hold_scene.hpp in MuJoCo: elliptic cones, friction with torsion (condim 4) and
// with rolling (6), whole steps with collision.
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <mujoco/mujoco.h>

#include "bench/hold_scene.hpp"

namespace isograsp::bench {

namespace {

/// How firm the engine's contacts are: friction against normal force, and their time constant [s].
struct Firmness {
  double impratio = 1.0;
  double settles_s = 0.02;  // its own default
};

std::string model_text(int digits, int condim, const Firmness& firm) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><option timestep='" << kStep_s << "' cone='elliptic' impratio='" << firm.impratio
      << "'/><worldbody><body pos='0 0 " << kBeside_m << "'><freejoint/><geom type='box' size='"
      << kTipHalf_m << ' ' << kBoxHalf_y_m << ' ' << kBoxHalf_z_m << "' mass='" << kBoxMass_kg
      << "'/></body>";
  for (const Tip& tip : tips_of(digits)) {
    xml << "<body pos='" << tip.side * (kTipHalf_m + kTip_m) << " 0 " << tip.z_m << "'>";
    for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
      xml << "<joint type='slide' axis='" << axis << "'/>";
    xml << "<geom type='sphere' size='" << kTip_m << "' mass='" << kTipMass_kg << "' condim='"
        << condim << "' friction='" << kFriction << ' ' << kFriction * kTorsion_m << ' '
        << kFriction * kTorsion_m << "' solref='" << firm.settles_s << " 1' priority='1'/></body>";
  }
  xml << "</worldbody></mujoco>";
  return xml.str();
}

void hold(int digits, int condim, const Firmness& firm) {
  const std::string text = model_text(digits, condim, firm);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "hold.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[500] = "";
  mjModel* model = mj_loadXML("hold.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error);
  mjData* data = mj_makeData(model);
  const std::vector<Tip> tips = tips_of(digits);
  constexpr int kFree = 6;
  Hold hold;
  double depth_m = 0.0;
  const int steps = static_cast<int>(kEnd_s / kStep_s);
  mj_forward(model, data);
  for (int k = 0; k < steps; ++k) {
    const double t_s = (k + 0.5) * kStep_s;
    model->opt.gravity[0] = model->opt.gravity[2] = 0.0;
    model->opt.gravity[1] = -kGravity_m_s2 * weight_at(t_s);
    const double begin_ns = processor_ns();
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const auto at = static_cast<int>(3 * i);
      const double* q = data->qpos + kFree + 1 + at;
      const double* v = data->qvel + kFree + at;
      const Eigen::Vector3d force =
          tip_force(tips[i], {q[0], q[1], tips[i].z_m + q[2]}, {v[0], v[1], v[2]}, t_s);
      for (int axis = 0; axis < 3; ++axis) data->qfrc_applied[kFree + at + axis] = force[axis];
      // The tips are led: they have no weight.
      data->qfrc_applied[kFree + at + 1] -= kTipMass_kg * model->opt.gravity[1];
    }
    mj_step(model, data);
    hold.timed(processor_ns() - begin_ns);
    const Eigen::Vector3d box(data->qpos[0], data->qpos[1], data->qpos[2]);
    const Eigen::Quaterniond turn(data->qpos[3], data->qpos[4], data->qpos[5], data->qpos[6]);
    depth_m = 0.0;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const double* q = data->qpos + kFree + 1 + 3 * i;
      const Eigen::Vector3d tip(tips[i].side * (kTipHalf_m + kTip_m) + q[0], q[1],
                                tips[i].z_m + q[2]);
      const Eigen::Vector3d tip_O = turn.conjugate() * (tip - box);
      depth_m = std::max(depth_m, kTipHalf_m + kTip_m - std::abs(tip_O.x()));
      if (i == 0) hold.look(t_s, tip_O, turn);
    }
  }
  char settings[80];
  std::snprintf(settings, sizeof settings, ", condim %d, impratio %g, solref %g ms", condim,
                firm.impratio, 1e3 * firm.settles_s);
  hold.print("MuJoCo " + std::string(mj_versionString()) + settings, digits, depth_m);
  mj_deleteData(data);
  mj_deleteModel(model);
}

}  // namespace

}  // namespace isograsp::bench

int main() {
  using isograsp::bench::Firmness;
  for (const int digits : {2, 3})
    for (const int condim : {4, 6})
      for (const Firmness& firm :
           {Firmness{}, Firmness{10.0}, Firmness{100.0}, Firmness{100.0, 0.004}})
        isograsp::bench::hold(digits, condim, firm);
}
