// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand study: people in software place six objects with assistance and without
// (docs/virtual_hand.md, "The simulated study").
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/language.hpp"
#include "app/paths.hpp"
#include "app/stop_signals.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/files.hpp"
#include "core/staging_folder.hpp"
#include "hand_world/placement_run.hpp"
#include "reports/paper/qt_application.hpp"
#include "reports/study/grasp_study.hpp"
#include "reports/study/study_analysis.hpp"
#include "reports/study/study_report.hpp"
#include "reports/study/study_writer.hpp"
#include "virtual_patient/hand/virtual_grasper.hpp"

namespace isograsp::app {

namespace {

namespace fs = std::filesystem;
using namespace virtual_hand;
using hand_world::AssistanceLevel;
using hand_world::PlacementResult;
using hand_world::PlacementRun;
using reports::GraspPlacement;

struct HandSimulatedStudyOptions {
  std::uint64_t seeds = 20;
  std::string out;
  std::string hand;
  bool json = false;
};

/// One person and all that they place.
struct StudyPerson {
  std::string_view user;
  std::uint64_t seed = 0;
  std::vector<GraspPlacement> placements;
};

GraspPlacement as_row(const StudyPerson& person, const StudyTest& test, std::size_t target,
                      const PlacementResult& result) {
  const StudyObject& object = study_objects()[test.object];
  GraspPlacement row;
  row.group = person.user;
  row.seed = person.seed;
  row.object = object.name;
  row.size = reports::kGraspSizes[static_cast<std::size_t>(object.size)];
  row.assistance = test.assistance;
  row.target = target;
  row.completed = result.score.completed;
  row.fails = result.score.fails;
  row.manipulation_s = result.score.manipulation_s;
  row.hold_distance_m = result.score.hold_distance_m;
  row.hold_axis_angle_rad = result.score.hold_axis_angle_rad;
  row.hold_geodesic_rad = result.score.hold_geodesic_rad;
  row.release_s = result.release_s;
  row.helped = result.helped;
  row.held_open_s = result.held_open_s;
  row.lost_share = result.lost_share;
  return row;
}

/// People work side by side, each in a world of their own: who is when does not matter.
class StudyWorkers {
 public:
  StudyWorkers(const HandModel& hand, std::vector<StudyPerson>& people)
      : hand_(hand), people_(people) {
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    for (unsigned k = 0; k < threads; ++k) threads_.emplace_back([this] { work(); });
  }
  ~StudyWorkers() {
    stop_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  StudyWorkers(const StudyWorkers&) = delete;
  StudyWorkers& operator=(const StudyWorkers&) = delete;

  /// False: it was stopped.
  [[nodiscard]] bool wait(ProgressBar& bar) const {
    constexpr std::size_t kTests = 24;
    const std::size_t all = kTests * people_.size();
    while (tests_ < all) {
      if (StopSignals::stop()) return false;
      bar.show(static_cast<double>(tests_) / static_cast<double>(all),
               "%1 of %2 tests"_text(tests_.load(), all));
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return true;
  }

 private:
  void work() {
    for (std::size_t k = next_++; k < people_.size() && !stop_; k = next_++) place_all(people_[k]);
  }
  void place_all(StudyPerson& person) {
    virtual_patient::VirtualGrasper grasper(hand_, *virtual_patient::grasp_traits(person.user),
                                            person.seed, hand_.side);
    PlacementRun run(hand_, grasper);
    for (const StudyTest& test : study_plan(person.seed)) {
      const StudyObject& object = study_objects()[test.object];
      for (const std::size_t target : test.targets) {
        if (stop_) return;
        const AssistanceLevel level =
            test.assistance ? AssistanceLevel::full : AssistanceLevel::off;
        person.placements.push_back(as_row(
            person, test, target, run.place(object, targets_of(object.size)[target], level)));
      }
      ++tests_;
    }
  }

  const HandModel& hand_;
  std::vector<StudyPerson>& people_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> tests_{0};
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
};

Result<void> write_reports(const std::vector<GraspPlacement>& placements,
                           const std::string& folder) {
  if (auto done = write_text(folder + "/placements.csv", reports::grasp_study_csv(placements));
      !done)
    return done;
  reports::ensure_qt_application();
  for (const reports::GraspMeasure measure : reports::kGraspMeasures) {
    const reports::Study study = reports::grasp_study(measure);
    const reports::StudyData data =
        reports::grasp_study_data(placements, measure, PlacementRun::kLongest_s);
    std::vector<reports::GroupAnalysis> analyses;
    for (const auto& group : data.groups) analyses.push_back(reports::analyse(study, group));
    const auto report = reports::study_report(study, data, analyses, spoken());
    const std::string name = folder + "/" + std::string(reports::name_of(measure));
    if (auto done = write_text(name + ".pdf", reports::study_pdf(report)); !done) return done;
    if (auto done = write_text(name + ".csv", reports::study_csv(study, data)); !done) return done;
    if (auto done = write_text(name + ".json", reports::study_json(study, data, analyses)); !done)
      return done;
    std::size_t plots = 0;
    for (const auto& block : report.blocks)
      if (const auto* plot = std::get_if<reports::StudyPlot>(&block)) {
        const std::string picture = name + "_" + data.groups[plots++].name + ".png";
        if (auto done = write_text(picture, reports::study_png(*plot)); !done) return done;
      }
  }
  return {};
}

void tell_tally(const std::vector<GraspPlacement>& placements, bool json) {
  auto list = HandJson::array();
  for (const reports::GraspTally& tally : reports::tally_of(placements)) {
    list.push_back({{"user", tally.group},
                    {"size", tally.size},
                    {"assistance", tally.assistance ? "on" : "off"},
                    {"placements", tally.placements},
                    {"completed", tally.completed},
                    {"fails", tally.fails},
                    {"helped", tally.helped},
                    {"longest_held_open_s", tally.longest_held_open_s}});
    if (!json)
      print("%-8s %-6s %-3s  %d/%d, %d, %d, %.2f s\n", tally.group.c_str(), tally.size.c_str(),
            tally.assistance ? "on" : "off", tally.completed, tally.placements, tally.fails,
            tally.helped, tally.longest_held_open_s);
  }
  if (json) print_json({{"cells", std::move(list)}});
}

Result<void> run_hand_simulated_study(const HandSimulatedStudyOptions& options) {
  std::error_code failure;
  if (fs::exists(options.out, failure))
    return refused("exists already"_text, "name a new folder"_text).at(options.out);
  const auto hand =
      load_hand(options.hand.empty() ? library_folder() + "/hands/default.toml" : options.hand);
  if (!hand) return hand.error();
  auto staging = StagingFolder::beside(options.out);
  if (!staging) return staging.error();
  std::vector<StudyPerson> people;
  for (const std::string_view user : virtual_patient::grasper_names())
    for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) people.push_back({user, seed, {}});
  {
    const StopSignals signals;
    ProgressBar bar("Study"_text);
    const StudyWorkers workers(*hand, people);
    if (!workers.wait(bar)) return cancelled();
  }
  std::vector<GraspPlacement> placements;
  for (const StudyPerson& person : people)
    placements.insert(placements.end(), person.placements.begin(), person.placements.end());
  fs::create_directory(staging->file(), failure);
  if (failure)
    return failed("could not be made: %1"_text(Known{failure.message()}),
                  "choose another folder"_text)
        .at(options.out);
  if (auto done = write_reports(placements, staging->file()); !done) return done;
  fs::rename(staging->file(), options.out, failure);
  if (failure)
    return failed("could not be made: %1"_text(Known{failure.message()}),
                  "choose another folder"_text)
        .at(options.out);
  tell_tally(placements, options.json);
  return {};
}

}  // namespace

void add_hand_simulated_study(Subcommand hand) {
  auto options = std::make_shared<HandSimulatedStudyOptions>();
  Subcommand study = hand.subcommand(
      "study", "People in software place six objects, with assistance and without: table, figures");
  constexpr int kMostSeeds = 10000;
  study.option("--seeds", options->seeds, "People of each kind").range(2, kMostSeeds);
  study.option("--out", options->out, "Folder to make").required().type("FOLDER");
  study.option("--hand", options->hand, "Hand file; without it that of the library").type("FILE");
  study.flag("--json", options->json, "Print what came of all placements as one JSON document");
  study.runs([options] { return run_hand_simulated_study(*options); });
}

}  // namespace isograsp::app
