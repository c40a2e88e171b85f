// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/harness.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <string_view>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define ISOGRASP_CALLGRIND 1
#endif

namespace isograsp::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// A method slower than this per hold is not run to the end, nor timed: nobody would pick it.
constexpr double kSlowest_ns = 400e3;
/// Time one process spends on one method [ns]; fast methods repeat the whole case.
constexpr double kBudget_ns = 4e6;
/// Slower methods are timed on the first holds of the case only, and very slow ones on fewer still.
constexpr std::size_t kFewHolds = 1000;
constexpr std::size_t kVeryFewHolds = 200;
constexpr double kVerySlow_ns = 50e3;
/// Holds whose instructions are counted, after as many that warm up.
constexpr std::size_t kCountedHolds = 50;
/// An error larger than the motion itself is no answer.
constexpr double kLost = 1.0;

double ns_of(Clock::duration d) {
  return std::chrono::duration<double, std::nano>(d).count();
}

/// Processor time of this thread: does not depend on who else computes.
double processor_ns() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

bool finite(const Motion6& m) {
  const auto all = [](const auto& a) {
    return std::all_of(a.begin(), a.end(), [](double x) { return std::isfinite(x); });
  };
  return all(m.p_WO) && all(m.q_WO) && all(m.v_WO_W) && all(m.w_WO_W);
}

struct Errors {
  Distance worst;
  double relative = 0.0;
  double drift = std::numeric_limits<double>::quiet_NaN();
  const char* status = "ok";
};

Errors measure_error(const Case& scene, const Method& method) {
  const auto simulation = method.start(scene);
  const std::size_t holds = scene.pushes.size();
  Errors errors;
  const bool free_of_forces =
      scene.stiffness == std::array<double, 6>{} && scene.damping == std::array<double, 6>{};
  const Conserved before = conserved(scene, scene.start);
  const double momentum = std::hypot(before.momentum[0], before.momentum[1], before.momentum[2]);
  double drift = 0.0;
  const double start = processor_ns();
  for (std::size_t k = 0; k < holds; ++k) {
    simulation->run(k, k + 1);
    const Motion6 motion = simulation->motion();
    const Distance d = distance(motion, scene.reference[k]);
    if (!finite(motion)) {
      errors.status = "diverged";
      break;
    }
    errors.worst.metres = std::max(errors.worst.metres, d.metres);
    errors.worst.radians = std::max(errors.worst.radians, d.radians);
    const Conserved now = conserved(scene, motion);
    drift = std::max(
        {drift, std::abs(now.energy / before.energy - 1.0),
         std::hypot(now.momentum[0] - before.momentum[0], now.momentum[1] - before.momentum[1],
                    now.momentum[2] - before.momentum[2]) /
             momentum});
    if (k % 100 == 99 && processor_ns() - start > kSlowest_ns * static_cast<double>(k + 1)) {
      errors.status = "too slow";
      break;
    }
  }
  if (free_of_forces) errors.drift = drift;
  if (scene.excursion_m > 0.0) errors.relative = errors.worst.metres / scene.excursion_m;
  if (scene.excursion_rad > 0.0)
    errors.relative = std::max(errors.relative, errors.worst.radians / scene.excursion_rad);
  if (errors.status == std::string_view("ok") && errors.relative > kLost) errors.status = "lost";
  return errors;
}

double time_of(const Case& scene, const Method& method, std::size_t holds) {
  const auto simulation = method.start(scene);
  const double processor_start = processor_ns();
  const auto start = Clock::now();
  simulation->run(0, holds);
  const auto end = Clock::now();
  const double processor = processor_ns() - processor_start;
  // The same unless another program had the core meanwhile, which is none of the method's fault.
  return std::min(ns_of(end - start), processor) / static_cast<double>(holds);
}

/// Median over batches within one process; the driver takes the median over processes.
double measure_time(const Case& scene, const Method& method) {
  const std::size_t all = scene.pushes.size();
  const std::size_t few = std::min(kFewHolds, all);
  const double first = time_of(scene, method, std::min(kVeryFewHolds, all));
  if (first > kVerySlow_ns) return first;
  const double warm_up = time_of(scene, method, few);
  if (warm_up * static_cast<double>(few) > kBudget_ns) return warm_up;
  const double whole = warm_up * static_cast<double>(all);
  const auto batches = static_cast<std::size_t>(std::clamp(kBudget_ns / whole, 1.0, 31.0));
  std::vector<double> times(batches);
  for (double& t : times) t = time_of(scene, method, all);
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(batches / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// Under callgrind only: writes a dump that carries the number of the method.
void count(const Case& scene, const Method& method, std::size_t number) {
#ifdef ISOGRASP_CALLGRIND
  const auto simulation = method.start(scene);
  simulation->run(0, kCountedHolds);
  const std::string name = std::to_string(number);
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  simulation->run(kCountedHolds, 2 * kCountedHolds);
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
#else
  static_cast<void>(scene), static_cast<void>(method), static_cast<void>(number);
#endif
}

int run_all(const std::string& engine, const std::string& version,
            const std::function<std::vector<Method>(const Case&)>& methods_of, int argc,
            char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s CASE list|error|time|count [NUMBER ...]\n", argv[0]);
    return 2;
  }
  const Case scene = read_case(argv[1]);
  const std::string mode = argv[2];
  const std::vector<Method> methods = methods_of(scene);
  std::vector<std::size_t> chosen;
  for (int i = 3; i < argc; ++i) chosen.push_back(std::stoul(argv[i]));
  const auto is_chosen = [&chosen](std::size_t n) {
    return chosen.empty() || std::find(chosen.begin(), chosen.end(), n) != chosen.end();
  };
  for (std::size_t n = 0; n < methods.size(); ++n) {
    if (!is_chosen(n)) continue;
    const Method& method = methods[n];
    std::printf("begin\t%zu\t%s\t%s\t%s\t%d\t%s\t%s\n", n, engine.c_str(), version.c_str(),
                method.integrator.c_str(), method.substeps, method.parts ? "parts" : "step",
                method.setup.c_str());
    std::fflush(stdout);
    if (mode == "list") continue;
    if (mode == "error") {
      const Errors e = measure_error(scene, method);
      std::printf("error\t%zu\t%.17g\t%.17g\t%.17g\t%.17g\t%s\n", n, e.worst.metres,
                  e.worst.radians, e.relative, e.drift, e.status);
    } else if (mode == "time") {
      std::printf("time\t%zu\t%.17g\n", n, measure_time(scene, method));
    } else {
      count(scene, method, n);
      std::printf("count\t%zu\t%zu\n", n, kCountedHolds);
    }
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int run_engine(const std::string& engine, const std::string& version,
               const std::function<std::vector<Method>(const Case&)>& methods, int argc,
               char** argv) {
  try {
    return run_all(engine, version, methods, argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}

std::vector<int> ladder(int most) {
  std::vector<int> steps;
  for (int n = 1; n <= most; n *= 2) steps.push_back(n);
  return steps;
}

}  // namespace isograsp::bench
