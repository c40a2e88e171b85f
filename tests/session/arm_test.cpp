// SPDX-License-Identifier: GPL-3.0-or-later
// A session with an arm seen by markers: what is seen, what stands in, what freezes, what is a
// fault, and that live, stored and later scores are the same numbers.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "core/signals.hpp"
#include "device/markers/marker_reader.hpp"
#include "hand/arm_columns.hpp"
#include "kinematics/pose_task.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/arm/marker_arm.hpp"
#include "session/library/arm_rules.hpp"
#include "session/session.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "virtual_patient/arm/virtual_arm.hpp"

namespace isograsp::session::arm_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";
constexpr double kPeriod_s = 0.01;
constexpr Timestamp kPeriod = std::chrono::milliseconds(10);

/// Cameras that show an arm at rest, and what a test does with each picture.
class ScriptedCameras final : public MarkerDevice {
 public:
  /// Changes the markers of picture `number`; false: the picture is lost.
  using Script = std::function<bool(std::int64_t number, std::span<Vec3> p_W)>;

  explicit ScriptedCameras(Hand hand = Hand::right) {
    virtual_patient::ArmTraits traits = *virtual_patient::arm_traits("healthy");
    traits.loss_per_s = 0.0;
    traits.view_rad = std::numbers::pi;
    virtual_patient::VirtualArm arm(traits, 5, hand);
    info_.description = "Scripted cameras"_text;
    info_.simulated = true;
    info_.period_s = kPeriod_s;
    for (const std::string& label : arm.labels()) info_.labels.push_back(label);
    still_.resize(info_.labels.size());
    arm.markers(0.0, still_);
    p_W_ = still_;
  }
  [[nodiscard]] std::size_t label(std::string_view name) const {
    for (std::size_t i = 0; i < info_.labels.size(); ++i)
      if (info_.labels[i] == name) return i;
    throw std::runtime_error("no such marker");
  }

  [[nodiscard]] const MarkerDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] MarkerHealth health() const noexcept override { return given; }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    return {};
  }
  [[nodiscard]] ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept override {
    for (;;) {
      const Timestamp stamp = start_ + next_ * kPeriod;
      if (stamp > deadline) {
        clock_->wait_until(deadline);
        return ReadStatus::timeout;
      }
      clock_->wait_until(stamp);
      const std::int64_t number = next_++;
      // A marker whose numbers do not change would be one that cameras have lost.
      constexpr double kNoise_m = 1e-7;
      for (std::size_t i = 0; i < still_.size(); ++i)
        p_W_[i] = still_[i] + Vec3::Constant(kNoise_m * static_cast<double>(number % 7));
      if (script && !script(number, p_W_)) continue;
      constexpr std::int64_t kFirst = 1000;
      out = {stamp, kFirst + number, p_W_};
      return ReadStatus::sample;
    }
  }
  void stop() noexcept override {}

  Script script;
  MarkerHealth given;

 private:
  MarkerDeviceInfo info_;
  std::vector<Vec3> still_;
  std::vector<Vec3> p_W_;
  Clock* clock_ = nullptr;
  Timestamp start_{0};
  std::int64_t next_ = 0;
};

/// Two references: the start posture itself, and one with the forearm turned by 30 degrees.
tasks::TaskSpec task(const std::string& folder = "") {
  return test::must(tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Turn\"\ninstruction = \"Turn it.\"\n"
      "kind = \"pose_matching\"\npostures = \"turned_forearm\"\nsequence = [\"start\", "
      "\"pronation\"]\nhold_s = 0.3\ndisplay_s = 0.5\ntime_limit_s = 2\n",
      folder + "turn.toml"));
}

/// A session's clockwork before scripted cameras, in virtual time.
struct Bench {
  explicit Bench(Hand hand = Hand::right) {
    auto cameras = std::make_unique<ScriptedCameras>(hand);
    cameras_ = cameras.get();
    arm_ = std::make_unique<MarkerArm>(
        std::move(cameras), test::must(ArmRig::load("kurillo15_trunk", kLibrary, hand, "test://")),
        kLibrary);
    EXPECT_TRUE(arm_->start(clock_));
    acquisition_.emplace(apparatus(), clock_);
  }
  Apparatus& apparatus() { return *arm_; }
  const ArmSnapshot& now() { return arm_->snapshots().read(); }
  void tick(int frames = 1) {
    for (int k = 0; k < frames; ++k) ASSERT_TRUE(acquisition_->tick());
  }
  void hide_object(std::span<Vec3> p_W) {
    for (const char* name : {"O1", "O2", "O3", "O4", "O5", "O6"})
      p_W[cameras_->label(name)] = unseen_marker();
  }
  /// As it falls, or is put down.
  void take_object_away(std::span<Vec3> p_W, double by_m) {
    for (const char* name : {"O1", "O2", "O3", "O4", "O5", "O6"})
      p_W[cameras_->label(name)].x() += by_m;
  }
  PreparationOutcome take_start_posture(int frames = 110) {
    preparation_ = test::must(apparatus().make_preparation({}));
    EXPECT_TRUE(acquisition_->commands().push(
        {.kind = Command::Kind::prepare, .preparation = preparation_.get()}));
    tick(frames);
    auto outcome = preparation_->outcome();
    if (outcome.accepted) write_postures(outcome.record.mean);
    return outcome;
  }
  /// A library whose reference subject is this arm.
  void write_postures(const std::vector<double>& mean) {
    Postures postures;
    postures.chain = {"elbow", "forearm", "dorsum", "object"};
    postures.postures = {{"start", {}}, {"pronation", {}}};
    for (std::size_t link = 1; link <= 3; ++link) {
      const double* x = mean.data() + 7 * link;
      postures.postures[0].X_L.push_back({{x[0], x[1], x[2]}, Quat(x[3], x[4], x[5], x[6])});
    }
    postures.postures[1] = {"pronation", postures.postures[0].X_L};
    Quat& forearm = postures.postures[1].X_L[0].q;
    forearm = forearm * Quat(Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3::UnitY()));
    EXPECT_TRUE(write_text(folder_.path("turned_forearm.toml"), postures_text(postures)));
  }
  void begin() { begin(task(folder_.path(""))); }
  void begin(const tasks::TaskSpec& spec) {
    trial_ = test::must(apparatus().make_trial(spec, {.period_s = kPeriod_s,
                                                      .seed = 1,
                                                      .references = {},
                                                      .ranges = {},
                                                      .screening = {},
                                                      .arm = {}}));
    EXPECT_TRUE(
        acquisition_->commands().push({.kind = Command::Kind::begin, .setup = trial_.get()}));
  }
  /// What the recorder would get since the last call.
  struct Told {
    std::vector<std::string> events;
    std::vector<std::vector<double>> rows;
    bool completed = false;
  };
  Told told() {
    Told all;
    RecordItem item;
    while (acquisition_->records().pop(item)) {
      if (item.kind == RecordItem::Kind::event) all.events.emplace_back(item.event_kind);
      if (item.kind == RecordItem::Kind::sample)
        all.rows.emplace_back(item.row.values().begin(), item.row.values().end());
      if (item.kind == RecordItem::Kind::end)
        all.completed = item.status == storage::TrialStatus::completed;
    }
    return all;
  }
  Signals signals(const Told& told) {
    std::vector<std::string> names;
    for (const auto& group : trial_->columns())
      names.insert(names.end(), group.columns.begin(), group.columns.end());
    Signals signals(names);
    for (const auto& row : told.rows) signals.append_row(row);
    return signals;
  }

  test::TemporaryFolder folder_;
  ManualClock clock_;
  ScriptedCameras* cameras_ = nullptr;
  std::unique_ptr<MarkerArm> arm_;
  std::optional<Acquisition> acquisition_;
  std::unique_ptr<Preparation> preparation_;
  std::unique_ptr<TrialSetup> trial_;
};

class Arm : public ::testing::Test, protected Bench {};

const Measure& measure(const std::vector<Measure>& all, std::string_view name,
                       std::string_view channel = "") {
  for (const Measure& one : all)
    if (one.name == name && (channel.empty() || one.channel == channel)) return one;
  throw std::runtime_error("no measure " + std::string(name));
}

TEST_F(Arm, WithoutAStartPostureNoReferenceIsKnownAndNoTrialBegins) {
  const auto refused = apparatus().make_trial(task(), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "start_posture");
}

TEST_F(Arm, AnArmThatMovesHasNoStartPosture) {
  cameras_->script = [](std::int64_t number, std::span<Vec3> p_W) {
    for (Vec3& p : p_W) p.x() += 0.0005 * static_cast<double>(number % 50);
    return true;
  };
  EXPECT_FALSE(take_start_posture().accepted);
  cameras_->script = [this](std::int64_t number, std::span<Vec3> p_W) {
    p_W[cameras_->label("W")].z() += 0.0005 * static_cast<double>(number % 50);
    return true;
  };
  EXPECT_FALSE(take_start_posture().accepted);
}

TEST_F(Arm, AStartPostureThatIsNotSeenIsRefusedAfterAWait) {
  cameras_->script = [this](std::int64_t, std::span<Vec3> p_W) {
    hide_object(p_W);
    return true;
  };
  EXPECT_FALSE(take_start_posture(1100).accepted);
  EXPECT_EQ(now().stage, Stage::idle);
}

TEST_F(Arm, TheStoredStartPostureIsAColumnForEachNumberWithItsUnit) {
  const auto outcome = take_start_posture();
  ASSERT_TRUE(outcome.accepted) << english(outcome.reason);
  EXPECT_EQ(outcome.record.kind, kStartPosture);
  EXPECT_EQ(outcome.record.columns.size(), 4u * 7u);
  EXPECT_EQ(outcome.record.mean.size(), outcome.record.columns.size());
  EXPECT_EQ(outcome.record.columns.front(), "elbow_x_m");
  EXPECT_EQ(outcome.record.columns[7], "forearm_in_elbow_x_m");
}

TEST_F(Arm, AMomentOutOfSightIsHeldALongerOneFreezesAndGoesOnByItself) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  tick(10);
  (void)told();
  std::int64_t hidden_until = 0;
  std::int64_t seen = 0;
  cameras_->script = [&](std::int64_t number, std::span<Vec3> p_W) {
    seen = number;
    if (number < hidden_until) hide_object(p_W);
    return true;
  };
  tick();
  hidden_until = seen + 1 + 5;
  tick(5);
  EXPECT_EQ(now().stage, Stage::trial) << "50 ms are held";
  tick(2);
  EXPECT_EQ(told().events, std::vector<std::string>{});
  hidden_until = seen + 1 + 30;
  tick(30);
  EXPECT_EQ(now().stage, Stage::paused);
  EXPECT_EQ(now().pause_cause, PauseCause::occluded);
  tick(2);
  EXPECT_EQ(now().stage, Stage::trial);
  EXPECT_EQ(told().events, (std::vector<std::string>{"occluded", "resume"}));
}

TEST_F(Arm, WhoDrinksIsNotStoppedWhileTheObjectIsOutOfSightAndNeedsNoStartPosture) {
  const auto drink = [](const std::string& hand) {
    return test::must(tasks::parse_task(
        "format = \"isograsp-task-1\"\nname = \"Drink\"\ninstruction = \"Drink.\"\nkind = "
        "\"drinking\"\nhand_marker = \"" +
            hand + "\"\nglass_marker = \"O1\"\nface_marker = \"T1\"\nlead_in_s = 0.1\n",
        "drink.toml"));
  };
  begin(drink("D1"));
  cameras_->script = [&](std::int64_t number, std::span<Vec3> p_W) {
    if (number % 100 > 30) hide_object(p_W);
    return true;
  };
  for (int k = 0; k < 200; ++k) {
    tick();
    EXPECT_EQ(now().stage, Stage::trial) << k;
  }
  const Told all = told();
  EXPECT_EQ(all.events, std::vector<std::string>{});
  const auto refused = apparatus().make_trial(drink("D9"), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().file, "drink.toml");
}

TEST_F(Arm, TheScreenSaysHowTheObjectIsSeenAndWhereItWasLast) {
  EXPECT_FALSE(now().start_p_WO.allFinite());
  ASSERT_TRUE(take_start_posture().accepted);
  constexpr double kStill_m = 1e-5;  // the noise of the cameras
  EXPECT_WITHIN((now().start_p_WO - now().segment(ArmSegment::object).X_W.p).norm(), 0.0, kStill_m);
  begin();
  tick(10);
  EXPECT_EQ(screen_of(now()).sight, ObjectSight::seen);
  const Pose last = screen_of(now()).X_WO;
  cameras_->script = [&](std::int64_t, std::span<Vec3> p_W) {
    hide_object(p_W);
    return true;
  };
  tick(5);
  EXPECT_EQ(screen_of(now()).sight, ObjectSight::held);
  EXPECT_FALSE(screen_of(now()).object_shown) << "a person in software sees nothing new";
  tick(5);
  EXPECT_EQ(screen_of(now()).sight, ObjectSight::unseen);
  EXPECT_EQ(screen_of(now()).X_WO.p, last.p);
}

TEST_F(Arm, TheRangeOfAnAngleGrowsWhileItCountsStaysOutOfSightAndEndsWithItsTrial) {
  begin(test::must(tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Range\"\ninstruction = \"Turn.\"\nkind = "
      "\"active_range\"\nlink = \"forearm\"\nangle = 3\nlead_in_s = 0.2\nduration_s = 1\n",
      "range.toml")));
  tick(10);
  EXPECT_TRUE(screen_of(now()).angle.shown && screen_of(now()).angle.seen);
  EXPECT_FALSE(screen_of(now()).angle.ranged) << "the lead-in does not count";
  tick(30);
  const ShownAngle ranged = screen_of(now()).angle;
  EXPECT_TRUE(ranged.ranged);
  EXPECT_LT(ranged.least_rad, ranged.largest_rad) << "by the noise of the cameras";
  EXPECT_LE(ranged.least_rad, ranged.now_rad);
  EXPECT_GE(ranged.largest_rad, ranged.now_rad);
  cameras_->script = [&](std::int64_t, std::span<Vec3> p_W) {
    for (const char* name : {"F1", "F2"}) p_W[cameras_->label(name)] = unseen_marker();
    return true;
  };
  tick(5);
  EXPECT_FALSE(screen_of(now()).angle.seen);
  EXPECT_EQ(screen_of(now()).angle.largest_rad, ranged.largest_rad);
  tick(120);
  EXPECT_EQ(now().stage, Stage::idle);
  EXPECT_FALSE(now().angle.shown);
}

TEST_F(Arm, SilenceIsAFaultAndWaitsForTheTherapist) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  tick(10);
  (void)told();
  bool silent = true;
  cameras_->script = [&](std::int64_t, std::span<Vec3>) { return !silent; };
  tick(5);
  EXPECT_EQ(now().stage, Stage::trial);
  tick(5);
  EXPECT_EQ(now().stage, Stage::paused);
  EXPECT_EQ(now().pause_cause, PauseCause::missing_samples);
  silent = false;
  tick(20);
  EXPECT_EQ(now().stage, Stage::paused) << "the therapist resumes";
  acquisition_->commands().push({.kind = Command::Kind::resume});
  tick(2);
  EXPECT_EQ(now().stage, Stage::trial);
  EXPECT_EQ(told().events, (std::vector<std::string>{"fault", "resume"}));
}

/// Beyond the 80 mm wherever the hand is.
constexpr double kOnTheFloor_m = 0.5;

TEST_F(Arm, AnObjectThatLeavesTheHandIsLostAndNoTimePassesUntilItIsBack) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  tick(10);
  (void)told();
  bool away = true;
  bool hidden = false;
  cameras_->script = [&](std::int64_t, std::span<Vec3> p_W) {
    if (away) take_object_away(p_W, kOnTheFloor_m);
    if (hidden) hide_object(p_W);
    return true;
  };
  tick(19);
  EXPECT_EQ(now().stage, Stage::trial) << "a moment may be a marker that is wrong";
  tick(1);
  EXPECT_EQ(now().stage, Stage::paused);
  EXPECT_EQ(now().pause_cause, PauseCause::object_lost);
  EXPECT_FALSE(is_fault(now().pause_cause));
  const double stopped_s = now().task.task_time_s;
  const int target = now().task.target_index;
  tick(300);  // longer than the time limit of a target
  hidden = true;
  tick(30);
  EXPECT_EQ(now().pause_cause, PauseCause::object_lost) << "unseen it is not back";
  hidden = false;
  away = false;
  tick(1);
  EXPECT_EQ(now().stage, Stage::trial);
  EXPECT_EQ(now().task.target_index, target) << "no time-out";
  EXPECT_NEAR(now().task.task_time_s, stopped_s, kLongestStandIn_s + 2 * kPeriod_s);
  const Told all = told();
  EXPECT_EQ(all.events, (std::vector<std::string>{"object_lost", "resume"}));
}

TEST_F(Arm, AnObjectThatWasNotYetInTheHandOrIsNearIsNotLost) {
  ASSERT_TRUE(take_start_posture().accepted);
  double by_m = kOnTheFloor_m;
  cameras_->script = [&](std::int64_t, std::span<Vec3> p_W) {
    take_object_away(p_W, by_m);
    return true;
  };
  begin();
  tick(60);
  EXPECT_EQ(now().stage, Stage::trial) << "it lies on the table";
  by_m = 0.0;
  tick(5);
  by_m = 0.04;
  tick(60);
  EXPECT_EQ(now().stage, Stage::trial) << "fingers move it so far";
}

TEST_F(Arm, TheScoreIsThatOfTheTaskThoughTheObjectWasLost) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  cameras_->script = [&](std::int64_t number, std::span<Vec3> p_W) {
    if (number % 150 > 60) take_object_away(p_W, kOnTheFloor_m);
    return true;
  };
  int live_reached = 0;
  while (now().stage != Stage::idle || now().frames < 130) {
    tick();
    live_reached = std::max(live_reached, now().task.targets_reached);
    ASSERT_LT(now().frames, 4000) << "the task does not end";
  }
  const Told all = told();
  EXPECT_GT(std::count(all.events.begin(), all.events.end(), "object_lost"), 1);
  const auto measures = tasks::score(task(), signals(all));
  EXPECT_EQ(measure(measures, "targets_reached").value, static_cast<double>(live_reached));
  EXPECT_FALSE(measure(measures, "completion_time", "target_2").value);
}

TEST(Assessment, OfAnArmHoldsEachReferenceForThreeTenthsOfASecond) {
  const auto with_hold = [](const std::string& hold_s) {
    return test::must(tasks::parse_task(
        "format = \"isograsp-task-1\"\nname = \"Turn\"\ninstruction = \"Turn it.\"\n"
        "kind = \"pose_matching\"\npostures = \"screw\"\nsequence = [\"screw\"]\nhold_s = " +
            hold_s + "\n",
        "turn.toml"));
  };
  EXPECT_TRUE(check_assessment(with_hold("0.3")));
  const auto refused = check_assessment(with_hold("0.29"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "hold_s");
  EXPECT_EQ(refused.error().file, "turn.toml");
}

/// The library's protocol with one thing changed.
Result<ReadyProtocol> protocol_with(const std::string& former, const std::string& now) {
  const std::string path = kLibrary + "/protocols/arm_assessment.toml";
  std::string text = test::must(read_text(path));
  const std::size_t at = text.rfind(former);
  EXPECT_NE(at, std::string::npos) << former;
  return read_protocol(text.replace(at, former.size(), now), path, kLibrary);
}

TEST(DoseOfAnArm, IsFourMovementsThenRestAMinuteBetweenBlocksAndAQuarterOfAnHourAtWorst) {
  EXPECT_TRUE(protocol_with("repetitions = 3", "repetitions = 3"));
  const auto too_long = protocol_with("repetitions = 3", "repetitions = 8");
  ASSERT_FALSE(too_long);
  EXPECT_NE(too_long.error().message().find("minutes at worst"), std::string::npos);
  const auto no_rest = protocol_with("repetitions = 3\nrest_s = 60", "repetitions = 3\nrest_s = 9");
  ASSERT_FALSE(no_rest);
  EXPECT_EQ(no_rest.error().field, "rest_s");
  const auto blocks = protocol_with("practice = true\nrest_s = 60", "practice = true\nrest_s = 59");
  ASSERT_FALSE(blocks);
  EXPECT_NE(blocks.error().message().find("59 s only"), std::string::npos);
  EXPECT_TRUE(protocol_with("practice = true\nrest_s = 60",
                            "practice = true\nrest_s = 50\n[[step]]\nkind = \"pause\"\n"
                            "duration_s = 10"))
      << "a pause is rest";
}

TEST_F(Arm, LostPicturesLeaveEmptyRowsAtTheirOwnTimes) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  cameras_->script = [](std::int64_t number, std::span<Vec3>) { return number % 3 != 0; };
  tick(60);
  const Signals recorded = signals(told());
  const auto t_s = recorded.column(columns::t_s);
  const auto x_m = recorded.column("object_x_m");
  int empty = 0;
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    EXPECT_EQ(t_s[row], static_cast<double>(row) * kPeriod_s);
    empty += std::isnan(x_m[row]) ? 1 : 0;
  }
  EXPECT_EQ(empty, 20);
  EXPECT_EQ(now().stage, Stage::trial);
}

/// The object is already where the first reference is; the second is never reached.
TEST_F(Arm, TheScoreOfTheRowsIsWhatTheTaskDidLive) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  int live_reached = 0;
  cameras_->script = [&](std::int64_t number, std::span<Vec3> p_W) {
    if (number % 100 > 90) hide_object(p_W);
    return true;
  };
  while (now().stage != Stage::idle || now().frames < 130) {
    tick();
    live_reached = std::max(live_reached, now().task.targets_reached);
    ASSERT_LT(now().frames, 2000) << "the task does not end";
  }
  const Told all = told();
  EXPECT_TRUE(all.completed);
  const auto measures = tasks::score(task(), signals(all));
  EXPECT_EQ(live_reached, 1);
  EXPECT_EQ(measure(measures, "targets_reached").value, 1.0);
  EXPECT_NEAR(measure(measures, "completion_time", "target_1").value.value(), 0.0, 1e-12)
      << "it is there when the reference appears";
  EXPECT_FALSE(measure(measures, "completion_time", "target_2").value);
  EXPECT_FALSE(measure(measures, "movement_time").value);
  // What is stored beside the trial is the task that was done.
  const auto stored = test::must(parse_pose_task(trial_->record.scene_text, "stored"));
  EXPECT_EQ(stored.targets.size(), 2u);
  const Signals rows = signals(all);
  std::vector<double> t_s;
  std::vector<Pose> X_WO;
  const auto& object = columns::segment_pose[index_of(ArmSegment::object)];
  const auto value = [&](const Column& column, std::size_t row) {
    return rows.column(column)[row];
  };
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (value(columns::phase, row) == static_cast<double>(tasks::Phase::paused)) continue;
    t_s.push_back(value(columns::t_s, row));
    const auto at = [&](std::size_t i) { return value(object.position[i], row); };
    const auto q = [&](std::size_t i) { return value(object.attitude[i], row); };
    X_WO.push_back({{at(0), at(1), at(2)}, Quat(q(0), q(1), q(2), q(3))});
  }
  const auto events = run_pose_task(stored, t_s, X_WO);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].position_error_m, measure(measures, "position_error").value)
      << "the same automaton on the same rows gives the same bits";
}

TEST_F(Arm, AFrameAllocatesNothing) {
  ASSERT_TRUE(take_start_posture().accepted);
  begin();
  tick(20);
  cameras_->script = nullptr;
  const auto before = test::allocations();
  for (int k = 0; k < 100; ++k) ASSERT_TRUE(acquisition_->tick());
  EXPECT_EQ(test::allocations(), before);
}

TEST(LeftArm, IsRightBehindTheCamerasAndItsMarkersAreRecordedAsSeen) {
  Bench right;
  Bench left(Hand::left);
  Signals of_right, of_left;
  for (auto [bench, signals] : {std::pair{&right, &of_right}, std::pair{&left, &of_left}}) {
    ASSERT_TRUE(bench->take_start_posture().accepted);
    bench->begin();
    bench->tick(20);
    *signals = bench->signals(bench->told());
  }
  ASSERT_EQ(of_left.rows(), of_right.rows());
  constexpr double kNoise =
      1e-3;  // of cameras and skin; the object is the same, not its reflection
  for (const char* same :
       {"object_x_m", "object_qy", "forearm_y_m", "reference_x_m", "reference_qz"})
    EXPECT_WITHIN(of_left.column(same)[19], of_right.column(same)[19], kNoise) << same;
  EXPECT_WITHIN(of_left.column("marker_B2_x_m")[19], -of_right.column("marker_B2_x_m")[19], kNoise);
  EXPECT_GT(std::abs(of_right.column("marker_B2_x_m")[19]), 10 * kNoise);
}

}  // namespace
}  // namespace isograsp::session::arm_test
