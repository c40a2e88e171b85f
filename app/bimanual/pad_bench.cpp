// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp pad-bench: one step of soft pads, point by point and aggregated, time against error: of
// a file, or of four scenes with few to many points.
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bimanual/pad_case.hpp"
#include "app/commands.hpp"
#include "app/console.hpp"
#include "bimanual/pads/pad_scenes.hpp"

namespace isograsp::app {

namespace {

using PadJson = nlohmann::ordered_json;
using bimanual::kPadSceneNames;
using bimanual::kPadSolverNames;
using bimanual::PadScene;
using bimanual::PadSolution;
using bimanual::PadSolver;
using bimanual::PadStep;

/// Talvas et al., table of the aggregate constraints: rows and time of one step, every contact by
/// itself and aggregated.
constexpr int kSourceRows = 528, kSourceAggregated = 51;
constexpr double kSourcePointwise_ms = 223.69, kSourceAggregated_ms = 54.75;
constexpr const char* kSourceRemark = "measured by its authors on other hardware";

struct PadBenchOptions {
  std::string file, scene;
  std::string points = "12,24,48,96,176,200";
  bool json = false;
};

struct TimedSolution {
  PadSolution solution;
  double solve_us = 0.0;  ///< median
  double wrench_error = 0.0;
};
using TimedSolutions = std::array<TimedSolution, kPadSolverNames.size()>;

TimedSolution timed(const PadStep& step, PadSolver solver) {
  constexpr int kTimes = 11;
  constexpr double kMicro = 1e6, kPatience_us = 2e5;  // what takes longer is timed less often
  TimedSolution timed;
  std::vector<double> times_us;
  for (double all_us = 0.0; times_us.size() < kTimes && all_us < kPatience_us;
       all_us += times_us.back()) {
    const auto begin = std::chrono::steady_clock::now();
    timed.solution = solve(step, solver);
    times_us.push_back(
        kMicro * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  const auto middle = times_us.begin() + static_cast<std::ptrdiff_t>(times_us.size() / 2);
  std::nth_element(times_us.begin(), middle, times_us.end());
  timed.solve_us = *middle;
  return timed;
}

TimedSolutions by_all_solvers(const PadStep& step) {
  TimedSolutions all;
  for (std::size_t s = 0; s < all.size(); ++s) {
    all[s] = timed(step, static_cast<PadSolver>(s));
    all[s].wrench_error = wrench_error(all[s].solution, all.front().solution);
  }
  return all;
}

PadJson rows_json(const std::vector<Vec6>& rows) {
  auto json = PadJson::array();
  for (const Vec6& row : rows) json.push_back(std::vector<double>(row.begin(), row.end()));
  return json;
}

void put_solutions(const TimedSolutions& all, PadJson& json) {
  for (std::size_t s = 0; s < all.size(); ++s) {
    const PadSolution& solution = all[s].solution;
    json[std::string(kPadSolverNames[s])] = {
        {"constraints", solution.constraints},
        {"sweeps", solution.sweeps},
        {"settled", solution.settled},
        {"solve_us", all[s].solve_us},
        {"wrench_on_object", rows_json(solution.wrench_on_object)},
        {"velocity", rows_json(solution.velocity)},
        {"wrench_error", all[s].wrench_error}};
  }
}

Result<void> run_pad_case(const PadBenchOptions& options) {
  const auto step = read_pad_case(options.file);
  if (!step) return step.error();
  const TimedSolutions all = by_all_solvers(*step);
  if (options.json) {
    PadJson answer;
    put_solutions(all, answer);
    print_json(answer);
    return {};
  }
  for (std::size_t s = 0; s < all.size(); ++s)
    print("%-16s %5zu rows %6d sweeps %10.1f us   wrench error %.2e\n",
          std::string(kPadSolverNames[s]).c_str(), all[s].solution.constraints,
          all[s].solution.sweeps, all[s].solve_us, all[s].wrench_error);
  return {};
}

/// "12,24" as numbers.
Result<std::vector<int>> point_counts(const std::string& text) {
  std::vector<int> counts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    int count = 0;
    const auto [stop, bad] = std::from_chars(text.data() + begin, text.data() + end, count);
    if (bad != std::errc() || stop != text.data() + end || count < 1)
      return refused("is no list of whole numbers"_text, "write it as 12,24,48"_text)
          .about("--points");
    counts.push_back(count);
    begin = end + 1;
  }
  return counts;
}

void print_scene_row(std::string_view scene, int points, const TimedSolutions& all) {
  print("%-9s %6d", std::string(scene).c_str(), points);
  for (const TimedSolution& one : all)
    print("  %4zu %5d%c %9.1f", one.solution.constraints, one.solution.sweeps,
          one.solution.settled ? ' ' : '*', one.solve_us);
  print("  %6.1f  %8.1e %8.1e\n", all[0].solve_us / all[1].solve_us, all[1].wrench_error,
        all[2].wrench_error);
}

struct ScenePoints {
  std::string_view scene;
  int points = 0;
  bimanual::PadGrasp grasp;
};
/// All that is asked for, before any of it is solved.
Result<std::vector<ScenePoints>> asked_scenes(const PadBenchOptions& options) {
  const auto counts = point_counts(options.points);
  if (!counts) return counts.error();
  std::vector<ScenePoints> asked;
  for (std::size_t k = 0; k < kPadSceneNames.size(); ++k) {
    if (!options.scene.empty() && options.scene != kPadSceneNames[k]) continue;
    for (const int count : *counts) {
      auto grasp = bimanual::pad_grasp(static_cast<PadScene>(k), count);
      if (!grasp) return grasp.error();
      asked.push_back({kPadSceneNames[k], count, *std::move(grasp)});
    }
  }
  return asked;
}

void print_scenes(const std::vector<ScenePoints>& asked) {
  print(
      "%-9s %6s  %-21s  %-21s  %-21s  %6s  %8s %8s\n%-16s"
      "  rows sweeps      [us]  rows sweeps      [us]  rows sweeps      [us]  faster  aggreg."
      "    exact\n",
      "scene", "points", "pointwise", "aggregate", "aggregate_exact", "times", "error", "error",
      "");
  for (const ScenePoints& one : asked)
    print_scene_row(one.scene, one.points, by_all_solvers(step_under_way(one.grasp)));
  print(
      "* had not settled when the sweeps ended\nsource: %d rows in %.2f ms, %d in %.2f ms; "
      "%s\n",
      kSourceRows, kSourcePointwise_ms, kSourceAggregated, kSourceAggregated_ms, kSourceRemark);
}

void print_scenes_json(const std::vector<ScenePoints>& asked) {
  PadJson answer;
  for (const ScenePoints& one : asked) {
    PadJson json{{"scene", one.scene}, {"pads", one.grasp.pads.size()}, {"points", one.points}};
    put_solutions(by_all_solvers(step_under_way(one.grasp)), json);
    answer["scenes"].push_back(std::move(json));
  }
  answer["source"] = {{"constraints", {kSourceRows, kSourceAggregated}},
                      {"solve_ms", {kSourcePointwise_ms, kSourceAggregated_ms}},
                      {"remark", kSourceRemark}};
  print_json(answer);
}

Result<void> run_pad_scenes(const PadBenchOptions& options) {
  const auto asked = asked_scenes(options);
  if (!asked) return asked.error();
  if (options.json)
    print_scenes_json(*asked);
  else
    print_scenes(*asked);
  return {};
}

Result<void> run_pad_bench(const PadBenchOptions& options) {
  return options.file.empty() ? run_pad_scenes(options) : run_pad_case(options);
}

}  // namespace

void add_pad_bench(CommandLine& line) {
  auto options = std::make_shared<PadBenchOptions>();
  Subcommand command =
      line.subcommand("pad-bench", "One step of soft pads: each point, and pads as one row block");
  auto file = command.option("--case", options->file, "Bodies and pads (JSON)");
  command.option("--scene", options->scene, "This scene alone; without: all four")
      .one_of({"ball", "dumbbell", "pencil", "edge"})
      .excludes(file);
  command.option("--points", options->points, "Points of all pads of a scene, a row each")
      .excludes(file);
  command.flag("--json", options->json, "Print JSON");
  command.runs([options] { return run_pad_bench(*options); });
}

}  // namespace isograsp::app
