// SPDX-License-Identifier: GPL-3.0-or-later
// devices, monitor, record, decode and emulate as a user calls them, where no CAN bus is needed.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::device_commands_test {
namespace {

using test::isograsp;
using test::TemporaryFolder;

std::string content_of(const std::string& path) {
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
  EXPECT_EQ(content_of(out),
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
  EXPECT_EQ(content_of(out),
            "t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags\n"
            "1.020130,thumb,12.34,-5.5,-48.02,0.1235,-0.75,0.0405,1,overload_fx+overload_fy+"
            "overload_fz+overload_tx+overload_ty+overload_tz\n");
}

/// What decode writes for a log; the rows without their header.
std::string decoded(const std::string& protocol, const std::string& log) {
  const TemporaryFolder folder;
  const auto out = folder.path("out.csv");
  const auto result = isograsp("decode --protocol " + protocol + " " + folder.write("x.log", log) +
                               " --out " + out);
  EXPECT_EQ(result.status, 0) << result.err;
  const auto text = content_of(out);
  return text.substr(text.find('\n') + 1);
}

// The worked examples of docs/devices.md.
TEST(DecodeCommand, ReadsTheMatrixOfAnAtiSensorFromTheLog) {
  const std::string rows[] = {"449C5000C39B2000", "42BF8000C6836800", "C30C800046808E80",
                              "C42F8000469B1500", "43C22000C6179B00", "44002000C614F400",
                              "469D1D80434D8000", "469FCE00C2B08000", "469E850043C8E000",
                              "C10800004300C000", "C3A14000C2750000", "43A5E000C2810000",
                              "43B9A00040900000", "C33E000042DB8000", "C3374000C2E10000",
                              "413C0000C3448000", "40E80000C3414000", "41180000C345C000"};
  std::string log;
  // A sample before the matrix is told: its scale comes later in the log.
  log +=
      "(1.000000) can0 200#\n(1.000100) can0 200#000005DC05A0FFD8\n"
      "(1.000200) can0 201#F7680C1CF8AD\n";
  for (int axis = 0; axis < 6; ++axis) {
    log += "(1.010000) can0 202#0" + std::to_string(axis) + "\n";
    for (int part = 0; part < 3; ++part)
      log += "(1.010100) can0 20" + std::to_string(2 + part) + "#" +
             rows[static_cast<std::size_t>(3 * axis + part)] + "\n";
  }
  log +=
      "(1.020000) can0 207#\n(1.020100) can0 207#000F4240000F4240\n"
      "(1.021000) can0 208#\n(1.021100) can0 208#0203\n"
      "(1.030000) can0 200#\n(1.030100) can0 200#80407FFF002DFEFC\n"
      "(1.030200) can0 201#8000012D0013\n";
  std::istringstream lines(decoded("ati-netcanoem", log));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("1.000200,thumb,", 0), 0u) << line;
  double values[6];
  ASSERT_EQ(std::sscanf(line.c_str(), "1.000200,thumb,%lf,%lf,%lf,%lf,%lf,%lf,1,", &values[0],
                        &values[1], &values[2], &values[3], &values[4], &values[5]),
            6)
      << line;
  // Gages less a bias of zero: M g / 1e6, the numbers worked by hand from the rows above.
  const double gages[] = {1500, -2200, 1440, 3100, -40, -1875};
  const double fx = (1250.5 * gages[0] - 310.25 * gages[1] + 95.75 * gages[2] - 16820.0 * gages[3] -
                     140.5 * gages[4] + 16455.25 * gages[5]) /
                    1e6;
  EXPECT_WITHIN(values[0], fx, 1e-12 * std::abs(fx));
  std::getline(lines, line);
  EXPECT_NE(line.find(",0,saturated+status_bad_active_calibration+status_any_error"),
            std::string::npos)
      << line;
}

TEST(DecodeCommand, ReadsTheFullScalesOfAJr3SensorFromTheLog) {
  EXPECT_EQ(decoded("jr3-can",
                    "(1.000000) can0 481#\n(1.000100) can0 101#00960096002C01\n"
                    "(1.001000) can0 501#\n(1.001100) can0 101#00500050005000\n"
                    "(1.010000) can0 080#\n(1.010100) can0 601#0000000000000100\n"
                    "(1.010200) can0 681#0000000000000100\n"
                    "(1.020000) can0 080#\n(1.020100) can0 601#004000C000C0FFFF\n"
                    "(1.020200) can0 681#004000C00020FFFF\n"),
            "1.010200,thumb,0,0,0,0,0,0,1,\n1.020200,thumb,150,-150,-300,8,-8,4,1,\n");
}

TEST(DecodeCommand, ReadsDatagramsOfNetFtBoxes) {
  EXPECT_EQ(decoded("net-ft",
                    "(1.000000) 192.168.1.12:49152 "
                    "000003E900001B770000000000BC4B20FFAC13A0FD2345E00001E26CFFF48E5000009E34\n"
                    "(1.000100) 192.168.1.9:49152 "
                    "000000010000000A00000000000000000000000000000000000000000000000000000000\n"
                    "(1.000200) 192.168.1.9:49152 "
                    "000000010000000A00000000000000000000000000000000000000000000000000000000\n"
                    "(1.001000) 192.168.1.12:49152 "
                    "000003EA00001B7E80020000FFFFFFFF000000017FFFFFFF8000000000000005FFFFFFFA\n"),
            "1.000000,index,12.34,-5.5,-48.02,0.1235,-0.75,0.0405,1,\n"
            "1.000100,thumb,0,0,0,0,0,0,1,\n"
            "1.001000,index,-1e-06,1e-06,2147.483647,-2147.483648,5e-06,-6e-06,0,"
            "saturated+status_error_summary+status_transducer_saturation_or_ad_error\n");
}

const std::string kArm = ISOGRASP_SOURCE_DIR "/tests/data/isotonic/session_a_markers.csv";

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
        {"decode --protocol jr3-can --config " ISOGRASP_SOURCE_DIR
         "/library/devices/ati_three_fingers.toml " +
             bad + " --out " + out,
         "protocol: the file is for ati-netcanoem"},
        {"emulate --protocol rft --on nocan9 --fault busoff@5s", "use --on slcan:can0"},
        {"monitor --device udp://1.2.3.4?protocol=net-ft", "not the addresses of three sensors"},
        {"monitor --device udp://?protocol=jr3-can", "do not speak over udp://"},
        {"devices --check", "--check"},
        {"devices --config " + device + " --check", "there is no sensor for the thumb"},
        {"monitor --device can://nocan9?protocol=rft", "nocan9: there is no such CAN interface"},
        {"monitor --device can://nocan9", "protocol: the protocol is missing"},
        {"monitor --device can://nocan9?protocol=abc", "no protocol is called 'abc'"},
        {"monitor --device 'can://nocan9?protocol=rft&rate=120'", "rate: "},
        {"monitor --device 'can://nocan9?protocol=rft&speed=1'", "speed: unknown parameter"},
        {"monitor --device warp://core", "no device is called warp://"},
        {"monitor --device sim://nobody", "there is no simulated patient 'nobody'"},
        {"record --duration 1 --device sim://healthy --raw x.log --out " + out, "--raw: "},
        {"emulate --protocol rft --on nocan9", "nocan9: there is no such CAN interface"},
        {"emulate --protocol rft --on nocan9 --play nobody", "--play: 'nobody'"},
        {"emulate --protocol rft --on nocan9 --fault explode=thumb", "there is no such fault"},
        {"emulate --protocol rft --on nocan9 --fault lose=thumb:tx3:1", "there is no such fault"},
        {"emulate --protocol rft --on nocan9 --fault lose=thumb:tx1:2", "'2' is not a probability"},
        {"emulate --protocol rft --on nocan9 --fault silence=toe@1s", "there is no such finger"},
        {"emulate --protocol qtm-rt --on 127.0.0.1:22223 --play absent.csv", "absent.csv"},
        {"emulate --protocol qtm-rt --on here --play " + kArm, "--on: 'here' is no address"},
        {"emulate --protocol qtm-rt --on 127.0.0.1:22223 --fault close --play " + kArm,
         "the instant is missing"},
        {"emulate --protocol natnet --on 127.0.0.1:1510 --fault split --play " + kArm,
         "NatNet has no connection"},
        {"emulate --protocol natnet --on 127.0.0.1:1510 --bitstream 4.2 --play " + kArm,
         "--bitstream: '4.2' is no known version"},
        {"emulate --protocol natnet --on 127.0.0.1:1510 --multicast x --play " + kArm,
         "--multicast: 'x' is no address"}}) {
    const auto result = isograsp(arguments);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(result.err.find("isograsp: error: "), 0u) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(DeviceCommands, EmulatedCamerasWaitForAClientUntilTimeIsUp) {
  for (const std::string protocol : {"qtm-rt", "natnet"}) {
    const auto emulated = isograsp("emulate --protocol " + protocol +
                                   " --on 127.0.0.1:" + std::to_string(test::free_port()) +
                                   " --duration 0.05 --json --play " + kArm);
    ASSERT_EQ(emulated.status, 0) << emulated.err;
    const auto report = nlohmann::json::parse(emulated.out);
    EXPECT_EQ(report["pictures"], 0);
    EXPECT_EQ(report["clients"], 0);
  }
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
  EXPECT_NE(content_of(out).find("# simulated\n"), std::string::npos);
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

/// A recording of a therapist who is led through the check: one second of nothing, then for every
/// support in, up and toward the wrist. `swapped`: the sensors of index and middle are exchanged.
std::string walked_through(bool swapped) {
  std::string text =
      "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N,index_fx_N,index_fy_N,index_fz_N,middle_fx_N,"
      "middle_fy_N,middle_fz_N\n";
  const int axis_of_press[] = {2, 0, 1};
  for (int k = 0; k < 1200; ++k) {
    double force_N[9] = {};
    const int press = (k - 200) / 100;
    if (k >= 200 && press < 9 && (k - 200) % 100 >= 20) {
      int finger = press / 3;
      if (swapped && finger > 0) finger = 3 - finger;
      // The platform stands for the right hand: its fingers have the wrist at -y, the thumb at +y.
      const bool backwards = press % 3 == 2 && finger > 0;
      force_N[3 * finger + axis_of_press[press % 3]] = backwards ? -8.0 : 8.0;
    }
    text += std::to_string(0.01 * k);
    for (const double value : force_N) text += "," + std::to_string(value);
    text += "\n";
  }
  return text;
}

TEST(DeviceCommands, HandsAreWordsInTheHelpAndInTheRefusal) {
  const auto help = isograsp("devices --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("{right,left}"), std::string::npos) << help.out;
  const auto refused = isograsp("devices --hand both");
  EXPECT_NE(refused.status, 0);
  EXPECT_NE(refused.err.find("both not in {right,left}"), std::string::npos) << refused.err;
}

TEST(DeviceCommands, TheGuidedCheckPassesAGoodDeviceAndNamesSwappedSensors) {
  const TemporaryFolder folder;
  const std::string check = "devices --check --config " ISOGRASP_SOURCE_DIR
                            "/library/devices/rft_three_fingers.toml --device 'replay://";
  const auto good = isograsp(check + folder.write("good.csv", walked_through(false)) + "?speed=0'");
  EXPECT_EQ(good.status, 0) << good.err << good.out;
  EXPECT_NE(good.out.find("Press the thumb's support straight in and hold."), std::string::npos);
  EXPECT_NE(good.out.find("The device passed."), std::string::npos);
  const auto swapped =
      isograsp(check + folder.write("bad.csv", walked_through(true)) + "?speed=0' --json");
  EXPECT_EQ(swapped.status, 1);
  EXPECT_NE(swapped.err.find("the sensors of index and middle are swapped"), std::string::npos)
      << swapped.err;
  const auto whole = walked_through(false);
  const auto half = whole.substr(0, whole.find('\n', whole.size() / 2) + 1);
  const auto too_short = isograsp(check + folder.write("short.csv", half) + "?speed=0'");
  EXPECT_EQ(too_short.status, 1);
  EXPECT_NE(too_short.err.find("the check was not finished"), std::string::npos) << too_short.err;
}

}  // namespace
}  // namespace isograsp::app::device_commands_test
