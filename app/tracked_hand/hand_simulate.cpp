// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand simulate, thresholds: a person in software places an object; limits of the criteria
// for a hand.
#include <algorithm>
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/paths.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "hand_world/placement_run.hpp"
#include "statistics/percentile.hpp"
#include "virtual_hand/reachable_grasps.hpp"
#include "virtual_patient/hand/virtual_grasper.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;
using hand_world::AssistanceLevel;
using hand_world::PlacementResult;
using hand_world::PlacementRun;

struct HandSimulateOptions {
  std::string hand;
  std::string object;
  std::string assistance;
  std::string user = "healthy";
  std::uint64_t seed = 0;
  int tests = 1;
  bool timing = false;
  bool json = false;
};

Result<std::size_t> object_named(const std::string& name) {
  std::string names;
  for (std::size_t k = 0; k < kStudyObjects; ++k) {
    const std::string one(study_objects()[k].name);
    if (one == name) return k;
    names += (names.empty() ? "" : ", ") + one;
  }
  return refused("there is no object '%1'"_text(name), "use one of: %1"_text(names))
      .about("--object");
}

HandJson or_null(const std::optional<double>& value) {
  return value ? HandJson(*value) : HandJson(nullptr);
}

HandJson placement_json(std::size_t number, const PlacementResult& result) {
  const PlacementScore& score = result.score;
  return {{"placement", number},
          {"completed", score.completed ? 1 : 0},
          {"fails", score.fails},
          {"manipulation_s", or_null(score.manipulation_s)},
          {"done_s", or_null(score.done_s)},
          {"hold_distance_m", or_null(score.hold_distance_m)},
          {"hold_axis_angle_rad", or_null(score.hold_axis_angle_rad)},
          {"hold_geodesic_rad", or_null(score.hold_geodesic_rad)},
          {"release_s", or_null(result.release_s)},
          {"held_open_s", result.held_open_s},
          {"helped", result.helped ? 1 : 0},
          {"lost_share", result.lost_share}};
}

Result<void> run_hand_simulate(const HandSimulateOptions& options) {
  const auto object = object_named(options.object);
  if (!object) return object.error();
  const auto model =
      load_hand(options.hand.empty() ? library_folder() + "/hands/default.toml" : options.hand);
  if (!model) return model.error();
  const bool assisted = options.assistance == "on";
  virtual_patient::VirtualGrasper person(*model, *virtual_patient::grasp_traits(options.user),
                                         options.seed, model->side);
  PlacementRun run(*model, person);
  const StudyObject& what = study_objects()[*object];
  auto placements = HandJson::array();
  int fails = 0;
  double residual_m_s = 0.0;
  for (const StudyTest& test : tests_of(*object, assisted, options.tests, options.seed))
    for (const std::size_t target : test.targets) {
      const PlacementResult result =
          run.place(what, targets_of(what.size)[target],
                    assisted ? AssistanceLevel::full : AssistanceLevel::off);
      fails += result.score.fails;
      residual_m_s = std::max(residual_m_s, result.residual_m_s);
      placements.push_back(placement_json(placements.size() + 1, result));
      if (!options.json)
        print("%zu %s, %d, %.2f s, %.2f mm\n", placements.size(),
              result.score.completed ? "1" : "0", result.score.fails,
              result.score.manipulation_s.value_or(0.0),
              1e3 * result.score.hold_distance_m.value_or(0.0));
    }
  if (!options.json) return {};
  HandJson answer{{"fails", fails}, {"placements", std::move(placements)}};
  // The same command prints the same bytes; only who asks for times gets what differs.
  answer["step_us"] = nullptr;
  if (options.timing) {
    std::vector<double> times_us;
    for (const double time_s : run.step_times_s()) times_us.push_back(1e6 * time_s);
    constexpr double kP99 = 99.0;
    answer["step_us"] = {{"median", *statistics::median(times_us).value},
                         {"p99", *statistics::percentile(times_us, kP99).value}};
  }
  answer["residual_N"] = residual_m_s / hand_world::PadLaw::kSoftness_m_N_s;
  print_json(answer);
  return {};
}

struct HandThresholdsOptions {
  std::string hand;
  std::uint64_t seed = 0;
  bool json = false;
};

HandJson limits_json(std::span<const GraspCriteria> grasps, std::size_t size) {
  const FoundLimits limits = limits_from(grasps);
  const Separation parts = separation_of(grasps);
  const auto number = [](double value) {
    return std::isfinite(value) ? HandJson(value) : HandJson(nullptr);
  };
  HandJson found{{"G_min", number(limits.G_min)}};
  if (size == 2) found["H_min"] = number(limits.H_min);
  found["H_det"] = number(limits.H_det);
  return {{"grasps", grasps.size()},
          {"closed", parts.closed},
          {"limits", std::move(found)},
          {"auc",
           {{"G_min", number(parts.G_min)},
            {"H_min", number(parts.H_min)},
            {"H_det", number(parts.H_det)},
            {"raw_G_min", number(parts.G_min_raw)}}}};
}

Result<void> run_hand_thresholds(const HandThresholdsOptions& options) {
  constexpr std::size_t kGrasps = 120;  // of each object and size of set
  const auto hand = load_hand(options.hand);
  if (!hand) return hand.error();
  auto objects = HandJson::array();
  for (const StudyObject& object : study_objects()) {
    HandJson one{{"object", object.name}};
    for (const std::size_t size : {std::size_t{2}, std::size_t{3}}) {
      const auto grasps = reachable_grasps(*hand, object.shape, size, kGrasps, options.seed);
      const char* const key = size == 2 ? "two" : "three";
      one[key] = limits_json(grasps, size);
      if (!options.json)
        print("%-14s %zu  G_min %.3g, H_min %.3g, H_det %.3g  AUC %.3f\n",
              std::string(object.name).c_str(), size, limits_from(grasps).G_min,
              limits_from(grasps).H_min, limits_from(grasps).H_det, separation_of(grasps).G_min);
    }
    objects.push_back(std::move(one));
  }
  if (options.json) print_json({{"objects", std::move(objects)}});
  return {};
}

}  // namespace

void add_hand_simulate(Subcommand hand) {
  auto options = std::make_shared<HandSimulateOptions>();
  Subcommand simulate =
      hand.subcommand("simulate", "A person in software places an object, with help or without");
  simulate.option("--object", options->object, "Of the study, such as small_cuboid").required();
  simulate.option("--assistance", options->assistance, "Ties of a feasible grasp")
      .required()
      .one_of({"on", "off"});
  simulate.option("--user", options->user, "Who grasps").one_of({"healthy", "paretic"});
  simulate.option("--seed", options->seed, "Of the person").required();
  simulate.option("--tests", options->tests, "Tests of three placements").range(1, 1000);
  simulate.option("--hand", options->hand, "Hand file; without it that of the library")
      .type("FILE");
  simulate.flag("--timing", options->timing, "Tell the time of a step, too");
  simulate.flag("--json", options->json, "Print one JSON document");
  simulate.runs([options] { return run_hand_simulate(*options); });

  auto limits = std::make_shared<HandThresholdsOptions>();
  Subcommand thresholds = hand.subcommand(
      "thresholds", "Limits of the criteria, from grasps of each object that a hand can reach");
  thresholds.option("--hand", limits->hand, "Hand file").required().type("FILE");
  thresholds.option("--seed", limits->seed, "Draws the grasps").required();
  thresholds.flag("--json", limits->json, "Print one JSON document");
  thresholds.runs([limits] { return run_hand_thresholds(*limits); });
}

}  // namespace isograsp::app
