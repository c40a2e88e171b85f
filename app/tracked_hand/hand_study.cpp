// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand plan.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;

struct HandPlanOptions {
  std::uint64_t seed = 0;
  bool json = false;
};

Result<void> run_hand_plan(const HandPlanOptions& options) {
  auto tests = HandJson::array();
  for (const StudyTest& test : study_plan(options.seed)) {
    const StudyObject& object = study_objects()[test.object];
    const char* const assistance = test.assistance ? "on" : "off";
    auto targets = HandJson::array();
    std::string places;
    for (const std::size_t which : test.targets) {
      const StudyTarget& target = targets_of(object.size)[which];
      targets.push_back(
          {{"position_m", place_json(target.p_W)}, {"axis", place_json(target.axis_W)}});
      places += " " + std::to_string(which + 1);
    }
    if (!options.json)
      print("%-14s %-3s%s\n", std::string(object.name).c_str(), assistance, places.c_str());
    tests.push_back(
        {{"object", object.name}, {"assistance", assistance}, {"targets", std::move(targets)}});
  }
  if (options.json) print_json({{"tests", std::move(tests)}});
  return {};
}

}  // namespace

void add_hand_study(Subcommand hand) {
  auto options = std::make_shared<HandPlanOptions>();
  Subcommand plan =
      hand.subcommand("plan", "The tests of a study of assistance: objects, modes, targets");
  plan.option("--seed", options->seed, "Orders objects, modes and targets").required();
  plan.flag("--json", options->json, "Print one JSON document");
  plan.runs([options] { return run_hand_plan(*options); });
}

}  // namespace isograsp::app
