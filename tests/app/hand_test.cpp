// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand, as it is called: tables in, JSON and tables out, and what is wrong is named.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/golden_table.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::hand_test {
namespace {

namespace fs = std::filesystem;
using test::every;
using test::isograsp;
using test::TemporaryFolder;

const std::string kHand = ISOGRASP_SOURCE_DIR "/tests/data/hand/";

TEST(HandCommands, WhatTheyPrintIsWhatTheLibraryComputes) {
  constexpr double kTable = 1e-12;
  const auto fk = isograsp("hand fk --json --poses " + kHand + "fk_poses.csv");
  ASSERT_EQ(fk.status, 0) << fk.err;
  const auto poses = nlohmann::json::parse(fk.out).at("poses");
  const auto joints = test::golden_table(kHand + "fk_joints.csv");
  EXPECT_WITHIN(poses[0].at("joints").at("thumb_tip")[0].get<double>(), -0.09310524893014938,
                kTable);
  EXPECT_EQ(poses[0].at("jacobian").at("little").size(), 6u);
  EXPECT_EQ(joints.size(), 26 * poses.size());

  const auto grasp = isograsp("hand grasp --json --cases " + kHand + "grasp_cases.csv --contacts " +
                              kHand + "grasp_contacts.csv --sets " + kHand +
                              "best_set.csv --friction 0.8 --patch-radius 0.005");
  ASSERT_EQ(grasp.status, 0) << grasp.err;
  std::map<std::string, nlohmann::json> best;
  const auto cases = nlohmann::json::parse(grasp.out).at("cases");
  for (const auto& one : cases)
    for (const auto& set : one.at("best"))
      best[std::to_string(one.at("id").get<int>()) + " " +
           std::to_string(set.at("set").get<int>())] = set.at("fingers");
  for (const auto& row : every(test::golden_table(kHand + "best_set.csv"))) {
    std::string fingers;
    for (const auto& name : best.at(row.at("id") + " " + row.at("set")))
      fingers += (fingers.empty() ? "" : "+") + name.get<std::string>();
    EXPECT_EQ(fingers, row.at("best"));
  }
}

TEST(HandCommands, ATraceBecomesTheStatesOfTheOracleInAFile) {
  const TemporaryFolder folder;
  const auto done = isograsp("hand assist --trace " + kHand +
                             "release_jitter.csv --release 0.3 --out " + folder.path("states.csv"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto states = test::golden_table(folder.path("states.csv"));
  const auto wanted = test::golden_table(kHand + "release_jitter_states.csv");
  ASSERT_EQ(states.size(), wanted.size());
  for (std::size_t k = 0; k < states.size(); ++k)
    for (const char* finger : {"thumb", "index", "middle", "ring", "little"})
      ASSERT_EQ(states[k].at(finger), wanted[k].at(finger)) << k;
}

TEST(HandCommands, BadInputIsNamedWithLineAndColumnAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out.csv");
  const auto refused_with = [&](const std::string& words, const std::string& message) {
    const auto done = isograsp("hand " + words);
    EXPECT_EQ(done.status, 2) << words;
    EXPECT_NE(done.err.find(message), std::string::npos) << words << "\n" << done.err;
    EXPECT_FALSE(fs::exists(out)) << words;
  };
  const std::string header = "t_s,hand,tracked,confidence,wrist_x_m,wrist_y_m,wrist_z_m\n";
  const auto calibrate = [&](const std::string& name, const std::string& text) {
    folder.write(name, text);
    return "calibrate --side right --out " + out + " --stream " + folder.path(name);
  };
  refused_with(calibrate("a.csv", header + "0,both,1,1,0,0,0\n"),
               "a.csv:2: hand: 'both' is no hand");
  refused_with(calibrate("b.csv", header + "0,right,2,1,0,0,0\n"),
               "tracked: '2' is neither 0 nor 1");
  refused_with(calibrate("c.csv", header + "0,right,1,1,0,,0\n"), "wrist: a part of the position");
  refused_with(calibrate("d.csv", header + "1,right,1,1,0,0,0\n1,right,1,1,0,0,0\n"),
               "d.csv:3: t_s: time does not increase");
  refused_with(calibrate("e.csv", "t_s,hand,tracked,colour\n"),
               "colour: is no column of a tracked hand");
  refused_with(calibrate("f.csv", header + "0,right,1,1,0,0,0\n"),
               "no frame shows the right hand well");
  folder.write("g.jsonl", "{\"version\":6}\n{\"timestamp\":1,\"hands\":\n");
  refused_with("convert --from leap-v6 " + folder.path("g.jsonl") + " --out " + out,
               "g.jsonl:2: is no message of the Leap service");
  folder.write("h.jsonl", "{\"version\":6}\n");
  refused_with("convert --from leap-v6 " + folder.path("h.jsonl") + " --out " + out,
               "shows no hand");
  folder.write("case.csv",
               "id,shape,sx_m,sy_m,sz_m,ax_m,ay_m,az_m,bx_m,by_m,bz_m,r_m\n"
               "0,cone,1,1,1,0,0,0,0,0,0,0\n");
  refused_with("distance --cases " + folder.path("case.csv"),
               "case.csv:2: shape: 'cone' is no shape");
}

/// The recordings of real hands, and what an independent program found in them.
TEST(HandCommands, RecordingsOfRealHandsHaveTheSizesAndAnglesOfTheOracle) {
  const std::string data = test::recorded_data() + "/hand/";
  if (!fs::exists(data)) GTEST_SKIP() << "the recordings are not there";
  constexpr double kLength_m = 1e-9;
  constexpr double kAngle_rad = 1e-7;
  for (const auto& [name, side] : {std::pair<std::string, std::string>{"leap_grab", "right"},
                                   {"leap_pinch", "right"},
                                   {"leap_two_hands", "left"},
                                   {"leap_two_hands", "right"}}) {
    const TemporaryFolder folder;
    const auto sized = isograsp("hand calibrate --json --stream " + data + name + ".csv --side " +
                                side + " --out " + folder.path("h.toml"));
    ASSERT_EQ(sized.status, 0) << sized.err;
    const auto fingers = nlohmann::json::parse(sized.out).at("fingers");
    const auto wanted = test::golden_table(kHand + "calibrate_" + name + "_" + side + ".csv");
    ASSERT_EQ(wanted.size(), fingers.size());
    for (std::size_t d = 0; d < wanted.size(); ++d)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string number = std::to_string(k + 1);
        EXPECT_WITHIN(fingers[d].at("lengths_m")[k].get<double>(),
                      test::number_in(wanted[d], "length" + number + "_m"), kLength_m);
        EXPECT_WITHIN(fingers[d].at("radii_m")[k].get<double>(),
                      test::number_in(wanted[d], "radius" + number + "_m"), kLength_m);
      }
    const auto angles =
        isograsp("hand angles --hand " + folder.path("h.toml") + " --stream " + data + name +
                 ".csv --side " + side + " --out " + folder.path("a.csv"));
    ASSERT_EQ(angles.status, 0) << angles.err;
    std::map<std::string, test::Fields> by_time;
    for (const auto& row : test::golden_table(folder.path("a.csv"))) by_time[row.at("t_s")] = row;
    for (const auto& row :
         every(test::golden_table(kHand + "angles_" + name + "_" + side + ".csv"))) {
      const auto found = std::find_if(by_time.begin(), by_time.end(), [&](const auto& one) {
        return std::abs(test::number_in(one.second, "t_s") - test::number_in(row, "t_s")) < 1e-9;
      });
      ASSERT_NE(found, by_time.end()) << row.at("t_s");
      for (const auto& [column, text] : row)
        if (column.ends_with("_rad")) {
          EXPECT_WITHIN(test::number_in(found->second, column), test::number_in(row, column),
                        kAngle_rad)
              << name << side << row.at("t_s") << column;
        }
      EXPECT_WITHIN(test::number_in(found->second, "residual_m"),
                    test::number_in(row, "residual_m"), kLength_m);
    }
  }
}

TEST(HandCommands, MessagesOfATrackerBecomeTheStreamThatTheyAre) {
  const std::string data = test::recorded_data() + "/hand/";
  if (!fs::exists(data)) GTEST_SKIP() << "the recordings are not there";
  const TemporaryFolder folder;
  const auto done = isograsp("hand convert --from leap-v6 " + data + "leap_messages.jsonl --out " +
                             folder.path("s.csv"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto rows = test::golden_table(folder.path("s.csv"));
  const auto wanted = test::golden_table(data + "leap_messages_expected.csv");
  constexpr double kRounding_m = 1e-12;
  ASSERT_EQ(rows.size(), wanted.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].at("tracked"), wanted[k].at("tracked"));
    for (const auto& [column, text] : wanted[k])
      if (column.ends_with("_m")) {
        ASSERT_EQ(rows[k].at(column).empty(), text.empty()) << column;
        if (!text.empty()) {
          EXPECT_WITHIN(test::number_in(rows[k], column), test::number_in(wanted[k], column),
                        kRounding_m);
        }
      }
  }
}

TEST(HandCommands, WhatIsPlayedAsTheLeapServiceIsRecordedToTheLastRow) {
  const std::string data = test::recorded_data() + "/hand/";
  if (!fs::exists(data)) GTEST_SKIP() << "the recordings are not there";
  const TemporaryFolder folder;
  const std::string at = "127.0.0.1:" + std::to_string(test::free_port());
  const test::BackgroundCommand tracker("\"" ISOGRASP_EXECUTABLE
                                        "\" hand emulate --json --fault split --stream " +
                                        data + "leap_pinch.csv --listen " + at);
  test::CommandResult done;
  ASSERT_TRUE(tracker.wait_until([&] {
    done = isograsp("hand record --stream leap://" + at + " --side right --out " +
                    folder.path("r.csv") + " --duration 20");
    return done.status == 0;
  })) << done.err
      << tracker.err();
  tracker.wait_for_end();
  EXPECT_EQ(nlohmann::json::parse(tracker.out()).at("frames"), 133);
  constexpr double kMillimetres_m = 1e-12;  // to millimetres and back
  constexpr double kMicrosecond_s = 1e-6;
  const auto rows = test::golden_table(folder.path("r.csv"));
  const auto wanted = test::golden_table(data + "leap_pinch.csv");
  ASSERT_EQ(rows.size(), wanted.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (const auto& [column, text] : wanted[k]) {
      if (column.ends_with("_m")) {
        ASSERT_EQ(rows[k].at(column).empty(), text.empty()) << column;
        if (!text.empty()) {
          EXPECT_WITHIN(test::number_in(rows[k], column), test::number_in(wanted[k], column),
                        kMillimetres_m);
        }
      } else if (column == "hand" || column == "tracked") {
        EXPECT_EQ(rows[k].at(column), text);
      } else {
        EXPECT_WITHIN(test::number_in(rows[k], column), test::number_in(wanted[k], column),
                      kMicrosecond_s)
            << column;
      }
    }
}

TEST(HandCommands, WhatCannotBeRecordedIsNamedAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out.csv");
  for (const auto& [words, message] : every(std::vector<std::pair<std::string, std::string>>{
           {"record --stream leap://127.0.0.1:" + std::to_string(test::free_port()),
            "nobody answers"},
           {"record --stream sim://hand?user=healthy", "nobody moves the simulated hand"},
           {"record --stream udp-hand://0.0.0.0:6440", "network=confirmed"},
           {"record --stream replay://" + folder.path("none.csv"), "none.csv"}})) {
    const auto done = isograsp("hand " + words + " --duration 1 --out " + out);
    EXPECT_NE(done.status, 0) << words;
    EXPECT_NE(done.err.find(message), std::string::npos) << words << "\n" << done.err;
    EXPECT_FALSE(fs::exists(out)) << words;
  }
  EXPECT_NE(isograsp("hand emulate --stream x.csv --listen 127.0.0.1:1 --fault explode")
                .err.find("there is no such fault"),
            std::string::npos);
}

}  // namespace
}  // namespace isograsp::app::hand_test
