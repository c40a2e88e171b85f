// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions of a pair of hands in software on two platforms: what was done is what is measured.
#include <gtest/gtest.h>

#include "hand/platform_records.hpp"
#include "hand/two_hands_columns.hpp"
#include "session/open_two_platforms.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::two_hands_session_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

std::string pair_uri(const std::string& name, int seed) {
  const std::string uri = "sim://pair?file=" + name + "&seed=" + std::to_string(seed);
  return test::must(two_platforms_uri({uri, uri}));
}

/// Of a session with a pair of hands in software.
SessionConfig pair_config(const std::string& database, const std::string& pair, int seed = 7) {
  SessionConfig config;
  config.database = database;
  config.patient_code = "P-2";
  config.hand.reset();
  config.device_uri = pair_uri(pair, seed);
  config.library = kLibrary;
  config.virtual_time = true;
  config.clock_is_right = true;  // sessions in virtual time end ahead of every clock
  return config;
}

/// Such a session, and the side of the person that is affected.
struct PairSession {
  explicit PairSession(const std::string& pair, storage::Side affected, int seed = 7)
      : database(folder.path() + "/clinic.db") {
    {
      auto store = test::must(storage::open_store(database, storage::OpenMode::create));
      const auto patient = test::must(store->add_patient("P-2", ""));
      storage::PatientProfile profile;
      profile.affected = affected;
      test::must(store->set_profile(patient.id, profile));
    }
    const auto protocol =
        test::must(read_protocol(kLibrary + "/protocols/two_hands_short.toml", kLibrary));
    const auto session = test::must(Session::open(pair_config(database, pair, seed)));
    result = test::must(run_protocol(*session, protocol, {}));
    session->close();
  }
  [[nodiscard]] double value(const char* name, const char* channel) const {
    for (const auto& trial : result.trials)
      for (const Measure& measure : trial.measures)
        if (measure.name == name && measure.channel == channel && measure.value)
          return *measure.value;
    throw std::runtime_error(std::string("there is no ") + name + " of " + channel);
  }

  test::TemporaryFolder folder;
  std::string database;
  ProtocolResult result;
};

TEST(TwoHandsSession, APareticHandSharesByWhatItCanDoAndLagsWithItsSign) {
  for (const auto& [pair, side, channel] :
       test::every(std::vector<std::tuple<std::string, storage::Side, const char*>>{
           {"paretic_left", storage::Side::left, "left"},
           {"paretic_right", storage::Side::right, "right"}})) {
    const PairSession session(pair, side);
    ASSERT_EQ(session.result.trials.size(), 3U);
    EXPECT_TRUE(session.result.left_out.empty());
    const double left_N = session.value("maximum_force", "left");
    const double right_N = session.value("maximum_force", "right");
    const double affected_N = side == storage::Side::left ? left_N : right_N;
    // The law of a pair that shares by capacity; the noise of a paretic hand, and what it cannot
    // follow of a sine, leave some percent.
    constexpr double kOff_percent = 4.0;
    EXPECT_NEAR(session.value("share_affected", channel), 100.0 * affected_N / (left_N + right_N),
                kOff_percent);
    EXPECT_GT(session.value("hand_lag", channel), 0.05);
  }
}

TEST(TwoHandsSession, IsStoredWithBothHandsBothDevicesAndWhatTheyDid) {
  const PairSession session("paretic_left", storage::Side::left);
  auto store = test::must(storage::open_store(session.database, storage::OpenMode::read_only));
  const auto patient = test::must(store->find_patient("P-2"));
  const auto sessions = test::must(store->sessions(patient->id));
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].hand, std::nullopt);
  EXPECT_TRUE(sessions[0].simulated);
  EXPECT_EQ(sessions[0].sensors.size(), 6U);
  const auto trials = test::must(store->trials(sessions[0].id));
  ASSERT_EQ(trials.size(), 3U);
  const auto signals = test::must(store->signals(trials[2]));
  test::AtLeast rows(1000);
  const auto left = signals.column(columns::hand_grip.left);
  const auto right = signals.column(columns::hand_grip.right);
  const auto sum = signals.column(columns::sum_force_N);
  const auto skew = signals.column(columns::skew_s);
  for (std::size_t row = 0; row < signals.rows(); ++row) {
    EXPECT_EQ(left[row] + right[row], sum[row]);
    EXPECT_EQ(skew[row], 0.0);  // one clock, two devices in software
    ++rows;
  }
  EXPECT_TRUE(storage::value_of(trials[2].references, columns::hand_maximum_force_N.left));
}

TEST(TwoHandsSession, TheSameSeedGivesTheSameBits) {
  const PairSession once("paretic_left", storage::Side::left);
  const PairSession again("paretic_left", storage::Side::left);
  const PairSession other("paretic_left", storage::Side::left, 8);
  ASSERT_EQ(once.result.trials.size(), again.result.trials.size());
  for (std::size_t k = 0; k < once.result.trials.size(); ++k)
    EXPECT_EQ(once.result.trials[k].measures, again.result.trials[k].measures);
  EXPECT_NE(once.result.trials[2].measures, other.result.trials[2].measures);
}

TEST(TwoHandsSession, TheSensorsUnderBothHandsHaveNoiseOfTheirOwn) {
  const PairSession session("healthy", storage::Side::none);
  auto store = test::must(storage::open_store(session.database, storage::OpenMode::read_only));
  const auto preparations =
      test::must(store->preparations(test::must(store->recent_sessions(1)).at(0).id));
  const auto sd = platform::two_six_axes_of(preparations.at(0).columns, preparations.at(0).sd);
  ASSERT_TRUE(sd.has_value());
  for (std::size_t f = 0; f < kFingerCount; ++f) EXPECT_NE(sd->left[f], sd->right[f]);
}

TEST(TwoHandsSession, AResumedSessionKeepsSideAndCeilings) {
  const test::TemporaryFolder folder;
  SessionConfig config = pair_config(folder.path() + "/clinic.db", "paretic_left");
  config.create_database = true;
  const auto protocol =
      test::must(read_protocol(kLibrary + "/protocols/two_hands_short.toml", kLibrary));
  config.protocol_name = protocol.spec.name;
  config.protocol_text = protocol.spec.text;
  config.affected = Hand::left;
  config.ceiling_N = 30.0;
  config.ceilings_N.left = 4.0;
  test::must(Session::open(config))->close();
  config.affected.reset();
  config.ceiling_N.reset();
  config.ceilings_N = {};
  config.resume = true;
  const auto resumed = [&] {
    const auto session = test::must(Session::open(config));
    const tasks::TwoHandsReferences known = session->known().two_hands;
    session->close();
    return known;
  };
  const auto known = resumed();
  EXPECT_EQ(known.affected, Hand::left);
  EXPECT_EQ(known.of.left.ceiling_N, 4.0);
  EXPECT_EQ(known.of.right.ceiling_N, 30.0) << "the one of both";
  config.ceiling_N = 3.0;
  const auto stricter = resumed();
  EXPECT_EQ(stricter.of.left.ceiling_N, 3.0) << "said today of both";
  EXPECT_EQ(stricter.of.right.ceiling_N, 3.0);
}

TEST(TwoHandsSession, ACheckOfThePlatformsThatIsLeftOutForgetsTheOneBefore) {
  const test::TemporaryFolder folder;
  SessionConfig config = pair_config(folder.path() + "/clinic.db", "healthy");
  config.create_database = true;
  const auto session = test::must(Session::open(config));
  EXPECT_FALSE(session->known().two_hands.coupled.has_value());
  platforms_checked(*session, false);
  EXPECT_EQ(session->known().two_hands.coupled, false);
  platforms_checked(*session, std::nullopt);
  EXPECT_FALSE(session->known().two_hands.coupled.has_value());
}

TEST(TwoHandsSession, ASideThatIsNotThatOfTheRecordIsRefused) {
  const PairSession known("paretic_left", storage::Side::left);
  SessionConfig config = pair_config(known.database, "paretic_left");
  config.affected = Hand::right;
  const auto refused = Session::open(config);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "affected") << refused.error().message();
  config.affected = Hand::left;
  EXPECT_TRUE(Session::open(config));
}

TEST(TwoHandsSession, WithOneDeviceOrOneHandIsRefusedAndNothingIsWritten) {
  const test::TemporaryFolder folder;
  SessionConfig config = pair_config(folder.path() + "/clinic.db", "healthy");
  config.create_database = true;
  config.device_uri = "sim://healthy";
  EXPECT_FALSE(Session::open(config));
  config.hand = Hand::right;
  config.device_uri = pair_uri("healthy", 1);
  EXPECT_FALSE(Session::open(config));
  config.hand.reset();
  config.device_uri = test::must(two_platforms_uri({"sim://healthy?seed=1", "sim://healthy"}));
  EXPECT_FALSE(Session::open(config));
  config.device_uri = pair_uri("nobody", 1);
  EXPECT_FALSE(Session::open(config));
  EXPECT_FALSE(std::filesystem::exists(config.database));
}

}  // namespace
}  // namespace isograsp::session::two_hands_session_test
