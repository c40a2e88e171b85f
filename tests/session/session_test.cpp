// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "session/protocol/protocol_run.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/score.hpp"
#include "tasks/waveform.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::session_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

ReadyProtocol protocol(const std::string& name) {
  return read_protocol(find_in_library(kLibrary, "protocols", name).value(), kLibrary).value();
}

struct Clinic {
  Clinic() { EXPECT_TRUE(storage::open_store(database, storage::OpenMode::create)); }

  SessionConfig config(const std::string& device) const {
    SessionConfig c;
    c.database = database;
    c.patient_code = "TEST-01";
    c.device_uri = device;
    c.library = kLibrary;
    c.software_version = "test";
    c.virtual_time = true;
    return c;
  }

  ProtocolResult run(const std::string& device, const std::string& name) {
    auto session = Session::open(config(device));
    EXPECT_TRUE(session) << session.error().message();
    const auto result = run_protocol(**session, protocol(name), {});
    EXPECT_TRUE(result) << result.error().message();
    return result ? *result : ProtocolResult{};
  }

  std::unique_ptr<storage::SessionStore> store() const {
    return storage::open_store(database, storage::OpenMode::existing).value();
  }

  test::TemporaryFolder folder;
  std::string database = folder.path("clinic.db");
};

double value_of(const std::vector<Measure>& measures, const std::string& name) {
  for (const auto& measure : measures)
    if (measure.name == name && measure.value) return *measure.value;
  return std::nan("");
}

double value_in(const ProtocolResult& result, const std::string& name) {
  double value = std::nan("");
  for (const auto& trial : result.trials)
    if (const double v = value_of(trial.measures, name); !trial.trial.practice && !std::isnan(v))
      value = v;
  return value;
}

void expect_same(const std::vector<Measure>& a, const std::vector<Measure>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].channel, b[i].channel);
    EXPECT_EQ(a[i].value, b[i].value) << a[i].name;
    EXPECT_EQ(a[i].samples, b[i].samples);
    EXPECT_EQ(a[i].excluded, b[i].excluded);
  }
}

TEST(Session, TheDemonstrationProtocolIsCompletedByAHealthySimulatedPatient) {
  Clinic clinic;
  const auto result = clinic.run("sim://healthy?seed=7", "demonstration");
  for (const auto& outcome : test::every(result.trials))
    EXPECT_EQ(outcome.trial.status, storage::TrialStatus::completed) << outcome.trial.task_name;
  EXPECT_GT(value_in(result, "maximum_force"), 20.0);
  EXPECT_GT(value_in(result, "targets_reached"), 0.0);
}

TEST(Session, APareticPatientScoresWorseInBothTasks) {
  double healthy_error = 0, paretic_error = 0, healthy_reached = 0, paretic_reached = 0;
  for (const char* seed : {"1", "2", "3"}) {
    Clinic clinic;
    const auto healthy = clinic.run(std::string("sim://healthy?seed=") + seed, "demonstration");
    const auto paretic = clinic.run(std::string("sim://paretic?seed=") + seed, "demonstration");
    EXPECT_LT(value_in(paretic, "maximum_force"), value_in(healthy, "maximum_force"));
    healthy_error += value_in(healthy, "relative_rmse");
    paretic_error += value_in(paretic, "relative_rmse");
    healthy_reached += value_in(healthy, "path_efficiency");
    paretic_reached += value_in(paretic, "path_efficiency");
  }
  EXPECT_LT(healthy_error, paretic_error);
  EXPECT_GT(healthy_reached, paretic_reached);
}

TEST(Session, AHandOfOneNewtonDoesTheWholeBatteryOnSensorsThatResolveIt) {
  Clinic clinic;
  const auto fine = clinic.run("sim://severe?seed=3&resolution=0.005", "battery");
  EXPECT_LT(value_in(fine, "maximum_force"), 3.0);
  EXPECT_TRUE(fine.left_out.empty()) << english(fine.left_out.front());
  const auto coarse = Clinic().run("sim://severe?seed=3", "battery_core");
  ASSERT_FALSE(coarse.left_out.empty());
  EXPECT_NE(english(coarse.left_out.front()).find("choose a level of at least"), std::string::npos);
}

TEST(Session, LiveIsOffline) {
  Clinic clinic;
  const auto result = clinic.run("sim://paretic?seed=5&drop=0.002", "demonstration");
  const auto store = clinic.store();
  const auto patient = store->find_patient("TEST-01").value().value();
  const auto session = store->sessions(patient.id).value().at(0);
  const auto trials = store->trials(session.id).value();
  ASSERT_EQ(trials.size(), result.trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto signals = store->signals(trials[i]).value();
    const auto path = clinic.folder.path("trial.csv");
    ASSERT_TRUE(write_signals(signals, path));
    const auto spec = tasks::parse_task(trials[i].task_text, "stored task").value();
    expect_same(result.trials[i].measures, tasks::score(spec, read_signals(path).value()));
    expect_same(result.trials[i].measures, store->measures(trials[i].id).value());
    EXPECT_TRUE(trials[i].drift.contains("drift_N")) << "the protocol ends with an empty zero";
    EXPECT_FALSE(trials[i].drifted);
  }
}

TEST(Session, TheSameSeedGivesTheSameSignalsBitForBit) {
  std::vector<Signals> runs[2];
  for (auto& run : runs) {
    Clinic clinic;
    (void)clinic.run("sim://paretic?seed=11&drop=0.001", "demonstration");
    const auto store = clinic.store();
    const auto patient = store->find_patient("TEST-01").value().value();
    for (const auto& trial : store->trials(store->sessions(patient.id).value().at(0).id).value())
      run.push_back(store->signals(trial).value());
  }
  ASSERT_EQ(runs[0].size(), runs[1].size());
  for (std::size_t i = 0; i < runs[0].size(); ++i) {
    ASSERT_EQ(runs[0][i].names(), runs[1][i].names());
    for (const auto& name : test::every(runs[0][i].names())) {
      const auto a = runs[0][i].column(name);
      const auto b = runs[1][i].column(name);
      ASSERT_EQ(a.size(), b.size());
      EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << name;
    }
  }
}

TEST(Session, ATrialThatLosesItsDeviceIsKeptAndMarkedNeverScoredAsFailure) {
  Clinic clinic;
  auto session = Session::open(clinic.config("sim://healthy?seed=1&drop=1.0"));
  ASSERT_TRUE(session);
  const auto result = run_protocol(**session, protocol("demonstration"), {});
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message().find("zero was refused"), std::string::npos)
      << result.error().message();
}

TEST(Session, RefusesAnUnknownPatientModelAWrongHandAndAnUnknownScheme) {
  Clinic clinic;
  for (const auto& [uri, message] : {std::pair{"sim://nobody", "no simulated patient 'nobody'"},
                                     {"sim://healthy?hand=left", "set up for the left hand"},
                                     {"quantum://x", "quantum"},
                                     {"sim://healthy?sed=7", "sed"}}) {
    const auto session = Session::open(clinic.config(uri));
    ASSERT_FALSE(session) << uri;
    EXPECT_EQ(session.error().code, Error::Code::bad_input);
    EXPECT_NE(session.error().message().find(message), std::string::npos)
        << session.error().message();
  }
}

TEST(Session, WhatWasAskedBeforeStandsWithItFromTheStart) {
  const Clinic clinic;
  SessionConfig config = clinic.config("sim://healthy?seed=7");
  config.answers = {{"screening", "pain", "2"}, {"posture", "seat", "chair"}};
  const auto session = Session::open(config);
  ASSERT_TRUE(session) << session.error().message();
  EXPECT_EQ(clinic.store()->answers((*session)->known().record.id).value(), config.answers);
}

TEST(Session, WhatIsAnsweredAndShownOnTheWayStandsWithIt) {
  const Clinic clinic;
  SessionConfig config = clinic.config("sim://healthy?seed=7");
  auto session = Session::open(config);
  ASSERT_TRUE(session) << session.error().message();
  const std::vector<storage::SessionAnswer> answers{{"posture", "elbow_deg", "90"}};
  EXPECT_TRUE((*session)->answer(answers));
  EXPECT_EQ((*session)->answer({{"posture", "", "90"}}).error().field, "item");
  ASSERT_TRUE((*session)->start_zero({true}));
  (void)(*session)->wait_for_news();
  const auto maximum = find_in_library(kLibrary, "tasks", "maximum_grip").value();
  const auto spec = tasks::parse_task(*read_text(maximum), maximum).value();
  for (const bool seen : {true, false}) {
    ASSERT_TRUE((*session)->start_trial(spec, false));
    if (seen) (*session)->shown({0.021, 0.8, 0.6});
    (void)(*session)->wait_for_news();
  }
  const auto id = (*session)->known().record.id;
  session->reset();
  EXPECT_EQ(clinic.store()->answers(id).value(), answers);
  const auto trials = clinic.store()->trials(id).value();
  ASSERT_EQ(trials.size(), 2u);
  EXPECT_EQ(trials[0].display_age_s, 0.021);
  EXPECT_EQ(trials[0].references.at("visual_gain_deg_per_N"), 0.8);
  EXPECT_EQ(trials[0].viewing_distance_m, 0.6);
  EXPECT_FALSE(trials[1].display_age_s) << "nobody looked at that one";
}

TEST(Session, AnswersThatMakeNoSenseAreRefusedBeforeAnythingIsWritten) {
  const Clinic clinic;
  SessionConfig config = clinic.config("sim://healthy?seed=7");
  config.answers = {{"screening", "", "2"}};
  const auto refused = Session::open(config);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "item");
  EXPECT_TRUE(clinic.store()->patients().value().empty());
}

TEST(Session, RealTimeIsNeverRecordedIntoAScratchFile) {
  Clinic clinic;
  SessionConfig config = clinic.config("sim://healthy");
  config.scratch_database = true;
  EXPECT_TRUE(Session::open(config));
  config.virtual_time = false;
  const auto session = Session::open(config);
  ASSERT_FALSE(session);
  EXPECT_NE(session.error().message().find("scratch"), std::string::npos);
}

TEST(Session, AProtocolWhoseStepsLackWhatTheyNeedIsRefusedBeforeASessionBegins) {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& steps) {
    return read_protocol(
        folder.write("p.toml", "format = \"isograsp-protocol-1\"\nname = \"P\"\n" + steps),
        kLibrary);
  };
  const std::string rest = "[[step]]\nkind = \"task\"\ntask = \"resting_force.toml\"\n";
  const std::string maximum = "[[step]]\nkind = \"task\"\ntask = \"maximum_grip.toml\"\n";
  const std::string sine = "[[step]]\nkind = \"task\"\ntask = \"grip_sine.toml\"\n";
  EXPECT_TRUE(read(rest + maximum + sine));
  for (const auto& [steps, message] :
       {std::pair{rest + sine, "step[2].task: the target is a share of the maximum of 'grip'"},
        {maximum + sine, "step[1].task: a maximum is measured above the resting force"}}) {
    const auto refused = read(steps);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message().find(message), std::string::npos)
        << refused.error().message();
  }
}

TEST(Session, TheStoredSeedOfATrialTellsItsParallelFormAndGivesItsTargetAgain) {
  Clinic clinic;
  const auto result = clinic.run("sim://healthy?seed=7", "demonstration");
  const auto store = clinic.store();
  int sines = 0;
  for (const auto& outcome : test::every(result.trials)) {
    const tasks::TaskSpec spec = tasks::parse_task(outcome.trial.task_text, "stored").value();
    const auto* tracking = spec.kind.get_if<tasks::ForceTrackingSpec>();
    if (tracking == nullptr) continue;
    ASSERT_EQ(tracking->waveform.forms, 2);
    ASSERT_NE(outcome.trial.seed, 0u);
    const auto signals = store->signals(outcome.trial).value();
    const auto target_N = signals.column("target_force_N");
    const double maximum_N = outcome.trial.references.at("maximum_force_N");
    const double start = tasks::form_of(tracking->waveform, outcome.trial.seed) == 0
                             ? tracking->least
                             : tracking->most;
    constexpr double kRounding_N = 1e-12;
    EXPECT_WITHIN(target_N.front(), start * maximum_N, kRounding_N);
    const auto wave =
        tasks::samples_of(tracking->waveform, tracking->duration_s, 0.01, outcome.trial.seed);
    const auto lead_in = static_cast<std::size_t>(std::lround(tracking->lead_in_s / 0.01));
    for (std::size_t k = 0; k < wave.size(); ++k)
      ASSERT_WITHIN(target_N[lead_in + k],
                    std::lerp(tracking->least, tracking->most, wave[k]) * maximum_N, kRounding_N);
    ++sines;
  }
  EXPECT_GT(sines, 0);
}

TEST(Session, ALeftHandedSimulatedSessionNamesNoOtherHand) {
  Clinic clinic;
  auto config = clinic.config("sim://healthy");
  config.hand = Hand::left;
  const auto session = Session::open(config);
  ASSERT_TRUE(session);
  EXPECT_EQ((*session)->known().record.hand, Hand::left);
  EXPECT_EQ((*session)->known().record.device_description.find("right"), std::string::npos);
}

TEST(Session, ATrialThatAFaultEndedSaysSo) {
  Clinic clinic;
  auto session = Session::open(clinic.config("sim://healthy?seed=4&drop=0.7"));
  ASSERT_TRUE(session);
  const test::TemporaryFolder folder;
  const auto path = folder.write("p.toml",
                                 "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\n"
                                 "kind = \"task\"\ntask = \"resting_force.toml\"\n");
  const auto result = run_protocol(**session, read_protocol(path, kLibrary).value(), {});
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message().find("Stopped after a device fault."), std::string::npos)
      << result.error().message();
}

TEST(Session, RunsInRealTimeOnThreeThreads) {
  Clinic clinic;
  auto config = clinic.config("sim://healthy?seed=2");
  config.virtual_time = false;
  auto session = Session::open(config);
  ASSERT_TRUE(session) << session.error().message();
  ASSERT_TRUE((*session)->start_zero({true}));
  const auto zero = (*session)->wait_for_news();
  ASSERT_EQ(zero.size(), 1u);
  ASSERT_TRUE(zero[0].prepared && zero[0].prepared->accepted) << english(zero[0].prepared->reason);
  const auto spec = tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Rest\"\nkind = \"rest\"\n"
      "instruction = \"Relax.\"\nduration_s = 1.5\n",
      "short.toml");
  ASSERT_TRUE(spec) << spec.error().message();
  ASSERT_TRUE((*session)->start_trial(*spec, false));
  EXPECT_FALSE((*session)->start_trial(*spec, false)) << "one trial at a time";
  const auto news = (*session)->wait_for_news();
  ASSERT_EQ(news.size(), 1u);
  ASSERT_TRUE(news[0].trial);
  EXPECT_EQ(news[0].trial->trial.status, storage::TrialStatus::completed);
  EXPECT_EQ(news[0].trial->trial.dropped, 0);
  EXPECT_GE(news[0].trial->trial.samples, 150);
  EXPECT_EQ((*session)->snapshot().recorder_dropped, 0u);
}

}  // namespace
}  // namespace isograsp::session::session_test
