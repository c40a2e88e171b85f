// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand hold, squeeze, slide: motions that are known otherwise, and what is wrong is named.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/golden_table.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::hand_world_test {
namespace {

namespace fs = std::filesystem;
using test::every;
using test::isograsp;
using test::number_in;
using test::TemporaryFolder;

const std::string kLedSprings = ISOGRASP_SOURCE_DIR "/tests/data/hand/";

TEST(HandWorldCommands, AnObjectOnLedSpringsMovesAsTheOracleSays) {
  // The oracle is of order eight; steps of 1 ms are of order two.
  constexpr double kPlace_m = 5e-6;
  constexpr double kQuaternion = 1e-4;
  const TemporaryFolder folder;
  for (const std::string name : {"hold_drop_two", "hold_lift_three"}) {
    const std::string out = folder.path(name + ".csv");
    const auto done = isograsp("hand hold --case " + kLedSprings + name + ".toml --out " + out);
    ASSERT_EQ(done.status, 0) << done.err;
    const auto moved = test::golden_table(out);
    const auto wanted = test::golden_table(kLedSprings + name + "_reference.csv");
    ASSERT_EQ(moved.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      for (const char* column : {"x_m", "y_m", "z_m"})
        ASSERT_WITHIN(number_in(moved[k], column), number_in(wanted[k], column), kPlace_m) << k;
      for (const char* column : {"qw", "qx", "qy", "qz"})
        ASSERT_WITHIN(number_in(moved[k], column), number_in(wanted[k], column), kQuaternion) << k;
    }
  }
}

TEST(HandWorldCommands, PadsHoldWhatTheyCanAndADiskComesToRest) {
  const std::string pads = "hand squeeze --json --mass 0.06 --friction 0.8 --force ";
  const auto held = nlohmann::json::parse(isograsp(pads + "0.4").out);
  EXPECT_LT(held.at("slip_m").get<double>(), 1e-6);
  const auto slips = nlohmann::json::parse(isograsp(pads + "0.3").out);
  EXPECT_GT(slips.at("slip_m").get<double>(), 1e-3);
  const auto disk = nlohmann::json::parse(
      isograsp("hand slide --json --friction 0.4 --radius 0.04 --v0 0 --w0 20").out);
  // It only turns: friction 2/3 mu m g R, inertia m R^2 / 2.
  const double stop_s = 20.0 * 0.04 / 2.0 / (2.0 / 3.0 * 0.4 * 9.81);
  EXPECT_WITHIN(disk.at("stop_s").get<double>(), stop_s, 0.002);
  EXPECT_WITHIN(disk.at("angle_rad").get<double>(), 10.0 * stop_s, 0.01);
}

TEST(HandWorldCommands, BadInputIsNamedAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string out = folder.path("out.csv");
  const auto refused_with = [&](const std::string& words, const std::string& message) {
    const auto done = isograsp("hand " + words);
    EXPECT_EQ(done.status, 2) << words;
    EXPECT_NE(done.err.find(message), std::string::npos) << words << "\n" << done.err;
    EXPECT_FALSE(fs::exists(out)) << words;
  };
  const std::string object =
      "[object]\nshape = \"box\"\nsize_m = [0.02, 0.02, 0.1]\nmass_kg = 0.06\n"
      "inertia_kg_m2 = [1e-4, 1e-4, 4e-6]\ngravity_m_s2 = [0, -9.81, 0]\n";
  const std::string spring =
      "[[attached]]\nfinger = \"thumb\"\nobject_point_m = [0, 0, 0]\nstiffness_N_m = 200\n"
      "damping_N_s_m = 5\n";
  const auto hold = [&](const std::string& name, const std::string& head, const std::string& rest) {
    folder.write(name, "format = \"isograsp-hold-1\"\nname = \"a\"\n" + head +
                           "anchors = \"anchors.csv\"\n" + rest);
    return "hold --case " + folder.path(name) + " --out " + out;
  };
  folder.write("anchors.csv", "t_s,thumb_x_m,thumb_y_m,thumb_z_m\n0,0,0,0\n0,0,0,0\n");
  refused_with(hold("a.toml", "duration_s = -1\n", object + spring), "a.toml:3: duration_s");
  refused_with(hold("b.toml", "duration_s = 1e9\n", object + spring), "write seconds, at most");
  refused_with(hold("c.toml", "duration_s = 1\n", object), "attached: stands there 0 times");
  refused_with(hold("d.toml", "duration_s = 1\n", object + spring),
               "anchors.csv:3: t_s: time does not increase");
  refused_with("slide --friction 0.001 --gravity 0 --radius 0.04 --v0 0.1 --w0 1",
               "does not come to rest");
}

}  // namespace
}  // namespace isograsp::app::hand_world_test
