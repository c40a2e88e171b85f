// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way of both hands as a user goes it: two platforms (in software, on real sockets, or a
// pair of hands in software), session, database, scores, report, exports.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::app::two_platforms_test {
namespace {

using test::isograsp;
using test::TemporaryFolder;

const std::string kProtocols = std::string(ISOGRASP_SOURCE_DIR) + "/library/protocols/";
const std::string kPair = "'sim://pair?file=paretic_left&seed=7'";

std::string both(const std::string& left, const std::string& right) {
  return " --device-left " + left + " --device-right " + right;
}

TEST(TwoPlatformsApp, AnErrorIsOneLineThatNamesTheCauseAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string rest = "run --protocol-file " + kProtocols + "two_hands_short.toml --db " +
                           folder.path("c.db") + " --patient B-1 --fast";
  for (const auto& [arguments, message] :
       test::every(std::vector<std::pair<std::string, std::string>>{
           {both(kPair, kPair) + " --device sim://healthy", "--device"},
           {both(kPair, kPair) + " --hand left", "--hand"},
           {" --device-left " + kPair, "--device-right"},
           {" --device-right " + kPair, "--device-left"},
           {both("'udp://?config=a.toml'", "'udp://?config=a.toml'"), "one platform"},
           {both("sim://healthy", "sim://paretic"), "sim://pair"},
           {both(kPair, kPair) + " --affected both", "--affected"},
           {" --device sim://healthy --affected left", "--affected"},
           {" --device sim://healthy --ceiling-left 5", "--ceiling-left"},
           {both("'sim://pair?file=nobody'", "'sim://pair?file=nobody'"), "nobody"},
           {both("sim://pair", "sim://pair"), "file=NAME"},
           {"", "--device"},
           {" --device sim://healthy", "two_platforms"}})) {
    const auto result = isograsp(rest + arguments);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << arguments << "\n" << result.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("c.db")));
}

TEST(TwoPlatformsApp, APairInSoftwareGoesFromSessionToReportAndExports) {
  const TemporaryFolder folder;
  const std::string database = folder.path("clinic.db");
  ASSERT_EQ(isograsp("db init " + database).status, 0);
  const auto run =
      isograsp("run --protocol-file " + kProtocols + "two_hands_short.toml --db " + database +
               " --patient B-1 --affected left --fast" + both(kPair, kPair));
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("share_affected (left)"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("both hands"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("bilateral_deficit"), std::string::npos) << run.out;
  EXPECT_EQ(isograsp("db check " + database).status, 0);
  const auto verified = isograsp("db verify " + database);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
  const auto report =
      isograsp("report --patient B-1 --db " + database + " --out " + folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = test::must(read_text(folder.path("r.html")));
  for (const char* said : {"Two hands, maximum", "left hand", "right hand", "SIMULATED",
                           "Both hands: sharing a force", "the left hand, which is affected, gives",
                           "Of what both hands can do it can do", "It follows the other one by"})
    EXPECT_NE(page.find(said), std::string::npos) << said;
  EXPECT_EQ(page.find("What limits this hand"), std::string::npos);
  EXPECT_EQ(page.find("not done: forces contain"), std::string::npos) << "both zeros were set";
  EXPECT_NE(page.find("Target of both"), std::string::npos) << "the last trial as a table";
  for (const char* not_said : {"orrelation of the hands", "Synergy of the hands"})
    EXPECT_EQ(page.find(not_said), std::string::npos) << not_said << ": of research";
  for (const char* format : {"csv", "hdf5", "bids", "fhir"}) {
    const auto exported = isograsp("export --db " + database + " --format " + format + " --out " +
                                   folder.path(format));
    EXPECT_EQ(exported.status, 0) << format << exported.err;
  }
}

TEST(TwoPlatformsApp, WhatBothHandsLiftAndCarryGoesFromSessionToReportAndExports) {
  for (const auto& [protocol, key, curves] :
       test::every(std::vector<std::tuple<std::string, std::string, std::string>>{
           {"two_hands_lifting", "raise_share_affected", "Push up, left hand"},
           {"two_hands_carrying", "path_efficiency", "Squeeze, right hand"}})) {
    const TemporaryFolder folder;
    const std::string database = folder.path("clinic.db");
    const auto run =
        isograsp("run --protocol-file " + kProtocols + protocol + ".toml --db " + database +
                 " --patient B-1 --affected left --fast" + both(kPair, kPair));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find(key), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("least_squeeze (right)"), std::string::npos) << run.out;
    EXPECT_EQ(isograsp("db check " + database).status, 0);
    const auto verified = isograsp("db verify " + database);
    EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
    for (const char* format : {"csv", "hdf5", "bids", "fhir"}) {
      const auto exported = isograsp("export --db " + database + " --format " + format + " --out " +
                                     folder.path(format));
      EXPECT_EQ(exported.status, 0) << format << exported.err;
    }
    // The exported signals, scored again with the task of the library, give what was stored.
    const std::string trial = folder.path("csv") + "/patient_1/session_1/trial_3_signals.csv";
    const std::string task = std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/" +
                             (key == "path_efficiency" ? "two_hands_carry" : "two_hands_lift") +
                             ".toml";
    const auto scored = isograsp("score --task " + task + " --signals " + trial);
    EXPECT_EQ(scored.status, 0) << scored.err;
    EXPECT_NE(scored.out.find(key), std::string::npos) << scored.out;
    for (const char* page : {"r.pdf", "r.html"}) {
      const auto report =
          isograsp("report --patient B-1 --db " + database + " --out " + folder.path(page));
      ASSERT_EQ(report.status, 0) << report.err;
    }
    const std::string page = test::must(read_text(folder.path("r.html")));
    EXPECT_NE(page.find(curves), std::string::npos) << "the last trial as a table";
    EXPECT_NE(page.find("Both hands: lifting and carrying"), std::string::npos);
    EXPECT_NE(page.find(key == "path_efficiency" ? "bubbles, pinch" : "lifted level"),
              std::string::npos);
    EXPECT_NE(page.find(key == "path_efficiency" ? "of 8" : "of 4"), std::string::npos) << protocol;
  }
}

TEST(TwoPlatformsApp, APatientCarriesInOneWayAndTheStudyIsOfVolunteers) {
  const TemporaryFolder folder;
  const auto protocol =
      folder.write("two.toml",
                   "format = \"isograsp-protocol-1\"\nname = \"Two ways\"\n[[step]]\nkind = "
                   "\"instrument_zero\"\n"
                   "[[step]]\nkind = \"task\"\ntask = \"two_hands_rest.toml\"\n"
                   "[[step]]\nkind = \"task\"\ntask = \"two_hands_maximum.toml\"\n"
                   "[[step]]\nkind = \"task\"\ntask = \"two_hands_carry_bubble_pinch.toml\"\n"
                   "[[step]]\nkind = \"task\"\ntask = \"two_hands_carry_clutch_pinch.toml\"\n");
  const std::string healthy = "'sim://pair?file=healthy&seed=3'";
  const auto patient = isograsp("run --protocol-file " + protocol + " --db " + folder.path("p.db") +
                                " --patient B-1 --affected left --fast" + both(healthy, healthy));
  EXPECT_NE((patient.out + patient.err).find("another way"), std::string::npos)
      << patient.out << patient.err;
  const auto volunteer =
      isograsp("run --protocol-file " + protocol + " --db " + folder.path("v.db") +
               " --patient B-1 --fast" + both(healthy, healthy));
  EXPECT_EQ(volunteer.status, 0) << volunteer.err;
  EXPECT_EQ((volunteer.out + volunteer.err).find("another way"), std::string::npos)
      << volunteer.out << volunteer.err;
}

/// Forces of one hand on its platform, 0.01 s after 0.01 s: quiet enough for a zero, no sensor that
/// stands still, and what `presses` adds to thumb, index and middle: f_x and f_z of each [N].
using Presses = std::function<std::array<double, 6>(double t_s)>;
std::string forces_of_a_hand(double duration_s, const Presses& presses = {}) {
  std::string text =
      "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N,index_fx_N,index_fy_N,index_fz_N,middle_fx_N,"
      "middle_fy_N,middle_fz_N\n";
  constexpr double kFrame_s = 0.01;
  for (int k = 0; k * kFrame_s < duration_s; ++k) {
    const double t_s = k * kFrame_s;
    const auto pressed = presses ? presses(t_s) : std::array<double, 6>{};
    text += format_number(t_s);
    for (int axis = 0; axis < 9; ++axis) {
      const auto digit = static_cast<std::size_t>(axis / 3);
      const double f_N = axis % 3 == 0   ? pressed[2 * digit]
                         : axis % 3 == 2 ? pressed[2 * digit + 1]
                                         : 0.0;
      text += "," + format_number(f_N + 0.02 * std::sin(0.3 * k + axis));
    }
    text += "\n";
  }
  return text;
}

/// A device file of three boxes from this address on.
std::string boxes(const TemporaryFolder& folder, const char* hand, int first) {
  std::string text =
      "format = \"isograsp-device-1\"\nname = \"boxes\"\nprotocol = \"net-ft\"\n"
      "rate_Hz = 500\nfir_taps = 33\nfir_cutoff_Hz = 31.25\nhand = \"" +
      std::string(hand) + "\"\n";
  for (int f = 0; f < 3; ++f)
    text += std::string("[[sensor]]\nfinger = \"") +
            (f == 0   ? "thumb"
             : f == 1 ? "index"
                      : "middle") +
            "\"\naddress = \"127.0.0." + std::to_string(first + f) +
            ":49552:8552\"\nserial_number = \"" + hand + "-" + std::to_string(f) +
            "\"\nrange_N = [145, 145, 290]\nrange_Nm = [5, 5, 5]\n";
  return folder.write(std::string(hand) + ".toml", text);
}

std::string emulated(const std::string& file, int first, const std::string& play, int duration_s) {
  return "\"" ISOGRASP_EXECUTABLE "\" emulate --protocol net-ft --config " + file +
         " --on 127.0.0." + std::to_string(first) + ":49552:8552 --play " + play + " --duration " +
         std::to_string(duration_s) + " --json";
}

TEST(TwoPlatformsApp, TwoPlatformsOnRealSocketsAreOneSessionWithTheirSkew) {
  const TemporaryFolder folder;
  constexpr int kPlay_s = 30;
  const std::string play = folder.write("quiet.csv", forces_of_a_hand(2.0 * kPlay_s));
  const std::string left = boxes(folder, "left", 21);
  const std::string right = boxes(folder, "right", 31);
  const test::BackgroundCommand left_boxes(emulated(left, 21, play, kPlay_s));
  const test::BackgroundCommand right_boxes(emulated(right, 31, play, kPlay_s));
  static_cast<void>(folder.write("rest.toml",
                                 "format = \"isograsp-task-1\"\nname = \"Both at rest\"\n"
                                 "instruction = \"Rest.\"\nkind = \"bilateral_rest\"\n"
                                 "duration_s = 3\n"));
  const std::string protocol = folder.write(
      "p.toml",
      "format = \"isograsp-protocol-1\"\nname = \"Short\"\n[[step]]\nkind = \"instrument_zero\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"rest.toml\"\n");
  const std::string database = folder.path("clinic.db");
  const auto run = [&](const std::string& first, const std::string& second) {
    return isograsp("run --protocol-file " + protocol + " --db " + database + " --patient B-1" +
                    both("'udp://?config=" + first + "'", "'udp://?config=" + second + "'"));
  };
  test::CommandResult done;
  ASSERT_TRUE(left_boxes.wait_until([&] {
    done = run(left, right);
    return done.status == 0;
  })) << done.err
      << left_boxes.err() << right_boxes.err();
  EXPECT_NE(done.out.find("resting_force (right)"), std::string::npos) << done.out;
  // The platforms of the other hands are not taken for those of these.
  const auto crossed = run(right, left);
  EXPECT_EQ(crossed.status, 2);
  EXPECT_NE(crossed.err.find("set up for the right hand"), std::string::npos) << crossed.err;
  const auto exported =
      isograsp("export --db " + database + " --format csv --out " + folder.path("csv"));
  ASSERT_EQ(exported.status, 0) << exported.err;
  const std::string table =
      test::must(read_text(folder.path("csv") + "/patient_1/session_1/trial_1_signals.csv"));
  left_boxes.wait_for_end();
  right_boxes.wait_for_end();
  for (const char* column :
       {"left_thumb_fz_N", "right_middle_tz_Nm", "left_push_x_N", "skew_s", "left_thumb_fx_counts"})
    EXPECT_NE(table.find(column), std::string::npos) << column;
}

/// What either hand plays: it rests, then squeezes again and again and pushes inwards and up. Thumb
/// and fingers press against each other (z of their contacts); what the fingers press more is the
/// squeeze, x of the contacts is up.
struct Lifting {
  double from_s = 14.0;  ///< zero and rest are over
  double grip_N = 20.0;
  double squeeze_N = 0.0;
  double raise_N = 0.0;

  std::array<double, 6> operator()(double t_s) const {
    constexpr double kPeriod_s = 4.0, kOn_s = 3.0, kRamp_s = 0.3;
    if (t_s < from_s) return {};
    const double at_s = std::fmod(t_s - from_s, kPeriod_s);
    const double level = std::clamp(std::min(at_s, kOn_s - at_s) / kRamp_s, 0.0, 1.0);
    const double finger_N = 0.5 * (grip_N + squeeze_N);
    return {level * raise_N, level * grip_N, 0.0, level * finger_N, 0.0, level * finger_N};
  }
};

/// A session on two sets of boxes that play such hands, and what comes of it.
struct BoxesSession {
  TemporaryFolder folder;
  std::string database = folder.path("clinic.db");
  test::CommandResult run;
  bool boxes_well = false;  ///< they played to their end

  void play(const Lifting& hand) {
    constexpr int kPlay_s = 60;
    const std::string forces = folder.write("lifting.csv", forces_of_a_hand(2.0 * kPlay_s, hand));
    const std::string left = boxes(folder, "left", 41);
    const std::string right = boxes(folder, "right", 51);
    const test::BackgroundCommand left_boxes(emulated(left, 41, forces, kPlay_s));
    const test::BackgroundCommand right_boxes(emulated(right, 51, forces, kPlay_s));
    const std::string protocol = write_protocol();
    static_cast<void>(left_boxes.wait_until([&] {
      run = isograsp("run --protocol-file " + protocol + " --db " + database +
                     " --patient B-1 --affected left" +
                     both("'udp://?config=" + left + "'", "'udp://?config=" + right + "'"));
      return run.status == 0;
    }));
    left_boxes.wait_for_end();
    right_boxes.wait_for_end();
    boxes_well = left_boxes.status() == 0 && right_boxes.status() == 0;
  }

 private:
  [[nodiscard]] std::string write_protocol() const {
    const auto task = [&](const std::string& file, const std::string& rest) {
      static_cast<void>(folder.write(file, "format = \"isograsp-task-1\"\nname = \"" + file +
                                               "\"\ninstruction = \"Do it.\"\n" + rest));
      return "[[step]]\nkind = \"task\"\ntask = \"" + file + "\"\n";
    };
    // Each effort is longer than the pulses are apart, so that each finds one.
    return folder.write(
        "p.toml",
        "format = \"isograsp-protocol-1\"\nname = \"Lift\"\n[[step]]\nkind = "
        "\"instrument_zero\"\n" +
            task("rest.toml", "kind = \"bilateral_rest\"\nduration_s = 3\n") +
            "[[step]]\nkind = \"pause\"\nduration_s = 15\n" +
            task("maximum.toml",
                 "kind = \"bilateral_maximum\"\nlead_in_s = 1\nsqueeze_s = 5\nrest_s = 0\n") +
            task("lift.toml",
                 "kind = \"bimanual_lift\"\nscene = \"tray_on_springs\"\nlevel_fraction = 0.25\n"
                 "position_tolerance_m = 0.02\nlifts = 1\nhold_s = 0.5\ntime_limit_s = 10\n"
                 "lead_in_s = 1\n"));
  }
};

TEST(LiftOnBoxes, ATrayIsLiftedOnTwoSetsOfBoxesFromSessionToReport) {
  // tray_on_springs.toml asks 5.5 N up and 10.3 N inwards of each hand; level_fraction of the grip
  // makes it lighter.
  Lifting hand;
  constexpr double kLevel = 0.25, kUp_N = 5.471, kInwards_N = 1.5 * kUp_N / 0.8;
  const double strength = kLevel * hand.grip_N / std::hypot(kUp_N, kInwards_N);
  hand.raise_N = strength * kUp_N;
  hand.squeeze_N = strength * kInwards_N;
  // Hands that are played do not wait for a computer that others hold up: samples that come late
  // are no maximum. It is tried again then.
  constexpr int kAttempts = 3;
  std::optional<BoxesSession> session;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    session.emplace().play(hand);
    if (session->run.out.find("1 of 1") != std::string::npos) break;
  }
  EXPECT_EQ(session->run.status, 0) << session->run.err;
  EXPECT_TRUE(session->boxes_well);
  EXPECT_NE(session->run.out.find("1 of 1"), std::string::npos) << "it was lifted\n"
                                                                << session->run.out;
  const auto verified = isograsp("db verify " + session->database);
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  const std::string file = session->folder.path("r.html");
  const auto report = isograsp("report --patient B-1 --db " + session->database + " --out " + file);
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = test::must(read_text(file));
  EXPECT_NE(page.find("Push up, left hand"), std::string::npos) << "the last trial as a table";
  EXPECT_NE(page.find("1 of 1"), std::string::npos) << "on the page of both hands";
  EXPECT_EQ(page.find("SIMULATED"), std::string::npos) << "boxes on sockets are devices";
}

}  // namespace
}  // namespace isograsp::app::two_platforms_test
