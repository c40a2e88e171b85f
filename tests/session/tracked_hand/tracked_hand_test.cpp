// SPDX-License-Identifier: GPL-3.0-or-later
// A session with a tracked hand: the entry test, what a lost hand does, what is kept, whose hand it
// is, and that live, stored and later scores are the same numbers.
#include "session/tracked_hand/tracked_hand.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "hand/hand_columns.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/library/hand_rules.hpp"
#include "session/library/library.hpp"
#include "session/session.hpp"
#include "session/tracked_hand/hand_size.hpp"
#include "tasks/kinds/hand/virtual_pick_place.hpp"
#include "tasks/score.hpp"
#include "tests/session/tracked_hand/scripted_hands.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::tracked_hand_test {
namespace {

using test::must;
using test::ScriptedUser;

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

tasks::TaskSpec library_task(const std::string& name) {
  return must(load_task(kLibrary + "/tasks/" + name));
}

/// A session's clockwork before a simulated tracker, in virtual time.
class HandBench {
 public:
  explicit HandBench(Hand side = Hand::right, bool size_of_other = false,
                     const std::string& uri = "sim://hand?user=scripted") {
    auto user = std::make_unique<ScriptedUser>(side);
    user_ = user.get();
    auto device = must(open_hand_device(must(Uri::parse(uri)), side, user_));
    hand_ = std::make_unique<TrackedHand>(
        std::move(device), HandSetup{side, test::usual_hand(), size_of_other}, std::move(user));
  }
  void start() {
    must(hand_->start(clock_));
    acquisition_.emplace(*hand_, clock_);
  }
  Apparatus& apparatus() { return *hand_; }
  const HandSnapshot& now() { return hand_->snapshots().read(); }
  void run(double duration_s) {
    for (int k = 0; k < std::lround(duration_s / TrackedHand::kPeriod_s); ++k) {
      ASSERT_TRUE(acquisition_->tick());
      record();
    }
  }
  PreparationOutcome enter() {
    preparations_.push_back(must(apparatus().make_preparation({})));
    EXPECT_TRUE(acquisition_->commands().push(
        {.kind = Command::Kind::prepare, .preparation = preparations_.back().get()}));
    do run(0.01);
    while (now().stage == Stage::zeroing);
    return preparations_.back()->outcome();
  }
  void begin(const tasks::TaskSpec& spec) {
    trials_.push_back(must(apparatus().make_trial(spec, {})));
    EXPECT_TRUE(acquisition_->commands().push(
        {.kind = Command::Kind::begin, .setup = trials_.back().get()}));
  }
  void run_to_end() {
    do run(0.01);
    while (now().trial_number != 0 || now().stage == Stage::trial || now().stage == Stage::paused);
  }
  /// What the recorder got since the last call.
  struct Told {
    std::vector<std::string> events;
    std::vector<std::vector<double>> rows;
    bool completed = false;
  };
  void record() {
    while (acquisition_->records().pop(item_)) {
      if (item_.kind == RecordItem::Kind::event) told_.events.emplace_back(item_.event_kind);
      if (item_.kind == RecordItem::Kind::sample)
        told_.rows.emplace_back(item_.row.values().begin(), item_.row.values().end());
      if (item_.kind == RecordItem::Kind::end)
        told_.completed = item_.status == storage::TrialStatus::completed;
    }
  }
  Told told() { return std::exchange(told_, {}); }
  Signals signals(const Told& told) {
    std::vector<std::string> names;
    for (const auto& group : trials_.back()->columns())
      names.insert(names.end(), group.columns.begin(), group.columns.end());
    Signals signals(names);
    for (const auto& row : told.rows) signals.append_row(row);
    return signals;
  }
  bool records(const std::string& group) {
    for (const auto& one : trials_.back()->columns())
      if (one.name == group) return true;
    return false;
  }

  ManualClock clock_;
  ScriptedUser* user_ = nullptr;
  std::unique_ptr<TrackedHand> hand_;
  std::optional<Acquisition> acquisition_;
  std::vector<std::unique_ptr<Preparation>> preparations_;
  std::vector<std::unique_ptr<TrialSetup>> trials_;

 private:
  RecordItem item_;
  Told told_;
};

const Measure& measure(const std::vector<Measure>& all, std::string_view name,
                       std::string_view channel = "") {
  for (const Measure& one : all)
    if (one.name == name && (channel.empty() || one.channel == channel)) return one;
  throw std::runtime_error("no measure " + std::string(name));
}

TEST(TrackedHand, AHandThatOpensPassesItsEntryTestAndIsMeasured) {
  for (const Hand side : {Hand::right, Hand::left}) {
    HandBench bench(side);
    bench.start();
    const PreparationOutcome outcome = bench.enter();
    ASSERT_TRUE(outcome.accepted) << english(outcome.reason);
    EXPECT_EQ(outcome.record.kind, kHandEntry);
    EXPECT_EQ(outcome.record.columns.size(), outcome.record.mean.size());
    EXPECT_GE(outcome.record.references.at("opening_m"), HandEntry::kLeastOpening_m);
    EXPECT_WITHIN(outcome.record.references.at("widest_object_m"),
                  0.7 * outcome.record.references.at("opening_m"), 1e-12);
    // The size of a hand that shows its joints without an error is its own.
    const auto measured = must(hand_of_size(outcome.record, test::usual_hand(), side));
    constexpr double kOfPictures_m = 1e-6;
    const virtual_hand::HandModel usual = test::usual_hand();
    const auto& middle = usual.digit(Digit::middle);
    EXPECT_WITHIN(
        measured.length_m,
        middle.base_m.norm() + middle.lengths_m[0] + middle.lengths_m[1] + middle.lengths_m[2],
        kOfPictures_m);
    for (std::size_t d = 0; d < kDigitCount; ++d)
      for (std::size_t k = 0; k < virtual_hand::kLinkCount; ++k)
        EXPECT_WITHIN(measured.digits[d].lengths_m[k], test::usual_hand().digits[d].lengths_m[k],
                      kOfPictures_m);
    EXPECT_GT(bench.now().opening_m, 0.0);
  }
}

TEST(TrackedHand, AHandThatDoesNotOpenIsBarredAndTheTasksForItAreNamed) {
  HandBench bench;
  bench.user_->opens = 0.05;
  bench.start();
  const PreparationOutcome outcome = bench.enter();
  EXPECT_FALSE(outcome.accepted);
  EXPECT_NE(english(outcome.reason).find("Opening force"), std::string::npos);
  const auto refused = bench.apparatus().make_trial(library_task("virtual_place.toml"), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Error::Code::bad_input) << "the task is left out, no fault";
  EXPECT_NE(english(refused.error().remedy).find("Opening force"), std::string::npos);
  EXPECT_TRUE(bench.apparatus().make_trial(library_task("hand_opening.toml"), {}))
      << "how far it opens is measured all the same";
}

TEST(TrackedHand, AHandThatIsLostAtRestIsBarred) {
  HandBench bench;
  bench.user_->hidden = [](double t_s) { return std::fmod(t_s, 1.0) < 0.15; };
  bench.start();
  const PreparationOutcome outcome = bench.enter();
  EXPECT_FALSE(outcome.accepted);
  EXPECT_NE(english(outcome.reason).find("loses this hand"), std::string::npos);
}

TEST(TrackedHand, WithoutAnEntryTestThereAreNoObjects) {
  HandBench bench;
  bench.start();
  bench.run(0.5);
  const auto refused = bench.apparatus().make_trial(library_task("virtual_place.toml"), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "hand_entry");
}

TEST(TrackedHand, NoObjectIsWiderThanSevenTenthsOfTheOpening) {
  HandBench bench;
  bench.user_->opens = 0.6;
  bench.start();
  const PreparationOutcome outcome = bench.enter();
  ASSERT_TRUE(outcome.accepted) << english(outcome.reason);
  const double widest_m = outcome.record.references.at("widest_object_m");
  ASSERT_LT(widest_m, 0.08) << "this test wants a hand that is too small for a flat object";
  ASSERT_GT(widest_m, 0.02);
  tasks::TaskSpec spec = library_task("virtual_place.toml");
  EXPECT_TRUE(bench.apparatus().make_trial(spec, {}));
  auto& placing = spec.kind.as<tasks::VirtualPickPlaceSpec>();
  placing.items.front().object = 2;  // flat_cuboid
  const auto refused = bench.apparatus().make_trial(spec, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "object");
}

TEST(TrackedHand, AMomentWithoutTheHandIsHeldALongerOneWaitsAndGoesOnByItself) {
  HandBench bench;
  double begun_s = 0.0;
  bench.user_->hidden = [&begun_s](double t_s) {
    const double since_s = t_s - begun_s;
    return (since_s > 4.0 && since_s < 4.15) || (since_s > 6.0 && since_s < 7.0);
  };
  bench.start();
  bench.run(1.0);
  begun_s = bench.now().session_time_s;
  bench.begin(library_task("hand_opening.toml"));
  bench.run_to_end();
  const auto told = bench.told();
  EXPECT_TRUE(told.completed);
  EXPECT_EQ(told.events, (std::vector<std::string>{"occluded", "resume"})) << "no fault, no drop";
  const Signals signals = bench.signals(told);
  const auto flags = signals.column(columns::sample_flags);
  const auto phase = signals.column(columns::phase);
  const auto gap_m = signals.column(columns::thumb_index_gap_m);
  int held = 0, missing = 0;
  for (std::size_t row = 1; row < signals.rows(); ++row) {
    if (flags[row] == 1.0) ++held;
    if (flags[row] == 2.0) ++missing;
    if (flags[row] != 0.0) {
      EXPECT_EQ(gap_m[row], gap_m[row - 1]) << "it stands still";
    }
    if (flags[row] == 2.0) {
      EXPECT_EQ(phase[row], static_cast<double>(tasks::Phase::paused));
    }
  }
  EXPECT_NEAR(held, 35, 4) << "0.15 s, and the first 0.2 s of the longer one";
  EXPECT_NEAR(missing, 80, 4);
  const auto measures = tasks::score(bench.trials_.back()->spec, signals);
  EXPECT_GE(measure(measures, "largest_gap").excluded, held + missing);
}

TEST(TrackedHand, RowsOfTheOtherHandAreNotUsedButCountedAndToldAndTheTrialWaits) {
  HandBench bench;
  bench.user_->flipped = [](double t_s) { return t_s > 4.0 && t_s < 5.0; };
  bench.start();
  bench.run(1.0);
  bench.begin(library_task("hand_opening.toml"));
  bench.run(3.9);
  EXPECT_EQ(bench.now().health.fault, HandFault::other_hand);
  EXPECT_EQ(bench.now().stage, Stage::paused);
  EXPECT_EQ(bench.now().pause_cause, PauseCause::occluded);
  EXPECT_GT(bench.now().health.counters.other_side, 50u);
  const auto counted = bench.now().health.counters;
  bench.run(1.0);
  EXPECT_EQ(bench.now().stage, Stage::trial) << "it goes on by itself";
  EXPECT_GE(bench.now().health.counters.other_side, counted.other_side) << "counters only grow";
  const auto told = bench.told();
  EXPECT_NE(std::find(told.events.begin(), told.events.end(), kFaultEvent), told.events.end());
}

/// A live tracker that a test plays.
std::unique_ptr<TrackedHand> live_hand(std::vector<test::ScriptedHands::Row> rows,
                                       Hand side = Hand::right) {
  return std::make_unique<TrackedHand>(
      std::make_unique<test::ScriptedHands>(std::move(rows), TrackedHand::kPeriod_s),
      HandSetup{side, test::usual_hand(), false});
}

TEST(TrackedHand, ACameraIsOnFromTheStartOfALiveTrackerToItsEndAndOfNoOther) {
  std::vector<test::ScriptedHands::Row> rows;
  for (int k = 0; k < 100; ++k) rows.push_back({0.01 * k, test::hand_at(0.1 + 1e-5 * k)});
  auto live = live_hand(rows);
  Apparatus& apparatus = *live;
  EXPECT_TRUE(apparatus.info().watches_person);
  EXPECT_FALSE(live->snapshots().read().camera_on);
  ManualClock clock;
  must(apparatus.start(clock));
  Acquisition acquisition(apparatus, clock);
  ASSERT_TRUE(acquisition.tick());
  EXPECT_TRUE(live->snapshots().read().camera_on);
  apparatus.stop();
  EXPECT_FALSE(live->snapshots().read().camera_on);

  HandBench simulated;
  simulated.start();
  simulated.run(0.1);
  EXPECT_FALSE(simulated.now().camera_on);
  EXPECT_FALSE(simulated.apparatus().info().watches_person);
}

TEST(TrackedHand, JointsAreRecordedOnlyWhereTheyMayBeKept) {
  for (const bool may : {false, true}) {
    HandBench bench;
    must(bench.hand_->know_person(std::nullopt, may));
    bench.start();
    bench.run(0.5);
    bench.begin(library_task("hand_opening.toml"));
    bench.run(0.5);
    EXPECT_TRUE(bench.records("hand")) << "angles are";
    EXPECT_EQ(bench.records("joints"), may);
  }
}

TEST(TrackedHand, AHandThatCannotOpenHasTheSizeOfTheOtherOneMirrored) {
  HandBench other(Hand::left);
  other.start();
  const auto stored = other.enter();
  ASSERT_TRUE(stored.accepted);

  HandBench bench(Hand::right, true);
  EXPECT_FALSE(bench.apparatus().make_preparation({})) << "the other hand was not measured";
  must(bench.hand_->know_person(stored.record, false));
  bench.start();
  const auto outcome = bench.enter();
  ASSERT_TRUE(outcome.accepted);
  EXPECT_EQ(outcome.record.mean, stored.record.mean);
  EXPECT_EQ(outcome.record.references.at("size_of_other_hand"), 1.0) << "it is said";
}

TEST(TrackedHand, FromFrameToPublishedStateNothingIsAllocated) {
  HandBench bench;
  bench.start();
  ASSERT_TRUE(bench.enter().accepted);
  for (const char* task : {"hand_opening.toml", "virtual_place_training.toml"}) {
    bench.begin(library_task(task));
    bench.run(0.1);
    const auto before = test::allocations();
    for (int k = 0; k < 1500; ++k) ASSERT_TRUE(bench.acquisition_->tick());
    EXPECT_EQ(test::allocations(), before) << task;
    EXPECT_TRUE(bench.acquisition_->commands().push({.kind = Command::Kind::abort}));
    bench.run(0.1);
    bench.told();
  }
}

TEST(TrackedHand, TheTherapistLetsTheObjectGoAndItsPlacementEnds) {
  HandBench bench;
  bench.start();
  ASSERT_TRUE(bench.enter().accepted);
  const auto ask = [&] {
    EXPECT_TRUE(bench.acquisition_->commands().push({.kind = Command::Kind::let_go}));
  };
  bench.begin(library_task("virtual_place_first.toml"));
  ask();  // before there is anything to let go
  while (!bench.now().grasp.object_there) bench.run(0.01);
  EXPECT_TRUE(bench.told().events.empty());
  bench.run(1.0);
  ask();
  ask();  // twice is once
  const auto before = test::allocations();
  ASSERT_TRUE(bench.acquisition_->tick());
  EXPECT_EQ(test::allocations(), before);
  EXPECT_TRUE(bench.now().grasp.helped);
  bench.run(1.1);
  EXPECT_FALSE(bench.now().grasp.object_there) << "the placement has ended";
  EXPECT_EQ(bench.told().events, std::vector<std::string>{kLetGoEvent});
  while (!bench.now().grasp.object_there) bench.run(0.01);
  EXPECT_FALSE(bench.now().grasp.helped) << "the next one is the hand's own";
}

TEST(TrackedHand, EveryColumnOfATrialHasItsMeaning) {
  HandBench bench;
  must(bench.hand_->know_person(std::nullopt, true));
  bench.start();
  ASSERT_TRUE(bench.enter().accepted);
  bench.begin(library_task("virtual_place_training.toml"));
  bench.run(0.1);
  std::size_t count = 0;
  for (const auto& group : bench.trials_.back()->columns())
    for (const std::string& name : group.columns) {
      EXPECT_NE(columns::find(name), nullptr) << name;
      ++count;
    }
  EXPECT_LE(count, TrialRow::kMostColumns);
  EXPECT_GT(count, 200u) << "joints and all";
}

TEST(TrackedHand, TheSizeAndTheConditionsOfATrackerAreText) {
  HandDeviceInfo device;
  device.uri = "leap://127.0.0.1?delay_ms=12";
  device.mounting = "desk";
  device.service = "6.1";
  EXPECT_NE(tracker_text(device).find("not measured"), std::string::npos);
  device.delay_s = 0.012;
  EXPECT_NE(tracker_text(device).find("delay = 12"), std::string::npos);
  EXPECT_NE(tracker_text(device).find("service = \"6.1\""), std::string::npos);
}

TEST(HandRules, HelpIsTrainingAndBoutsHaveRestsBetweenThem) {
  const auto protocol = [](const std::string& steps) {
    return read_protocol("format = \"isograsp-protocol-1\"\nname = \"P\"\n" + steps,
                         kLibrary + "/protocols/p.toml", kLibrary);
  };
  const std::string entry = "[[step]]\nkind = \"hand_entry\"\n";
  const auto placing = [](const std::string& task, const std::string& more) {
    return "[[step]]\nkind = \"task\"\ntask = \"" + task + "\"\n" + more;
  };
  const std::string rest = "rest_s = 60\n";
  EXPECT_TRUE(protocol(entry + placing("virtual_place.toml", rest)));
  EXPECT_FALSE(protocol(placing("virtual_place.toml", rest))) << "no entry test";
  EXPECT_FALSE(protocol(entry + placing("virtual_place_training.toml", rest))) << "with help";
  EXPECT_TRUE(protocol(entry + placing("virtual_place_training.toml", rest + "adaptive = true\n")));
  EXPECT_FALSE(protocol(entry + placing("virtual_place.toml", "rest_s = 30\nrepetitions = 2\n")));
  EXPECT_FALSE(protocol(entry + placing("virtual_place.toml", "rest_s = 30\n") +
                        placing("virtual_place.toml", "")));
  EXPECT_TRUE(protocol(entry + placing("virtual_place.toml", "rest_s = 60\nrepetitions = 4\n")));
  EXPECT_FALSE(protocol(entry + placing("virtual_place.toml", "rest_s = 60\nrepetitions = 5\n")))
      << "30 placements";
}

}  // namespace
}  // namespace isograsp::session::tracked_hand_test
