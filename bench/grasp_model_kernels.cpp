// SPDX-License-Identifier: GPL-3.0-or-later
// Google Benchmark kernels of grasp_model: one frame of each kind of scene, and its parts.
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "core/csv.hpp"
#include "grasp_model/batch/batch.hpp"
#include "grasp_model/contact.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/rotation.hpp"
#include "grasp_model/spin.hpp"
#include "grasp_model/zoh.hpp"
#include "hand/finger_forces.hpp"

namespace isograsp {

namespace {

const std::string kGiven = std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/dynamics/";
constexpr double kHold_s = 0.01;

template <class T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(english(result.error().what));
  return std::move(*result);
}

Plan plan_of(const std::string& file) {
  return value_or_throw(
      Plan::compile(value_or_throw(parse_scene(value_or_throw(read_text(file)), file)), kHold_s));
}

const std::vector<FingerWrenches>& forces() {
  static const std::vector<FingerWrenches> all = [] {
    std::vector<FingerWrenches> rows;
    auto reader = value_or_throw(FingerForcesReader::open(kGiven + "forces.csv"));
    FingerForcesRow row;
    while (value_or_throw(reader.next(row))) rows.push_back(row.wrench_C);
    return rows;
  }();
  return all;
}

void frame(benchmark::State& bench, const std::string& file, bool pressed = true) {
  const Plan plan = plan_of(kGiven + file);
  ObjectState state = plan.initial_state();
  const auto rows = pressed ? forces() : std::vector<FingerWrenches>(forces().size());
  std::size_t k = 0;
  for (auto _ : bench) {
    plan.step(rows[k], state);
    benchmark::DoNotOptimize(state);
    if (++k == rows.size()) {
      k = 0;
      state = plan.initial_state();
    }
  }
}
BENCHMARK_CAPTURE(frame, S1_knob, std::string("S1.toml"));
BENCHMARK_CAPTURE(frame, S2_planar_block, std::string("S2.toml"));
BENCHMARK_CAPTURE(frame, S3_free_block, std::string("S3.toml"));
BENCHMARK_CAPTURE(frame, S4a_stiff, std::string("S4a.toml"));
BENCHMARK_CAPTURE(frame, S5_tumbling, std::string("S5.toml"), false);
BENCHMARK_CAPTURE(frame, S7_overdamped, std::string("S7.toml"));

/// A frame of one of `count` objects that move side by side, each under its own forces.
void batch_frame(benchmark::State& bench, const std::string& file, std::size_t count) {
  const Plan plan = plan_of(kGiven + file);
  Batch batch(plan, count);
  constexpr std::size_t kApart = 97;  // rows of the recording between two objects
  std::vector<std::vector<FingerWrenches>> rows(forces().size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t i = 0; i < count; ++i)
      rows[k].push_back(forces()[(k + kApart * i) % rows.size()]);
  std::size_t k = 0;
  std::size_t waiting = 0;
  for (auto _ : bench) {
    if (++waiting < count) continue;
    waiting = 0;
    batch.step(rows[k]);
    if (++k == rows.size()) k = 0;
  }
}
BENCHMARK_CAPTURE(batch_frame, S2_planar_block_one_of_8, std::string("S2.toml"), 8);
BENCHMARK_CAPTURE(batch_frame, S2_planar_block_one_of_64, std::string("S2.toml"), 64);
BENCHMARK_CAPTURE(batch_frame, S3_free_block_one_of_8, std::string("S3.toml"), 8);
BENCHMARK_CAPTURE(batch_frame, S3_free_block_one_of_64, std::string("S3.toml"), 64);

void grasp_alone(benchmark::State& bench) {
  const Plan plan = plan_of(kGiven + "S2.toml");
  ObjectState state = plan.initial_state();
  const auto& rows = forces();
  std::size_t k = 0;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(plan.grasp(rows[k], state));
    if (++k == rows.size()) k = 0;
  }
}
BENCHMARK(grasp_alone);

void clamp_sliding_finger(benchmark::State& bench) {
  Contact contact;
  contact.friction = 0.8;
  const FrictionLimit limit(contact);
  Wrench wrench;
  wrench.force = {3.0, -2.0, 4.0};
  for (auto _ : bench) {
    benchmark::DoNotOptimize(wrench);
    benchmark::DoNotOptimize(clamp_to_friction(limit, wrench));
  }
}
BENCHMARK(clamp_sliding_finger);

constexpr Oscillator kBlock{0.3, 1.0, 30.0};

void linear_step_build(benchmark::State& bench) {
  double hold_s = kHold_s;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(hold_s);
    benchmark::DoNotOptimize(LinearStep(kBlock, hold_s));
  }
}
BENCHMARK(linear_step_build);

void linear_step_advance(benchmark::State& bench) {
  const LinearStep step(kBlock, kHold_s);
  Motion motion{0.1, 0.0};
  for (auto _ : bench) {
    motion = step.advance(motion, 3.0);
    benchmark::DoNotOptimize(motion);
  }
}
BENCHMARK(linear_step_advance);

void rotation_step(benchmark::State& bench) {
  so3::SpinRate rate({{1e-4, 2e-4, 3e-4}, Vec3::Constant(1e-3), Vec3::Constant(0.2)});
  rate.load({{0.01, -0.02, 0.03}, Vec3::Zero()});
  const so3::SpinVector start = so3::pack({so3::exp({0.5, -0.4, 0.3}), {3.0, -2.0, 4.0}});
  for (auto _ : bench)
    benchmark::DoNotOptimize(so3::explicit_step(so3::Order::eighth, rate, start, kHold_s, nullptr));
}
BENCHMARK(rotation_step);

}  // namespace

}  // namespace isograsp
