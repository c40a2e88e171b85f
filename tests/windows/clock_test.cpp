// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of the computer is behind the newest session of the file: progress would be put in a
// wrong order. The window asks before it begins a session; pressing Connect once more is the yes.
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::clock_test {
namespace {

class ClockBehind : public test::ClinicDesk {
 protected:
  ClockBehind() {
    fill();
    const auto ahead = test::run("sqlite3 " + database() +
                                 " \"UPDATE sessions SET started_utc = '2199-01-01T00:00:00Z', "
                                 "ended_utc = '2199-01-01T00:10:00Z'\"");
    EXPECT_EQ(ahead.status, 0) << ahead.err;
  }
  [[nodiscard]] bool is_asked() {
    return wait_for_words("the newest session of this file is of 2199-01-01T00:00:00Z");
  }
  /// But for the session that was put ahead, which is named.
  void expect_otherwise_sound() const {
    const auto checked = test::isograsp("db check " + database());
    EXPECT_EQ(checked.out, "sessions: row 1 is not what isograsp wrote\n") << checked.err;
  }
  [[nodiscard]] std::string sessions() const { return stored("SELECT count(*) FROM sessions"); }
};

TEST_F(ClockBehind, NoSessionBeginsAsLongAsNobodySaysThatItIsRight) {
  ASSERT_NO_FATAL_FAILURE(connect());
  ASSERT_TRUE(is_asked()) << desktop_.seen();
  EXPECT_NE(words_on("fault_remedy").find("connect again if it is right"), std::string::npos);
  EXPECT_EQ(sessions(), "1\n");
  expect_clean_end();
  EXPECT_EQ(sessions(), "1\n") << "to leave is a no";
  EXPECT_EQ(stored("SELECT count(*) FROM events WHERE kind = 'clock'"), "0\n");
  expect_otherwise_sound();
}

TEST_F(ClockBehind, ConnectingAgainBeginsOneThatTellsOfIt) {
  ASSERT_NO_FATAL_FAILURE(connect());
  ASSERT_TRUE(is_asked()) << desktop_.seen();
  ASSERT_TRUE(desktop_.click("connect"));
  ASSERT_TRUE(desktop_.wait_for_press("zero"));
  expect_clean_end();
  EXPECT_EQ(sessions(), "2\n");
  EXPECT_EQ(stored("SELECT count(*) FROM events WHERE kind = 'clock'"), "1\n");
  expect_otherwise_sound();
}

TEST_F(ClockBehind, AnAnswerThatWasNotGivenIsNotTakenForTheNextChoice) {
  ASSERT_NO_FATAL_FAILURE(connect());
  ASSERT_TRUE(is_asked()) << desktop_.seen();
  ASSERT_TRUE(desktop_.click("section_2"));
  ASSERT_TRUE(desktop_.click("hand_left"));
  ASSERT_TRUE(wait_for_words("Ask the screening questions")) << "the question is gone";
  ASSERT_TRUE(desktop_.click("screening_clear"));
  ASSERT_TRUE(desktop_.click("connect"));
  EXPECT_TRUE(is_asked()) << "nobody has been asked about this session: " << desktop_.seen();
  EXPECT_EQ(sessions(), "1\n");
  expect_clean_end();
}

}  // namespace
}  // namespace isograsp::clock_test
