// SPDX-License-Identifier: GPL-3.0-or-later
// devices, monitor, record, decode and emulate as a user calls them, where no CAN bus is needed.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace isograsp {
namespace {

using test::isograsp;
using test::TemporaryFolder;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

TEST(DecodeCommand, DecodesTheGoldenLogToTheLastCharacter) {
  const TemporaryFolder folder;
  const auto out = folder.path("out.csv");
  const auto result = isograsp("decode --protocol rft --json " ISOGRASP_SOURCE_DIR
                               "/tests/data/golden_rft.log --out " +
                               out);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(text_of(out),
            "t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags\n"
            "1700000000.076610,thumb,12.34,-5.5,-48.02,0.1235,-0.75,0.0405,1,\n"
            "1700000000.077441,index,-0.8,6.2,18.1,-0.006,0.032,-0.0015,1,\n"
            "1700000000.078472,middle,-1.1,5.8,29.92,-0.01,0.0355,0.002,1,\n"
            "1700000000.087003,thumb,12.44,-5.4,-48.2,0.123,-0.751,0.04,1,\n"
            "1700000000.087834,index,-0.82,6.24,18.2,-0.006,0.032,-0.0015,1,\n"
            "1700000000.088865,middle,-1.08,5.76,-242,-0.01,0.0355,0.002,1,overload_fz\n");
  const auto counts = nlohmann::json::parse(result.out);
  EXPECT_EQ(counts["samples"], 6);
  EXPECT_EQ(counts["answers"], 6);
  EXPECT_EQ(counts["commands"], 12);
  EXPECT_EQ(counts["torn"], 0);
  EXPECT_EQ(counts["foreign"], 0);
}

TEST(DecodeCommand, CountsDamageAndWritesOnlyWholeSamples) {
  const TemporaryFolder folder;
  const auto log = folder.write("x.log",
                                "DROPCOUNT: dropped 3 CAN frames\r\n"
                                "(1.000000) can0 002#F7FA240051000000\r\n"  // alone
                                "(1.010000) can0 001#0B0269FEEDF69F00\r\n"  // no second
                                "(1.020000) can0 001#0A0269FEEDF69F00\r\n"  // good, read once
                                "(1.020130) can0 002#F7FA2400513F0000\r\n"
                                "(1.020140) can0 002#F7FA2400513F0000\r\n"       // repeated
                                "(1.030000) can1 001#0B0269FEEDF69F00\r\n"       // another bus
                                "(1.030000) can0 00000001#0B0269FEEDF69F00\r\n"  // extended
                                "(1.030000) can0 7FF#00\r\n");
  const auto out = folder.path("out.csv");
  const auto result = isograsp("decode --protocol rft " + log + " --out " + out);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("1 samples; frames: 2 torn, 1 duplicate, 3 foreign"), std::string::npos)
      << result.err;
  EXPECT_EQ(text_of(out),
            "t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags\n"
            "1.020130,thumb,12.34,-5.5,-48.02,0.1235,-0.75,0.0405,1,overload_fx+overload_fy+"
            "overload_fz+overload_tx+overload_ty+overload_tz\n");
}

TEST(DeviceCommands, AnErrorIsOneLineWithAPlaceAndARemedyAndNothingIsWritten) {
  const TemporaryFolder folder;
  const auto out = folder.path("out.csv");
  const auto bad = folder.write("bad.log", "(1.000000) can0 001#0B\n(1.000000) can0 00\n");
  const auto device =
      folder.write("bad.toml", "format = \"isograsp-device-1\"\nprotocol = \"rft\"\n");
  for (const auto& [arguments, message] :
       {std::pair<std::string, std::string>{"decode --protocol rft " + bad + " --out " + out,
                                            bad + ":2: "},
        {"decode --protocol rft " + folder.path("absent.log") + " --out " + out, "absent.log"},
        {"decode --protocol abc " + bad + " --out " + out,
         "--protocol: no protocol is called 'abc'"},
        {"decode --protocol rft --config " + device + " " + bad + " --out " + out, device},
        {"devices --check", "--check"},
        {"devices --config " + device + " --check", "there is no sensor for the thumb"},
        {"monitor --device can://nocan9?protocol=rft", "nocan9: there is no such CAN interface"},
        {"monitor --device can://nocan9", "protocol: the protocol is missing"},
        {"monitor --device can://nocan9?protocol=abc", "no CAN protocol is called 'abc'"},
        {"monitor --device 'can://nocan9?protocol=rft&rate=120'", "rate: "},
        {"monitor --device 'can://nocan9?protocol=rft&speed=1'", "speed: unknown parameter"},
        {"monitor --device warp://core", "no device is called warp://"},
        {"monitor --device sim://nobody", "there is no simulated patient 'nobody'"},
        {"record --duration 1 --device sim://healthy --raw x.log --out " + out, "--raw: "},
        {"emulate --protocol rft --on nocan9", "nocan9: there is no such CAN interface"},
        {"emulate --protocol rft --on nocan9 --play nobody", "--play: 'nobody'"},
        {"emulate --protocol rft --on nocan9 --fault explode=thumb", "use lose=FINGER:tx1"},
        {"emulate --protocol rft --on nocan9 --fault lose=thumb:tx3:1", "'tx3'"},
        {"emulate --protocol rft --on nocan9 --fault lose=thumb:tx1:2", "'2' is not a probability"},
        {"emulate --protocol rft --on nocan9 --fault silence=toe@1s", "'toe' is not a finger"}}) {
    const auto result = isograsp(arguments);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(result.err.find("isograsp: error: "), 0u) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(DeviceCommands, MonitorAndRecordTheSimulatedPatient) {
  const TemporaryFolder folder;
  const auto monitored = isograsp("monitor --device 'sim://healthy?seed=3' --duration 0.5 --json");
  ASSERT_EQ(monitored.status, 0) << monitored.err;
  const auto report = nlohmann::json::parse(monitored.out);
  EXPECT_EQ(report["frames"], 50);
  EXPECT_EQ(report["sensors"].size(), 3u);
  EXPECT_EQ(report["state"], "streaming");
  const auto out = folder.path("out.csv");
  const auto recorded =
      isograsp("record --device 'sim://healthy?seed=3' --duration 0.5 --out " + out);
  ASSERT_EQ(recorded.status, 0) << recorded.err;
  EXPECT_NE(text_of(out).find("# simulated\n"), std::string::npos);
  // What was recorded is a device again.
  const auto replayed = isograsp("monitor --device 'replay://" + out + "?speed=0' --json");
  ASSERT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_EQ(nlohmann::json::parse(replayed.out)["frames"], 50);
}

TEST(DeviceCommands, ListsSchemesAndChecksAFile) {
  const auto list = isograsp("devices --json");
  ASSERT_EQ(list.status, 0);
  EXPECT_GE(nlohmann::json::parse(list.out)["schemes"].size(), 4u);
  const auto checked = isograsp("devices --check --config " ISOGRASP_SOURCE_DIR
                                "/library/devices/rft_three_fingers.toml");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_NE(checked.out.find("command 0x65"), std::string::npos);
}

}  // namespace
}  // namespace isograsp
