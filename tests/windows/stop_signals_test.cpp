// SPDX-License-Identifier: GPL-3.0-or-later
// SIGTERM, SIGINT and SIGHUP (a computer that is shut down, Ctrl-C, a terminal that closes) end the
// windows in good order: the trial is kept, the session is ended, the status says what is stored.
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::stop_signals_test {
namespace {

namespace fs = std::filesystem;

class ToldToEnd : public test::ClinicDesk {
 protected:
  test::Ending send(int signal) {
    EXPECT_EQ(kill(desktop_.process(), signal), 0);
    return desktop_.wait_for_end();
  }
  void expect_session_ended() const {
    EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
    expect_sound();
    EXPECT_TRUE(emergency_files().empty());
  }
};

class ToldToEndBy : public ToldToEnd, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(, ToldToEndBy, testing::Values(SIGTERM, SIGINT, SIGHUP),
                         [](const auto& signal) {
                           return std::string(sigabbrev_np(signal.param));
                         });

TEST_P(ToldToEndBy, ARunningTrialIsKeptAsAbortedAndTheSessionIsEndedWithStatusZero) {
  ASSERT_NO_FATAL_FAILURE(open_trial());
  expect_end(send(GetParam()));
  expect_session_ended();
  EXPECT_EQ(stored("SELECT status, sample_count >= 300 FROM trials"), "aborted|1\n");
  EXPECT_EQ(stored("SELECT count(*) > 0 FROM signal_packs"), "1\n");
}

TEST_P(ToldToEndBy, AnOpenSessionIsEndedWithStatusZero) {
  ASSERT_NO_FATAL_FAILURE(open_session());
  ASSERT_TRUE(desktop_.wait_for("start"));
  expect_end(send(GetParam()));
  expect_session_ended();
}

TEST_F(ToldToEnd, WindowsWithoutASessionEndWithStatusZero) {
  start();
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_end(send(SIGTERM));
  expect_sound();
}

TEST_F(ToldToEnd, AQuestionThatStandsOpenAboveTheWindowIsNoObstacle) {
  start();
  for (const char* button : {"add_patient", "hand_right", "screening_clear"})
    ASSERT_TRUE(desktop_.click(button)) << button;
  ASSERT_TRUE(desktop_.choose("devices", "A recording …"));
  ASSERT_TRUE(desktop_.wait_for("QFileDialog"));
  expect_end(send(SIGTERM));
  expect_sound();
}

TEST_F(ToldToEnd, ASessionWhoseFileWasTakenAwayInThatMomentGivesStatusOneAndASentence) {
  ASSERT_NO_FATAL_FAILURE(open_trial());
  fs::rename(database(), database() + ".away");
  const auto ending = send(SIGTERM);
  expect_end(ending, 1);
  EXPECT_NE(ending.err.find("was deleted or moved away"), std::string::npos) << ending.err;
  EXPECT_NE(ending.err.find("isograsp db rescue " + database()), std::string::npos) << ending.err;
  ASSERT_EQ(emergency_files().size(), 1u);
  EXPECT_EQ(asked(emergency_files()[0], "SELECT status, sample_count >= 300 FROM trials"),
            "aborted|1\n");
}

}  // namespace
}  // namespace isograsp::stop_signals_test
