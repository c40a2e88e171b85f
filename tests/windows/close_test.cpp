// SPDX-License-Identifier: GPL-3.0-or-later
// The program that a clinic starts opens its windows, and leaves without a crash, from wherever it
// is told to close: a real X server, a window manager, a mouse, and the executable itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include "tests/support/background_command.hpp"
#include "tests/support/free_port.hpp"
#include "tests/windows/clinic_desk.hpp"

namespace isograsp::close_test {
namespace {

/// Cameras or a tracker in another program, until this goes.
class Emulated {
 public:
  Emulated(const std::string& arguments, std::string pid)
      : pid_(std::move(pid)),
        command_("sh -c 'echo $$ > " + pid_ + "; exec \"" ISOGRASP_EXECUTABLE "\" " + arguments +
                 "'") {}
  ~Emulated() {
    static_cast<void>(test::run("kill -INT $(cat " + pid_ + ")"));
    command_.wait_for_end();
  }
  Emulated(const Emulated&) = delete;
  Emulated& operator=(const Emulated&) = delete;
  [[nodiscard]] const test::BackgroundCommand& command() const { return command_; }

 private:
  std::string pid_;
  test::BackgroundCommand command_;
};

/// A flat right hand before a tracker, 4 s at 100 Hz; a slow wave makes no picture the same.
std::string resting_hand() {
  std::vector<std::pair<std::string, std::array<double, 3>>> joints{{"palm", {0.0, 0.2, 0.0}},
                                                                    {"wrist", {0.0, 0.2, 0.07}}};
  constexpr std::array kDigits{"thumb", "index", "middle", "ring", "little"};
  for (std::size_t d = 0; d < kDigits.size(); ++d) {
    double away_m = -0.05;
    for (const char* joint : {"metacarpal", "proximal", "intermediate", "distal", "tip"}) {
      if (d == 0 && std::string(joint) == "intermediate") continue;
      joints.push_back({std::string(kDigits[d]) + "_" + joint,
                        {0.02 * (static_cast<double>(d) - 2.0), 0.2, -away_m}});
      away_m += 0.03;
    }
  }
  std::ostringstream out;
  out << "t_s,hand,tracked,confidence";
  for (const auto& [name, p] : joints)
    for (const char* axis : {"_x_m", "_y_m", "_z_m"}) out << "," << name << axis;
  for (int k = 0; k < 400; ++k) {
    const double t_s = k / 100.0;
    out << "\n" << t_s << ",right,1,1";
    for (const auto& [name, p] : joints)
      out << "," << p[0] << "," << p[1] + 1e-4 * std::sin(t_s) << "," << p[2];
  }
  out << "\n";
  return out.str();
}

class Leaving : public test::ClinicDesk {
 protected:
  /// A recording of cameras, made by the program and changed here: an arm that lies still while its
  /// object is moved to the right, up and away, from rest to rest.
  std::string moved_object();
};

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::string field;
  for (std::istringstream in(line); std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

std::string Leaving::moved_object() {
  const std::string protocol = desktop_.folder().write(
      "library/protocols/one_range.toml",
      "format = \"isograsp-protocol-1\"\nname = \"One range\"\n[[step]]\nkind = "
      "\"start_posture\"\n[[step]]\nkind = \"task\"\ntask = \"arm_range_forearm.toml\"\n");
  const std::string other = desktop_.folder().path("other.db"), out = desktop_.folder().path("ex");
  const auto done = test::isograsp("run --device 'sim://arm?seed=5' --protocol-file " + protocol +
                                   " --db " + other + " --patient A-1 --fast");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(test::isograsp("export --db " + other + " --format csv --out " + out).status, 0);
  std::ifstream signals(out + "/patient_1/session_1/trial_1_signals.csv");
  std::string head, first;
  std::getline(signals, head);
  std::getline(signals, first);
  const auto names = fields_of(head), values = fields_of(first);
  const std::string mark = "marker_";
  std::ostringstream csv;
  csv << "t_s";
  for (const std::string& name : names)
    if (name.rfind(mark, 0) == 0) csv << ',' << name.substr(mark.size());
  constexpr double kRate_Hz = 100.0, kWay_m = 0.13;
  constexpr int kRest = 120, kMove = 60;  // rows
  std::array<double, 3> moved_m{};
  int row = 0;
  const auto show = [&](int rows, std::size_t axis, double way_m) {
    for (int k = 0; k < rows; ++k) {
      moved_m[axis] += way_m / rows;
      csv << '\n' << row++ / kRate_Hz;
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].rfind(mark, 0) != 0) continue;
        const bool of_object = names[i][mark.size()] == 'O';
        const auto along = static_cast<std::size_t>(names[i][names[i].size() - 3] - 'x');  // _x_m
        csv << ',';
        if (i < values.size() && !values[i].empty())  // it is seen
          csv << std::stod(values[i]) + (of_object ? moved_m[along] : 0.0);
      }
    }
  };
  for (const auto& [axis, way_m] : {std::pair{std::size_t{0}, kWay_m}, {1, kWay_m}, {2, -kWay_m}}) {
    show(kRest, axis, 0.0);
    show(kMove, axis, way_m);
  }
  show(kRest, 0, 0.0);
  return desktop_.folder().write("moved.csv", csv.str() + '\n');
}

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

TEST_F(Leaving, ATargetOfLiveCamerasComesBehindTheCheckOfThePicture) {
  const std::string port = std::to_string(test::free_port());
  const Emulated cameras(
      "emulate --protocol qtm-rt --loop --on 127.0.0.1:" + port + " --play " + moved_object(),
      desktop_.folder().path("cameras.pid"));
  ASSERT_TRUE(cameras.command().wait_until(
      [&] { return cameras.command().err().find(port) != std::string::npos; }));
  desktop_.start(
      {"gui", "--db", database(), "--device", "qtm://127.0.0.1:" + port + "?rig=kurillo15_trunk"});
  ASSERT_TRUE(desktop_.click("add_patient"));
  ASSERT_TRUE(desktop_.click("hand_right"));
  ASSERT_TRUE(desktop_.click("arm_screening_clear"));
  ASSERT_TRUE(desktop_.click("connect"));
  ASSERT_TRUE(desktop_.click("start_posture"));
  ASSERT_TRUE(desktop_.click("by_hand"));
  ASSERT_TRUE(desktop_.choose("tasks", "Turn an object, first try"));
  ASSERT_TRUE(wait_for_words("check that the picture moves"));
  EXPECT_FALSE(desktop_.widget("start")->enabled) << desktop_.seen();
  // Three ways and the way back are four: whenever it is asked for, it begins with the first one in
  // the end.
  constexpr int kTries = 5;
  const auto says = [&](const char* sign) {
    return words_on("picture_check_words").rfind(sign, 0) == 0;
  };
  for (int k = 0; k < kTries && !says("✓"); ++k) {
    ASSERT_TRUE(desktop_.click("picture_check"));
    ASSERT_TRUE(desktop_.wait_until([&] { return !says("✓") && !says("✗"); }));
    ASSERT_TRUE(desktop_.wait_until([&] { return says("✓") || says("✗"); }));
  }
  ASSERT_TRUE(says("✓")) << words_on("picture_check_words");
  ASSERT_TRUE(desktop_.click("start"));
  ASSERT_TRUE(desktop_.wait_for_press("stop")) << desktop_.seen();
  expect_clean_end();
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
  EXPECT_EQ(stored("SELECT status FROM trials"), "aborted\n");
  expect_sound();
}

TEST_F(Leaving, ALiveTrackerConnectsOnceItsLawfulBasisIsRecordedInTheWindow) {
  const std::string port = std::to_string(test::free_port());
  const std::string stream = desktop_.folder().write("resting_hand.csv", resting_hand());
  const Emulated tracker("hand emulate --loop --listen 127.0.0.1:" + port + " --stream " + stream,
                         desktop_.folder().path("tracker.pid"));
  ASSERT_TRUE(tracker.command().wait_until(
      [&] { return tracker.command().err().find(port) != std::string::npos; }));
  desktop_.start({"gui", "--db", database(), "--device", "leap://127.0.0.1:" + port});
  ASSERT_TRUE(desktop_.click("add_patient"));
  ASSERT_TRUE(desktop_.click("hand_right"));
  ASSERT_TRUE(desktop_.click("hand_screening_clear"));
  ASSERT_TRUE(desktop_.click("connect"));
  ASSERT_TRUE(wait_for_words("No lawful basis"));
  EXPECT_EQ(stored("SELECT count(*) FROM sessions"), "0\n");
  ASSERT_TRUE(desktop_.click("basis_open"));
  ASSERT_TRUE(desktop_.choose("basis_purpose", "Treatment"));
  ASSERT_TRUE(desktop_.choose("basis_basis", "Care"));
  ASSERT_TRUE(desktop_.choose("basis_state", "given"));
  ASSERT_TRUE(desktop_.click("basis_record"));
  ASSERT_TRUE(wait_for_words("Connect"));
  ASSERT_TRUE(desktop_.click("connect"));
  ASSERT_TRUE(desktop_.wait_for_press("entry_test")) << desktop_.seen();
  expect_clean_end();
  EXPECT_EQ(stored("SELECT purpose, basis, state FROM consents"), "treatment|care|given\n");
  EXPECT_EQ(stored("SELECT count(*), sum(ended_utc <> '') FROM sessions"), "1|1\n");
  expect_sound();
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
