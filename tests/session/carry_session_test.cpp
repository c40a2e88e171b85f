// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions in which a pair of hands in software, as points, carries a box.
#include <gtest/gtest.h>

#include "hand/two_hands_columns.hpp"
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

TEST(CarrySession, TheSameSeedGivesTheSameBits) {
  const CarrySession once("paretic_left");
  const CarrySession again("paretic_left");
  EXPECT_EQ(once.measures(), again.measures());
}

}  // namespace
}  // namespace isograsp::session::carry_session_test
