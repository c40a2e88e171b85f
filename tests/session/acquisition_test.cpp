// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/acquisition.hpp"

#include <set>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/signals.hpp"
#include "hand/columns.hpp"
#include "session/session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::session::acquisition_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// A simulated device with a person in front of it, in virtual time.
struct Bench {
  explicit Bench(const std::string& uri = "sim://healthy?seed=3")
      : viewer(*virtual_patient::patient_traits("healthy"), 3) {
    DeviceOptions device_options;
    device_options.source = &viewer;
    device = std::move(open_device(uri, device_options)).value();
    EXPECT_TRUE(device->start(clock));
    Acquisition::Options options;
    options.viewer = &viewer;
    acquisition.emplace(*device, clock, clock.now(), options);
  }

  tasks::TaskSpec task(const std::string& name) {
    const auto path = find_in_library(kLibrary, "tasks", name);
    return tasks::parse_task(read_text(*path).value(), *path).value();
  }

  TrialSetup setup(const std::string& name, double maximum_N) {
    TrialSetup made;
    made.spec = task(name);
    tasks::TaskContext context;
    if (maximum_N > 0.0) context.references.maximum_N[{}] = maximum_N;
    if (const auto scene = made.spec.scene(); !scene.empty()) {
      const auto path = find_in_library(kLibrary, "scenes", scene).value();
      made.plan =
          Plan::compile(parse_scene(read_text(path).value(), path).value(), context.period_s)
              .value();
    }
    made.task = tasks::make_task(made.spec, context).value();
    return made;
  }

  ManualClock clock;
  virtual_patient::VirtualPatient viewer;
  std::unique_ptr<ForceDevice> device;
  std::optional<Acquisition> acquisition;
};

/// The same device, in the health that a test gives it.
class Ailing final : public ForceDevice {
 public:
  explicit Ailing(std::unique_ptr<ForceDevice> device) : device_(std::move(device)) {}
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return device_->info(); }
  [[nodiscard]] DeviceHealth health() const noexcept override { return given; }
  [[nodiscard]] Result<void> start(Clock& clock) override { return device_->start(clock); }
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    return device_->read(deadline, out);
  }
  void stop() noexcept override { device_->stop(); }
  DeviceHealth given;

 private:
  std::unique_ptr<ForceDevice> device_;
};

class Ailment : public ::testing::Test {
 protected:
  Ailment() {
    bench_.device = std::make_unique<Ailing>(std::move(bench_.device));
    Acquisition::Options options;
    options.viewer = &bench_.viewer;
    bench_.acquisition.emplace(*bench_.device, bench_.clock, bench_.clock.now(), options);
  }
  DeviceHealth& health() { return static_cast<Ailing&>(*bench_.device).given; }
  void tick(int frames) {
    for (int k = 0; k < frames; ++k) ASSERT_TRUE(bench_.acquisition->tick());
  }
  void set_zero() {
    constexpr double kHandLeaves_s = 1.0;
    ASSERT_TRUE(bench_.acquisition->commands().push(
        {Command::Kind::zero, nullptr, "", false, kHandLeaves_s}));
    tick(250);
  }
  const Snapshot& now() { return bench_.acquisition->snapshots().read(); }
  /// What was told of faults since the last call.
  std::vector<std::string> told() {
    std::vector<std::string> words;
    RecordItem item;
    while (bench_.acquisition->records().pop(item))
      if (item.kind == RecordItem::Kind::event && !item.told_before)
        words.emplace_back(item.reason);
    return words;
  }
  Bench bench_;
};

TEST_F(Ailment, AZeroIsOlderThanTheRestartOfASensorUntilItIsSetAgain) {
  health().sensors[1].restarts = 2;  // while nothing was zeroed
  tick(1);
  set_zero();
  ASSERT_TRUE(now().zeroed);
  EXPECT_FALSE(now().restarted);
  health().sensors[1].restarts = 3;
  tick(1);
  EXPECT_EQ(now().restarted, Finger::index);
  tick(500);
  EXPECT_EQ(now().restarted, Finger::index) << "however long ago";
  set_zero();
  EXPECT_FALSE(now().restarted);
}

TEST_F(Ailment, ARestartWhileTheZeroIsMeasuredSpoilsThatZero) {
  ASSERT_TRUE(bench_.acquisition->commands().push({Command::Kind::zero, nullptr, ""}));
  tick(20);
  ++health().sensors[0].restarts;
  tick(130);
  ASSERT_TRUE(now().zeroed);
  EXPECT_EQ(now().restarted, Finger::thumb);
}

TEST_F(Ailment, EveryFaultIsRecordedOnceAlsoBetweenTrials) {
  const auto suffer = [&](DeviceFault fault, std::optional<Finger> finger) {
    health().fault = fault;
    health().finger = finger;
    tick(5);
  };
  suffer(DeviceFault::none, std::nullopt);
  EXPECT_TRUE(told().empty());
  suffer(DeviceFault::silence, Finger::index);
  suffer(DeviceFault::restarted, Finger::index);
  suffer(DeviceFault::none, std::nullopt);
  suffer(DeviceFault::overload, Finger::thumb);
  EXPECT_EQ(told(), (std::vector<std::string>{
                        std::string(describe(DeviceFault::silence, Finger::index)),
                        std::string(describe(DeviceFault::restarted, Finger::index)),
                        std::string(describe(DeviceFault::overload, Finger::thumb))}));
  TrialSetup setup = bench_.setup("two_target", 0.0);
  ASSERT_TRUE(bench_.acquisition->commands().push({Command::Kind::begin, &setup, ""}));
  suffer(DeviceFault::overload, Finger::middle);
  EXPECT_EQ(now().stage, Stage::trial) << "it does not stop the trial";
  EXPECT_EQ(told().size(), 1u);
}

TEST(Acquisition, ASamplesWholeWayToThePublishedSnapshotAllocatesNothing) {
  for (const char* name : {"grip_sine", "two_target"}) {
    Bench bench("sim://healthy?seed=3&drop=0.01");
    TrialSetup setup = bench.setup(name, 40.0);
    ASSERT_TRUE(bench.acquisition->commands().push({Command::Kind::begin, &setup, ""}));
    ASSERT_TRUE(bench.acquisition->tick());
    const auto before = test::allocations();
    for (int frame = 0; frame < 900; ++frame) ASSERT_TRUE(bench.acquisition->tick());
    EXPECT_EQ(test::allocations() - before, 0u) << name;
  }
}

TEST(Acquisition, TheSnapshotIsTheRecordedSample) {
  Bench bench;
  TrialSetup setup = bench.setup("two_target", 0.0);
  ASSERT_TRUE(bench.acquisition->commands().push({Command::Kind::begin, &setup, ""}));
  std::vector<std::string> names;
  for (const auto& group : signal_groups(true))
    names.insert(names.end(), group.columns.begin(), group.columns.end());
  RecordItem item;
  test::AtLeast compared(290);
  for (int frame = 0; frame < 300; ++frame) {
    ASSERT_TRUE(bench.acquisition->tick());
    const Snapshot& shown = bench.acquisition->snapshots().read();
    while (bench.acquisition->records().pop(item)) {
      if (item.kind != RecordItem::Kind::sample) continue;
      Signals row(names);
      ASSERT_EQ(item.row.values().size(), names.size());
      row.append_row(item.row.values());
      const auto recorded = [&row](const Column& column) { return row.column(column)[0]; };
      EXPECT_EQ(recorded(columns::finger_force[0][2]), shown.forces.wrench_C[0].force.z());
      EXPECT_EQ(recorded(columns::raw_torque[2][0]), shown.forces.raw_counts[2][3]);
      EXPECT_EQ(recorded(columns::target_index), shown.task.target_index);
      EXPECT_EQ(recorded(columns::object_force[1]), shown.grasp.F_O_W.force.y());
      ++compared;
    }
  }
}

TEST(TrialRow, EveryColumnStandsOnceAndHasAValue) {
  constexpr std::size_t kForceTask = 12 + 15 + 28 + 18 + 2;
  constexpr std::size_t kObjectTask = 12 + 11 + 28 + 18 + 31 + 2;
  for (const bool has_object : {false, true}) {
    std::set<std::string> names;
    for (const auto& group : test::every(signal_groups(has_object)))
      for (const auto& name : test::every(group.columns))
        EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(names.size(), has_object ? kObjectTask : kForceTask);
    ASSERT_LE(names.size(), TrialRow::kMostColumns);
    TrialRow row;
    write_row({0.0, {}, {}, tasks::Phase::active, {}, {}, {}, {}, 0.0, 0.0}, has_object, row);
    EXPECT_EQ(row.values().size(), names.size());
  }
}

TEST(Acquisition, AMissingSampleIsHeldAndASilentSensorPausesTheTrialWithoutMovingAnything) {
  Bench bench("sim://healthy?seed=3&drop=1.0");
  TrialSetup setup = bench.setup("two_target", 0.0);
  ASSERT_TRUE(bench.acquisition->commands().push({Command::Kind::begin, &setup, ""}));
  for (int frame = 0; frame < 100; ++frame) ASSERT_TRUE(bench.acquisition->tick());
  const Snapshot& shown = bench.acquisition->snapshots().read();
  EXPECT_EQ(shown.stage, Stage::paused);
  EXPECT_EQ(shown.pause_cause, PauseCause::missing_samples);
  EXPECT_EQ(shown.task.task_time_s, 0.0);
  EXPECT_EQ(shown.object.X_WO.p, Vec3(0, 0, 0));
}

TEST(Acquisition, PauseStopsTaskAndObjectAndResumeContinues) {
  Bench bench;
  TrialSetup setup = bench.setup("two_target", 0.0);
  auto& acquisition = *bench.acquisition;
  ASSERT_TRUE(acquisition.commands().push({Command::Kind::begin, &setup, ""}));
  for (int frame = 0; frame < 300; ++frame) ASSERT_TRUE(acquisition.tick());
  const Snapshot before = acquisition.snapshots().read();
  ASSERT_TRUE(acquisition.commands().push({Command::Kind::pause, nullptr, ""}));
  for (int frame = 0; frame < 200; ++frame) ASSERT_TRUE(acquisition.tick());
  const Snapshot paused = acquisition.snapshots().read();
  EXPECT_EQ(paused.task.task_time_s, before.task.task_time_s);
  EXPECT_GT(paused.session_time_s, before.session_time_s + 1.9);
  ASSERT_TRUE(acquisition.commands().push({Command::Kind::resume, nullptr, ""}));
  for (int frame = 0; frame < 2; ++frame) ASSERT_TRUE(acquisition.tick());
  EXPECT_GT(acquisition.snapshots().read().task.task_time_s, before.task.task_time_s);
}

}  // namespace
}  // namespace isograsp::session::acquisition_test
