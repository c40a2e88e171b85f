// SPDX-License-Identifier: GPL-3.0-or-later
// The program that a clinic starts opens its windows, and leaves without a crash, from wherever it
// is told to close: a real X server, a window manager, a mouse, and the executable itself.
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::close_test {
namespace {

class Leaving : public test::ClinicDesk {};

TEST_F(Leaving, AnEmptyClinicEndsWithStatusZero) {
  start();
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_clean_end();
}

TEST_F(Leaving, TheFirstStartWithoutArgumentsEndsWithStatusZero) {
  desktop_.start({});
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_clean_end();
}

TEST_F(Leaving, TheDemonstrationClinicOpensInItsPlaceAndEndsWithStatusZero) {
  desktop_.start({});
  ASSERT_TRUE(desktop_.click("demonstration"));
  ASSERT_TRUE(desktop_.choose("patient_list", "DEMO-01"));
  for (const char* page : {"page_2", "page_5", "page_1"}) ASSERT_TRUE(desktop_.click(page));
  expect_clean_end();
}

TEST_F(Leaving, AFilledClinicEndsWithStatusZeroFromEveryPage) {
  fill();
  constexpr int kPages = 7;
  for (int page = 1; page <= kPages; ++page) {
    start();
    ASSERT_TRUE(desktop_.choose("patient_list", "P-001"));
    ASSERT_TRUE(desktop_.click("page_" + std::to_string(page)));
    expect_clean_end();
  }
}

TEST_F(Leaving, RightBehindThePressOfConnectLeavesNoSessionOpen) {
  connect();
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*) FROM sessions WHERE ended_utc = ''"), "0\n");
  expect_sound();
}

TEST_F(Leaving, TheLoginOfAProtectedClinicEndsWithStatusZero) {
  const std::string phrase =
      desktop_.folder().write("phrase", "seven calm boats on a wide river\n");
  const auto made =
      test::isograsp("db init --protected " + database() + " --passphrase-file " + phrase);
  ASSERT_EQ(made.status, 0) << made.err;
  start();
  ASSERT_TRUE(desktop_.wait_for("login"));
  expect_clean_end();
}

TEST_F(Leaving, AnOpenSessionIsEndedInTheDatabase) {
  open_session();
  ASSERT_TRUE(desktop_.wait_for("start"));
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
}

TEST_F(Leaving, ARunningTrialIsKeptAsAbortedAndTheSessionIsEnded) {
  open_session();
  ASSERT_TRUE(desktop_.click("strapped"));
  ASSERT_TRUE(desktop_.wait_for_press("stop")) << "the resting force begins after a minute";
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
  EXPECT_EQ(stored("SELECT status FROM trials"), "aborted\n");
}

TEST_F(Leaving, WithBothWindowsOpenEndsWithStatusZero) {
  open_session();
  ASSERT_TRUE(desktop_.click("patient_screen"));
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
}

TEST_F(Leaving, AStoredTrialOfATrackedHandIsPlayedAndEndsWithStatusZero) {
  const std::string protocol = desktop_.folder().write(
      "library/protocols/one_hand.toml",
      "format = \"isograsp-protocol-1\"\nname = \"One hand\"\n[[step]]\nkind = \"hand_entry\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"virtual_place_first.toml\"\npractice = true\n");
  const auto done = test::isograsp("run --protocol-file " + protocol +
                                   " --device 'sim://hand?user=healthy&seed=7' --patient P-001 "
                                   "--fast --db " +
                                   database());
  ASSERT_EQ(done.status, 0) << done.err;
  start();
  ASSERT_TRUE(desktop_.choose("patient_list", "P-001"));
  ASSERT_TRUE(desktop_.click("page_2"));
  ASSERT_TRUE(desktop_.choose("course_trials", "Place virtual objects, first steps"));
  ASSERT_TRUE(desktop_.wait_for("replay_grasp_verdict")) << "its numbers stand beside it";
  ASSERT_TRUE(desktop_.click("trial_play"));
  ASSERT_TRUE(desktop_.wait_until([&] {
    return words_on("replay_digit_state_0") == "tied" || !desktop_.runs();
  })) << desktop_.seen();
  expect_clean_end();
}

TEST_F(Leaving, EveryLanguageAndEverySizeOfLettersMakesTheWindowAnewAndEndsWithStatusZero) {
  fill();
  start();
  ASSERT_TRUE(desktop_.choose("patient_list", "P-001"));
  ASSERT_TRUE(desktop_.click("page_7"));
  for (const char* language : {"Deutsch", "Français", "English"}) {
    ASSERT_TRUE(desktop_.choose("settings_language", language));
    for (const char* percent : {"150", "200", "100"})
      ASSERT_TRUE(desktop_.choose("settings_letters", percent)) << language;
  }
  expect_clean_end();
}

}  // namespace
}  // namespace isograsp::close_test
