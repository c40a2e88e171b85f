// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions in which a pair of hands in software, as points, carries a box.
#include <gtest/gtest.h>

#include "hand/two_hands_columns.hpp"
#include "session/library/library.hpp"
#include "session/two_platforms/carried_by_hands.hpp"
#include "storage/access/open_store.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::carry_session_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

struct CarrySession {
  explicit CarrySession(const std::string& pair, const std::string& task = "two_hands_carry",
                        int seed = 7) {
    const std::string uri = "sim://pair?file=" + pair + "&seed=" + std::to_string(seed);
    database = folder.path() + "/clinic.db";
    std::string steps =
        "format = \"isograsp-protocol-1\"\nname = \"Carry\"\n"
        "[[step]]\nkind = \"instrument_zero\"\n";
    for (const std::string& one :
         {std::string("two_hands_rest"), std::string("two_hands_maximum"), task})
      steps += "[[step]]\nkind = \"task\"\ntask = \"" + one + ".toml\"\n";
    const auto protocol = folder.write("carry.toml", steps);
    result =
        test::run_whole({database, "P-2", test::must(two_platforms_uri({uri, uri})), protocol});
  }
  [[nodiscard]] const std::vector<Measure>& measures() const {
    return result.trials.at(2).measures;
  }
  [[nodiscard]] double value(const char* name, const char* channel) const {
    for (const Measure& measure : measures())
      if (measure.name == name && measure.channel == channel && measure.value)
        return *measure.value;
    throw std::runtime_error(std::string("there is no ") + name + " of " + channel);
  }

  test::TemporaryFolder folder;
  std::string database;
  ProtocolResult result;
};

TEST(CarrySession, HealthyHandsPlaceTheBoxWithEachTechnique) {
  for (const char* how :
       test::every(std::vector{"clutch", "bubble", "clutch_pinch", "bubble_pinch"})) {
    const CarrySession session("healthy", std::string("two_hands_carry_") + how);
    ASSERT_EQ(session.result.trials.size(), 3U) << how;
    EXPECT_EQ(session.value("targets_reached", "targets"), 4.0) << how;
    EXPECT_LE(session.value("drops", "contact"), 2.0) << how;
  }
}

TEST(CarrySession, AHandOfAThirdOfTheStrengthCarriesAsTheOtherOneDoes) {
  for (const char* pair : test::every(std::vector{"paretic_left", "paretic_right"})) {
    const CarrySession session(pair);
    ASSERT_EQ(session.result.trials.size(), 3U) << pair;
    EXPECT_GE(session.value("targets_reached", "targets"), 6.0) << pair;
  }
}

TEST(CarrySession, AStoredTrialIsReplayedToTheLastBit) {
  for (const char* how : test::every(std::vector{"bubble", "clutch_pinch"})) {
    const CarrySession session("healthy", std::string("two_hands_carry_") + how);
    auto store = test::must(storage::open_store(session.database, storage::OpenMode::read_only));
    const auto trials = test::must(store->trials(test::must(store->recent_sessions(1)).at(0).id));
    ASSERT_EQ(trials.size(), 3U);
    const auto signals = test::must(store->signals(trials[2]));
    const auto spec = test::must(tasks::parse_task(trials[2].task_text, "stored"));
    const auto column = [&](std::string_view name) { return signals.column(name); };
    CarrySetup setup;
    for (const Hand hand : kBothHands)
      setup.of[hand] = {column(columns::hand_at_edge_N[hand])[0],
                        column(columns::hand_on_N[hand])[0]};
    setup.left_share = column(columns::left_share)[0];
    auto hands = test::must(
        CarriedByHands::make(trials[2].scene_text, "stored", *spec.hands_carry(), setup, 0.01));
    CarriedView seen;
    hands.begin(seen);
    const Pose start = seen.object.X_WO;
    test::AtLeast held(300);
    for (std::size_t row = 0; row < signals.rows(); ++row) {
      const double phase = column(columns::phase)[row];
      if (phase == static_cast<double>(tasks::Phase::paused)) continue;
      OfHands<Vec3> push_W;
      for (const Hand hand : kBothHands)
        for (std::size_t a = 0; a < 3; ++a)
          push_W[hand][static_cast<Eigen::Index>(a)] = column(columns::hand_push[hand][a])[row];
      hands.press(push_W, column(columns::clutch_held)[row] > 0.0, seen);
      for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        ASSERT_EQ(seen.object.X_WO.p[axis], column(columns::actual_position[a])[row]) << how << row;
        for (const Hand hand : kBothHands)
          ASSERT_EQ(seen.of[hand].p_W[axis], column(columns::hand_point[hand][a])[row])
              << how << row;
      }
      ASSERT_EQ(seen.held ? 1.0 : 0.0, column(columns::both_hold)[row]);
      if (seen.held) ++held;
      if (column(columns::on_rest)[row] != 0.0)
        hands.stay(start, phase == static_cast<double>(tasks::Phase::lead_in), seen);
      else
        hands.move(seen);
    }
  }
}

/// A patient's session with more carries than one is asked for; `affected` is said by hand.
SessionConfig session_of_a_patient(const std::string& database, const ReadyProtocol& protocol) {
  const std::string uri = "sim://pair?file=healthy&seed=7";
  SessionConfig config;
  config.database = database;
  config.create_database = true;
  config.patient_code = "P-2";
  config.device_uri = test::must(two_platforms_uri({uri, uri}));
  config.hand.reset();
  config.affected = Hand::left;
  config.library = kLibrary;
  config.protocol_name = protocol.spec.name;
  config.protocol_text = protocol.spec.text;
  config.virtual_time = true;
  config.clock_is_right = true;  // sessions in virtual time end ahead of every clock
  return config;
}

void wait_for_trial_in(Session& session) {
  for (;;)
    for (const auto& news : session.wait_for_news())
      if (news.trial) return;
}

struct BrokenOff {};

constexpr const char* kOften = R"(format = "isograsp-protocol-1"
name = "Carry often"
[[step]]
kind = "instrument_zero"
[[step]]
kind = "task"
task = "two_hands_rest.toml"
[[step]]
kind = "task"
task = "two_hands_maximum.toml"
[[step]]
kind = "task"
task = "two_hands_carry.toml"
repetitions = 4
)";

TEST(CarrySession, AResumedSessionCountsTheCarriesOfTheOneThatBrokeOffAndKeepsItsTechnique) {
  const test::TemporaryFolder folder;
  const std::string database = folder.path("clinic.db");
  const auto protocol = test::must(read_protocol(folder.write("often.toml", kOften), kLibrary));
  constexpr int kSecondCarry = 4;  // after zero, rest, maximum and eight carries
  const auto task = [](const char* name) {
    return test::must(load_task(test::must(find_in_library(kLibrary, "tasks", name))));
  };
  const auto carry = task("two_hands_carry");
  const auto other_way = task("two_hands_carry_clutch_pinch");
  ASSERT_EQ(3 * carry.repetitions(), tasks::kMostCarries);
  auto config = session_of_a_patient(database, protocol);
  {
    const auto session = test::must(Session::open(config));
    try {
      static_cast<void>(run_protocol(*session, protocol, [&](const ProtocolProgress& at) {
        if (at.step == kSecondCarry) throw BrokenOff{};
      }));
    } catch (const BrokenOff&) {
    }
    ASSERT_TRUE(session->start_trial(carry, false).ok());
    session->let_pass(1.0);  // in its first carry the session ends: counted as a whole
    session->close();
  }
  config.resume = true;
  for (const int left : test::every(std::vector{1, 0})) {
    const auto session = test::must(Session::open(config));
    ASSERT_TRUE(session->start_zero({true, false, 1.0}).ok());
    static_cast<void>(session->wait_for_news());
    const auto another = session->start_trial(other_way, false);
    ASSERT_FALSE(another.ok());
    EXPECT_NE(another.error().message().find("another way"), std::string::npos)
        << another.error().message();
    const auto allowed = session->start_trial(carry, false);
    EXPECT_EQ(allowed.ok(), left > 0) << left;
    if (allowed.ok()) {
      wait_for_trial_in(*session);
      const auto more = session->start_trial(carry, false);
      ASSERT_FALSE(more.ok());
      EXPECT_NE(more.error().message().find("of which 0 are left"), std::string::npos)
          << more.error().message();
    }
    session->close();
  }
}

TEST(CarrySession, TheSameSeedGivesTheSameBits) {
  const CarrySession once("paretic_left");
  const CarrySession again("paretic_left");
  EXPECT_EQ(once.measures(), again.measures());
}

}  // namespace
}  // namespace isograsp::session::carry_session_test
