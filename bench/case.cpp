// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/case.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace isograsp::bench {

namespace {

constexpr char kMark[] = "isograsp-bench-case-1";

/// Applies `io` to every field, in the order of the file; reads and writes alike.
template <class Any, class Io>
void each_field(Any& scene, Io io) {
  io(scene.peers);
  io(scene.follows);
  io(scene.hold_s);
  io(scene.mass_kg);
  io(scene.inertia_kg_m2);
  io(scene.free);
  io(scene.stiffness);
  io(scene.damping);
  io(scene.start);
  io(scene.excursion_m);
  io(scene.excursion_rad);
}

template <class T>
void write_array(std::ostream& out, const std::vector<T>& values) {
  out.write(reinterpret_cast<const char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(T)));
}

template <class T>
void read_array(std::istream& in, std::size_t count, std::vector<T>& values) {
  values.resize(count);
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

std::array<double, 4> product(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

}  // namespace

void write_case(const Case& scene, const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out << kMark << '\n'
      << scene.name << '\n'
      << scene.title << '\n'
      << scene.scene_file << '\n'
      << scene.pushes.size() << '\n';
  each_field(scene, [&out](const auto& field) {
    out.write(reinterpret_cast<const char*>(&field), sizeof field);
  });
  write_array(out, scene.fingers);
  write_array(out, scene.pushes);
  write_array(out, scene.reference);
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

Case read_case(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  Case scene;
  std::string mark;
  std::string count;
  std::getline(in, mark);
  std::getline(in, scene.name);
  std::getline(in, scene.title);
  std::getline(in, scene.scene_file);
  std::getline(in, count);
  if (mark != kMark) throw std::runtime_error(path + ": not a case of this benchmark");
  each_field(scene, [&in](auto& field) { in.read(reinterpret_cast<char*>(&field), sizeof field); });
  const std::size_t holds = std::stoul(count);
  read_array(in, holds, scene.fingers);
  read_array(in, holds, scene.pushes);
  read_array(in, holds, scene.reference);
  if (!in) throw std::runtime_error(path + ": too short");
  return scene;
}

Distance distance(const Motion6& a, const Motion6& b) {
  const double metres = std::hypot(a.p_WO[0] - b.p_WO[0], a.p_WO[1] - b.p_WO[1],  //
                                   a.p_WO[2] - b.p_WO[2]);
  const auto between = product(inverse(a.q_WO), b.q_WO);
  const double sine = std::hypot(between[1], between[2], between[3]);
  return {metres, 2.0 * std::atan2(sine, std::abs(between[0]))};
}

Conserved conserved(const Case& scene, const Motion6& motion) {
  const Triple w_O = turn(inverse(motion.q_WO), motion.w_WO_W);
  Conserved sum;
  Triple momentum_O{};
  for (std::size_t i = 0; i < 3; ++i) {
    momentum_O[i] = scene.inertia_kg_m2[i] * w_O[i];
    sum.energy += 0.5 * momentum_O[i] * w_O[i];
  }
  sum.momentum = turn(motion.q_WO, momentum_O);
  return sum;
}

}  // namespace isograsp::bench
