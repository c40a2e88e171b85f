// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose file was taken away while it was recorded waits in an emergency file: the windows
// offer it at their start. A yes brings it into the database, without one it stays.
#include "tests/support/background_command.hpp"
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::rescue_test {
namespace {

namespace fs = std::filesystem;

class Rescue : public test::ClinicDesk {
 protected:
  /// An unattended session of T-01 in real time; `fate` comes over its file in the second trial.
  void lose_a_session(const std::function<void()>& fate, const std::string& login = "") {
    const auto& folder = desktop_.folder();
    static_cast<void>(folder.write(
        "library/tasks/one_second.toml",
        "format = \"isograsp-task-1\"\nname = \"One second\"\ninstruction = \"Move.\"\n"
        "version = 1\nkind = \"observe\"\nscene = \"firm_block\"\nduration_s = 1\n"));
    const auto protocol = folder.write(
        "library/protocols/two.toml",
        "format = \"isograsp-protocol-1\"\nname = \"Two\"\n[[step]]\nkind = \"instrument_zero\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"one_second.toml\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"free_handling.toml\"\n");
    const test::BackgroundCommand session(
        "\"" ISOGRASP_EXECUTABLE "\" run --protocol-file " + protocol +
        " --device 'sim://healthy?seed=3' --patient T-01 --db " + database() + login);
    const auto second_trial = [&] {
      return stored(
                 "SELECT count(*) FROM signal_blocks b JOIN trials t ON t.id = b.trial_id WHERE "
                 "t.step = 2 AND b.second = 1 AND b.position = 0") == "1\n";
    };
    ASSERT_TRUE(session.wait_until(second_trial)) << session.err();
    fate();
    session.wait_for_end();
    ASSERT_EQ(session.status(), 1) << session.err();
    ASSERT_EQ(emergency_files().size(), 1u) << session.err();
  }
  [[nodiscard]] std::function<void()> moved_away_and_back() const {
    return [this] {
      fs::rename(database(), database() + ".away");
      // Until the program has noticed.
      while (emergency_files().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      fs::rename(database() + ".away", database());
    };
  }
  [[nodiscard]] std::function<void()> deleted() const {
    return [this] { fs::remove(database()); };
  }
  void answer(const char* button) {
    start();
    ASSERT_TRUE(desktop_.wait_for(button));
    EXPECT_NE(desktop_.seen().find("T-01"), std::string::npos) << desktop_.seen();
    ASSERT_TRUE(desktop_.click(button));
    ASSERT_TRUE(desktop_.wait_for("add_patient"));
  }
  [[nodiscard]] std::string status_of_trials() const {
    return stored(
        "SELECT group_concat(t.status) FROM trials t JOIN sessions s ON s.id = t.session_id JOIN "
        "patients p ON p.id = s.patient_id WHERE p.code = 'T-01'");
  }
  void expect_taken_in() {
    ASSERT_TRUE(desktop_.choose("patient_list", "T-01"));
    expect_clean_end();
    EXPECT_EQ(status_of_trials(), "completed,aborted\n");
    EXPECT_EQ(stored("SELECT count(*) FROM sessions WHERE ended_utc IS NULL OR ended_utc = ''"),
              "0\n");
    EXPECT_TRUE(emergency_files().empty());
    expect_sound();
  }
};

TEST_F(Rescue, AYesBringsTheSessionIntoTheDatabase) {
  fill();
  ASSERT_NO_FATAL_FAILURE(lose_a_session(moved_away_and_back()));
  ASSERT_NO_FATAL_FAILURE(answer("rescue_yes"));
  expect_taken_in();
  EXPECT_EQ(stored("SELECT group_concat(code) FROM patients"), "P-001,T-01\n");
}

TEST_F(Rescue, WithoutAYesEverythingStaysAndIsOfferedAgain) {
  ASSERT_NO_FATAL_FAILURE(lose_a_session(moved_away_and_back()));
  const auto kept = emergency_files();
  ASSERT_NO_FATAL_FAILURE(answer("rescue_no"));
  expect_clean_end();
  EXPECT_EQ(emergency_files(), kept);
  EXPECT_EQ(status_of_trials(), "completed,interrupted\n") << "as the file had it";
  start();
  ASSERT_TRUE(desktop_.wait_for_press("rescue_yes"));
  desktop_.key("Escape");
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_clean_end();
  EXPECT_EQ(emergency_files(), kept);
  start();
  ASSERT_TRUE(desktop_.wait_for_press("rescue_yes"));
  ASSERT_EQ(kill(desktop_.process(), SIGTERM), 0);
  expect_end(desktop_.wait_for_end());
  EXPECT_EQ(emergency_files(), kept) << "a question that nobody answered";
  ASSERT_NO_FATAL_FAILURE(answer("rescue_yes"));
  expect_taken_in();
}

TEST_F(Rescue, ADeletedFileComesBackWithEverythingThatWasInIt) {
  fill();
  ASSERT_NO_FATAL_FAILURE(lose_a_session(deleted()));
  ASSERT_FALSE(fs::exists(database()));
  ASSERT_NO_FATAL_FAILURE(answer("rescue_yes"));
  expect_taken_in();
  EXPECT_EQ(stored("SELECT group_concat(code) FROM patients"), "P-001,T-01\n");
  EXPECT_EQ(stored("SELECT count(*) FROM sessions"), "2\n");
}

TEST_F(Rescue, ANewFileInThePlaceOfADeletedOneTakesAllOfItInWhenSomebodySaysYesLater) {
  fill();
  ASSERT_NO_FATAL_FAILURE(lose_a_session(deleted()));
  ASSERT_NO_FATAL_FAILURE(answer("rescue_no"));
  ASSERT_TRUE(desktop_.click("add_patient"));
  expect_clean_end();
  const auto added = stored("SELECT code FROM patients");
  ASSERT_FALSE(added.empty());
  ASSERT_EQ(emergency_files().size(), 1u);
  ASSERT_NO_FATAL_FAILURE(answer("rescue_yes"));
  expect_taken_in();
  EXPECT_EQ(stored("SELECT count(*) FROM patients WHERE code IN ('P-001', 'T-01', '" +
                   added.substr(0, added.size() - 1) + "')"),
            "3\n");
  EXPECT_EQ(stored("SELECT count(*) FROM sessions"), "2\n");
}

TEST_F(Rescue, TheQuestionIsAskedInTheLanguageOfTheStation) {
  ASSERT_NO_FATAL_FAILURE(lose_a_session(moved_away_and_back()));
  start();
  ASSERT_TRUE(desktop_.click("rescue_no"));
  ASSERT_TRUE(desktop_.click("page_7"));
  ASSERT_TRUE(desktop_.choose("settings_language", "Deutsch"));
  expect_clean_end();
  start();
  ASSERT_TRUE(desktop_.wait_for("rescue_no"));
  EXPECT_NE(desktop_.seen().find("Jetzt in die Datenbank aufnehmen?"), std::string::npos)
      << desktop_.seen();
  ASSERT_TRUE(desktop_.click("rescue_no"));
  ASSERT_TRUE(desktop_.wait_for("add_patient"));
  expect_clean_end();
}

TEST_F(Rescue, OfAProtectedFileTheCommandIsNamedAndEverythingStays) {
  const auto words = desktop_.folder().write("words", "words of the clinic\n");
  const std::string login = " --passphrase-file " + words;
  ASSERT_EQ(test::isograsp("db init --protected " + database() + login).status, 0);
  ASSERT_NO_FATAL_FAILURE(lose_a_session(moved_away_and_back(), login));
  const auto kept = emergency_files();
  start();
  ASSERT_TRUE(desktop_.wait_for("rescue_ok"));
  EXPECT_NE(desktop_.seen().find("isograsp db rescue " + database()), std::string::npos)
      << desktop_.seen();
  ASSERT_TRUE(desktop_.click("rescue_ok"));
  ASSERT_TRUE(desktop_.wait_for("login_secret"));
  expect_clean_end();
  EXPECT_EQ(emergency_files(), kept);
  const auto rescued = test::isograsp("db rescue " + database() + login);
  EXPECT_EQ(rescued.status, 0) << rescued.err;
  EXPECT_EQ(status_of_trials(), "completed,aborted\n");
  EXPECT_TRUE(emergency_files().empty());
}

}  // namespace
}  // namespace isograsp::rescue_test
