// SPDX-License-Identifier: GPL-3.0-or-later
// Placements of a virtual object: the clinical rules as a state machine, and that its score tells
// the same story from the rows.
#include "tasks/kinds/hand/virtual_pick_place.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "hand/hand_columns.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::tasks::virtual_pick_place_test {
namespace {

using virtual_hand::AssistanceLevel;

constexpr double kStep_s = 0.01;

VirtualPickPlaceSpec two_placements() {
  VirtualPickPlaceSpec spec;
  spec.items = {{4, 0}, {5, 3}};
  return spec;
}

/// An object that a test moves, and the rows of the trial.
class Play {
 public:
  explicit Play(const VirtualPickPlaceSpec& spec, int placements_left = kMostPlacements)
      : spec_(spec), signals_(names()) {
    TaskContext context;
    context.placements_left = placements_left;
    task_ = test::must(make_task(test::spec_of(spec), context));
    step();
  }
  /// One frame; the object is where the last order put it.
  void step() {
    ++input.frames;
    input.lost += input.seen ? 0 : 1;
    view = task_->step(input);
    const HandView& of = view.hand();
    write();
    if (of.order != ObjectOrder::none) orders.push_back(of.order);
    switch (of.order) {
      case ObjectOrder::place:
      case ObjectOrder::reset:
        there_ = true;
        rest();
        break;
      case ObjectOrder::remove: there_ = false; break;
      default: break;
    }
    ++frame_;
  }
  void run(double duration_s) {
    for (int k = 0; k < std::lround(duration_s / kStep_s); ++k) step();
  }
  /// Until a placement is there.
  void wait_for_object() {
    for (int k = 0; k < 10000 && !(there_ && view.hand().placement >= 0); ++k) step();
  }
  void rest() {
    input.held = input.touched = false;
    input.supported = true;
    input.X_WO = {Vec3(0.0, 0.11, 0.0), Quat::Identity()};
  }
  void hold(double away_m = 0.0) {
    input.held = input.touched = true;
    input.supported = false;
    input.X_WO = view.hand().X_WT;
    input.X_WO.p.x() += away_m;
  }
  void open() { input.held = input.touched = false; }
  void drop() {
    hold(0.2);
    run(0.05);
    open();
    run(0.3);
  }
  void place() {
    hold(0.2);
    run(0.5);
    hold();
    run(1.1);
  }
  /// Of all that was recorded.
  [[nodiscard]] std::vector<Measure> measures() const {
    return score(test::spec_of(spec_), signals_);
  }
  [[nodiscard]] double value(std::string_view name, std::string_view channel) const {
    for (const Measure& one : measures())
      if (one.name == name && one.channel == channel) return one.value.value_or(std::nan(""));
    throw std::runtime_error("no measure " + std::string(name) + " of " + std::string(channel));
  }
  [[nodiscard]] int count(ObjectOrder order) const {
    return static_cast<int>(std::count(orders.begin(), orders.end(), order));
  }

  HandInput input{.seen = true};
  TaskView view;
  std::vector<ObjectOrder> orders;

 private:
  static std::vector<std::string> names() {
    std::vector<std::string> all{
        columns::t_s,         columns::phase,          columns::sample_flags,
        columns::pause_cause, columns::placement,      columns::assistance,
        columns::eased,       columns::let_go_asked,   columns::object_helped,
        columns::object_held, columns::object_touched, columns::object_supported};
    for (const auto* axes : {&columns::actual_position, &columns::target_position})
      for (const Column& column : *axes) all.emplace_back(column);
    for (const auto* parts : {&columns::actual_attitude, &columns::target_attitude})
      for (const Column& column : *parts) all.emplace_back(column);
    return all;
  }
  void write() {
    const HandView& of = view.hand();
    const Pose target = of.target_shown ? of.X_WT : missing_pose();
    const Pose object = there_ ? input.X_WO : missing_pose();
    std::vector<double> row{frame_ * kStep_s,
                            static_cast<double>(view.phase),
                            input.seen ? 0.0 : 1.0,
                            0.0,
                            static_cast<double>(of.placement),
                            static_cast<double>(of.assistance),
                            static_cast<double>(of.eased),
                            static_cast<double>(of.let_go_asked),
                            static_cast<double>(of.helped),
                            static_cast<double>(input.held),
                            static_cast<double>(input.touched),
                            static_cast<double>(input.supported)};
    for (const Pose* pose : {&object, &target})
      row.insert(row.end(), {pose->p.x(), pose->p.y(), pose->p.z()});
    for (const Pose* pose : {&object, &target})
      row.insert(row.end(), {pose->q.w(), pose->q.x(), pose->q.y(), pose->q.z()});
    signals_.append_row(row);
  }

  VirtualPickPlaceSpec spec_;
  Signals signals_;
  std::unique_ptr<Task> task_;
  bool there_ = false;
  int frame_ = 0;
};

TEST(VirtualPickPlace, AnObjectIsPlacedHeldForASecondThenItIsPurpleAndLetGo) {
  Play play(two_placements());
  play.wait_for_object();
  EXPECT_EQ(play.view.phase, Phase::transport);
  EXPECT_EQ(play.view.cue, Cue::move);
  EXPECT_FALSE(play.view.hand().let_go_asked);
  play.hold(0.2);
  play.run(0.5);
  play.hold();
  play.run(0.9);
  EXPECT_EQ(play.view.phase, Phase::hold);
  EXPECT_NEAR(play.view.hold_fraction, 0.9, 0.02);
  play.run(0.2);
  EXPECT_TRUE(play.view.hand().let_go_asked);
  EXPECT_EQ(play.view.cue, Cue::let_go);
  EXPECT_EQ(play.count(ObjectOrder::release), 1);
  play.run(0.5);
  play.open();
  play.run(0.2);
  EXPECT_EQ(play.count(ObjectOrder::remove), 1);
  EXPECT_EQ(play.view.targets_reached, 1);
  EXPECT_EQ(play.value("placements_completed", "off"), 1.0);
  EXPECT_EQ(play.value("placement_fails", "off"), 0.0);
  EXPECT_EQ(play.value("placement_distance", "off"), 0.0);
  EXPECT_NEAR(play.value("manipulation_time", "off"), 0.5, 2.1 * kStep_s);
  EXPECT_NEAR(play.value("object_release_time", "off"), 0.6, 3.1 * kStep_s);
}

TEST(VirtualPickPlace, TheTriggerIsTheLevelAndLeavingItBeginsTheSecondAnew) {
  constexpr double kInside = 0.99;
  constexpr double kOutside = 1.01;
  for (const auto& [text, tolerance_m] :
       {std::pair{"level = 1\n", 0.03}, {"level = 2\n", 0.02}, {"level = 3\n", 0.01}}) {
    const TaskSpec spec = test::must(
        parse_task("format = \"isograsp-task-1\"\nname = \"P\"\ninstruction = \"P.\"\nkind = "
                   "\"virtual_pick_place\"\nassistance = \"off\"\n" +
                       std::string(text) + "[[placement]]\nobject = \"slim_cuboid\"\ntarget = 1\n",
                   "p.toml"));
    const auto& placing = spec.kind.as<VirtualPickPlaceSpec>();
    EXPECT_WITHIN(placing.position_tolerance_m, tolerance_m, 1e-12);
    Play play(placing);
    play.wait_for_object();
    play.hold(kOutside * tolerance_m);
    play.run(2.0);
    EXPECT_EQ(play.view.phase, Phase::transport) << text;
    play.hold(kInside * tolerance_m);
    play.run(0.5);
    EXPECT_EQ(play.view.phase, Phase::hold);
    play.hold(1.4 * tolerance_m);  // it stays up to one and a half times
    play.run(0.2);
    EXPECT_EQ(play.view.phase, Phase::hold);
    play.hold(1.6 * tolerance_m);
    play.run(0.05);
    EXPECT_EQ(play.view.phase, Phase::transport);
    play.hold();
    play.run(0.9);
    EXPECT_FALSE(play.view.hand().let_go_asked) << "the second began anew";
    play.run(0.2);
    EXPECT_TRUE(play.view.hand().let_go_asked);
  }
}

TEST(VirtualPickPlace, ADropFailsAndTheObjectIsAtItsStartAgain) {
  Play play(two_placements());
  play.wait_for_object();
  play.drop();
  EXPECT_EQ(play.count(ObjectOrder::reset), 1);
  EXPECT_EQ(play.view.hand().fails, 1);
  EXPECT_EQ(play.view.hand().placement, 0) << "the same placement goes on";
}

TEST(VirtualPickPlace, ALossOfTheHandIsNeverADropAndItsTimeIsNotThePersons) {
  Play play(two_placements());
  play.wait_for_object();
  play.hold(0.2);
  play.run(0.5);
  play.open();  // let go, and in this moment the tracker loses the hand
  play.step();
  play.input.seen = false;
  play.run(5.0);
  EXPECT_EQ(play.view.hand().fails, 0);
  play.input.seen = true;
  play.hold(0.2);
  play.step();
  EXPECT_EQ(play.view.hand().fails, 0);
  EXPECT_EQ(play.count(ObjectOrder::reset), 0);
}

TEST(VirtualPickPlace, APlacementThatWasHardlySeenIsNotScoredAndAskedOnceMore) {
  Play play(two_placements());
  play.wait_for_object();
  play.hold(0.2);
  play.input.seen = false;
  play.run(0.5);
  play.input.seen = true;
  play.place();
  play.open();
  play.run(0.3);
  EXPECT_EQ(play.view.targets_reached, 0) << "a tenth of it was lost and more";
  EXPECT_EQ(play.value("placements_not_scored", "off"), 1.0);
  for (int more = 0; more < 2; ++more) {
    play.wait_for_object();
    play.place();
    play.open();
    play.run(0.3);
  }
  EXPECT_EQ(play.view.targets_reached, 2) << "the other one, and this one again";
  EXPECT_EQ(play.value("placements_completed", "off"), 2.0);
  play.run(4.0);
  EXPECT_EQ(play.view.phase, Phase::done);
}

TEST(VirtualPickPlace, SixtySecondsAreALimitThatCensors) {
  Play play(two_placements());
  play.wait_for_object();
  play.run(60.1);
  EXPECT_EQ(play.count(ObjectOrder::remove), 1);
  EXPECT_EQ(play.value("placements_completed", "off"), 0.0);
  EXPECT_TRUE(std::isnan(play.value("manipulation_time", "off")));
  EXPECT_EQ(play.value("manipulation_time_restricted", "off"), 60.0);
}

TEST(VirtualPickPlace, AHandThatDoesNotOpenEndsThePlacementByHelp) {
  Play play(two_placements());
  play.wait_for_object();
  play.place();
  play.run(10.1);
  EXPECT_EQ(play.count(ObjectOrder::let_go), 1);
  EXPECT_TRUE(play.view.hand().helped);
  play.open();
  play.run(1.5);
  EXPECT_EQ(play.count(ObjectOrder::remove), 1);
  EXPECT_EQ(play.view.targets_reached, 1) << "no fail";
  EXPECT_EQ(play.value("placement_fails", "off"), 0.0);
  EXPECT_EQ(play.value("releases_helped", "off"), 1.0);
  EXPECT_TRUE(std::isnan(play.value("object_release_time", "off"))) << "longer than 10 s";
  EXPECT_EQ(play.value("object_release_time_restricted", "off"), 10.0);
}

TEST(VirtualPickPlace, TheTherapistsKeyLetsGoOfWhatWasPlacedAndTheHandHasNotLetGo) {
  Play play(two_placements());
  play.wait_for_object();
  play.place();
  play.run(3.9);
  ASSERT_TRUE(play.view.hand().let_go_asked);
  play.input.let_go = true;
  play.step();
  play.input.let_go = false;
  EXPECT_EQ(play.count(ObjectOrder::let_go), 1);
  EXPECT_TRUE(play.view.hand().helped);
  play.open();  // it falls through the hand
  play.run(1.5);
  EXPECT_EQ(play.count(ObjectOrder::remove), 1);
  EXPECT_EQ(play.view.targets_reached, 1);
  EXPECT_EQ(play.value("placement_fails", "off"), 0.0);
  EXPECT_EQ(play.value("releases_helped", "off"), 1.0);
  EXPECT_TRUE(std::isnan(play.value("object_release_time", "off"))) << "not the hand's doing";
  EXPECT_EQ(play.value("object_release_time_restricted", "off"), 10.0);
}

TEST(VirtualPickPlace, TheTherapistsKeyEndsAPlacementOnItsWayAndThatIsNoDrop) {
  Play play(two_placements());
  play.wait_for_object();
  play.hold(0.2);
  play.run(2.0);
  // Not before the hand is seen again.
  play.input.seen = false;
  play.input.let_go = true;
  play.step();
  EXPECT_EQ(play.count(ObjectOrder::let_go), 0);
  play.input.seen = true;
  play.step();
  play.input.let_go = false;
  EXPECT_EQ(play.count(ObjectOrder::let_go), 1);
  EXPECT_TRUE(play.view.hand().helped);
  EXPECT_FALSE(play.view.hand().let_go_asked) << "nobody asked the hand to open";
  play.open();
  play.run(1.5);
  EXPECT_EQ(play.count(ObjectOrder::remove), 1);
  EXPECT_EQ(play.count(ObjectOrder::reset), 0);
  EXPECT_EQ(play.value("placement_fails", "off"), 0.0);
  EXPECT_EQ(play.value("placements_completed", "off"), 0.0);
  EXPECT_EQ(play.value("releases_helped", "off"), 1.0);
  play.wait_for_object();
  EXPECT_EQ(play.view.hand().placement, 1) << "the next one";
  EXPECT_FALSE(play.view.hand().helped);
}

TEST(VirtualPickPlace, ThreeFailsEaseTheTrainingAndAreMarked) {
  VirtualPickPlaceSpec spec = two_placements();
  spec.assistance = AssistanceLevel::softer;
  spec.eases = true;
  Play play(spec);
  play.wait_for_object();
  for (int k = 0; k < 2; ++k) play.drop();
  play.hold(0.2);
  play.run(0.05);
  play.open();
  while (play.count(ObjectOrder::remove) == 0) play.step();
  EXPECT_EQ(play.view.hand().fails, 3);
  EXPECT_EQ(play.view.hand().assistance, AssistanceLevel::softer)
      << "it changes between placements only";
  play.wait_for_object();
  EXPECT_EQ(play.view.hand().assistance, AssistanceLevel::full);
  EXPECT_TRUE(play.view.hand().eased);
  play.place();
  play.open();
  play.run(0.3);
  EXPECT_EQ(play.value("placements_completed", "full_eased"), 1.0);
  EXPECT_EQ(play.value("placements_completed", "softer"), 0.0)
      << "with another help it shares no measure";

  spec.assistance = AssistanceLevel::full;
  spec.items = {{0, 0}, {1, 3}};
  Play most(spec);
  most.wait_for_object();
  for (int k = 0; k < 3; ++k) most.drop();
  most.wait_for_object();
  const auto& object =
      virtual_hand::study_objects()[static_cast<std::size_t>(most.view.hand().object)];
  EXPECT_EQ(object.name, "slim_cylinder") << "a larger one of the same shape";
}

TEST(VirtualPickPlace, AnAssessmentIsNotEasedHoweverOftenItFails) {
  Play play(two_placements());
  play.wait_for_object();
  for (int k = 0; k < 5; ++k) play.drop();
  EXPECT_EQ(play.view.hand().fails, 5);
  EXPECT_EQ(play.view.hand().placement, 0);
  EXPECT_FALSE(play.view.hand().eased);
}

TEST(VirtualPickPlace, AHandIsAskedForNoMoreThanASessionAllows) {
  TaskContext context;
  context.placements_left = 0;
  EXPECT_FALSE(make_task(test::spec_of(two_placements()), context));
  Play play(two_placements(), 1);
  play.wait_for_object();
  play.place();
  play.open();
  play.run(4.0);
  EXPECT_EQ(play.view.phase, Phase::done);
}

TEST(VirtualPickPlace, TasksThatTireOrLeanToOneSideAreRefused) {
  const auto parsed = [](const std::string& placements) {
    return parse_task(
        "format = \"isograsp-task-1\"\nname = \"P\"\ninstruction = \"P.\"\nkind = "
        "\"virtual_pick_place\"\nassistance = \"off\"\n" +
            placements,
        "p.toml");
  };
  const auto placement = [](int target) {
    return "[[placement]]\nobject = \"slim_cuboid\"\ntarget = " + std::to_string(target) + "\n";
  };
  std::string seven;
  for (int k = 0; k < 7; ++k) seven += placement(1);
  EXPECT_FALSE(parsed(seven));
  EXPECT_FALSE(parsed(placement(1) + placement(2) + placement(4)));
  EXPECT_TRUE(parsed(placement(1) + placement(4)));
  EXPECT_TRUE(parsed(placement(4) + placement(5))) << "all on the side that is seen";
  EXPECT_FALSE(parsed(""));
}

TEST(VirtualPickPlace, AStepTakesNoMemory) {
  Play play(two_placements());
  play.wait_for_object();
  auto task = test::must(make_task(test::spec_of(two_placements()), {}));
  HandInput input;
  input.seen = true;
  input.X_WO = Pose{};
  const auto before = test::allocations();
  for (int k = 0; k < 20000; ++k) {
    input.frames = k;
    input.lost = k / 2;  // each is asked again
    static_cast<void>(task->step(input));
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::tasks::virtual_pick_place_test
