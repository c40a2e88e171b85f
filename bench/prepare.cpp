// SPDX-License-Identifier: GPL-3.0-or-later
// bench_prepare DIR: writes one case per scene, with the wrench of every hold as the product's own
// friction clamp and grasp map compute it, and the reference. Prints one line per scene.
#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "bench/case.hpp"
#include "bench/reference.hpp"
#include "core/csv.hpp"
#include "grasp_model/plan.hpp"
#include "hand/finger_forces.hpp"

namespace isograsp::bench {

namespace {

const std::string kSource = ISOGRASP_SOURCE_DIR;
const std::string kGiven = kSource + "/tests/data/dynamics/";
const std::string kOwn = kSource + "/bench/scenes/";

struct Entry {
  const char* name;
  std::string scene;
  bool forces = true;  ///< recorded finger forces act; otherwise none
  bool follows = false;
  std::size_t holds = 6000;
  bool peers = true;
  std::string given;  ///< reference that came with the scene, every 20th hold
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"S1", kGiven + "S1.toml", true, false, 6000, true, kGiven + "S1_reference.csv"},
      {"S2", kGiven + "S2.toml", true, false, 6000, true, kGiven + "S2_reference.csv"},
      {"S3", kGiven + "S3.toml", true, false, 6000, true, kGiven + "S3_reference.csv"},
      {"S3o", kGiven + "S3.toml", true, true, 6000, true, ""},
      {"S4a", kGiven + "S4a.toml", true, false, 6000, true, kGiven + "S4a_reference.csv"},
      {"S5", kGiven + "S5.toml", false, false, 6000, true, kGiven + "S5_reference.csv"},
      {"S6", kOwn + "S6.toml", true, false, 6000, true, ""},
      {"S7", kGiven + "S7.toml", true, false, 6000, true, kGiven + "S7_reference.csv"},
      {"gram", kOwn + "gram.toml", true, false, 6000, false, ""},
      {"1.6kHz", kOwn + "spring_1600_hz.toml", true, false, 6000, false, ""},
      {"10kHz", kOwn + "spring_10_khz.toml", true, false, 6000, false, ""},
      {"critical", kOwn + "stiff_rotation_critical.toml", true, false, 1000, false, ""},
      {"damped5", kOwn + "stiff_rotation_5_percent.toml", true, false, 1000, false, ""},
      {"overdamped", kOwn + "overdamped_rotation.toml", true, false, 1000, false, ""},
  };
  return all;
}

template <class T>
T value_or_throw(Result<T> result) {
  if (!result)
    throw std::runtime_error(english(result.error().what) + " (" + result.error().file + ")");
  return std::move(*result);
}

template <class Out, class In>
Out components(const In& in) {
  Out out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = in[static_cast<Eigen::Index>(i)];
  return out;
}

Case make_case(const Entry& entry) {
  Scene scene = value_or_throw(parse_scene(value_or_throw(read_text(entry.scene)), entry.scene));
  if (entry.follows) scene.wrench_frame = WrenchFrame::object;
  if (!scene.gravity_m_s2.isZero(0.0) || !scene.anchor_m.isZero(0.0) || !scene.limits.empty())
    throw std::runtime_error(entry.scene + ": gravity, anchor and limits are not compared");
  const std::string forces = kGiven + "forces.csv";
  const double hold_s = value_or_throw(read_time_grid(forces)).hold_s;

  Case out;
  out.name = entry.name;
  out.title = scene.name;
  if (entry.follows) out.title = "free 6-DOF block, inertia 1:2:3, wrench held in object axes";
  out.scene_file = entry.scene;
  out.peers = entry.peers;
  out.follows = entry.follows;
  out.hold_s = hold_s;
  out.mass_kg = scene.mass_kg;
  out.inertia_kg_m2 = components<Triple>(scene.inertia_kg_m2);
  out.free = scene.free;
  out.stiffness = components<std::array<double, 6>>(scene.stiffness);
  out.damping = components<std::array<double, 6>>(scene.damping);
  out.start.v_WO_W = components<Triple>(scene.initial_v_WO_W);
  out.start.w_WO_W = components<Triple>(scene.initial_w_WO_W);

  const Plan plan = value_or_throw(Plan::compile(scene, hold_s));
  auto reader = value_or_throw(FingerForcesReader::open(forces));
  ObjectState touching = plan.initial_state();
  FingerForcesRow row;
  while (out.pushes.size() < entry.holds && value_or_throw(reader.next(row))) {
    if (!entry.forces) row.wrench_C = {};
    const GraspWrench grasped = plan.grasp(row.wrench_C, touching);
    out.pushes.push_back(
        {components<Triple>(grasped.held.force), components<Triple>(grasped.held.torque)});
    std::array<double, 9> nine{};
    for (std::size_t f = 0; f < kFingerCount; ++f)
      for (std::size_t i = 0; i < 3; ++i)
        nine[3 * f + i] = row.wrench_C[f].force[static_cast<Eigen::Index>(i)];
    out.fingers.push_back(nine);
  }
  add_reference(out);
  return out;
}

/// Largest distance from the reference that came with the scene.
Distance compare(const Case& scene, const std::string& given) {
  auto csv = value_or_throw(CsvReader::open(given));
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < csv.columns().size(); ++i) columns[csv.columns()[i]] = i;
  std::vector<double> row(csv.columns().size());
  Distance worst;
  while (value_or_throw(csv.next(row))) {
    const auto field = [&](const char* name) { return row[columns.at(name)]; };
    Motion6 motion;
    motion.p_WO = {field("x_m"), field("y_m"), field("z_m")};
    motion.q_WO = {field("qw"), field("qx"), field("qy"), field("qz")};
    const auto hold = static_cast<std::size_t>(std::lround(field("t_s") / scene.hold_s)) - 1;
    const Distance d = distance(motion, scene.reference.at(hold));
    worst.metres = std::max(worst.metres, d.metres);
    worst.radians = std::max(worst.radians, d.radians);
  }
  return worst;
}

int prepare(const std::string& folder) {
  for (const Entry& entry : entries()) {
    const Case scene = make_case(entry);
    write_case(scene, folder + "/" + scene.name + ".case");
    std::printf("%s\t%s\t%d\t%zu\t%.17g\t%.17g", scene.name.c_str(), scene.title.c_str(),
                scene.peers ? 1 : 0, scene.pushes.size(), scene.excursion_m, scene.excursion_rad);
    if (!entry.given.empty()) {
      const Distance d = compare(scene, entry.given);
      std::printf("\t%.3g\t%.3g", d.metres, d.radians);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

}  // namespace isograsp::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: bench_prepare DIR\n");
    return 2;
  }
  try {
    return isograsp::bench::prepare(argv[1]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_prepare: %s\n", e.what());
    return 1;
  }
}
