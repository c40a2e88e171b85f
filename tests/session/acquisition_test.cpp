// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/acquisition.hpp"

#include <set>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/signals.hpp"
#include "hand/columns.hpp"
#include "session/platform/force_platform.hpp"
#include "session/session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/platform_columns.hpp"

namespace isograsp::session::acquisition_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// A simulated device with a person in front of it, in virtual time.
struct Bench {
  /// `wrap` makes another device of the simulated one.
  template <class Wrap>
  Bench(const std::string& uri, Wrap wrap) {
    auto viewer = std::make_unique<virtual_patient::VirtualPatient>(
        *virtual_patient::patient_traits("healthy"), 3);
    DeviceOptions options;
    options.source = viewer.get();
    platform.emplace(wrap(std::move(open_device(uri, options)).value()), std::move(viewer));
    EXPECT_TRUE(platform->start(clock));
    acquisition.emplace(*platform, clock);
  }
  explicit Bench(const std::string& uri = "sim://healthy?seed=3")
      : Bench(uri, [](std::unique_ptr<ForceDevice> device) { return device; }) {}

  tasks::TaskSpec task(const std::string& name) {
    const auto path = find_in_library(kLibrary, "tasks", name);
    return tasks::parse_task(read_text(*path).value(), *path).value();
  }

  std::unique_ptr<PlatformTrial> setup(const std::string& name, double maximum_N) {
    auto made = std::make_unique<PlatformTrial>();
    made->spec = task(name);
    tasks::TaskContext context;
    if (maximum_N > 0.0) context.references.maximum_N[{}] = maximum_N;
    if (const auto scene = made->spec.scene(); !scene.empty()) {
      const auto path = find_in_library(kLibrary, "scenes", scene).value();
      made->plan =
          Plan::compile(parse_scene(read_text(path).value(), path).value(), context.period_s)
              .value();
    }
    made->task = tasks::make_task(made->spec, context).value();
    return made;
  }

  void begin(PlatformTrial& trial) {
    EXPECT_TRUE(acquisition->commands().push({.kind = Command::Kind::begin, .setup = &trial}));
  }
  const Snapshot& now() { return platform->snapshots().read(); }

  ManualClock clock;
  std::optional<ForcePlatform> platform;
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
  Ailment()
      : bench_("sim://healthy?seed=3", [this](std::unique_ptr<ForceDevice> device) {
          auto ailing = std::make_unique<Ailing>(std::move(device));
          ailing_ = ailing.get();
          return ailing;
        }) {}
  DeviceHealth& health() { return ailing_->given; }
  void tick(int frames) {
    for (int k = 0; k < frames; ++k) ASSERT_TRUE(bench_.acquisition->tick());
  }
  void set_zero(double settle_s = 1.0) {  // the hand leaves
    zero_ = {};
    zero_.settle_s = settle_s;
    ASSERT_TRUE(bench_.acquisition->commands().push(
        {.kind = Command::Kind::prepare, .preparation = &zero_}));
  }
  const Snapshot& now() { return bench_.now(); }
  /// What was told of faults since the last call.
  std::vector<std::string> told() {
    std::vector<std::string> words;
    RecordItem item;
    while (bench_.acquisition->records().pop(item))
      if (item.kind == RecordItem::Kind::event && !item.told_before)
        words.emplace_back(item.reason.english());
    return words;
  }
  Ailing* ailing_ = nullptr;
  Bench bench_;
  InstrumentZero zero_;
};

TEST_F(Ailment, AZeroIsOlderThanTheRestartOfASensorUntilItIsSetAgain) {
  health().sensors[1].restarts = 2;  // while nothing was zeroed
  tick(1);
  set_zero();
  tick(250);
  ASSERT_TRUE(now().zeroed);
  EXPECT_FALSE(now().restarted);
  health().sensors[1].restarts = 3;
  tick(1);
  EXPECT_EQ(now().restarted, Finger::index);
  tick(500);
  EXPECT_EQ(now().restarted, Finger::index) << "however long ago";
  set_zero();
  tick(250);
  EXPECT_FALSE(now().restarted);
}

TEST_F(Ailment, ARestartWhileTheZeroIsMeasuredSpoilsThatZero) {
  set_zero(0.0);
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
                        std::string(words_of(DeviceFault::silence, Finger::index).english()),
                        std::string(words_of(DeviceFault::restarted, Finger::index).english()),
                        std::string(words_of(DeviceFault::overload, Finger::thumb).english())}));
  const auto setup = bench_.setup("two_target", 0.0);
  bench_.begin(*setup);
  suffer(DeviceFault::overload, Finger::middle);
  EXPECT_EQ(now().stage, Stage::trial) << "it does not stop the trial";
  EXPECT_EQ(told().size(), 1u);
}

TEST(Acquisition, ASamplesWholeWayToThePublishedSnapshotAllocatesNothing) {
  for (const char* name : {"grip_sine", "two_target"}) {
    Bench bench("sim://healthy?seed=3&drop=0.01");
    const auto setup = bench.setup(name, 40.0);
    bench.begin(*setup);
    ASSERT_TRUE(bench.acquisition->tick());
    const auto before = test::allocations();
    for (int frame = 0; frame < 900; ++frame) ASSERT_TRUE(bench.acquisition->tick());
    EXPECT_EQ(test::allocations() - before, 0u) << name;
  }
}

TEST(Acquisition, TheSnapshotIsTheRecordedSample) {
  Bench bench;
  const auto setup = bench.setup("two_target", 0.0);
  bench.begin(*setup);
  std::vector<std::string> names;
  for (const auto& group : setup->columns())
    names.insert(names.end(), group.columns.begin(), group.columns.end());
  RecordItem item;
  test::AtLeast compared(290);
  for (int frame = 0; frame < 300; ++frame) {
    ASSERT_TRUE(bench.acquisition->tick());
    const Snapshot& shown = bench.now();
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
    const auto all = test::platform_columns(has_object);
    const std::set<std::string> names(all.begin(), all.end());
    EXPECT_EQ(names.size(), all.size()) << "one stands twice";
    EXPECT_EQ(names.size(), has_object ? kObjectTask : kForceTask);
    ASSERT_LE(names.size(), TrialRow::kMostColumns);
    const test::StillFrame still;
    TrialRow row;
    write_row({}, still.seen(has_object), row);
    EXPECT_EQ(row.values().size(), names.size());
  }
}

TEST(Acquisition, AMissingSampleIsHeldAndASilentSensorPausesTheTrialWithoutMovingAnything) {
  Bench bench("sim://healthy?seed=3&drop=1.0");
  const auto setup = bench.setup("two_target", 0.0);
  bench.begin(*setup);
  for (int frame = 0; frame < 100; ++frame) ASSERT_TRUE(bench.acquisition->tick());
  const Snapshot& shown = bench.now();
  EXPECT_EQ(shown.stage, Stage::paused);
  EXPECT_EQ(shown.pause_cause, PauseCause::missing_samples);
  EXPECT_EQ(shown.task.task_time_s, 0.0);
  EXPECT_EQ(shown.object.X_WO.p, Vec3(0, 0, 0));
}

TEST(Acquisition, PauseStopsTaskAndObjectAndResumeContinues) {
  Bench bench;
  const auto setup = bench.setup("two_target", 0.0);
  auto& acquisition = *bench.acquisition;
  bench.begin(*setup);
  for (int frame = 0; frame < 300; ++frame) ASSERT_TRUE(acquisition.tick());
  const Snapshot before = bench.now();
  ASSERT_TRUE(acquisition.commands().push({.kind = Command::Kind::pause}));
  for (int frame = 0; frame < 200; ++frame) ASSERT_TRUE(acquisition.tick());
  const Snapshot paused = bench.now();
  EXPECT_EQ(paused.task.task_time_s, before.task.task_time_s);
  EXPECT_GT(paused.session_time_s, before.session_time_s + 1.9);
  ASSERT_TRUE(acquisition.commands().push({.kind = Command::Kind::resume}));
  for (int frame = 0; frame < 2; ++frame) ASSERT_TRUE(acquisition.tick());
  EXPECT_GT(bench.now().task.task_time_s, before.task.task_time_s);
}

}  // namespace
}  // namespace isograsp::session::acquisition_test
