// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers: from recordings to measures through the command line.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "kinematics/posture_edit.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::markers_test {
namespace {

using test::isograsp;
using test::read_file;
using test::TemporaryFolder;

std::string data(const std::string& name) {
  return ISOGRASP_SOURCE_DIR "/tests/data/isotonic/" + name;
}

/// Runs `isograsp markers …`, which must succeed; its JSON.
nlohmann::json answer(const std::string& words) {
  const auto done = isograsp("markers " + words + " --json");
  EXPECT_EQ(done.status, 0) << done.err;
  return nlohmann::json::parse(done.out, nullptr, false);
}

TEST(Markers, GoFromARecordingToPosesLinksEventsAndMeasures) {
  const TemporaryFolder folder;
  const std::string rig = " --rig " + data("kurillo15.toml");
  const std::string poses = folder.path("p.csv");
  ASSERT_EQ(
      isograsp("markers poses" + rig + " --in " + data("session_a_markers.csv") + " --out " + poses)
          .status,
      0);
  EXPECT_EQ(read_file(poses).rfind("# hand: right\nt_s,brace_x_m,", 0), 0U);
  ASSERT_EQ(isograsp("markers links" + rig + " --poses " + poses + " --out " + folder.path("l.csv"))
                .status,
            0);
  EXPECT_NE(read_file(folder.path("l.csv")).find("EF_a3_rad"), std::string::npos);
  const auto rom = answer("rom" + rig + " --poses " + poses)["rom"];
  EXPECT_EQ(rom.size(), 12U);
  EXPECT_LE(rom[0]["min_rad"], rom[0]["min_held_rad"]);
  const auto measures =
      answer("score" + rig + " --poses " + data("session_a_poses.csv") + " --events " +
             data("session_a_events.csv") + " --bands " + folder.path("b.csv"))["measures"];
  EXPECT_EQ(measures.size(), 3U * 37U);
  EXPECT_EQ(measures[0]["channel"], "task");
  EXPECT_NE(read_file(folder.path("b.csv")).find("screw,EF_r,"), std::string::npos);
  ASSERT_EQ(isograsp("markers task --task " + data("task_plain_task.toml") + " --poses " +
                     data("task_plain_poses.csv") + " --out " + folder.path("e.csv"))
                .status,
            0);
  EXPECT_NE(read_file(folder.path("e.csv")).find("unscrew,11.21,,17.21,,,"), std::string::npos);
}

TEST(Markers, QualityStandsBesideTheScore) {
  const std::string files = "quality --rig " + data("kurillo15.toml") + " --poses " +
                            data("session_a_poses.csv") + " --events " +
                            data("session_a_events.csv");
  const auto all = answer(files + " --range EF:1:-1.5:1.5 --range DO:3:-1:1");
  std::map<std::string, int> with_value;
  test::AtLeast measures(30);
  for (const auto& one : test::every(all["measures"])) {
    ++measures;
    EXPECT_NE(one["value"].is_null(), !one.contains("reason")) << one.dump();
    if (!one["value"].is_null()) ++with_value[one["name"].get<std::string>()];
  }
  for (const char* name :
       {"sparc", "ldlj", "peak_speed", "coupling_slope", "lead", "range_margin", "movement_time"})
    EXPECT_GT(with_value[name], 0) << name;
  EXPECT_EQ(with_value["trunk_displacement"], 0) << "this rig has none";
  test::AtLeast notes(1);
  for (const auto& one : all["notes"])
    if (one["note"] == "trunk not measured") ++notes;
  EXPECT_EQ(isograsp("markers " + files + " --range EF:1:-1.5").status, 2);
  EXPECT_EQ(isograsp("markers " + files + " --range leg:1:-1:1").status, 2);
}

TEST(Markers, TheDrinkingTaskIsMeasuredFromNamedMarkers) {
  const TemporaryFolder folder;
  std::string csv = "t_s,H_x_m,H_y_m,H_z_m,G_x_m,G_y_m,G_z_m,N_x_m,N_y_m,N_z_m\n";
  const auto gone = [](double t_s, double from_s) {
    const double s = std::clamp(t_s - from_s, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
  };
  for (int k = 0; k <= 700; ++k) {
    const double t_s = k * 0.01;
    const double carried = 0.35 * (gone(t_s, 1.8) - gone(t_s, 4.0));
    const double hand = 0.3 * (gone(t_s, 0.5) - gone(t_s, 5.3)) + carried;
    csv += std::to_string(t_s) + "," + std::to_string(hand) + ",0.1,0.1," +
           std::to_string(0.3 + carried) + ",0.1,0.1,0.7,0.1,0.1\n";
  }
  const std::string words =
      "drinking --in " + folder.write("d.csv", csv) + " --hand-marker H --glass G";
  const auto all = answer(words + " --face N");
  ASSERT_EQ(all["phases"].size(), 5U) << all.dump();
  EXPECT_EQ(all["phases"][2]["phase"], "drinking");
  EXPECT_EQ(all["measures"][0]["name"], "total_movement_time");
  constexpr double kFeet_s = 0.2;
  EXPECT_WITHIN(all["measures"][0]["value"].get<double>(), 5.8, kFeet_s);
  EXPECT_EQ(isograsp("markers " + words + " --face nose").status, 2);
  EXPECT_EQ(isograsp("markers " + words).status, 2) << "the face is needed";
}

TEST(Markers, ARecordingBecomesAC3dFileAndATableAgain) {
  const TemporaryFolder folder;
  const std::string in = data("session_a_markers.csv");
  for (const char* numbers : {"", " --integer"}) {
    ASSERT_EQ(isograsp("markers convert " + in + " --out " + folder.path("a.c3d") + numbers).status,
              0);
    ASSERT_EQ(isograsp("markers convert " + folder.path("a.c3d") + " --out " + folder.path("b.csv"))
                  .status,
              0);
    const std::string commented = read_file(in);
    const std::string before = commented.substr(commented.find('\n') + 1);
    const std::string after = read_file(folder.path("b.csv"));
    EXPECT_EQ(std::count(after.begin(), after.end(), '\n'),
              std::count(before.begin(), before.end(), '\n'));
    EXPECT_EQ(after.substr(0, after.find('\n')), before.substr(0, before.find('\n')));
  }
  EXPECT_EQ(isograsp("markers convert " + in + " --integer --out " + folder.path("c.csv")).status,
            2);
}

TEST(Markers, ALeftArmIsMarkedInItsPoses) {
  const TemporaryFolder folder;
  const std::string command = "markers poses --hand left --rig " + data("kurillo15.toml") +
                              " --in " + data("session_a_markers.csv") + " --out ";
  ASSERT_EQ(isograsp(command + folder.path("p.csv")).status, 0);
  EXPECT_EQ(read_file(folder.path("p.csv")).rfind("# hand: left\n", 0), 0U);
}

TEST(Markers, PosturesAreRecordedAndGivenBackToTheSameArm) {
  const TemporaryFolder folder;
  const std::string rig = " --rig " + data("kurillo15.toml");
  // One row, in which all markers are seen.
  const std::string all = read_file(data("session_a_markers.csv"));
  const auto header = all.find("t_s,");
  const auto first = all.find('\n', header) + 1;
  const std::string still =
      folder.write("still.csv", all.substr(header, all.find('\n', first) + 1 - header));
  ASSERT_EQ(isograsp("markers postures" + rig + " --in initial=" + still + " --out " +
                     folder.path("lib.toml"))
                .status,
            0);
  ASSERT_EQ(
      isograsp("markers poses" + rig + " --in " + still + " --out " + folder.path("p.csv")).status,
      0);
  const auto adapted =
      answer("adapt --postures " + folder.path("lib.toml") + " --start " + folder.path("p.csv"));
  ASSERT_EQ(adapted["poses"].size(), 1U);
  const std::string poses = read_file(folder.path("p.csv"));
  const auto object = poses.rfind(",ok,");  // the object's pose begins behind the dorsum's state
  constexpr double kBack_m = 1e-12;
  EXPECT_WITHIN(adapted["poses"][0]["position_m"][0].get<double>(),
                std::strtod(poses.c_str() + object + 4, nullptr), kBack_m);
  const auto other = isograsp("markers adapt --postures " + folder.path("lib.toml") + " --start " +
                              data("task_plain_poses.csv"));
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("has no frame 'elbow'"), std::string::npos) << other.err;
}

TEST(Markers, PosturesThatWereChangedByHandAreAdaptedAsTheyStandInTheirFile) {
  const TemporaryFolder folder;
  Postures library = test::must(parse_postures(read_file(data("postures.toml")), "postures.toml"));
  const Posture initial = library.postures.front();
  const Posture turned = with_link_changed(initial, 1, turn_about(EditAxis::x, 0.5), EditAxes::own);
  library.postures.push_back(turned);
  library.postures.back().name = "turned";
  library.postures.push_back(part_of_the_way(initial, turned, 0.0));
  library.postures.back().name = "not turned";
  const auto written = folder.write("own.toml", postures_text(library));
  const auto poses =
      answer("adapt --postures " + written + " --start " + data("adapt_start1.csv"))["poses"];
  const auto series = test::must(read_poses(data("adapt_start1.csv")));
  const auto start = test::must(start_posture(series, library.chain));
  ASSERT_EQ(poses.size(), library.postures.size());
  constexpr double kSame = 1e-12;
  for (std::size_t j = 0; j < library.postures.size(); ++j) {
    EXPECT_EQ(poses[j]["posture"], library.postures[j].name);
    const Pose X_WO = adapted(library, j, start, SizeScale::none);
    for (std::size_t a = 0; a < 3; ++a)
      EXPECT_WITHIN(poses[j]["position_m"][a].get<double>(), X_WO.p[static_cast<Eigen::Index>(a)],
                    kSame);
  }
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_WITHIN(poses.back()["position_m"][a].get<double>(),
                  poses[0]["position_m"][a].get<double>(), kSame)
        << "nothing of the way is the initial posture";
}

TEST(Markers, BoxPlotsAndPairsAgreeWithTheReference) {
  const auto box = answer("box --values " + data("box_values.csv"));
  const auto expected = nlohmann::json::parse(read_file(data("box_expected.json")));
  constexpr double kValue = 1e-12;
  for (const auto& [name, reference] : test::every(expected["boxes"].items()))
    for (const auto& [key, value] : reference.items()) {
      if (value.is_array()) {
        EXPECT_EQ(box["boxes"][name][key], value) << name << " " << key;
      } else {
        EXPECT_WITHIN(box["boxes"][name][key].get<double>(), value.get<double>(), kValue)
            << name << " " << key;
      }
    }
  ASSERT_EQ(box["pairs"].size(), expected["pairs"].size());
  for (std::size_t k = 0; k < expected["pairs"].size(); ++k)
    for (const char* key : {"n", "w_plus", "p", "p_holm"})
      EXPECT_WITHIN(box["pairs"][k][key].get<double>(), expected["pairs"][k][key].get<double>(),
                    kValue)
          << k << " " << key;
}

TEST(Markers, BadInputIsOneLineWithItsPlaceAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string csv = "t_s,M1_x_m,M1_y_m,M1_z_m,M2_x_m,M2_y_m,M2_z_m,M3_x_m,M3_y_m,M3_z_m\n";
  const std::string good = "0,0,0,0,0.06,0,0,0.02,0.045,0\n";
  const std::string out = folder.path("o.csv");
  struct Case {
    std::string text;
    std::string place;
  };
  for (const auto& [text, place] :
       {Case{csv + good + "0.01,0,,0,0.06,0,0,0.02,0.045,0\n", "m.csv:3: M1"},
        Case{csv + good + "0.01,nan,0,0,0.06,0,0,0.02,0.045,0\n", "m.csv:3: M1_x_m"},
        Case{csv + good + "0.01,0,0\n", "m.csv:3"}, Case{csv + good + good, "m.csv:3: t_s"},
        Case{"t_s,M1_x_m,M1_y_m,M1_z_m,speed\n", "m.csv:1: speed"},
        Case{"t_s,Q_x_m,Q_y_m,Q_z_m\n0,1,2,3\n", "m.csv: has none of the markers"}}) {
    const auto done = isograsp("markers poses --rig " + data("kabsch_triad_rig.toml") + " --in " +
                               folder.write("m.csv", text) + " --out " + out);
    EXPECT_EQ(done.status, 2) << text;
    EXPECT_EQ(done.err.rfind("isograsp: error: ", 0), 0U) << done.err;
    EXPECT_NE(done.err.find(place), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_NE(done.err.find("; "), std::string::npos) << "no remedy: " << done.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  const std::string rig = folder.write("rig.toml", "format = \"isograsp-rig-1\"\nextra = 1\n");
  const auto bad_rig = isograsp("markers poses --rig " + rig + " --in " + data("kabsch_triad.csv") +
                                " --out " + out);
  EXPECT_EQ(bad_rig.status, 2);
  EXPECT_NE(bad_rig.err.find("rig.toml:"), std::string::npos) << bad_rig.err;
  const auto no_frame =
      isograsp("markers landmark --rig " + data("kabsch_triad_rig.toml") + " --in " +
               data("kabsch_triad.csv") + " --probe stick --frame body --name L");
  EXPECT_EQ(no_frame.status, 2);
  EXPECT_NE(no_frame.err.find("kabsch_triad_rig.toml: --probe: 'stick'"), std::string::npos)
      << no_frame.err;
  const auto onto_itself = isograsp("markers convert " + folder.write("m.csv", csv + good) +
                                    " --out " + folder.path("m.csv"));
  EXPECT_EQ(onto_itself.status, 2);
  EXPECT_EQ(read_file(folder.path("m.csv")), csv + good);
}

}  // namespace
}  // namespace isograsp::app::markers_test
