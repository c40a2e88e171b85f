// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands, each on a platform: one grid, two zeros, a fault of either is nobody's failure, and
// what a pair of hands in software does is what is measured.
#include "session/two_platforms/two_platforms.hpp"

#include <array>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/library/library.hpp"
#include "session/open_two_platforms.hpp"
#include "session/two_platforms/two_zeros.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::session::two_platforms_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";
constexpr double kFrame_s = 0.01;

/// Three sensors on the grid that press as a test says; nothing: silence.
class Scripted final : public ForceDevice {
 public:
  explicit Scripted(std::string uri) {
    info_.uri = std::move(uri);
    info_.description = "Scripted"_text;
    info_.simulated = true;
    info_.on_grid = true;
    for (Vec6& unit : info_.units_per_count) unit.setConstant(0.01);
  }
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return given; }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    return {};
  }
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    const Timestamp at{std::llround(static_cast<double>(sample_) * kFrame_s * 1e9)};
    if (at > deadline) {
      clock_->wait_until(deadline);
      return ReadStatus::timeout;
    }
    clock_->wait_until(at);
    out = {};
    out.finger = kFingers[next_];
    out.stamp = at;
    out.valid = !silent;
    out.wrench_C.force = {0.0, 0.0, finger_N[next_]};
    out.wrench_C.torque.setZero();
    next_ = (next_ + 1) % kFingerCount;
    if (next_ == 0) ++sample_;
    return ReadStatus::sample;
  }
  void stop() noexcept override {}

  DeviceInfo info_;
  DeviceHealth given;
  std::array<double, kFingerCount> finger_N{};
  bool silent = false;

 private:
  Clock* clock_ = nullptr;
  std::int64_t sample_ = 0;
  std::size_t next_ = 0;
};

struct Bench {
  Bench() {
    TwoPlatforms::Devices devices;
    for (const Hand hand : kBothHands) {
      auto made = std::make_unique<Scripted>(std::string("test://") + std::string(name_of(hand)));
      device[hand] = made.get();
      devices[hand] = std::move(made);
    }
    platforms.emplace(std::move(devices), nullptr, std::nullopt);
    apparatus = &*platforms;
    test::must(apparatus->start(clock));
    acquisition.emplace(*apparatus, clock);
  }
  void run(int frames) {
    for (int k = 0; k < frames; ++k) ASSERT_TRUE(acquisition->tick());
  }
  const TwoPlatformsSnapshot& now() {
    return static_cast<const TwoPlatformsSnapshot&>(apparatus->newest());
  }
  /// Takes both zeros.
  PreparationOutcome zero() {
    ZeroRequest request;
    request.device_is_empty = true;
    kept.push_back(test::must(apparatus->make_preparation(request)));
    EXPECT_TRUE(acquisition->commands().push(
        {.kind = Command::Kind::prepare, .preparation = kept.back().get()}));
    run(1);
    for (int k = 0; k < 1000 && now().stage == Stage::zeroing; ++k) run(1);
    return kept.back()->outcome();
  }
  TwoPlatformsTrial& begin(const std::string& task, const tasks::TaskContext& context) {
    const auto path = find_in_library(kLibrary, "tasks", task).value();
    auto made = test::must(apparatus->make_trial(
        test::must(tasks::parse_task(test::must(read_text(path)), path)), context));
    trial = std::move(made);
    EXPECT_TRUE(acquisition->commands().push({.kind = Command::Kind::begin, .setup = trial.get()}));
    return static_cast<TwoPlatformsTrial&>(*trial);
  }

  ManualClock clock;
  OfHands<Scripted*> device;
  std::optional<TwoPlatforms> platforms;
  Apparatus* apparatus = nullptr;
  std::optional<Acquisition> acquisition;
  std::vector<std::unique_ptr<Preparation>> kept;
  std::unique_ptr<TrialSetup> trial;
};

tasks::TaskContext strong_hands() {
  tasks::TaskContext context;
  for (const Hand hand : kBothHands) {
    context.two_hands.of[hand].maximum_N = 60.0;
    context.two_hands.of[hand].resting_N = 0.0;
  }
  context.two_hands.affected = Hand::left;
  return context;
}

TEST(TwoPlatforms, BothZerosAreSubtractedAndStoredSideBySide) {
  Bench bench;
  bench.device.left->finger_N = {0.5, 0.25, 0.125};
  bench.device.right->finger_N = {-1.0, 2.0, 0.75};
  const PreparationOutcome outcome = bench.zero();
  ASSERT_TRUE(outcome.accepted) << english(outcome.reason);
  bench.run(1);
  for (const Hand hand : test::every(kBothHands))
    for (std::size_t f = 0; f < kFingerCount; ++f)
      EXPECT_EQ(bench.now().of[hand].forces.wrench_C[f].force.z(), 0.0);
  EXPECT_TRUE(bench.now().zeroed);
  const auto means = platform::two_six_axes_of(outcome.record.columns, outcome.record.mean);
  ASSERT_TRUE(means.has_value());
  EXPECT_EQ(means->left[0][2], 0.5);
  EXPECT_EQ(means->right[1][2], 2.0);
}

TEST(TwoPlatforms, AZeroThatIsRefusedOnOnePlatformIsInForceOnNeither) {
  for (const Hand loaded : test::every(kBothHands)) {
    Bench bench;
    bench.device[other_than(loaded)]->finger_N = {0.5, 0.5, 0.5};
    bench.device[loaded]->finger_N = {40.0, 0.0, 0.0};  // a hand lies in it
    const PreparationOutcome outcome = bench.zero();
    EXPECT_FALSE(outcome.accepted);
    EXPECT_FALSE(bench.now().zeroed);
    bench.run(1);
    EXPECT_EQ(bench.now().of[other_than(loaded)].forces.wrench_C[0].force.z(), 0.5);
    const char* words = loaded == Hand::left ? "Left platform: " : "Right platform: ";
    EXPECT_EQ(english(outcome.reason).rfind(words, 0), 0U) << english(outcome.reason);
  }
}

TEST(TwoPlatforms, SilenceOfEitherPausesTheTrialAndSaysWhose) {
  for (const Hand silent : test::every(kBothHands)) {
    Bench bench;
    (void)bench.zero();
    (void)bench.begin("two_hands_sum.toml", strong_hands());
    bench.run(50);
    ASSERT_EQ(bench.now().stage, Stage::trial);
    const double task_time_s = bench.now().task.task_time_s;
    bench.device[silent]->silent = true;
    bench.device[silent]->given.fault = DeviceFault::silence;
    bench.device[silent]->given.finger = Finger::index;
    bench.run(20);
    EXPECT_EQ(bench.now().stage, Stage::paused);
    EXPECT_TRUE(is_fault(bench.now().pause_cause));
    // Held for 50 ms, then the task stands still.
    EXPECT_NEAR(bench.now().task.task_time_s, task_time_s + 0.05, kFrame_s + 1e-9);
    RecordItem item;
    std::string told;
    while (bench.acquisition->records().pop(item))
      if (item.kind == RecordItem::Kind::event && item.pauses)
        told = english(item.where.value()(item.reason));
    EXPECT_EQ(told.rfind(silent == Hand::left ? "Left platform: " : "Right platform: ", 0), 0U)
        << told;
  }
}

TEST(TwoPlatforms, TheSameFaultOfTheOtherPlatformIsAnotherFault) {
  Bench bench;
  bench.device.left->given.fault = DeviceFault::silence;
  bench.run(1);
  const int left = bench.apparatus->fault().number;
  bench.device.left->given.fault = DeviceFault::none;
  bench.device.right->given.fault = DeviceFault::silence;
  bench.run(1);
  const int right = bench.apparatus->fault().number;
  EXPECT_NE(left, 0);
  EXPECT_NE(right, 0);
  EXPECT_NE(left, right);
}

TEST(TwoPlatforms, ASensorThatBeganAnewMakesBothZerosOutdated) {
  for (const Hand hand : test::every(kBothHands)) {
    Bench bench;
    ASSERT_TRUE(bench.zero().accepted);
    bench.run(1);
    EXPECT_TRUE(bench.apparatus->ready());
    bench.device[hand]->given.sensors[1].restarts = 1;
    bench.run(1);
    const auto ready = bench.apparatus->ready();
    ASSERT_FALSE(ready);
    EXPECT_NE(ready.error().message().find(std::string(name_of(hand)) + " index"),
              std::string::npos);
  }
}

TEST(TwoPlatforms, APushToThePatientsRightIsOneOfEitherHand) {
  // Three digits of either hand push to +x of the screen: the left platform is turned.
  EXPECT_EQ(push_in_view(Hand::right, Vec3(1.0, 2.0, 3.0)), Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(push_in_view(Hand::left, Vec3(-1.0, 2.0, -3.0)), Vec3(1.0, 2.0, 3.0));
  Bench bench;
  bench.device.right->finger_N = {3.0, 0.0, 0.0};  // the thumb presses to +x of its platform
  bench.device.left->finger_N = {0.0, 2.0, 1.0};   // the fingers press to -x of theirs
  bench.run(2);
  EXPECT_EQ(bench.now().of.right.push_W.value(), Vec3(3.0, 0.0, 0.0));
  EXPECT_EQ(bench.now().of.left.push_W.value(), Vec3(3.0, 0.0, 0.0));
}

TEST(TwoPlatforms, AFrameTakesNoMemory) {
  Bench bench;
  (void)bench.zero();
  (void)bench.begin("two_hands_sum.toml", strong_hands());
  bench.run(10);
  RecordItem item;
  const auto before = test::allocations();
  for (int k = 0; k < 500; ++k) {
    ASSERT_TRUE(bench.acquisition->tick());
    while (bench.acquisition->records().pop(item)) {
    }
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(TwoPlatforms, PlatformsThatCannotStandSideBySideAreRefused) {
  const auto pair_of = [](auto change) {
    TwoPlatforms::Devices devices;
    for (const Hand hand : kBothHands) devices[hand] = std::make_unique<Scripted>("test://x");
    change(static_cast<Scripted&>(*devices.right).info_);
    return TwoPlatforms::check(devices);
  };
  EXPECT_TRUE(pair_of([](DeviceInfo&) {}));
  EXPECT_FALSE(pair_of([](DeviceInfo& info) { info.frame_period_s = 0.02; }));
  EXPECT_FALSE(pair_of([](DeviceInfo& info) { info.delay_s = 0.01; }));
  EXPECT_FALSE(pair_of([](DeviceInfo& info) { info.simulated = false; }));
  EXPECT_FALSE(pair_of([](DeviceInfo& info) { info.recorded = true; }));
}

TEST(TwoPlatforms, ASensorThatBothPlatformsNameIsOneSensorAndRefused) {
  const auto started = [](const char* left, const char* right) {
    TwoPlatforms::Devices devices;
    for (const Hand hand : kBothHands) {
      auto made = std::make_unique<Scripted>("test://x");
      made->info_.simulated = false;
      made->info_.serial_numbers = {"A1", hand == Hand::left ? left : right, ""};
      made->info_.serial_numbers[0] += name_of(hand);
      devices[hand] = std::move(made);
    }
    ManualClock clock;
    TwoPlatforms two(std::move(devices), nullptr, std::nullopt);
    return static_cast<Apparatus&>(two).start(clock);
  };
  EXPECT_TRUE(started("B1", "B2"));
  EXPECT_TRUE(started("", "")) << "not told";
  const auto refused = started("B1", "B1");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "serial_number");
}

TEST(TwoPlatformsAddress, OnePlatformForTwoHandsIsRefusedButForAPairInSoftware) {
  const std::string can = "can://can0?protocol=rft";
  EXPECT_FALSE(two_platforms_uri({can, can}));
  const auto two = two_platforms_uri({can + "&config=a.toml", can + "&config=b.toml"});
  ASSERT_TRUE(two);
  const auto parts = two_platforms_in(*two);
  ASSERT_TRUE(parts.has_value());
  EXPECT_EQ(parts->left, can + "&config=a.toml");
  EXPECT_EQ(parts->right, can + "&config=b.toml");
  EXPECT_EQ(kind_of_apparatus(*two), TwoPlatforms::kKind);
  EXPECT_TRUE(two_platforms_uri({"sim://pair?file=healthy", "sim://pair?file=healthy"}));
  EXPECT_FALSE(two_platforms_in(can).has_value());
}

}  // namespace
}  // namespace isograsp::session::two_platforms_test
