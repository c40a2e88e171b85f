// SPDX-License-Identifier: GPL-3.0-or-later
// Commands about two hands, pads and patches, as a user types them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/golden_table.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::bimanual_test {
namespace {

using Json = nlohmann::json;
using test::isograsp;
using test::number_in;
using test::TemporaryFolder;
const std::string kData = ISOGRASP_SOURCE_DIR "/tests/data/bimanual/";

TEST(TwoHandsCommands, ASceneOfBubblesMovesAsTheReference) {
  const TemporaryFolder folder;
  for (const std::string name : {"revolving_door", "weak_carry_joint", "tilt_spring"}) {
    const std::string file = kData + "bubble/" + name;
    const auto done = isograsp("simulate --scene " + file + ".toml --forces " + file +
                               "_forces.csv --out " + folder.path("o.csv"));
    ASSERT_EQ(done.status, 0) << done.err;
    const auto golden = test::golden_table(file + "_reference.csv");
    const auto found = test::golden_table(folder.path("o.csv"));
    ASSERT_EQ(found.size(), golden.size());
    // Springs are integrated, the rest is arithmetic; velocities are differences over 10 ms.
    const double place = name == "tilt_spring" ? 1e-6 : 1e-10;
    for (std::size_t row = 0; row < golden.size(); ++row)
      for (const auto& [column, text] : test::every(golden[row])) {
        if (column == "angle_z_rad") continue;  // of the attitude, which has its own columns
        const double tolerance = column.ends_with("mps") ? 100.0 * place : place;
        ASSERT_WITHIN(number_in(found[row], column), number_in(golden[row], column), tolerance)
            << name << " " << column << " row " << row;
      }
  }
}

TEST(TwoHandsCommands, PadsLiftTiltAndTwistABlockAsTheReference) {
  const TemporaryFolder folder;
  const auto golden = test::golden_table(kData + "pad_lift_reference.csv");
  for (const auto& [solver, limit] : {std::pair{"aggregate", 0.15}, {"aggregate_exact", 0.03}}) {
    const auto done =
        isograsp("simulate --scene " + kData + "pad_lift.toml --proxies " + kData +
                 "pad_lift_proxies.csv --pad-solver " + solver + " --out " + folder.path("o.csv"));
    ASSERT_EQ(done.status, 0) << done.err;
    const auto found = test::golden_table(folder.path("o.csv"));
    std::size_t row = 0;
    for (const auto& expected : test::every(golden)) {
      while (number_in(found[row], "t_s") < number_in(expected, "t_s") - 1e-6) ++row;
      for (const auto& [column, text] : expected) {
        if (column == "t_s" || column.ends_with("_band")) continue;
        // What a first-order step of 1 ms may differ, and a share of the largest value.
        const double largest = column.ends_with("_Nm")  ? 0.02
                               : column.ends_with("_N") ? 3.0
                               : column.ends_with("_m") ? 0.02
                                                        : 1.0;
        const auto band = expected.find(column + "_band");
        const double tolerance =
            limit * largest +
            (band == expected.end() ? 0.0 : number_in(expected, column + "_band"));
        ASSERT_WITHIN(number_in(found[row], column), number_in(expected, column), tolerance)
            << solver << " " << column << " at " << number_in(expected, "t_s") << " s";
      }
    }
  }
}

TEST(TwoHandsCommands, ForcesThatAreNoPushesAreRefusedByColumnAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("f.csv", "t_s,left_push_x_N\n0,1\n0.01,1\n");
  const auto refused = isograsp("simulate --scene " + kData + "bubble/tilt_spring.toml --forces " +
                                forces + " --out " + folder.path("o.csv"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("left_push_y_N"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("o.csv")));
}

const std::string kTray = ISOGRASP_SOURCE_DIR "/library/scenes/tray.toml";

/// Both hands squeeze with 4 N and raise with `left_N` and `right_N`.
std::string pushes(const TemporaryFolder& folder, double left_N, double right_N) {
  std::string text =
      "t_s,left_push_x_N,left_push_y_N,left_push_z_N,right_push_x_N,right_push_y_N,right_push_z_"
      "N\n";
  for (int k = 0; k < 400; ++k)
    text += std::to_string(0.01 * k) + ",4," + std::to_string(left_N) + ",0,-4," +
            std::to_string(right_N) + ",0\n";
  return folder.write("pushes.csv", text);
}

TEST(TwoHandsCommands, ATrayIsLiftedAndTiltsTowardsWhoRaisesLess) {
  const TemporaryFolder folder;
  const std::string out = folder.path("o.csv");
  const auto done = isograsp("simulate --scene " + kTray + " --forces " + pushes(folder, 2.0, 2.5) +
                             " --out " + out);
  ASSERT_EQ(done.status, 0) << done.err;
  const auto rows = test::golden_table(out);
  ASSERT_EQ(rows.size(), 401U) << "and the end of the last hold";
  const auto& last = rows.back();
  constexpr double kAtRest = 1e-3;  // of springs and dampers after 4 s
  EXPECT_WITHIN(number_in(last, "y_m"), (4.5 - 0.3 * 9.81) / 10.0, kAtRest * 10.0);
  EXPECT_WITHIN(2.0 * std::asin(number_in(last, "qz")), 0.5 * 0.15 / 0.57, kAtRest);
  EXPECT_EQ(number_in(last, "fy_N"), 4.5);
  EXPECT_EQ(number_in(last, "left_contact"), 1.0);
  EXPECT_EQ(number_in(last, "right_contact"), 1.0);
  const std::string first = test::must(read_text(out));
  ASSERT_EQ(isograsp("simulate --scene " + kTray + " --forces " + folder.path("pushes.csv") +
                     " --out " + out)
                .status,
            0);
  EXPECT_EQ(test::must(read_text(out)), first) << "a second run is the same bytes";
}

TEST(TwoHandsCommands, TheFingersOfAHandPushWithTheirSum) {
  const TemporaryFolder folder;
  // Thumb against both fingers: 6 N of grip cancel, the net push of either hand is that above. The
  // left platform is turned by pi about y.
  std::string text = "t_s";
  for (const char* side : {"left_", "right_"})
    for (const char* finger : {"thumb_", "index_", "middle_"})
      for (const char* axis : {"fx_N", "fy_N", "fz_N"})
        text += "," + std::string(side) + finger + axis;
  text += "\n";
  // The left thumb presses along -x, its fingers along +x; of the right hand the other way.
  const std::string left = ",1,0,6,0.5,0,5,0.5,0,5";
  const std::string right = ",1,0,6,1,0,5,0.5,0,5";
  for (int k = 0; k < 400; ++k) text += std::to_string(0.01 * k) + left + right + "\n";
  const std::string out = folder.path("o.csv"), same = folder.path("same.csv");
  const auto done = isograsp("simulate --scene " + kTray + " --forces " +
                             folder.write("f.csv", text) + " --out " + out);
  ASSERT_EQ(done.status, 0) << done.err;
  ASSERT_EQ(isograsp("simulate --scene " + kTray + " --forces " + pushes(folder, 2.0, 2.5) +
                     " --out " + same)
                .status,
            0);
  EXPECT_EQ(test::must(read_text(out)), test::must(read_text(same)));
}

TEST(TwoHandsCommands, HandsWithoutCouplingAreTwoNumbersThatScoreReads) {
  const TemporaryFolder folder;
  const std::string scene =
      folder.write("none.toml", "format = \"isograsp-scene-1\"\n[hands]\ncoupling = \"none\"\n");
  const std::string out = folder.path("o.csv");
  const auto done = isograsp("simulate --scene " + scene + " --forces " + pushes(folder, 3.0, 0.0) +
                             " --out " + out);
  ASSERT_EQ(done.status, 0) << done.err;
  const auto rows = test::golden_table(out);
  ASSERT_EQ(rows.size(), 400U);
  EXPECT_EQ(number_in(rows[7], "left_force_N"), 5.0);
  EXPECT_EQ(number_in(rows[7], "right_force_N"), 4.0);
  EXPECT_EQ(number_in(rows[7], "right_push_x_N"), -4.0);
  EXPECT_EQ(isograsp("score --json --affected left --signals " + out).status, 0);
}

TEST(TwoHandsCommands, ForcesThatDoNotFitTheContactsAreRefusedWithColumnAndRemedy) {
  const TemporaryFolder folder;
  const std::string good = pushes(folder, 1.0, 1.0);
  const std::string rows = test::must(read_text(good));
  const auto refuses = [&](const std::string& scene, const std::string& text,
                           const std::string& named) {
    const auto done = isograsp("simulate --scene " + scene + " --forces " +
                               folder.write("bad.csv", text) + " --out " + folder.path("no.csv"));
    EXPECT_EQ(done.status, 2) << named;
    EXPECT_NE(done.err.find(named), std::string::npos) << done.err;
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path("no.csv")));
  };
  const std::string mixed = "t_s,left_push_x_N,left_push_y_N,left_push_z_N,left_thumb_fx_N\n";
  refuses(kTray, mixed + "0,1,1,1,1\n0.1,1,1,1,1\n", "left_thumb_fx_N");
  refuses(kTray, "t_s,left_push_x_N\n0,1\n0.1,1\n", "left_push_y_N");
  std::string gap = rows;
  gap.replace(gap.find(",4,"), 3, ",,");
  refuses(kTray, gap, "left_push_x_N");
  std::string fingers = test::must(read_text(kTray));
  fingers.replace(fingers.find("hand = \"left\""), 13, "hand = \"left\"\nfinger = \"thumb\"");
  const std::string by_fingers = folder.write("fingers.toml", fingers);
  refuses(by_fingers, rows, "left_thumb_fx_N");
  const auto handed = isograsp("simulate --hand left --scene " + kTray + " --forces " + good +
                               " --out " + folder.path("no.csv"));
  EXPECT_EQ(handed.status, 2);
  EXPECT_NE(handed.err.find("--hand"), std::string::npos) << handed.err;
}

TEST(TwoHandsCommands, ARecordOfTwoHandsIsScoredAsTheReference) {
  constexpr double kOtherSums = 1e-9;  // the reference adds up in another order
  const auto golden = Json::parse(test::must(read_text(kData + "bilateral.json")));
  for (const auto& one : test::every(golden.at("cases"))) {
    const auto number = [&](const char* key) { return std::to_string(one.at(key).get<double>()); };
    const auto done =
        isograsp("score --json --signals " + kData + one.at("signals").get<std::string>() +
                 " --affected " + one.at("affected").get<std::string>() + " --maximum-left " +
                 number("maximum_left_N") + " --maximum-right " + number("maximum_right_N"));
    ASSERT_EQ(done.status, 0) << done.err;
    const Json printed = Json::parse(done.out);
    std::map<std::string, Json> found;
    for (const auto& measure : printed.at("measures")) {
      const auto name = measure.at("name").get<std::string>();
      const auto channel = measure.at("channel").get<std::string>();
      found[name == "rmse" ? "rmse_" + channel : name] = measure.at("value");
    }
    for (const auto& [name, value] : one.at("expected").items()) {
      ASSERT_EQ(found[name].is_null(), value.is_null()) << one.at("id") << " " << name;
      if (value.is_null()) continue;
      const double expected = value.get<double>();
      EXPECT_WITHIN(found[name].get<double>(), expected,
                    kOtherSums * std::max(1.0, std::abs(expected)))
          << one.at("id") << " " << name;
    }
  }
}

TEST(TwoHandsCommands, TheChannelNamesTheAffectedHandAndWithoutMaximaThereIsNoShareOfEffort) {
  const std::string signals = kData + "bilateral/affected_lags_130ms.csv";
  double sum = 0.0;
  for (const std::string hand : {"left", "right"}) {
    const auto done = isograsp("score --json --signals " + signals + " --affected " + hand);
    ASSERT_EQ(done.status, 0) << done.err;
    const auto measures = Json::parse(done.out).at("measures");
    EXPECT_EQ(measures.at(0).at("name"), "mean_force");
    EXPECT_EQ(measures.at(0).at("channel"), hand);
    EXPECT_EQ(measures.at(1).at("name"), "mean_force");
    const auto mean = [&](int at) { return measures.at(at).at("value").get<double>(); };
    EXPECT_EQ(measures.at(2).at("name"), "share_affected");
    EXPECT_EQ(measures.at(2).at("channel"), hand);
    EXPECT_WITHIN(mean(2), 100.0 * mean(0) / (mean(0) + mean(1)), 1e-9);  // rounding
    sum += mean(2);
    EXPECT_TRUE(measures.at(4).at("value").is_null());
    EXPECT_EQ(measures.at(4).at("reason"), "the maximum of each hand is not known");
  }
  EXPECT_WITHIN(sum, 100.0, 1e-9);  // rounding
}

TEST(TwoHandsCommands, AScoreOfTwoHandsThatCannotBeIsRefusedWithTheRemedy) {
  const TemporaryFolder folder;
  const std::string one = folder.write("one.csv", "t_s,left_force_N\n0,1\n0.01,1\n");
  const std::string both = kData + "bilateral/affected_lags_130ms.csv";
  const std::vector<std::pair<std::string, std::string>> bad{
      {one + " --affected left", "left_force_N and right_force_N"},
      {both + " --affected both", "--affected"},
      {both + " --affected left --task " ISOGRASP_SOURCE_DIR "/library/tasks/grip_sine.toml",
       "--task"},
      {both + " --maximum-left 12", "--affected"},
      {both + " --affected left --maximum-left 0", "--maximum-left"},
      {both + " --affected left --maximum-right nan", "--maximum-right"}};
  for (const auto& [words, named] : bad) {
    const auto done = isograsp("score --signals " + words);
    EXPECT_EQ(done.status, 2) << words;
    EXPECT_NE(done.err.find(named), std::string::npos) << done.err;
    EXPECT_TRUE(done.out.empty()) << done.out;
  }
}

TEST(PatchCommand, SaysAreaTorsionAndWhyEachRayStopped) {
  const std::string near_edge =
      "--point -0.0325 0.028 0 --normal 1 0 0 --tangent 0 1 0 --pad 0.0075 0.0055 "
      "--friction 0.8 --json";
  const auto solid = isograsp("patch --shape box --size 0.065 0.06 0.08 " + near_edge);
  ASSERT_EQ(solid.status, 0) << solid.err;
  const Json of_solid = Json::parse(solid.out);
  EXPECT_EQ(of_solid["stopped"]["edge"].get<int>(), 25);
  EXPECT_EQ(of_solid["outline_m"].size(), 64U);
  EXPECT_WITHIN(of_solid["torsion_m"].get<double>(), 0.002845212093072018, 1e-15);
  const auto mesh = isograsp("patch --mesh " + kData + "mesh/box.obj " + near_edge);
  ASSERT_EQ(mesh.status, 0) << mesh.err;
  EXPECT_WITHIN(Json::parse(mesh.out)["torsion_m"].get<double>(),
                of_solid["torsion_m"].get<double>(), 1e-15);
  const auto off = isograsp(
      "patch --shape sphere --size 0.06 --point 0.031 0 0 --normal -1 0 0 --tangent 0 1 0 --pad "
      "0.0075 0.0055");
  EXPECT_EQ(off.status, 2);
  EXPECT_NE(off.err.find("--point"), std::string::npos) << off.err;
}

TEST(PatchCommand, AContactOfASceneMayBeAPadAndItsLimitIsThatOfThePatch) {
  const TemporaryFolder folder;
  const std::string scene = folder.write(
      "pad.toml",
      "format = \"isograsp-scene-1\"\n[object]\nshape = \"box\"\nsize_m = [0.065, 0.06, 0.08]\n"
      "mass_kg = 0.3\n[dynamics]\nfree = [\"x\"]\nstiffness = [1, 1, 1, 1, 1, 1]\n"
      "damping = [1, 1, 1, 1, 1, 1]\n[[contact]]\nfinger = \"index\"\n"
      "position_m = [-0.0325, 0.028, 0]\nnormal = [1, 0, 0]\ntangent = [0, 1, 0]\n"
      "model = \"pad\"\nfriction = 0.8\npatch = {semi_axes_m = [0.0075, 0.0055]}\n");
  const auto shown = isograsp("patch --scene " + scene + " --json");
  ASSERT_EQ(shown.status, 0) << shown.err;
  EXPECT_WITHIN(Json::parse(shown.out)["torsion_m"].get<double>(), 0.002845212093072018, 1e-15);
  EXPECT_EQ(isograsp("patch --scene " + scene + " --finger thumb").status, 2);
  const auto grasp = isograsp("grasp --scene " + scene);
  EXPECT_EQ(grasp.status, 0) << grasp.err;
}

TEST(PadBenchCommand, PrintsRowsSweepsAndErrorsOfAllSolvers) {
  const TemporaryFolder folder;
  Json cases = Json::parse(test::must(read_text(kData + "pad_steps.json")))["cases"];
  const std::string file = folder.write("case.json", cases[1].dump());
  const auto done = isograsp("pad-bench --case " + file + " --json");
  ASSERT_EQ(done.status, 0) << done.err;
  const Json answer = Json::parse(done.out);
  EXPECT_EQ(answer["pointwise"]["constraints"].get<int>(), 72);
  EXPECT_EQ(answer["aggregate"]["constraints"].get<int>(), 8);
  EXPECT_EQ(answer["pointwise"]["wrench_error"].get<double>(), 0.0);
  EXPECT_LT(answer["aggregate_exact"]["wrench_error"].get<double>(), 1e-5);
  for (const char* text : {"{", "[]", "{\"step_s\": 0}", "{\"step_s\": 0.001, \"pads\": 3}"}) {
    const auto refused = isograsp("pad-bench --case " + folder.write("bad.json", text));
    EXPECT_EQ(refused.status, 2) << text;
    EXPECT_NE(refused.err.find("bad.json"), std::string::npos) << refused.err;
  }
  const auto refuses = [&](const Json& bad, const std::string& why) {
    const auto refused = isograsp("pad-bench --case " + folder.write("bad.json", bad.dump()));
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
  };
  Json bad = cases[1];
  bad["pads"][1]["pad"] = bad["pads"][0]["pad"];
  refuses(bad, "a body is that of two pads");
  bad = cases[1];
  bad["pads"][0]["normal"][2] = {2.0, 0.0, 0.0};
  refuses(bad, "no unit normal");
  bad = cases[1];
  bad["pads"][0]["p_pad_m"][2] = {0.0, 0.0, 1.0};
  refuses(bad, "not at one place");
}

TEST(PadBenchCommand, HasFourScenesOfFewToManyPointsBesideWhatTheSourceMeasured) {
  const auto done = isograsp("pad-bench --points 12,48 --json");
  ASSERT_EQ(done.status, 0) << done.err;
  const Json answer = Json::parse(done.out);
  ASSERT_EQ(answer["scenes"].size(), 8U);
  for (const Json& one : test::every(answer["scenes"])) {
    const int points = one["points"], pads = one["pads"];
    EXPECT_EQ(one["pointwise"]["constraints"].get<int>(), 3 * points);
    EXPECT_EQ(one["aggregate"]["constraints"].get<int>(), 4 * pads);
    for (const char* solver : {"pointwise", "aggregate", "aggregate_exact"})
      EXPECT_TRUE(one[solver]["settled"].get<bool>()) << solver;
  }
  EXPECT_EQ(answer["source"]["constraints"], Json::parse("[528, 51]"));
  const auto table = isograsp("pad-bench --scene pencil --points 24");
  ASSERT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("pencil        24    72"), std::string::npos) << table.out;
  EXPECT_EQ(table.out.find("ball"), std::string::npos);
  for (const char* bad : {"--points 13", "--points 12,", "--points many", "--points 12000",
                          "--scene cup", "--scene ball --case x.json"}) {
    const auto refused = isograsp(std::string("pad-bench ") + bad);
    EXPECT_EQ(refused.status, 2) << bad;
    EXPECT_TRUE(refused.out.empty()) << refused.out;
  }
}

}  // namespace
}  // namespace isograsp::app::bimanual_test
