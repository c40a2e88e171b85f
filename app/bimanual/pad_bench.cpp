// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp pad-bench: one step of soft pads, point by point and aggregated, time against error.
#include <algorithm>
#include <chrono>
#include <memory>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "bimanual/pads/pad_step.hpp"
#include "core/files.hpp"

namespace isograsp::app {

namespace {

using PadJson = nlohmann::ordered_json;
using bimanual::PadFace;
using bimanual::PadPoint;
using bimanual::PadSolution;
using bimanual::PadSolver;
using bimanual::PadStep;

struct PadBenchOptions {
  std::string file;
  bool json = false;
};

/// Numbers of a JSON array. Throws what nlohmann throws; caught where the file is named.
template <int kRows>
Eigen::Matrix<double, kRows, 1> numbers_in(const nlohmann::json& array) {
  Eigen::Matrix<double, kRows, 1> numbers;
  for (int i = 0; i < kRows; ++i) numbers[i] = array.at(static_cast<std::size_t>(i)).get<double>();
  return numbers;
}

PadFace face_in(const nlohmann::json& json) {
  PadFace face;
  face.object = json.at("object");
  face.pad = json.at("pad");
  face.friction = json.at("friction");
  face.stiffness_N_m3 = json.at("stiffness_N_m3");
  const auto& object = json.at("p_object_m");
  for (std::size_t i = 0; i < object.size(); ++i)
    face.points.push_back({numbers_in<3>(object.at(i)), numbers_in<3>(json.at("p_pad_m").at(i)),
                           numbers_in<3>(json.at("normal").at(i)),
                           json.at("area_m2").at(i).get<double>(),
                           json.at("penetration_free_m").at(i).get<double>()});
  return face;
}

PadStep step_in(const nlohmann::json& json) {
  PadStep step;
  step.step_s = json.at("step_s");
  for (const auto& rows : json.at("inertia_kg")) {
    bimanual::Mat6 inertia;
    for (int i = 0; i < 6; ++i)
      inertia.row(i) = numbers_in<6>(rows.at(static_cast<std::size_t>(i))).transpose();
    step.inertia.push_back(inertia);
  }
  for (const auto& velocity : json.at("velocity_free"))
    step.velocity_free.push_back(numbers_in<6>(velocity));
  for (const auto& pad : json.at("pads")) step.faces.push_back(face_in(pad));
  return step;
}

Result<void> check_step(const PadStep& step) {
  const auto bad = [](Text what) { return refused(std::move(what), "correct the case"_text); };
  if (!(step.step_s > 0.0)) return bad("step_s is not above zero"_text);
  if (step.inertia.empty() || step.inertia.size() != step.velocity_free.size())
    return bad("inertia_kg and velocity_free are not of as many bodies"_text);
  for (const auto& inertia : step.inertia)
    if (!(inertia.determinant() > 0.0) || !inertia.allFinite())
      return bad("an inertia cannot be inverted"_text);
  for (const PadFace& face : step.faces) {
    if (face.object >= step.inertia.size() || face.pad >= step.inertia.size() ||
        face.object == face.pad)
      return bad("a pad names a body that is not there"_text);
    if (!(face.friction >= 0.0) || !(face.stiffness_N_m3 > 0.0))
      return bad("a pad has no friction or no stiffness"_text);
    for (const PadPoint& point : face.points)
      if (!(point.area_m2 > 0.0) || !point.normal.allFinite() || !(point.normal.norm() > 0.0))
        return bad("a point has no area or no normal"_text);
  }
  return {};
}

Result<PadStep> read_case(const std::string& file) {
  const auto text = read_text(file);
  if (!text) return text.error();
  PadStep step;
  try {
    step = step_in(nlohmann::json::parse(*text));
  } catch (const nlohmann::json::exception& bad) {
    return refused("is no case of pads: %1"_text(std::string(bad.what())),
                   "see docs/bimanual.md, Pads"_text)
        .at(file);
  }
  if (auto good = check_step(step); !good) return Error(good.error()).at(file);
  return step;
}

struct TimedSolution {
  PadSolution solution;
  double solve_us = 0.0;  ///< median
};
TimedSolution timed(const PadStep& step, PadSolver solver) {
  constexpr int kTimes = 11;
  constexpr double kMicro = 1e6;
  TimedSolution timed;
  std::vector<double> times_us;
  for (int k = 0; k < kTimes; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    timed.solution = solve(step, solver);
    times_us.push_back(
        kMicro * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::nth_element(times_us.begin(), times_us.begin() + kTimes / 2, times_us.end());
  timed.solve_us = times_us[kTimes / 2];
  return timed;
}

PadJson rows_json(const std::vector<Vec6>& rows) {
  auto json = PadJson::array();
  for (const Vec6& row : rows) json.push_back(std::vector<double>(row.begin(), row.end()));
  return json;
}

Result<void> run_pad_case(const PadBenchOptions& options) {
  const auto step = read_case(options.file);
  if (!step) return step.error();
  PadJson answer;
  PadSolution exact;
  for (std::size_t s = 0; s < bimanual::kPadSolverNames.size(); ++s) {
    const TimedSolution one = timed(*step, static_cast<PadSolver>(s));
    if (s == 0) exact = one.solution;
    const std::string name(bimanual::kPadSolverNames[s]);
    const double error = wrench_error(one.solution, exact);
    if (options.json)
      answer[name] = {{"constraints", one.solution.constraints},
                      {"sweeps", one.solution.sweeps},
                      {"settled", one.solution.settled},
                      {"solve_us", one.solve_us},
                      {"wrench_on_object", rows_json(one.solution.wrench_on_object)},
                      {"velocity", rows_json(one.solution.velocity)},
                      {"wrench_error", error}};
    else
      print("%-16s %5zu rows %6d sweeps %10.1f us   wrench error %.2e\n", name.c_str(),
            one.solution.constraints, one.solution.sweeps, one.solve_us, error);
  }
  if (options.json) print_json(answer);
  return {};
}

}  // namespace

void add_pad_bench(CommandLine& line) {
  auto options = std::make_shared<PadBenchOptions>();
  Subcommand command =
      line.subcommand("pad-bench", "One step of soft pads: each point, and pads as one row block");
  command.option("--case", options->file, "Bodies and pads (JSON)").required();
  command.flag("--json", options->json, "Print JSON");
  command.runs([options] { return run_pad_case(*options); });
}

}  // namespace isograsp::app
