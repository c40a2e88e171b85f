// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way of an arm as a user goes it: cameras (in software, on a real port), session,
// database, scores, export, report.
#include <cmath>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/drinking_motion.hpp"
#include "tests/support/every.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::app::arm_test {
namespace {

using test::isograsp;
using test::TemporaryFolder;

/// A start posture, a short range and four turns.
std::string short_protocol(const TemporaryFolder& folder) {
  static_cast<void>(folder.write(
      "range.toml",
      "format = \"isograsp-task-1\"\nname = \"Short range\"\ninstruction = \"Turn.\"\nkind = "
      "\"active_range\"\nlink = \"forearm\"\nangle = 3\nlead_in_s = 0.2\nduration_s = 2\n"));
  return folder.write("short.toml",
                      "format = \"isograsp-protocol-1\"\nname = \"Short\"\n[[step]]\nkind = "
                      "\"start_posture\"\n[[step]]\nkind = \"task\"\ntask = \"range.toml\"\n"
                      "[[step]]\nkind = \"task\"\ntask = \"arm_screw.toml\"\n");
}

std::string run(const TemporaryFolder& folder, const std::string& device, const std::string& more) {
  return "run --device '" + device + "' --protocol-file " + short_protocol(folder) + " --db " +
         folder.path("clinic.db") + " " + more;
}

/// The measure as it is printed; NaN: it has no value.
double printed(const std::string& out, const std::string& name) {
  double value = std::nan("");
  const std::regex line("    " + name + " \\([a-z_0-9]+\\) +([-0-9.e+]+) ");
  for (std::sregex_iterator at(out.begin(), out.end(), line), end; at != end; ++at)
    value = std::stod((*at)[1]);
  return value;
}

TEST(Arm, ASimulatedOneGoesFromMarkersToAReport) {
  const TemporaryFolder folder;
  const auto healthy =
      isograsp(run(folder, "sim://arm?patient=healthy&seed=3", "--patient A-1 --fast"));
  ASSERT_EQ(healthy.status, 0) << healthy.err;
  EXPECT_EQ(printed(healthy.out, "targets_reached"), 4.0) << healthy.out;
  const auto left =
      isograsp(run(folder, "sim://arm?patient=healthy&seed=3", "--patient A-1 --fast --hand left"));
  ASSERT_EQ(left.status, 0) << left.err;
  EXPECT_EQ(printed(left.out, "targets_reached"), 4.0) << left.out;
  const auto verified = isograsp("db verify " + folder.path("clinic.db"));
  EXPECT_EQ(verified.status, 0) << verified.out;
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
  const auto report = isograsp("report --patient A-1 --db " + folder.path("clinic.db") + " --out " +
                               folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = test::must(read_text(folder.path("r.html")));
  for (const char* said : {"Turn an object in and out", "held still; largest wander of a link",
                           "Time of the movement"})
    EXPECT_NE(page.find(said), std::string::npos) << said;
  for (const char* not_said : {"grip force", "Instrument zero", "What limits this hand"})
    EXPECT_EQ(page.find(not_said), std::string::npos) << not_said;
}

TEST(Arm, ASimulatedPersonIsTheSameOnADayAndInAnotherFormOnTheNext) {
  const TemporaryFolder folder;
  const auto on_day = [&](const std::string& day) {
    const auto done =
        isograsp(run(folder, "sim://arm?patient=paretic&seed=3&recovery=0.5&day=" + day,
                     "--patient A-1 --fast"));
    EXPECT_EQ(done.status, 0) << done.err;
    return printed(done.out, "rotation");
  };
  const double first = on_day("0");
  EXPECT_EQ(first, on_day("0"));
  EXPECT_NE(first, on_day("1"));
}

TEST(Arm, IsAskedForAPartOfItsOwnRangeOfToday) {
  const TemporaryFolder folder;
  const std::string with_protocol = "--protocol-file " + std::string(ISOGRASP_SOURCE_DIR) +
                                    "/library/protocols/arm_assessment_own_range.toml --db " +
                                    folder.path("clinic.db") + " --fast ";
  // A paretic arm does not reach a fixed posture; its own range it does.
  const auto done = isograsp("run --device 'sim://arm?patient=paretic&seed=3' " + with_protocol +
                             "--patient A-1");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_GE(printed(done.out, "targets_reached"), 3.0) << done.out;
  const auto verified = isograsp("db verify " + folder.path("clinic.db"));
  EXPECT_EQ(verified.status, 0) << verified.out;

  const std::string without = folder.write(
      "without.toml",
      "format = \"isograsp-protocol-1\"\nname = \"Without\"\n[[step]]\nkind = \"start_posture\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"arm_own_range.toml\"\n");
  const auto refused = isograsp("run --device 'sim://arm?seed=3' --protocol-file " + without +
                                " --db " + folder.path("clinic.db") + " --fast --patient A-2");
  EXPECT_NE((refused.out + refused.err).find("has not been measured in this session"),
            std::string::npos)
      << refused.out << refused.err;
}

TEST(Arm, ASimulatedPersonDrinksWhereTheRigNamesTheirMarkers) {
  const TemporaryFolder folder;
  const auto total_s = [&](const std::string& patient) {
    const auto done =
        isograsp("run --device 'sim://arm?patient=" + patient + "&seed=3&rig=drinking' " +
                 "--protocol-file " + std::string(ISOGRASP_SOURCE_DIR) +
                 "/library/protocols/arm_drinks.toml --db " + folder.path("clinic.db") +
                 " --patient A-1 --fast");
    EXPECT_EQ(done.status, 0) << done.err;
    return printed(done.out, "total_movement_time");
  };
  const double healthy_s = total_s("healthy");
  const double paretic_s = total_s("paretic");
  EXPECT_GT(healthy_s, 3.0);
  EXPECT_GT(paretic_s, 1.5 * healthy_s);
}

TEST(Arm, APareticReachesLessOrLaterAndMovesItsElbow) {
  double healthy_s = 0.0;
  double paretic_s = 0.0;
  for (int seed = 1; seed <= 3; ++seed) {
    const TemporaryFolder folder;
    const auto time = [&](const std::string& patient) {
      const auto done =
          isograsp(run(folder, "sim://arm?patient=" + patient + "&seed=" + std::to_string(seed),
                       "--patient A-1 --fast"));
      EXPECT_EQ(done.status, 0) << done.err;
      return printed(done.out, "restricted_mean_time");
    };
    healthy_s += time("healthy");
    paretic_s += time("paretic");
  }
  EXPECT_GT(paretic_s, 1.5 * healthy_s);
}

/// All values of a measure, in the order in which they are printed.
std::vector<double> all_printed(const std::string& out, const std::string& name) {
  std::vector<double> values;
  const std::regex line("    " + name + " \\([a-z_0-9]+\\) +(-?[0-9][-0-9.e+]*) ");
  for (std::sregex_iterator at(out.begin(), out.end(), line), end; at != end; ++at)
    values.push_back(std::stod((*at)[1]));
  return values;
}

TEST(Arm, TheRangesOfAnAssessmentAreThoseOfThePerson) {
  const TemporaryFolder folder;
  const auto ranges = [&](const std::string& patient) {
    const auto done = isograsp("run --device 'sim://arm?patient=" + patient +
                               "&seed=4' --protocol-file " ISOGRASP_SOURCE_DIR
                               "/library/protocols/arm_assessment.toml --db " +
                               folder.path("clinic.db") + " --patient A-1 --fast");
    EXPECT_EQ(done.status, 0) << done.err;
    return all_printed(done.out, "active_range");
  };
  const auto healthy = ranges("healthy");
  const auto paretic = ranges("paretic");
  ASSERT_EQ(healthy.size(), 3u) << "turning the forearm, bending and tilting the wrist";
  ASSERT_EQ(paretic.size(), 3u);
  // In radians: far more than an arm at rest trembles.
  constexpr double kLeast_rad[] = {1.5, 1.2, 0.5};
  for (std::size_t i = 0; i < healthy.size(); ++i) {
    EXPECT_GT(healthy[i], kLeast_rad[i]) << i;
    EXPECT_LT(paretic[i], 0.85 * healthy[i]) << i;
    EXPECT_GT(paretic[i], 0.2) << i;
  }
}

TEST(Arm, AMovingReferenceIsFollowedScoredVerifiedAndReported) {
  const TemporaryFolder folder;
  const auto run_following = [&](const std::string& patient) {
    const auto done = isograsp("run --device 'sim://arm?patient=" + patient +
                               "&seed=4' --protocol-file " ISOGRASP_SOURCE_DIR
                               "/library/protocols/arm_following.toml --db " +
                               folder.path("clinic.db") + " --patient A-1 --fast");
    EXPECT_EQ(done.status, 0) << done.err;
    return done.out;
  };
  const std::string healthy = run_following("healthy");
  const std::string paretic = run_following("paretic");
  const auto error = all_printed(healthy, "rmse");
  ASSERT_EQ(error.size(), 2u * 6u) << "of position and attitude, two of practice and twice each\n"
                                   << healthy;
  const auto other = all_printed(paretic, "rmse");
  ASSERT_EQ(other.size(), error.size()) << paretic;
  double healthy_sum = 0.0, paretic_sum = 0.0;
  for (std::size_t i = 1; i < error.size(); i += 2) {
    healthy_sum += error[i];
    paretic_sum += other[i];
  }
  EXPECT_GT(paretic_sum, 1.3 * healthy_sum) << "angles";
  for (const double lag_s : all_printed(healthy, "lag")) EXPECT_LT(std::abs(lag_s), 0.8);
  const auto verified = isograsp("db verify " + folder.path("clinic.db"));
  EXPECT_EQ(verified.status, 0) << verified.out;
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
  EXPECT_EQ(isograsp("report --patient A-1 --db " + folder.path("clinic.db") + " --out " +
                     folder.path("r.html"))
                .status,
            0);
  EXPECT_NE(test::must(read_text(folder.path("r.html"))).find("Follow an object that turns"),
            std::string::npos);
}

/// What the cameras showed in the trial of the exported signals: `still_s` of its first picture,
/// then all of them.
std::string marker_csv(const TemporaryFolder& folder, const std::string& signals, double still_s) {
  std::istringstream in(test::must(read_text(signals)));
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names;
  for (std::istringstream head(line); std::getline(head, line, ',');) names.push_back(line);
  std::vector<std::vector<std::string>> rows;
  while (std::getline(in, line)) {
    std::vector<std::string> fields;
    std::string field;
    for (std::istringstream row(line); std::getline(row, field, ',');) fields.push_back(field);
    fields.resize(names.size());
    rows.push_back(fields);
  }
  const auto write_row = [&](std::ostream& out, double t_s, const std::vector<std::string>& row) {
    out << format_number(t_s);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].starts_with("marker_")) out << ',' << row[i];
    out << '\n';
  };
  std::ostringstream out;
  out << "t_s";
  for (const std::string& name : names)
    if (name.starts_with("marker_")) out << ',' << name.substr(7);
  out << '\n';
  constexpr double kPeriod_s = 0.01;
  double t_s = 0.0;
  for (; t_s < still_s; t_s += kPeriod_s) write_row(out, t_s, rows.front());
  for (const auto& row : rows) write_row(out, t_s += kPeriod_s, row);
  return folder.write("arm.csv", out.str());
}

/// A recording of what cameras see: an arm that is still, then does a trial of arm_screw.
std::string recorded_arm(const TemporaryFolder& folder) {
  static_cast<void>(short_protocol(folder));  // the tasks that a test asks for
  const std::string turns =
      folder.write("turns.toml",
                   "format = \"isograsp-protocol-1\"\nname = \"Turns\"\n[[step]]\nkind = "
                   "\"start_posture\"\n[[step]]\nkind = \"task\"\ntask = \"arm_screw.toml\"\n");
  EXPECT_EQ(isograsp("run --device 'sim://arm?seed=5' --protocol-file " + turns + " --db " +
                     folder.path("clinic.db") + " --patient A-1 --fast")
                .status,
            0);
  EXPECT_EQ(isograsp("export --db " + folder.path("clinic.db") + " --format csv --out " +
                     folder.path("ex"))
                .status,
            0);
  constexpr double kStill_s = 4.0;
  return marker_csv(folder, folder.path("ex/patient_1/session_1/trial_1_signals.csv"), kStill_s);
}

TEST(Arm, EmulatedCamerasOnARealPortGiveASessionWithAReport) {
  const TemporaryFolder folder;
  const std::string play = recorded_arm(folder);
  const std::string port = std::to_string(test::free_port());
  const test::BackgroundCommand cameras("\"" ISOGRASP_EXECUTABLE
                                        "\" emulate --protocol qtm-rt --duration 40 --on "
                                        "127.0.0.1:" +
                                        port + " --play " + play);
  ASSERT_TRUE(cameras.wait_until([&] { return cameras.err().find(port) != std::string::npos; }))
      << cameras.err();
  static_cast<void>(folder.write("only_range.toml",
                                 "format = \"isograsp-protocol-1\"\nname = \"Range\"\n[[step]]\n"
                                 "kind = \"start_posture\"\n[[step]]\nkind = \"task\"\ntask = "
                                 "\"range.toml\"\n"));
  const auto live =
      isograsp("run --device 'qtm://127.0.0.1:" + port + "?rig=kurillo15_trunk' --protocol-file " +
               folder.path("only_range.toml") + " --patient A-2 --db " + folder.path("clinic.db"));
  ASSERT_EQ(live.status, 0) << live.err << live.out;
  EXPECT_FALSE(std::isnan(printed(live.out, "active_range"))) << live.out;
  const auto verified = isograsp("db verify " + folder.path("clinic.db"));
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
  EXPECT_EQ(isograsp("report --patient A-2 --db " + folder.path("clinic.db") + " --out " +
                     folder.path("r.pdf"))
                .status,
            0);
  cameras.wait_for_end();
  EXPECT_EQ(cameras.status(), 0) << cameras.err();
}

TEST(Arm, ARecordingOfMarkersIsASessionToo) {
  const TemporaryFolder folder;
  const std::string play = recorded_arm(folder);
  const auto replayed =
      isograsp(run(folder, "replay://" + play + "?rig=kurillo15_trunk", "--patient A-3 --fast"));
  EXPECT_NE(replayed.out.find("Short range"), std::string::npos) << replayed.out << replayed.err;
}

/// A person who drinks, as cameras would record it.
std::string recorded_drink(const TemporaryFolder& folder) {
  const DrinkingMarkers drink = test::healthy_drinking();
  const std::pair<const char*, const std::vector<Vec3>*> parts[] = {
      {"HAND", &drink.hand},   {"GLASS", &drink.glass},       {"FACE", &drink.face},
      {"TRUNK", &drink.trunk}, {"SHOULDER", &drink.shoulder}, {"ELBOW", &drink.elbow},
      {"WRIST", &drink.wrist}};
  std::ostringstream out;
  out << "t_s";
  for (const auto& [name, p] : parts)
    for (const char* axis : {"_x_m", "_y_m", "_z_m"}) out << ',' << name << axis;
  out << '\n';
  for (std::size_t k = 0; k < drink.t_s.size(); ++k) {
    out << format_number(drink.t_s[k]);
    for (const auto& [name, p] : parts)
      for (int axis = 0; axis < 3; ++axis) out << ',' << format_number((*p)[k][axis]);
    out << '\n';
  }
  return folder.write("drink.csv", out.str());
}

TEST(Arm, ADrinkGoesFromMarkersToAReportWithoutAStartPosture) {
  const TemporaryFolder folder;
  const std::string play = recorded_drink(folder);
  static_cast<void>(folder.write(
      "drink.toml",
      "format = \"isograsp-task-1\"\nname = \"One drink\"\ninstruction = \"Drink.\"\nkind = "
      "\"drinking\"\nlead_in_s = 0.1\nduration_s = 6.5\n"));
  const std::string protocol =
      folder.write("drinks.toml",
                   "format = \"isograsp-protocol-1\"\nname = \"Drinks\"\n[[step]]\nkind = "
                   "\"task\"\ntask = \"drink.toml\"\n");
  const auto done =
      isograsp("run --device 'replay://" + play + "?rig=drinking' --protocol-file " + protocol +
               " --db " + folder.path("clinic.db") + " --patient A-4 --fast");
  ASSERT_EQ(done.status, 0) << done.err << done.out;
  const DrinkingTask whole = drinking_task(test::healthy_drinking());
  constexpr double kPrinted = 1e-3;  // digits that are printed
  EXPECT_NEAR(printed(done.out, "total_movement_time"), *whole.measures.front().value, kPrinted)
      << done.out;
  const auto verified = isograsp("db verify " + folder.path("clinic.db"));
  EXPECT_EQ(verified.status, 0) << verified.out;
  EXPECT_NE(verified.out.find("largest relative difference 0"), std::string::npos) << verified.out;
  EXPECT_EQ(isograsp("report --patient A-4 --db " + folder.path("clinic.db") + " --out " +
                     folder.path("r.html"))
                .status,
            0);
  const std::string page = test::must(read_text(folder.path("r.html")));
  EXPECT_NE(page.find("Time of the whole movement"), std::string::npos);
}

TEST(Arm, ATaskThatRigOrMarkersDoNotFitIsRefusedInOneSentence) {
  const TemporaryFolder folder;
  const std::string play = recorded_drink(folder);
  const auto refusal = [&](const std::string& device, const std::string& step) {
    const std::string protocol = folder.write(
        "one.toml", "format = \"isograsp-protocol-1\"\nname = \"One\"\n[[step]]\n" + step);
    const auto done = isograsp("run --device '" + device + "' --protocol-file " + protocol +
                               " --db " + folder.path("clinic.db") + " --patient A-4 --fast");
    EXPECT_EQ(done.out.find("Trial"), std::string::npos) << done.out;
    return done.err;
  };
  const std::string drinks = "kind = \"task\"\ntask = \"arm_drinking.toml\"\n";
  EXPECT_NE(refusal("sim://arm", drinks).find("needs the marker 'HAND'"), std::string::npos);
  const std::string alone = "replay://" + play + "?rig=drinking";
  EXPECT_NE(refusal(alone, "kind = \"task\"\ntask = \"arm_screw.toml\"\n")
                .find("needs a rig with a chain"),
            std::string::npos);
  EXPECT_NE(refusal(alone, "kind = \"start_posture\"\n").find("has no start posture"),
            std::string::npos);
}

TEST(Arm, WhatDoesNotFitIsOneSentenceAndNothingIsWritten) {
  const TemporaryFolder folder;
  for (const auto& [device, said] : test::every(std::vector<std::pair<std::string, std::string>>{
           {"sim://arm?patient=nobody", "there is no simulated arm 'nobody'"},
           {"sim://arm?rig=none", "none"},
           {"qtm://127.0.0.1:9?rig=kurillo15", "127.0.0.1:9"},
           {"qtm://127.0.0.1:9", "names no rig"},
           {"sim://healthy", "arm"}})) {
    const auto refused = isograsp(run(folder, device, "--patient A-1 --fast"));
    EXPECT_NE(refused.status, 0) << device;
    EXPECT_NE(refused.err.find(said), std::string::npos) << device << ": " << refused.err;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path("clinic.db"))) << device;
  }
}

}  // namespace
}  // namespace isograsp::app::arm_test
