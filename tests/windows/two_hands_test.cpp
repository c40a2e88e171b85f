// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands, each on a platform, in the program that a clinic starts: with mouse and keyboard from
// the first click through both zeros, the test of the stop, rest and maxima to one force together
// and the end of the session.
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::two_hands_windows_test {
namespace {

class BothHandsDesk : public test::ClinicDesk {
 protected:
  BothHandsDesk() { test::shorten_two_hands(desktop_.folder().path("library"), "3"); }
};

TEST_F(BothHandsDesk, GoTheWholeWayFromTheFirstClickToAStoredSessionAndStatusZero) {
  desktop_.start({"gui", "--db", database()});
  for (const char* button :
       {"add_patient", "hand_both", "left_screening_clear", "right_screening_clear"})
    ASSERT_TRUE(desktop_.click(button)) << button;
  ASSERT_TRUE(desktop_.choose("platforms_left", "Simulated, left hand paretic"));
  for (const char* button : {"connect", "zero", "crosstalk_skip"})
    ASSERT_TRUE(desktop_.click(button)) << button;
  ASSERT_TRUE(wait_for_words("press the pedal")) << words_on("sentence");
  desktop_.key("F8");  // Start: nothing begins
  ASSERT_TRUE(wait_for_words("press the pedal")) << words_on("sentence");
  desktop_.keep_picture("two_hands_stop_test");
  desktop_.key("F10");
  ASSERT_TRUE(wait_for_words("within reach")) << words_on("sentence");
  for (const char* button : {"within_reach", "strapped"})
    ASSERT_TRUE(desktop_.click(button)) << button;
  ASSERT_TRUE(wait_for_words("They settle")) << words_on("sentence");
  // A minute later the resting force begins by itself, and what follows.
  ASSERT_TRUE(wait_for_words("Recording: Two hands, resting force")) << words_on("sentence");
  ASSERT_TRUE(wait_for_words("Recording: Two hands, maximum")) << words_on("sentence");
  ASSERT_TRUE(wait_for_words("Recording: Two hands, together")) << words_on("sentence");
  desktop_.keep_picture("two_hands_together");
  ASSERT_TRUE(wait_for_words("The protocol is finished")) << words_on("sentence");
  ASSERT_TRUE(desktop_.click("closing_end"));
  ASSERT_TRUE(desktop_.wait_until([this] {
    return stored("SELECT sum(ended_utc <> '') FROM sessions") == "1\n";
  })) << desktop_.seen();
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*), sum(status = 'completed') FROM trials"), "3|3\n");
  EXPECT_EQ(stored("SELECT count(*) FROM session_answers WHERE topic = 'safety' AND value = 'yes'"),
            "2\n");
  expect_sound();
}

}  // namespace
}  // namespace isograsp::two_hands_windows_test
