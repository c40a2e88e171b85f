// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand simulate, thresholds, study: people in software, as they are called.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"

namespace isograsp::app::hand_simulate_test {
namespace {

namespace fs = std::filesystem;
using test::every;
using test::isograsp;
using test::TemporaryFolder;

TEST(HandSimulate, PrintsThreePlacementsATestAndTheSameBytesEachTime) {
  const std::string command =
      "hand simulate --object small_cylinder --assistance on --user healthy --seed 3 --tests 1 "
      "--json";
  const auto once = isograsp(command);
  ASSERT_EQ(once.status, 0) << once.err;
  const auto answer = nlohmann::json::parse(once.out);
  EXPECT_EQ(answer.at("placements").size(), 3U);
  for (const auto& placement : every(answer.at("placements"))) {
    if (placement.at("completed") == 0) continue;
    EXPECT_LT(placement.at("hold_distance_m").get<double>(), 0.015);
    EXPECT_GT(placement.at("manipulation_s").get<double>(), 0.0);
  }
  EXPECT_TRUE(answer.at("step_us").is_null()) << "times differ, so they are asked for";
  EXPECT_EQ(isograsp(command).out, once.out);
  const auto timed = isograsp(command + " --timing");
  ASSERT_EQ(timed.status, 0) << timed.err;
  EXPECT_GT(nlohmann::json::parse(timed.out).at("step_us").at("p99").get<double>(), 0.0);
}

TEST(HandSimulate, AnObjectThatDoesNotExistIsNamed) {
  const auto wrong = isograsp("hand simulate --object ball --assistance on --seed 1");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("ball"), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find("small_cuboid"), std::string::npos) << wrong.err;
}

TEST(HandSimulate, ThresholdsHaveLimitsForEveryObject) {
  const auto found = isograsp("hand thresholds --json --seed 2 --hand " ISOGRASP_SOURCE_DIR
                              "/library/hands/default.toml");
  ASSERT_EQ(found.status, 0) << found.err;
  const auto objects = nlohmann::json::parse(found.out).at("objects");
  EXPECT_EQ(objects.size(), 6U);
  for (const auto& object : every(objects)) {
    EXPECT_GT(object.at("two").at("limits").at("G_min").get<double>(), 0.0) << object.dump();
    // Of the slim ones many close far from the middle, where little force turns much.
    const bool slim = object.at("object").get<std::string>().starts_with("slim");
    EXPECT_GT(object.at("two").at("auc").at("G_min").get<double>(), slim ? 0.5 : 0.85)
        << object.dump();
    // Three digits hardly find room on a small one.
    if (!object.at("object").get<std::string>().starts_with("small")) {
      EXPECT_GT(object.at("three").at("limits").at("G_min").get<double>(), 0.0) << object.dump();
    }
  }
}

TEST(HandSimulate, AStudyIsAWholeFolderOrNone) {
  const TemporaryFolder folder;
  const std::string out = folder.path("study");
  fs::create_directory(out);
  const auto there = isograsp("hand study --seeds 2 --out " + out);
  EXPECT_EQ(there.status, 2) << there.err;
  EXPECT_NE(there.err.find("exists already"), std::string::npos) << there.err;
  EXPECT_TRUE(fs::is_empty(out));
  const auto nowhere = isograsp("hand study --seeds 2 --out " + folder.path("no/such/folder"));
  EXPECT_NE(nowhere.status, 0);
  EXPECT_FALSE(fs::exists(folder.path("no")));
}

}  // namespace
}  // namespace isograsp::app::hand_simulate_test
