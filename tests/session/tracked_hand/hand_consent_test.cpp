// SPDX-License-Identifier: GPL-3.0-or-later
// No camera is opened on a person before a lawful basis is on record; joints are kept only where
// research was agreed to; a recorded session played again has the same bits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/column.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "storage/access/access.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "tasks/score.hpp"
#include "tests/session/tracked_hand/scripted_hands.hpp"
#include "tests/support/every.hpp"
#include "tests/support/hand_recording.hpp"
#include "tests/support/must.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/scripted_hand.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::hand_consent_test {
namespace {

using test::must;
using test::TemporaryFolder;

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

/// How often the camera was opened.
int camera_starts = 0;

/// A camera that sees a still hand.
class CountedCamera final : public HandDevice {
 public:
  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return hands_.info(); }
  [[nodiscard]] HandHealth health() const noexcept override { return {}; }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    ++camera_starts;
    return hands_.start(clock);
  }
  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    return hands_.read(deadline, out);
  }
  void stop() noexcept override { hands_.stop(); }

 private:
  test::ScriptedHands hands_{{}, 0.01};
};

Result<std::unique_ptr<Apparatus>> open_camera(const ApparatusRequest& request) {
  return std::unique_ptr<Apparatus>(std::make_unique<TrackedHand>(
      std::make_unique<CountedCamera>(), HandSetup{request.hand, test::usual_hand(), false}));
}
constexpr std::array<ApparatusRow, 1> kCameras{
    {{"camera", "", "", open_camera, TrackedHand::kKind}}};

SessionConfig of_camera(const std::string& database) {
  SessionConfig config;
  config.database = database;
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "camera://here";
  config.library = kLibrary;
  config.apparatuses = kCameras;
  config.realtime = Realtime::off;
  return config;
}

void say(const std::string& database, const char* purpose, const char* basis, const char* state) {
  const auto access = must(storage::Access::open(database));
  must(storage::add_consent(*access, "P-1", {0, "2026-03-05", purpose, basis, state, "", "", ""}));
}

TEST(HandConsent, WithoutALawfulBasisOnRecordNoStreamIsOpenedAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string database = folder.path("clinic.db");
  camera_starts = 0;
  const auto none = Session::open(of_camera(database));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().field, "consent");
  EXPECT_FALSE(std::filesystem::exists(database));

  must(must(storage::open_store(database, storage::OpenMode::create))->add_patient("P-1"));
  EXPECT_FALSE(Session::open(of_camera(database))) << "the person is known, a basis is not";
  say(database, "treatment", "consent", "refused");
  EXPECT_FALSE(Session::open(of_camera(database)));
  EXPECT_EQ(camera_starts, 0);

  say(database, "treatment", "care", "given");
  must(Session::open(of_camera(database)))->close();
  EXPECT_EQ(camera_starts, 1) << "consent is not the only lawful basis";

  say(database, "treatment", "care", "withdrawn");
  EXPECT_FALSE(Session::open(of_camera(database)));
  EXPECT_EQ(camera_starts, 1);
}

TEST(HandConsent, ABasisThatIsWithdrawnElsewhereEndsTheSessionAndItsCamera) {
  const TemporaryFolder folder;
  const std::string database = folder.path("clinic.db");
  must(must(storage::open_store(database, storage::OpenMode::create))->add_patient("P-1"));
  say(database, "treatment", "consent", "given");
  const auto session = must(Session::open(of_camera(database)));
  session->let_pass(1.5);  // it was looked at once
  EXPECT_FALSE(session->failure());
  say(database, "treatment", "consent", "withdrawn");
  constexpr double kAtMost_s = 30.0;  // it is looked at once a second
  session->let_pass(kAtMost_s);       // ends at once when the session has failed
  const auto failure = session->failure();
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->field, "consent");
  test::AtLeast told(1);
  for (const SessionNews& news : session->take_news())
    if (news.failure) ++told;
  session->close();
}

/// Runs the protocol of opening with a recording; measures of its trial.
ProtocolResult run_recording(const std::string& database, const std::string& recording) {
  SessionConfig config;
  config.database = database;
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "replay://" + recording + "?speed=0";
  config.library = kLibrary;
  config.virtual_time = true;
  const auto protocol = must(read_protocol(kLibrary + "/protocols/hand_opens.toml", kLibrary));
  const auto session = must(Session::open(config));
  auto result = must(run_protocol(*session, protocol, {}));
  session->close();
  return result;
}

std::pair<storage::TrialRecord, Signals> stored_trial(const std::string& database) {
  const auto store = must(storage::open_store(database, storage::OpenMode::existing));
  const auto patient = must(store->find_patient("P-1"));
  const auto trials = must(store->trials(must(store->sessions(patient->id)).front().id));
  return {trials.front(), must(store->signals(trials.front()))};
}

TEST(HandReplay, ARecordedSessionPlayedAgainHasTheSameBitsAndItsScoreIsThatOfItsSignals) {
  const TemporaryFolder folder;
  const std::string recording = test::write_hand_recording(folder.path("hand.csv"), 120.0);
  EXPECT_EQ(kind_of_apparatus("replay://" + recording), TrackedHand::kKind);
  const auto first = run_recording(folder.path("a.db"), recording);
  const auto second = run_recording(folder.path("b.db"), recording);
  ASSERT_EQ(first.trials.size(), 1u);
  EXPECT_TRUE(first.left_out.empty());
  const auto [trial, signals] = stored_trial(folder.path("a.db"));
  const auto [again, same] = stored_trial(folder.path("b.db"));
  ASSERT_EQ(signals.names(), same.names());
  int columns = 0;
  for (const std::string& name : test::every(signals.names())) {
    if (name == columns::lateness_s || name == columns::compute_s) continue;
    const auto a = signals.column(name);
    const auto b = same.column(name);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) << name;
    ++columns;
  }
  EXPECT_GT(columns, 30);
  EXPECT_EQ(first.trials.front().measures, second.trials.front().measures);
  const auto spec = must(tasks::parse_task(trial.task_text, "stored"));
  EXPECT_EQ(tasks::score(spec, signals), first.trials.front().measures);
}

TEST(HandReplay, JointsAreKeptOnlyWithConsentToResearch) {
  const TemporaryFolder folder;
  const std::string recording = test::write_hand_recording(folder.path("hand.csv"), 120.0);
  const auto keeps_joints = [&](const std::string& database) {
    run_recording(database, recording);
    const auto trial = stored_trial(database).first;
    return std::any_of(trial.groups.begin(), trial.groups.end(),
                       [](const auto& group) { return group.name == "joints"; });
  };
  EXPECT_FALSE(keeps_joints(folder.path("none.db")));
  const std::string agreed = folder.path("agreed.db");
  must(must(storage::open_store(agreed, storage::OpenMode::create))->add_patient("P-1"));
  say(agreed, "research", "consent", "given");
  EXPECT_TRUE(keeps_joints(agreed));
}

TEST(HandInSoftware, PassesItsEntryTestAndIsScoredAsItsSignalsAre) {
  const TemporaryFolder folder;
  SessionConfig config;
  config.database = folder.path("clinic.db");
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "sim://hand?user=healthy&seed=3";
  config.library = kLibrary;
  config.virtual_time = true;
  const auto protocol = must(read_protocol(
      "format = \"isograsp-protocol-1\"\nname = \"First\"\n[[step]]\nkind = \"hand_entry\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"virtual_place_first.toml\"\npractice = true\n",
      kLibrary + "/protocols/first.toml", kLibrary));
  const auto session = must(Session::open(config));
  const auto result = must(run_protocol(*session, protocol, {}));
  session->close();
  ASSERT_EQ(result.trials.size(), 1u)
      << (result.left_out.empty() ? std::string() : english(result.left_out.front()));
  const auto [trial, signals] = stored_trial(config.database);
  const auto spec = must(tasks::parse_task(trial.task_text, "stored"));
  EXPECT_EQ(tasks::score(spec, signals), result.trials.front().measures);
  EXPECT_EQ(result.trials.front().measures.front().channel, "full");
}

TEST(HandReplay, ARecordingOfARealHandGoesTheWholeWay) {
  const std::string recording = test::recorded_data() + "/hand/leap_grab.csv";
  if (!std::filesystem::exists(recording)) GTEST_SKIP() << "the recordings are not there";
  const TemporaryFolder folder;
  SessionConfig config;
  config.database = folder.path("clinic.db");
  config.create_database = true;
  config.patient_code = "P-1";
  config.device_uri = "replay://" + recording + "?speed=0";
  config.library = kLibrary;
  config.virtual_time = true;
  const auto session = must(Session::open(config));
  const auto* hand = hand_of(*session);
  ASSERT_NE(hand, nullptr);
  session->let_pass(0.5);
  must(session->start_trial(must(load_task(kLibrary + "/tasks/hand_opening.toml")), false));
  static_cast<void>(session->wait_for_news());
  const auto* now = hand_of(*session);
  EXPECT_GT(now->health.counters.rows, 10u);
  EXPECT_TRUE(now->pose.has_value());
  constexpr double kOtherSize_m = 0.03;  // the hand is not of usual size
  EXPECT_LT(now->pose->residual_m, kOtherSize_m);
  session->close();
}

}  // namespace
}  // namespace isograsp::session::hand_consent_test
