// SPDX-License-Identifier: GPL-3.0-or-later
// Google Benchmark of scoring: trials of five minutes (30 000 rows at 100 Hz) of the kinds that are
// scored in full, a table of target_X, actual_X pairs, and the dearest measures by themselves.
#include <map>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "core/csv.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/regularity.hpp"
#include "tasks/measures/smoothness.hpp"
#include "tasks/measures/spectrum.hpp"
#include "tasks/score.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp {

namespace {

using test::must;

constexpr std::size_t kRows = 30'000;
const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// A task file of at least five minutes.
std::string task_text(const std::string& kind) {
  const std::string head = "format = \"isograsp-task-1\"\nname = \"" + kind +
                           "\"\ninstruction = \"Work.\"\nversion = 1\nkind = ";
  if (kind == "sine") return head + "\"force_tracking\"\nfrequency_Hz = 0.2\nduration_s = 300\n";
  if (kind == "multi_sine")
    return head +
           "\"force_tracking\"\nwaveform = \"multi_sine\"\nduration_s = 300\n"
           "frequencies_Hz = [0.1, 0.23, 0.4, 0.6]\n";
  if (kind == "steadiness")
    return head +
           "\"steadiness\"\nlevels_fractions = [0.1, 0.25]\nband_fraction = 0.15\n"
           "hold_s = 145\n";
  if (kind == "fatigue")
    return head + "\"fatigue\"\nlevel_fraction = 0.2\nband_fraction = 0.15\nhold_s = 300\n";
  if (kind == "pose_tracking") {
    std::string text = head +
                       "\"pose_tracking\"\nscene = \"planar_block\"\nlead_in_s = 4\n"
                       "duration_s = 300\n";
    for (const char* axis : {"\"x\"\nleast_m = -0.08\nmost_m = 0.08\nfrequency_Hz = 0.15\n",
                             "\"y\"\nleast_m = -0.05\nmost_m = 0.05\nfrequency_Hz = 0.1\n",
                             "\"rz\"\nleast_deg = -30\nmost_deg = 30\nfrequency_Hz = 0.08\n"})
      text += std::string("[[axis]]\nwaveform = \"sine\"\ndof = ") + axis;
    return text;
  }
  std::string text = head +
                     "\"pose_targets\"\nscene = \"planar_block\"\nposition_tolerance_m = 0.02\n"
                     "angle_tolerance_deg = 15\ntime_limit_s = 30\n";
  constexpr int kTargets = 200;
  for (int target = 0; target < kTargets; ++target)
    text += std::string("[[target]]\nposition_m = ") +
            (target / 2 % 2 == 0 ? "[-0.08, -0.06, 0]" : "[0.08, 0.06, 0]") +
            (target % 2 == 0 ? "\nlevel = true\n" : "\nangle_deg = 90\nhold_s = 1\n");
  return text;
}

struct Trial {
  tasks::TaskSpec spec;
  Signals signals;  ///< every column that is stored of such a trial
};

Signals first_rows(const Signals& all) {
  if (all.rows() < kRows) throw std::runtime_error("the trial is shorter than five minutes");
  Signals some;
  for (const std::string& name : all.names()) {
    const auto column = all.column(name).first(kRows);
    some.add_column(name, {column.begin(), column.end()});
  }
  return some;
}

/// A virtual patient's trial, as it comes back from the database.
Trial recorded(const std::string& kind) {
  const test::TemporaryFolder folder;
  folder.write("long.toml", task_text(kind));
  std::string steps =
      "format = \"isograsp-protocol-1\"\nname = \"Bench\"\n"
      "[[step]]\nkind = \"instrument_zero\"\n";
  for (const char* task : {"resting_force.toml", "maximum_grip.toml", "long.toml"})
    steps += "[[step]]\nkind = \"task\"\ntask = \"" + std::string(task) + "\"\n";
  const test::WholeSession whole{folder.path("bench.db"), "BENCH-1", "sim://healthy?seed=7",
                                 folder.write("p.toml", steps)};
  const auto result = run_whole(whole);
  const auto store = must(storage::open_store_to_read(whole.database));
  return {must(tasks::parse_task(task_text(kind), "long.toml")),
          first_rows(must(store->signals(result.trials.back().trial)))};
}

const Trial& trial_of(const std::string& kind) {
  static std::map<std::string, Trial> made;
  const auto known = made.find(kind);
  return known != made.end() ? known->second : made.emplace(kind, recorded(kind)).first->second;
}

void score_trial(benchmark::State& bench, const std::string& kind) {
  const Trial& trial = trial_of(kind);
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::score(trial.spec, trial.signals));
}
BENCHMARK_CAPTURE(score_trial, sine, std::string("sine"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(score_trial, multi_sine, std::string("multi_sine"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(score_trial, steadiness, std::string("steadiness"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(score_trial, fatigue, std::string("fatigue"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(score_trial, pose_targets, std::string("pose_targets"))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(score_trial, pose_tracking, std::string("pose_tracking"))
    ->Unit(benchmark::kMillisecond);

/// Three positions, three angles and the force with their targets. What each follows is the force
/// that a person made, so that noise and delay are real.
const Signals& pairs() {
  static const Signals table = [] {
    const Signals& trial = trial_of("multi_sine").signals;
    Signals all;
    const auto add = [&](const std::string& name, std::string_view column) {
      const auto values = trial.column(column);
      all.add_column(name, {values.begin(), values.end()});
    };
    add("t_s", "t_s");
    for (const char* quantity :
         {"x_m", "y_m", "z_m", "roll_rad", "pitch_rad", "yaw_rad", "force_N"}) {
      add(std::string("target_") + quantity, "target_force_N");
      add(std::string("actual_") + quantity, "actual_force_N");
    }
    return all;
  }();
  return table;
}

void score_all_pairs(benchmark::State& bench) {
  const Signals& table = pairs();
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::score_pairs(table));
}
BENCHMARK(score_all_pairs)->Unit(benchmark::kMillisecond);

void read_all_pairs(benchmark::State& bench) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("pairs.csv");
  if (!write_signals(pairs(), path)) throw std::runtime_error("cannot write " + path);
  for (auto _ : bench) benchmark::DoNotOptimize(must(read_signals(path)));
}
BENCHMARK(read_all_pairs)->Unit(benchmark::kMillisecond);

statistics::UniformSamples column(const char* name) {
  const auto values = trial_of("multi_sine").signals.column(name);
  return {0.01, {values.begin(), values.end()}};
}

void measure_sample_entropy(benchmark::State& bench) {
  const statistics::UniformSamples force = column("actual_force_N");
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::sample_entropy(force.values));
}
BENCHMARK(measure_sample_entropy)->Unit(benchmark::kMillisecond);

void measure_lag(benchmark::State& bench) {
  const statistics::UniformSamples target = column("target_force_N");
  const statistics::UniformSamples force = column("actual_force_N");
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::lag(target, force));
}
BENCHMARK(measure_lag)->Unit(benchmark::kMillisecond);

void measure_sparc(benchmark::State& bench) {
  const statistics::UniformSamples rate = tasks::rate_of(column("actual_force_N"));
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::sparc(rate));
}
BENCHMARK(measure_sparc)->Unit(benchmark::kMillisecond);

void measure_ldlj(benchmark::State& bench) {
  const statistics::UniformSamples rate = tasks::rate_of(column("actual_force_N"));
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::ldlj(rate));
}
BENCHMARK(measure_ldlj)->Unit(benchmark::kMillisecond);

void measure_spectrum(benchmark::State& bench) {
  const statistics::UniformSamples force = column("actual_force_N");
  for (auto _ : bench) benchmark::DoNotOptimize(tasks::welch(force));
}
BENCHMARK(measure_spectrum)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace isograsp
