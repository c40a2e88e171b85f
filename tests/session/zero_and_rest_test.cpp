// SPDX-License-Identifier: GPL-3.0-or-later
// Zero and rest are two acts: what each of them keeps, refuses and marks.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/csv.hpp"
#include "session/platform/force_platform.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/recorder.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::session::zero_and_rest_test {
namespace {

using test::library_task;

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";
constexpr ZeroRequest kEmpty{true, false, 0.0};
constexpr ZeroRequest kServiced{true, true, 0.0};

tasks::TaskSpec task(const std::string& keys) {
  return tasks::parse_task(
             "format = \"isograsp-task-1\"\nname = \"T\"\ninstruction = \"T\"\n" + keys, "t")
      .value();
}
const tasks::TaskSpec& short_rest() {
  static const tasks::TaskSpec spec = task("kind = \"rest\"\nduration_s = 1.0\n");
  return spec;
}

struct Clinic {
  Clinic() { EXPECT_TRUE(storage::open_store(database, storage::OpenMode::create)); }

  std::unique_ptr<Session> open(const std::string& uri = "sim://paretic?seed=3") {
    SessionConfig c;
    c.database = database;
    c.patient_code = "TEST-01";
    c.device_uri = uri;
    c.library = kLibrary;
    c.operator_name = "Therapist 7";
    c.started_utc = "2026-03-01T09:30:00Z";
    c.virtual_time = true;
    return Session::open(c).value();
  }
  std::unique_ptr<storage::SessionStore> store() const {
    return storage::open_store(database, storage::OpenMode::existing).value();
  }
  storage::SessionRecord last_session() const {
    const auto records = store();
    return records->sessions(records->find_patient("TEST-01").value()->id).value().back();
  }

  test::TemporaryFolder folder;
  std::string database = folder.path("clinic.db");
};

PreparationOutcome zero(Session& session, const ZeroRequest& request) {
  EXPECT_TRUE(session.start_zero(request));
  return session.wait_for_news().at(0).prepared.value();
}
TrialOutcome trial(Session& session, const tasks::TaskSpec& spec) {
  const auto started = session.start_trial(spec, false);
  EXPECT_TRUE(started) << started.error().message();
  return session.wait_for_news().at(0).trial.value();
}

TEST(InstrumentZero, IsRefusedWithoutTheConfirmationThatTheDeviceIsEmpty) {
  Clinic clinic;
  const auto session = clinic.open();
  const auto refused = session->start_zero({});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("device is empty"), std::string::npos);
  session->let_pass(2.0);
  EXPECT_FALSE(session->snapshot().zeroed);
}

/// Of the newest session, of this kind.
std::vector<storage::PreparationRecord> kept_preparations(Clinic& clinic, const std::string& kind) {
  auto all = clinic.store()->preparations(clinic.last_session().id).value();
  std::erase_if(all, [&](const auto& one) { return one.kind != kind; });
  return all;
}

TEST(InstrumentZero, IsKeptWithWhoWhenAndTheEmptyNoise) {
  Clinic clinic;
  auto session = clinic.open();
  session->let_pass(120.0);
  EXPECT_TRUE(zero(*session, kEmpty).accepted);
  session.reset();
  const auto kept = kept_preparations(clinic, "instrument_zero").at(0);
  EXPECT_EQ(kept.operator_name, "Therapist 7");
  EXPECT_EQ(kept.recorded_utc, "2026-03-01T09:32:01Z");
  EXPECT_FALSE(kept.references.contains("change_N")) << "the first of this device";
  const auto noise = platform::six_axes_of(kept.columns, kept.sd).value();
  for (const auto& sd : test::every(noise)) {
    EXPECT_GT(sd[2], 0.0);
    EXPECT_LT(sd[2], 0.1) << "0.4 counts of noise and 0.3 of rounding, 0.08 N each";
  }
}

/// A zero of the same device in an earlier session that read `offset_N` at the index finger.
void add_earlier_zero(Clinic& clinic, double offset_N, bool same_sensors = true) {
  const auto store = clinic.store();
  storage::SessionRecord earlier = clinic.last_session();
  earlier.uuid.clear();  // another one
  if (!same_sensors) earlier.sensors = {{"thumb", "A"}, {"index", "B"}, {"middle", "C"}};
  ZeroRecord zero;
  for (auto& mean : zero.mean) mean.setZero();
  for (auto& sd : zero.sd) sd.setZero();
  zero.mean[1][0] = offset_N;
  storage::PreparationRecord record = as_stored(zero);
  record.session_id = store->begin_session(earlier).value();
  ASSERT_TRUE(store->add_preparation(record));
}

TEST(InstrumentZero, OutsideTheBandOfAnEarlierSessionItIsRefusedUntilServiceIsConfirmed) {
  Clinic clinic;
  clinic.open().reset();
  add_earlier_zero(clinic, 3.0);
  auto session = clinic.open();
  const auto refused = zero(*session, kEmpty);
  EXPECT_FALSE(refused.accepted);
  EXPECT_TRUE(refused.only_changed);
  EXPECT_NE(english(refused.reason).find("index sensor differs from the last empty zero"),
            std::string::npos)
      << english(refused.reason);
  EXPECT_FALSE(session->snapshot().zeroed);

  const auto accepted = zero(*session, kServiced);
  EXPECT_TRUE(accepted.accepted) << english(accepted.reason);
  EXPECT_NE(english(accepted.remark).find("confirmed as serviced or remounted"), std::string::npos);
  EXPECT_TRUE(zero(*session, kEmpty).accepted) << "the new one is the measure from now on";
  session.reset();
  const auto kept = kept_preparations(clinic, "instrument_zero");
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_TRUE(kept[0].change_confirmed);
  EXPECT_NEAR(kept[0].references.at("change_N"), 3.0, 0.1);
  EXPECT_FALSE(kept[1].change_confirmed);
  const auto events = clinic.store()->events(clinic.last_session().id).value();
  ASSERT_EQ(events.size(), 2u) << "never silent";
  EXPECT_EQ(events[0].kind, "zero refused");
  EXPECT_EQ(events[1].kind, "zero");
}

TEST(InstrumentZero, WithoutAWindowTheWayOutIsNamedAndWorks) {
  Clinic clinic;
  clinic.open().reset();
  add_earlier_zero(clinic, 3.0);
  const auto path = clinic.folder.write(
      "p.toml",
      "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\nkind = \"instrument_zero\"\n");
  const auto protocol = read_protocol(path, kLibrary).value();
  const auto refused = run_protocol(*clinic.open(), protocol, {});
  ASSERT_FALSE(refused);
  EXPECT_NE(english(refused.error().remedy).find("--serviced"), std::string::npos);
  EXPECT_TRUE(run_protocol(*clinic.open(), protocol, {}, true));
  EXPECT_TRUE(run_protocol(*clinic.open(), protocol, {}));
}

TEST(InstrumentZero, AConfirmationThatWasNotNeededLeavesNoMark) {
  Clinic clinic;
  clinic.open().reset();
  add_earlier_zero(clinic, 1.5);
  EXPECT_FALSE(zero(*clinic.open(), kServiced).record.change_confirmed);
}

TEST(InstrumentZero, OtherSensorsHaveAnotherBand) {
  Clinic clinic;
  clinic.open().reset();
  add_earlier_zero(clinic, 3.0, false);
  const auto outcome = zero(*clinic.open(), kEmpty);
  EXPECT_TRUE(outcome.accepted) << english(outcome.reason);
  EXPECT_FALSE(outcome.record.references.contains(platform::kChange_N));
}

TEST(RestingForce, IsKeptPerFingerWithWhoWhenAndASentence) {
  Clinic clinic;
  auto session = clinic.open();
  zero(*session, kEmpty);
  const auto outcome = trial(*session, short_rest());
  ASSERT_TRUE(outcome.rest);
  EXPECT_EQ(english(outcome.rest->words).find("At rest thumb"), 0u);
  session.reset();
  const auto kept = kept_preparations(clinic, "resting_force").at(0);
  EXPECT_EQ(kept.operator_name, "Therapist 7");
  EXPECT_EQ(kept.recorded_utc.substr(0, 17), "2026-03-01T09:30:");
  EXPECT_EQ(kept.references, (storage::References{{"duration_s", 1.0}}));
  EXPECT_EQ(kept.samples, 100);
  EXPECT_EQ(kept.mean, platform::as_row(outcome.rest->rest.mean));
  EXPECT_EQ(kept.sd, platform::as_row(outcome.rest->rest.sd));
}

TEST(RestingForce, WaitsAMinuteAfterStrappingWhereThatIsKnown) {
  Clinic clinic;
  auto session = clinic.open();
  zero(*session, kEmpty);
  session->strapped();
  session->let_pass(20.0);
  const auto early = session->start_trial(short_rest(), false);
  ASSERT_FALSE(early);
  EXPECT_NE(early.error().message().find("wait another 40 s"), std::string::npos)
      << early.error().message();
  session->let_pass(40.0);
  EXPECT_EQ(session->settling_s(), 0.0);
  EXPECT_NEAR(trial(*session, short_rest()).rest->rest.since_strapping_s.value(), 60.0, 0.02);
  zero(*session, kEmpty);  // the hand was out
  EXPECT_FALSE(trial(*session, short_rest()).rest->rest.since_strapping_s.has_value());
}

TEST(RestingForce, IsNeverSubtracted) {
  // The same person presses twice; one of the sessions measures the resting force before.
  const tasks::TaskSpec handling =
      task("kind = \"observe\"\nscene = \"planar_block\"\nduration_s = 2\n");
  Clinic with_rest;
  auto measured = with_rest.open();
  zero(*measured, kEmpty);
  trial(*measured, short_rest());
  const double begin_s = trial(*measured, handling).trial.session_time_s;
  measured.reset();
  Clinic without_rest;
  auto plain = without_rest.open();
  zero(*plain, kEmpty);
  constexpr double kFrame_s = 0.01;
  plain->let_pass(begin_s - 0.5 * kFrame_s - plain->snapshot().session_time_s);
  EXPECT_EQ(trial(*plain, handling).trial.session_time_s, begin_s) << "else nothing is compared";
  plain.reset();
  const auto signals = [&](const Clinic& clinic) {
    const auto store = clinic.store();
    return store->signals(store->trials(clinic.last_session().id).value().back()).value();
  };
  const Signals a = signals(with_rest);
  const Signals b = signals(without_rest);
  int compared = 0;
  for (const auto& name : test::every(a.names())) {
    if (name.find("_f") == std::string::npos && name.find("_t") == std::string::npos) continue;
    if (name == "resting_force_N") continue;
    const auto x = a.column(name);
    const auto y = b.column(name);
    ASSERT_EQ(x.size(), y.size());
    EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size_bytes()), 0) << name;
    ++compared;
  }
  EXPECT_GE(compared, 36);
}

/// Three sensors that read what the test says, without noise.
class ScriptedDevice final : public ForceDevice {
 public:
  ScriptedDevice() {
    info_.on_grid = true;
    info_.frame_period_s = info_.sample_period_s = 0.01;
  }
  FingerWrenches wrench_C{};

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] DeviceHealth health() const noexcept override { return {}; }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    start_ = clock.now();
    return {};
  }
  [[nodiscard]] ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    out = {};
    out.stamp = start_ + from_seconds(static_cast<double>(sample_ / 3) * info_.frame_period_s);
    if (out.stamp > deadline) {
      clock_->wait_until(deadline);
      return ReadStatus::timeout;
    }
    clock_->wait_until(out.stamp);
    out.finger = kFingers[static_cast<std::size_t>(sample_++ % 3)];
    out.wrench_C = wrench_C[index_of(out.finger)];
    return ReadStatus::sample;
  }
  void stop() noexcept override {}

 private:
  DeviceInfo info_;
  Clock* clock_ = nullptr;
  Timestamp start_{0};
  std::int64_t sample_ = 0;
};

/// Acquisition and recorder on a scripted device, in virtual time.
struct Bench {
  Bench() {
    auto made = std::make_unique<ScriptedDevice>();
    device = made.get();
    platform.emplace(std::move(made));
    EXPECT_TRUE(platform->start(clock));
    acquisition.emplace(*platform, clock);
    auto store = storage::open_store(folder.path("c.db"), storage::OpenMode::create).value();
    const storage::PatientRecord patient = store->add_patient("P-1").value();
    record.patient_id = patient.id;
    record.started_utc = "2026-03-01T09:30:00Z";
    record.rate_Hz = 100.0;
    record.id = store->begin_session(record).value();
    recorder.emplace(std::make_unique<SessionWriter>(std::move(store), patient, record,
                                                     std::vector<storage::SessionAnswer>(), true),
                     record, acquisition->records(), false);
  }
  void run(double seconds) {
    for (int k = 0; k < std::lround(100.0 * seconds); ++k) {
      EXPECT_TRUE(acquisition->tick());
      recorder->pump();
    }
  }
  PreparationOutcome zero(bool accept_changed = false) {
    asked = {};
    asked.accept_changed = accept_changed;
    EXPECT_TRUE(
        acquisition->commands().push({.kind = Command::Kind::prepare, .preparation = &asked}));
    run(1.1);
    return recorder->take_news().at(0).prepared.value();
  }
  void trial() {
    auto& setup = *setups.emplace_back(std::make_unique<PlatformTrial>());
    setup.spec = short_rest();
    setup.task = tasks::make_task(setup.spec, tasks::TaskContext{}).value();
    setup.record.session_id = record.id;
    setup.record.number = static_cast<int>(setups.size());
    EXPECT_TRUE(acquisition->commands().push({.kind = Command::Kind::begin, .setup = &setup}));
    run(1.1);
    EXPECT_TRUE(recorder->take_news().at(0).trial);
  }
  std::vector<storage::TrialRecord> trials() {
    return storage::open_store(folder.path("c.db"), storage::OpenMode::read_only)
        .value()
        ->trials(record.id)
        .value();
  }

  test::TemporaryFolder folder;
  ManualClock clock;
  ScriptedDevice* device = nullptr;
  std::optional<ForcePlatform> platform;
  InstrumentZero asked;
  storage::SessionRecord record;
  std::optional<Acquisition> acquisition;
  std::optional<Recorder> recorder;
  std::vector<std::unique_ptr<PlatformTrial>> setups;
};

TEST(ZeroDrift, BeyondTheLimitMarksTheTrialsBetweenTwoZerosAndNoOthers) {
  Bench bench;
  EXPECT_TRUE(bench.zero().accepted);
  bench.trial();
  bench.device->wrench_C[2].force.y() = -0.3;
  EXPECT_FALSE(bench.zero().record.drifted) << "below the limit of 0.4 N";
  bench.trial();
  bench.trial();
  bench.device->wrench_C[2].force.y() = -0.9;
  const auto drifted = bench.zero();
  EXPECT_TRUE(drifted.accepted) << "nothing automatic: the new zero is used, the trials are marked";
  EXPECT_TRUE(drifted.record.drifted);
  EXPECT_NE(english(drifted.remark).find("0.6 N"), std::string::npos) << english(drifted.remark);
  bench.trial();
  const auto trials = bench.trials();
  ASSERT_EQ(trials.size(), 4u);
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(trials[0].drift.at("drift_N"), 0.3, kRounding);
  EXPECT_FALSE(trials[0].drifted);
  for (const int between : {1, 2}) {
    EXPECT_WITHIN(trials[static_cast<std::size_t>(between)].drift.at("drift_N"), 0.6, kRounding);
    EXPECT_TRUE(trials[static_cast<std::size_t>(between)].drifted);
  }
  EXPECT_FALSE(trials[3].drift.contains("drift_N")) << "no zero followed";
  EXPECT_FALSE(trials[3].drifted);
}

TEST(ZeroDrift, ARefusedZeroMarksNothingAndAConfirmedOneDoes) {
  Bench bench;
  EXPECT_TRUE(bench.zero().accepted);
  bench.trial();
  bench.device->wrench_C[0].force.z() = 5.0;
  EXPECT_TRUE(bench.zero().only_changed);
  EXPECT_FALSE(bench.trials()[0].drift.contains("drift_N"));
  EXPECT_TRUE(bench.zero(true).accepted);
  EXPECT_TRUE(bench.trials()[0].drifted);
}

TEST(NetPush, OfASqueezeIsNothingAndOfAnArmIsItsForce) {
  FingerFrame frame;
  frame.wrench_C[0].force.z() = 6.0;
  frame.wrench_C[1].force.z() = 4.0;
  frame.wrench_C[2].force.z() = 2.0;
  constexpr double kRounding = 1e-12;
  auto push = net_push(Platform(), frame, 6.0);
  ASSERT_TRUE(push.known);
  EXPECT_WITHIN(push.share_of_grip_percent.value(), 0.0, kRounding);
  frame.wrench_C[0].force.z() += 3.0;  // the arm pushes the thumb's support along +x
  push = net_push(Platform(), frame, 6.0);
  EXPECT_WITHIN(push.wrench_P.force.x(), 3.0, kRounding);
  EXPECT_WITHIN(push.share_of_grip_percent.value(), 50.0, kRounding);
  EXPECT_FALSE(net_push(Platform(), frame, 0.1).share_of_grip_percent.has_value());
  frame.flags[1] = bit(SampleFlag::missing);
  EXPECT_FALSE(net_push(Platform(), frame, 6.0).known) << "nothing is invented";
}

TEST(Recorded, NetPushHealthAndTimingStandWithTheTrial) {
  Bench bench;
  bench.device->wrench_C[0].force.x() = 2.0;
  bench.trial();
  const auto trial = bench.trials().at(0);
  const auto signals = storage::open_store(bench.folder.path("c.db"), storage::OpenMode::read_only)
                           .value()
                           ->signals(trial)
                           .value();
  EXPECT_EQ(signals.column("net_fy_N")[5], 2.0) << "x of the thumb's contact is y of the platform";
  EXPECT_TRUE(std::isnan(signals.column("net_push_percent")[5])) << "no grip";
  for (const char* counter :
       {"good", "invalid", "torn", "duplicate", "late", "lost", "stale", "saturated", "overload",
        "status_errors", "restarts", "foreign_frames", "kernel_drops", "overflows", "error_frames",
        "unsent", "fault"})
    EXPECT_NE(trial.health_json.find("\"" + std::string(counter) + "\""), std::string::npos)
        << counter;
  EXPECT_NE(trial.timing_json.find("\"period\": {\"count\": 99, \"median_s\": 0.01"),
            std::string::npos)
      << trial.timing_json;
}

TEST(Acquisition, AZeroAndTheTimingAllocateNothing) {
  Bench bench;
  ASSERT_TRUE(bench.acquisition->tick());
  const auto before = test::allocations();
  ASSERT_TRUE(bench.acquisition->commands().push(
      {.kind = Command::Kind::prepare, .preparation = &bench.asked}));
  for (int frame = 0; frame < 300; ++frame) ASSERT_TRUE(bench.acquisition->tick());
  EXPECT_EQ(test::allocations() - before, 0u);
  EXPECT_TRUE(bench.platform->snapshots().read().zeroed);
}

TEST(Thresholds, AreStoredAndTheStoredTrialMovesTheObjectAgainToTheBit) {
  Clinic clinic;
  auto session = clinic.open("sim://healthy?seed=5");
  zero(*session, kEmpty);
  trial(*session, short_rest());
  trial(*session, library_task("maximum_grip.toml"));
  const double maximum_N = session->known().maximum_force_N().value();
  ASSERT_GT(maximum_N, 16.0);
  trial(*session, library_task("two_target.toml"));
  session.reset();

  const auto store = clinic.store();
  const auto stored = store->trials(clinic.last_session().id).value().back();
  for (const char* name : test::every(platform::kThreshold_N))
    EXPECT_EQ(stored.references.at(name), 0.8);
  const auto signals = store->signals(stored).value();
  Scene scene = for_hand(parse_scene(stored.scene_text, "stored").value(), Hand::right);
  for (auto& contact : scene.contacts)
    contact.threshold_N = stored.references.at(platform::kThreshold_N[index_of(contact.finger)]);
  const auto plan = Plan::compile(scene, 0.01).value();
  ObjectState state = plan.initial_state();
  const auto x_m = signals.column("actual_x_m");
  const auto y_m = signals.column("actual_y_m");
  const auto angle_rad = signals.column("actual_angle_rad");
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    ASSERT_EQ(state.X_WO.p.x(), x_m[row]) << row;
    ASSERT_EQ(state.X_WO.p.y(), y_m[row]) << row;
    ASSERT_EQ(state.angle_rad, angle_rad[row]) << row;
    FingerWrenches wrench_C{};
    for (std::size_t f = 0; f < kFingerCount; ++f)
      for (const int axis : {0, 1, 2}) {
        const std::string finger(kFingerNames[f]);
        wrench_C[f].force[axis] = signals.column(finger + "_f" + "xyz"[axis] + "_N")[row];
        wrench_C[f].torque[axis] = signals.column(finger + "_t" + "xyz"[axis] + "_Nm")[row];
      }
    const GraspWrench grasp = plan.grasp(wrench_C, state);
    plan.move(grasp, state);
  }
}

TEST(Session, APlatformMountedForTheOtherHandIsRefusedInWords) {
  EXPECT_TRUE(check_hand("can://can0", "left", Hand::left));
  const auto refused = check_hand("can://can0", "left", Hand::right);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find(
                "the device is set up for the left hand, the session for the right"),
            std::string::npos);
  EXPECT_NE(english(refused.error().remedy).find("turn the platform"), std::string::npos);
}

TEST(Session, RequiredRealTimeThatIsRefusedLeavesNoTrace) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    int status = 1;
    {
      Clinic clinic;
      SessionConfig c;
      c.database = clinic.database;
      c.patient_code = "TEST-01";
      c.device_uri = "sim://healthy";
      c.library = kLibrary;
      c.realtime = Realtime::require;
      const auto refused = Session::open(c);
      const auto patients = clinic.store()->patients();
      if (!refused && refused.error().field == "--realtime" && patients && patients->empty())
        status = 0;
    }
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace isograsp::session::zero_and_rest_test
