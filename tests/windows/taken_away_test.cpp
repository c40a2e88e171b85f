// SPDX-License-Identifier: GPL-3.0-or-later
// The file of the clinic is deleted or replaced while a trial is recorded in the windows: the
// session ends, both screens say so, nothing is called completed, and all of it comes back.
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::taken_away_test {
namespace {

namespace fs = std::filesystem;

struct Fate {
  const char* name;
  void (*strike)(const std::string& file);
  const char* words;
};

const Fate kFates[]{
    {"Deleted", [](const std::string& file) { fs::remove(file); }, "was deleted or moved away"},
    {"Replaced",
     [](const std::string& file) {
       EXPECT_EQ(test::isograsp("db backup " + file + " --to " + file + ".backup").status, 0);
       fs::rename(file + ".backup", file);
     },
     "another file was put in its place"}};

class TakenAway : public test::ClinicDesk, public testing::WithParamInterface<Fate> {
 protected:
  /// The frame and the sign of its notice of a fault: only that is drawn in this colour.
  [[nodiscard]] bool patient_screen_tells() {
    constexpr int kFrame = 1000;
    return desktop_.points_of("8E140E") > kFrame;
  }
};
INSTANTIATE_TEST_SUITE_P(, TakenAway, testing::ValuesIn(kFates),
                         [](const auto& fate) { return std::string(fate.param.name); });

TEST_P(TakenAway, DuringATrialBothScreensSaySoAndTheNextStartBringsItBack) {
  ASSERT_NO_FATAL_FAILURE(open_trial());
  ASSERT_TRUE(desktop_.click("patient_screen"));
  ASSERT_TRUE(desktop_.wait_until([this] { return desktop_.points_of("F4F6F8") > 1000; }))
      << "its paper";
  EXPECT_FALSE(patient_screen_tells());

  GetParam().strike(database());
  ASSERT_TRUE(wait_for_words(GetParam().words)) << desktop_.seen();
  EXPECT_TRUE(desktop_.wait_until([this] { return patient_screen_tells(); }));
  ASSERT_TRUE(desktop_.wait_until([this] {
    return words_on("fault_remedy").find("isograsp db rescue " + database()) != std::string::npos;
  })) << desktop_.seen();
  desktop_.keep_picture("taken_away");
  EXPECT_NE(words_on("result_remark").find("interrupted"), std::string::npos)
      << words_on("result_remark");
  EXPECT_EQ(desktop_.seen().find("completed"), std::string::npos) << desktop_.seen();
  EXPECT_EQ(desktop_.seen().find("Trial stored"), std::string::npos) << desktop_.seen();
  ASSERT_EQ(emergency_files().size(), 1u);
  const std::string kept = "SELECT status, sample_count >= 300 FROM trials";
  // The words stand while the last trial is still being written behind them.
  EXPECT_TRUE(desktop_.wait_until([&] {
    return asked(emergency_files()[0], kept) == "aborted|1\n";
  })) << asked(emergency_files()[0], kept);
  expect_clean_end();

  start();
  ASSERT_TRUE(desktop_.click("rescue_yes"));
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_clean_end();
  EXPECT_EQ(stored(kept), "aborted|1\n");
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
  EXPECT_TRUE(emergency_files().empty());
  expect_sound();
}

}  // namespace
}  // namespace isograsp::taken_away_test
