// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/csv_mapping.hpp"

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "device/recording/replay_device.hpp"
#include "hand/finger_forces.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::csv_mapping_test {
namespace {

using test::TemporaryFolder;

constexpr const char* kHead = "format = \"isograsp-mapping-1\"\n";

std::string message_of(const Result<CsvMapping>& result) {
  return result ? "accepted" : result.error().message();
}
std::string refusal_of_mapping(const std::string& text) {
  return message_of(parse_csv_mapping(kHead + text, "m.toml"));
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// Parses the mapping, converts in the folder, returns the error or "accepted".
std::string convert(const TemporaryFolder& folder, const std::string& mapping_text) {
  const auto mapping = parse_csv_mapping(kHead + mapping_text, folder.path("m.toml"));
  if (!mapping) return mapping.error().message();
  const auto converted = convert_csv(*mapping, "", folder.path("out.csv"));
  return converted ? "accepted" : converted.error().message();
}

std::vector<FingerForcesRow> rows_of(const std::string& path) {
  auto reader = FingerForcesReader::open(path);
  EXPECT_TRUE(reader) << reader.error().message();
  std::vector<FingerForcesRow> rows;
  FingerForcesRow row;
  for (;;) {
    const auto more = reader->next(row);
    EXPECT_TRUE(more) << more.error().message();
    if (!more || !*more) return rows;
    rows.push_back(row);
  }
}

TEST(CsvMapping, TurnsSignsAndUnitsAndKeepsMissingSamplesMissing) {
  const TemporaryFolder folder;
  folder.write("a.csv", "Fx,Fy,Fz,Mz\n1000,2000,-3000,5\n,,,\n4000,0,-6000,7\n");
  folder.write("b.csv", "load,other\n1,9\n2,9\n3,9\n");
  ASSERT_EQ(convert(folder, R"(
rate_Hz = 200
force_unit = "mN"
torque_unit = "Nmm"
[[finger]]
finger = "thumb"
file = "a.csv"
axes = {fx = "Fy", fy = "-Fx", fz = "-Fz", tz = "Mz"}
[[finger]]
finger = "middle"
file = "b.csv"
force_unit = "kg"
axes = {fz = "+load"}
)"),
            "accepted");
  const auto rows = rows_of(folder.path("out.csv"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].wrench_C[0].force, Vec3(2, -1, 3));
  EXPECT_EQ(rows[0].wrench_C[0].torque, Vec3(0, 0, 0.005));
  EXPECT_EQ(rows[2].wrench_C[2].force, Vec3(0, 0, 3 * 9.80665));
  EXPECT_FALSE(rows[1].present[0]);
  EXPECT_TRUE(rows[1].present[2]);
  EXPECT_FALSE(rows[0].present[1]);
  EXPECT_EQ(rows[1].t_s, 0.005);
}

TEST(CsvMapping, OneLogMayHoldAllFingersAndItsOwnTime) {
  const TemporaryFolder folder;
  folder.write("a.csv", "ms,T,I,M\n10,1,2,3\n30,4,5,6\n");
  ASSERT_EQ(convert(folder, R"(
time_column = "ms"
time_unit = "ms"
force_scale = 0.5
[[finger]]
finger = "thumb"
file = "a.csv"
axes = {fz = "T"}
[[finger]]
finger = "index"
file = "a.csv"
axes = {fz = "I"}
[[finger]]
finger = "middle"
file = "a.csv"
axes = {fz = "M"}
)"),
            "accepted");
  const auto rows = rows_of(folder.path("out.csv"));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].t_s, 0.01);
  EXPECT_EQ(rows[1].t_s, 0.03);
  EXPECT_EQ(rows[1].wrench_C[2].force.z(), 3.0);
}

TEST(CsvMapping, AStatedRateGivesARegularGridAtAnyLength) {
  const TemporaryFolder folder;
  std::string log = "F\n";
  for (int k = 0; k < 20000; ++k) log += "1\n";
  folder.write("a.csv", log);
  for (const char* rate : {"60", "100", "119.88", "120", "1000"}) {
    ASSERT_EQ(convert(folder, "rate_Hz = " + std::string(rate) +
                                  "\n[[finger]]\nfinger = \"thumb\"\nfile = \"a.csv\"\naxes = {fz "
                                  "= \"F\"}\n"),
              "accepted");
    const auto grid = read_time_grid(folder.path("out.csv"));
    ASSERT_TRUE(grid) << grid.error().message();
    EXPECT_TRUE(grid->regular) << rate;
  }
}

TEST(CsvMapping, EverythingTheMappingStatesIsWrittenDown) {
  const TemporaryFolder folder;
  folder.write("a.csv", "Fz\n1\n2\n");
  ASSERT_EQ(convert(folder, R"(
name = "bench"
label = "stand-in: a bench test"
notes = ["sensor turned\nby hand"]
rate_Hz = 120
force_unit = "mN"
[[finger]]
finger = "index"
file = "a.csv"
axes = {fz = "-Fz"}
)"),
            "accepted");
  const auto reader = CsvReader::open(folder.path("out.csv"));
  ASSERT_TRUE(reader);
  const auto& comments = reader->comments();
  ASSERT_EQ(comments.size(), 6U);
  EXPECT_EQ(comments[0], "stand-in: a bench test");
  EXPECT_EQ(comments[1], "converted by mapping m.toml (bench)");
  EXPECT_EQ(comments[2], "stated by the mapping: rate 120 Hz");
  EXPECT_EQ(comments[3], "index from a.csv");
  EXPECT_EQ(comments[4],
            "stated by the mapping: index fx = 0 (not measured), fy = 0 (not measured), fz = -Fz, "
            "tx = 0 (not measured), ty = 0 (not measured), tz = 0 (not measured); force in mN");
  EXPECT_EQ(comments[5], "note: sensor turned by hand");
}

TEST(CsvMapping, ABadMappingIsRefusedWithTheLine) {
  const std::string finger = "[[finger]]\nfinger = \"thumb\"\nfile = \"a.csv\"\n";
  const std::string axes = "axes = {fz = \"F\"}\n";
  expect_part(refusal_of_mapping("rate_Hz = 1\nforce_unit = \"stone\"\n" + finger + axes),
              "m.toml:3: force_unit: 'stone' is not known");
  expect_part(refusal_of_mapping("rate_Hz = 1\n" + finger + "torque_unit = \"x\"\n" + axes),
              "m.toml:6: finger[1].torque_unit: 'x' is not known");
  expect_part(refusal_of_mapping("rate_Hz = 0\n" + finger + axes), "rate_Hz: is not positive");
  expect_part(refusal_of_mapping(finger + axes), "give either the rate or the column");
  expect_part(refusal_of_mapping("rate_Hz = 1\ntime_column = \"t\"\n" + finger + axes),
              "give either the rate or the column");
  expect_part(refusal_of_mapping("time_column = \"t\"\ntime_unit = \"h\"\n" + finger + axes),
              "time_unit: 'h' is not known");
  expect_part(refusal_of_mapping("rate_Hz = 1\n"), "no finger is mapped");
  expect_part(refusal_of_mapping("rate_Hz = 1\n" + finger + axes + finger + axes),
              "is mapped twice");
  expect_part(refusal_of_mapping("rate_Hz = 1\n" + finger + "axes = {fx = \"F\"}\n"),
              "finger[1].axes.fz: is missing");
  expect_part(refusal_of_mapping("rate_Hz = 1\n" + finger + "axes = {fz = \"-\"}\n"),
              "names no column");
  expect_part(refusal_of_mapping("rate_Hz = 1\nforce_scale = 0\n" + finger + axes),
              "force_scale: is zero");
  expect_part(refusal_of_mapping("rate_Hz = 1\n" + finger + "axes = {fz = \"F\", fq = \"G\"}\n"),
              "unknown key");
}

TEST(CsvMapping, ABadLogIsRefusedWithFileLineAndColumnAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string mapping =
      "rate_Hz = 100\n"
      "[[finger]]\nfinger = \"thumb\"\nfile = \"a.csv\"\naxes = {fx = \"Fx\", fz = \"Fz\"}\n"
      "[[finger]]\nfinger = \"index\"\nfile = \"b.csv\"\naxes = {fz = \"Fz\"}\n";
  const auto refusal = [&](const std::string& a, const std::string& b) {
    folder.write("a.csv", a);
    folder.write("b.csv", b);
    const auto message = convert(folder, mapping);
    EXPECT_FALSE(std::filesystem::exists(folder.path("out.csv")));
    EXPECT_FALSE(std::filesystem::exists(folder.path("out.csv.part")));
    return message;
  };
  const std::string good = "Fx,Fz\n1,2\n1,2\n1,2\n";
  expect_part(refusal("Fx,Fq\n1,2\n1,2\n", good),
              "a.csv:1: Fz: the column is missing; correct the "
              "mapping; the file has: Fx, Fq");
  expect_part(refusal(good, "Fx,Fz\n1,2\n1,two\n1,2\n"),
              "b.csv:3: Fz: 'two' is not a finite number");
  expect_part(refusal(good, "Fx,Fz\n1,2\n1,nan\n1,2\n"), "b.csv:3: Fz: 'nan'");
  expect_part(refusal("Fx,Fz\n1,2\n,2\n1,2\n", good), "a.csv:3: Fx: the field is empty");
  expect_part(refusal(good, "Fx,Fz\n1,2\n1,2\n"), "b.csv:3: ends after 2 rows, before");
  expect_part(refusal("Fx,Fz\n1,2\n", "Fx,Fz\n1,2\n"), "fewer than two rows");
  std::filesystem::remove(folder.path("b.csv"));
  expect_part(convert(folder, mapping), "b.csv: cannot be opened");
}

TEST(CsvMapping, NumbersThatOverflowInSiUnitsAreRefused) {
  const TemporaryFolder folder;
  folder.write("a.csv", "F\n1\n1e300\n");
  const std::string finger =
      "[[finger]]\nfinger = \"thumb\"\nfile = \"a.csv\"\naxes = {fz = \"F\"}\n";
  expect_part(convert(folder, "rate_Hz = 1\nforce_scale = 1e300\n" + finger),
              "a.csv:3: F: is too large in SI units");
  expect_part(
      refusal_of_mapping("rate_Hz = 1\nforce_unit = \"kN\"\nforce_scale = 1e307\n" + finger),
      "force_scale: is out of range");
  expect_part(
      refusal_of_mapping("rate_Hz = 1\ntorque_unit = \"Nmm\"\ntorque_scale = 1e-308\n" + finger),
      "torque_scale: is out of range");
  expect_part(refusal_of_mapping("rate_Hz = 1e-310\n" + finger), "rate_Hz: is out of range");
}

TEST(CsvMapping, LogsWithTimesOfTheirOwnMustAgree) {
  const TemporaryFolder folder;
  const std::string mapping =
      "time_column = \"t\"\ntime_unit = \"s\"\n"
      "[[finger]]\nfinger = \"thumb\"\nfile = \"a.csv\"\naxes = {fz = \"F\"}\n"
      "[[finger]]\nfinger = \"index\"\nfile = \"b.csv\"\naxes = {fz = \"F\"}\n";
  folder.write("a.csv", "t,F\n0,1\n1,1\n");
  folder.write("b.csv", "t,F\n0,1\n1.5,1\n");
  expect_part(convert(folder, mapping), "b.csv:3: t: differs from the time in");
  folder.write("a.csv", "t,F\n0,1\n0,1\n");
  folder.write("b.csv", "t,F\n0,1\n0,1\n");
  expect_part(convert(folder, mapping), "a.csv:3: t: time does not increase");
}

TEST(CsvMapping, TheShippedMappingConvertsTheHandoverRecording) {
  const std::string data = test::recorded_data();
  const std::string recording = data + "/kth-handover";
  if (!std::filesystem::exists(recording)) GTEST_SKIP() << "no recording in " << recording;
  const std::string path = ISOGRASP_SOURCE_DIR "/library/devices/mappings/kth_handover.toml";
  const auto text = read_text(path);
  ASSERT_TRUE(text) << text.error().message();
  const auto mapping = parse_csv_mapping(*text, path);
  ASSERT_TRUE(mapping) << mapping.error().message();
  const TemporaryFolder folder;
  const auto converted = convert_csv(*mapping, recording, folder.path("out.csv"));
  ASSERT_TRUE(converted) << converted.error().message();
  EXPECT_EQ(converted->rows, 801);
  EXPECT_EQ(converted->comments.front().rfind("stand-in: ", 0), 0U);

  const auto grid = read_time_grid(folder.path("out.csv"));
  ASSERT_TRUE(grid);
  EXPECT_TRUE(grid->regular);
  EXPECT_EQ(grid->hold_s, 1.0 / 120.0);
  const auto rows = rows_of(folder.path("out.csv"));
  EXPECT_EQ(rows[0].wrench_C[0].force,
            Vec3(0.911489050214612, -1.39137960318945, 18.9543587551671));
  EXPECT_EQ(rows[0].wrench_C[1].force.z(), 0.16689373279645);
  // What the recording is known to hold: the giver grips with up to 23 N and lets go, the taker
  // with up to 38 N.
  double giver_N = 0.0;
  double taker_N = 0.0;
  for (const auto& row : rows) {
    giver_N = std::max(giver_N, row.wrench_C[0].force.z());
    taker_N = std::max(taker_N, row.wrench_C[1].force.z());
  }
  EXPECT_NEAR(giver_N, 23.0, 1.0);
  EXPECT_NEAR(taker_N, 38.0, 1.0);
  EXPECT_LT(rows.back().wrench_C[0].force.z(), 2.0);
  // It replays on its own grid and says what it is.
  const auto device = open_replay_device(*Uri::parse("replay://" + folder.path("out.csv")));
  ASSERT_TRUE(device) << device.error().message();
  EXPECT_TRUE((*device)->info().on_grid);
  EXPECT_EQ((*device)->info().frame_period_s, 1.0 / 120.0);
  EXPECT_EQ((*device)->info().provenance, converted->comments);
}

}  // namespace
}  // namespace isograsp::csv_mapping_test
