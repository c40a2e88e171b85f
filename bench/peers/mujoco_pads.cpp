// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo holds the block of bench/pads_hold.cpp between two pads that press with 5 N: by points
// with friction in two directions (condim 3), or by one contact a pad with torsion (4), and rolling
// (6). Elliptic cones, steps of 1 ms, whole steps with collision. The same line a case.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <mujoco/mujoco.h>

namespace {

constexpr double kHold_s = 10.0, kSettled_s = 2.0, kStep_s = 0.001;
// The block and the pads of the edge scene (bimanual/pads/pad_scenes.cpp), held by its side.
constexpr double kHalf_m = 0.03, kHalfThick_m = 0.01, kMass_kg = 0.15, kBeside_m = 0.0025;
constexpr double kFriction = 0.6, kSemi_z_m = 0.0075, kSemi_y_m = 0.0055, kPress_N = 5.0;
constexpr double kGravity_m_s2 = 9.81, kClosing_s = 0.05;
// Smaller spheres or lighter pads sink in by more than their radius with the engine's own springs.
constexpr double kPoint_m = 0.005, kPadMass_kg = 0.05;
constexpr double kDropped_m = 0.05;  // it is not held any more

double now_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// `points` of a pad, evenly over the ellipse; a single one stands for it with its torsion.
void add_pad(std::ostringstream& xml, double side, int points, int condim) {
  const double out_m = side * (kHalf_m + kPoint_m);
  // Mean distance of a point of the ellipse from its middle, that of a disk of its area.
  const double torsion_m = 2.0 / 3.0 * std::sqrt(kSemi_z_m * kSemi_y_m);
  xml << "<body pos='" << out_m << " 0 " << kBeside_m << "'><inertial pos='0 0 0' mass='"
      << kPadMass_kg << "' diaginertia='1e-6 1e-6 1e-6'/><joint name='pad" << (side < 0 ? 0 : 1)
      << "' type='slide' axis='" << -side << " 0 0' damping='4'/>";
  for (int i = 0; i < points; ++i) {
    const double r = points == 1 ? 0.0 : std::sqrt((i + 0.5) / points);
    const double angle_rad = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    xml << "<geom type='sphere' size='" << kPoint_m << "' pos='0 "
        << r * kSemi_y_m * std::sin(angle_rad) << ' ' << r * kSemi_z_m * std::cos(angle_rad)
        << "' condim='" << condim << "' friction='" << kFriction << ' ' << kFriction * torsion_m
        << ' ' << kFriction * torsion_m << "' priority='1'/>";
  }
  xml << "</body>";
}

std::string model_text(int points, int condim, double impratio) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><compiler angle='radian'/><size nconmax='2000' njmax='8000'/><option timestep='"
      << kStep_s << "' cone='elliptic' impratio='" << impratio << "'/><worldbody>"
      << "<body><freejoint/><geom type='box' size='" << kHalf_m << ' ' << kHalf_m << ' '
      << kHalfThick_m << "' mass='" << kMass_kg << "'/></body>";
  add_pad(xml, -1.0, points, condim);
  add_pad(xml, 1.0, points, condim);
  xml << "</worldbody><actuator><motor joint='pad0'/><motor joint='pad1'/></actuator></mujoco>";
  return xml.str();
}

void hold(const std::string& name, int points, int condim, double impratio) {
  const std::string text = model_text(points, condim, impratio);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "pads.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[500] = "";
  mjModel* model = mj_loadXML("pads.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(error);
  mjData* data = mj_makeData(model);
  data->ctrl[0] = data->ctrl[1] = kPress_N;
  const auto place = [&] { return Eigen::Vector3d(data->qpos[0], data->qpos[1], data->qpos[2]); };
  const auto attitude = [&] {
    return Eigen::Quaterniond(data->qpos[3], data->qpos[4], data->qpos[5], data->qpos[6]);
  };
  const int steps = static_cast<int>(kHold_s / kStep_s),
            settled = static_cast<int>(kSettled_s / kStep_s);
  std::vector<double> times_ns;
  std::vector<int> sweeps;
  Eigen::Vector3d place_then;
  Eigen::Quaterniond attitude_then;
  for (int k = 1; k <= steps; ++k) {
    // The pads press before the block has weight, as those of ours.
    model->opt.gravity[1] = -kGravity_m_s2 * std::min(1.0, k * kStep_s / kClosing_s);
    const double begin_ns = now_ns();
    mj_step(model, data);
    if (k > settled) {
      times_ns.push_back(now_ns() - begin_ns);
      sweeps.push_back(data->solver_iter);
    }
    if (k == settled) {
      place_then = place();
      attitude_then = attitude();
    }
  }
  // The pads move along x alone.
  Eigen::Vector3d way = place() - place_then;
  way.x() = 0.0;
  std::sort(times_ns.begin(), times_ns.end());
  std::sort(sweeps.begin(), sweeps.end());
  std::printf("%s\t%d\t%.0f\t%.0f\t%d\t", name.c_str(), data->nefc, times_ns[times_ns.size() / 2],
              times_ns[times_ns.size() * 99 / 100], sweeps[sweeps.size() / 2]);
  if (way.norm() > kDropped_m)
    std::printf("dropped\tdropped\n");
  else
    std::printf("%.3g\t%.3g\n", way.norm() / (kHold_s - kSettled_s),
                attitude().angularDistance(attitude_then) / (kHold_s - kSettled_s));
  mj_deleteData(data);
  mj_deleteModel(model);
}

}  // namespace

int main() {
  const std::string version = mj_versionString();
  for (const double impratio : {1.0, 10.0}) {
    const std::string with = ", impratio " + std::to_string(static_cast<int>(impratio));
    for (const int condim : {4, 6})
      hold("MuJoCo " + version + ", condim " + std::to_string(condim) + with + ", 2 points", 1,
           condim, impratio);
  }
  for (const int points : {12, 24, 48, 96, 176, 200})
    hold("MuJoCo " + version + ", condim 3, impratio 10, " + std::to_string(points) + " points",
         points / 2, 3, 10.0);
}
