// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of markers that other systems write: C3D, TRC, tables of Qualisys, and our own.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "device/markers/c3d_codec.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/marker_reader.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::marker_files_test {
namespace {

using test::must;
using test::TemporaryFolder;

struct Recorded {
  std::vector<std::string> markers;
  std::vector<double> t_s;
  std::vector<std::vector<Vec3>> p_W;
};

Result<Recorded> read_all(const std::string& path) {
  const auto reader = open_markers(path);
  if (!reader) return reader.error();
  Recorded all;
  all.markers = (*reader)->markers();
  std::vector<Vec3> p_W(all.markers.size());
  for (double t_s = 0.0;;) {
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) return all;
    all.t_s.push_back(t_s);
    all.p_W.push_back(p_W);
  }
}

bool unseen(const Vec3& p) {
  return std::isnan(p.x()) && std::isnan(p.y()) && std::isnan(p.z());
}

/// Words of a point in a frame: x, y, z and what tells whether it was seen.
struct Words4 {
  float x, y, z, residual;
};

/// A C3D file with one analog value a frame, as integers of 1/16 mm or as floats.
std::string c3d(const std::vector<std::string>& labels,
                const std::vector<std::vector<Words4>>& frames, bool floating,
                std::uint8_t processor = 84, const std::string& unit = "mm") {
  constexpr float kScale = 1.0F / 16.0F;
  std::string bytes(2 * kC3dBlock, '\0');
  const auto put16 = [&bytes](std::size_t at, std::size_t value) {
    bytes[at] = static_cast<char>(value & 0xFF);
    bytes[at + 1] = static_cast<char>(value >> 8);
  };
  const auto put_float = [&bytes](std::size_t at, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(bits >> (8 * i));
  };
  bytes[0] = 2;
  bytes[1] = 0x50;
  put16(2, labels.size());
  put16(4, 1);
  put16(6, 1);
  put16(8, frames.size());
  put_float(12, floating ? -kScale : kScale);
  put16(16, 3);
  put16(18, 1);
  put_float(20, 50.0F);
  std::string parameters{'\x01', '\x50', '\x01', static_cast<char>(processor)};
  const auto record = [&parameters](const std::string& name, int group, const std::string& rest,
                                    bool last = false) {
    parameters += static_cast<char>(name.size());
    parameters += static_cast<char>(group);
    parameters += name;
    const std::size_t step = last ? 0 : 2 + rest.size();
    parameters += static_cast<char>(step & 0xFF);
    parameters += static_cast<char>(step >> 8);
    parameters += rest;
  };
  const auto texts = [](const std::vector<std::string>& all, std::size_t length) {
    std::string rest{'\xFF', '\x02', static_cast<char>(length), static_cast<char>(all.size())};
    for (std::string text : all) {
      text.resize(length, ' ');
      rest += text;
    }
    return rest + '\0';
  };
  record("POINT", -1, std::string(1, '\0'));
  record("LABELS", 1, texts(labels, 12));
  // A count that has overflown, which is not believed.
  record("FRAMES", 1, std::string{'\x02', '\x00', '\xFF', '\xFF', '\x00'});
  record("UNITS", 1, texts({unit}, 4), true);
  bytes.replace(kC3dBlock, parameters.size(), parameters);
  bytes.resize(2 * kC3dBlock);
  for (const auto& frame : frames) {
    for (const Words4& point : frame)
      for (const float value : {point.x, point.y, point.z, point.residual}) {
        const std::size_t at = bytes.size();
        bytes.resize(at + (floating ? 4 : 2));
        if (floating)
          put_float(at, value);
        else
          put16(at,
                static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value / kScale))));
      }
    bytes.resize(bytes.size() + (floating ? 4 : 2));
  }
  return bytes;
}

TEST(C3d, IntegersAndFloatsOfTheSameRecordingGiveTheSamePositions) {
  Random random(1);
  std::vector<std::vector<Words4>> frames(20);
  for (auto& frame : frames)
    for (int k = 0; k < 3; ++k) {
      const auto sixteenth = [&] {
        return std::floor(16000.0F * static_cast<float>(random.uniform())) / 16.0F + 2.0F;
      };
      frame.push_back({sixteenth(), -sixteenth(), sixteenth(), 0.0F});
    }
  const TemporaryFolder folder;
  const auto whole = must(read_all(folder.write("i.c3d", c3d({"A", "B", "C"}, frames, false))));
  const auto real = must(read_all(folder.write("f.c3d", c3d({"A", "B", "C"}, frames, true))));
  ASSERT_EQ(whole.t_s.size(), 20U);
  EXPECT_EQ(whole.t_s, real.t_s);
  EXPECT_EQ(whole.t_s[1], 0.02);
  for (std::size_t r = 0; r < 20; ++r)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(whole.p_W[r][k], real.p_W[r][k]);
      EXPECT_EQ(real.p_W[r][k].x(), 1e-3 * static_cast<double>(frames[r][k].x));
    }
}

TEST(C3d, WhatWasNotSeenIsMissingHoweverItIsWritten) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::vector<Words4>> frames{
      {{1, 2, 3, 0}, {1, 2, 3, -1}, {0, 0, 0, 0}, {nan, nan, nan, 0}}};
  const TemporaryFolder folder;
  const auto read =
      must(read_all(folder.write("a.c3d", c3d({"Her:A", "Her:B", "C", "D"}, frames, true))));
  EXPECT_EQ(read.markers, (std::vector<std::string>{"A", "B", "C", "D"})) << "without the subject";
  EXPECT_FALSE(unseen(read.p_W[0][0]));
  for (std::size_t k = 1; k < 4; ++k) EXPECT_TRUE(unseen(read.p_W[0][k])) << k;
}

TEST(C3d, UnitsAreThoseOfTheFile) {
  const TemporaryFolder folder;
  const std::vector<std::vector<Words4>> frames{{{1, 2, 4, 0}}};
  for (const auto& [unit, metres] : {std::pair("m", 1.0), {"cm", 0.01}, {"mm", 0.001}})
    EXPECT_EQ(
        must(read_all(folder.write("u.c3d", c3d({"A"}, frames, true, 84, unit)))).p_W[0][0].z(),
        4.0 * metres);
  const auto inch = read_all(folder.write("u.c3d", c3d({"A"}, frames, true, 84, "inch")));
  ASSERT_FALSE(inch);
  EXPECT_NE(inch.error().message().find("'inch'"), std::string::npos);
}

TEST(C3d, AFileThatIsCutOrOfAnotherProcessorIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string good = c3d({"A", "B"}, {{{1, 2, 3, 0}, {1, 2, 3, 0}}}, true);
  for (std::size_t size = 1; size < good.size(); size += 7) {
    const auto read = read_all(folder.write("cut.c3d", good.substr(0, size)));
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().code, Error::Code::bad_input) << size;
    EXPECT_NE(read.error().message().find("cut.c3d"), std::string::npos) << size;
  }
  const auto sgi = read_all(folder.write("sgi.c3d", c3d({"A"}, {{{1, 2, 3, 0}}}, true, 86)));
  ASSERT_FALSE(sgi);
  EXPECT_NE(sgi.error().message().find("(86)"), std::string::npos);
  const auto twice =
      read_all(folder.write("t.c3d", c3d({"x:A", "y:A"}, {{{1, 2, 3, 0}, {1, 2, 3, 0}}}, true)));
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().message().find("'A' appears twice"), std::string::npos);
}

TEST(C3d, DamagedFilesNeverReadBeyondTheirEnd) {
  const std::string good = c3d({"A", "B"}, {{{1, 2, 3, 0}, {1, 2, 3, 0}}}, true);
  Random random(2);
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::vector<std::uint8_t> bytes(good.begin(), good.end());
    for (int k = 0; k < 8; ++k)
      bytes[static_cast<std::size_t>(random.uniform() * 700.0) % bytes.size()] =
          static_cast<std::uint8_t>(256.0 * random.uniform());
    const auto start = c3d_data_start(bytes);
    if (!start || *start > bytes.size()) continue;
    read += parse_c3d_head(std::span(bytes).first(*start)) ? 1 : 0;
  }
  EXPECT_GT(read, 0);
}

const std::string kTrc =
    "PathFileType\t4\t(X/Y/Z)\tC:\\Jane Doe\\trial.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\n"
    "100\t100\t3\t2\tmm\t100\n"
    "Frame#\tTime\tHer:A\t\t\tB\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n"
    "1\t0.00\t1\t2\t3\t4\t5\t6\n"
    "2\t0.01\t\t\t\t4\t5\t6\n"
    "3\t0.02\t0\t0\t0\tNaN\tNaN\tNaN\n";

TEST(Trc, GivesPositionsInMetresAndWhatIsMissing) {
  const TemporaryFolder folder;
  const auto read = must(read_all(folder.write("a.trc", kTrc)));
  EXPECT_EQ(read.markers, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(read.t_s, (std::vector<double>{0.0, 0.01, 0.02}));
  EXPECT_EQ(read.p_W[0][1], Vec3(1e-3 * 4, 1e-3 * 5, 1e-3 * 6));
  EXPECT_TRUE(unseen(read.p_W[1][0]));
  EXPECT_FALSE(unseen(read.p_W[1][1]));
  EXPECT_TRUE(unseen(read.p_W[2][0]));
  EXPECT_TRUE(unseen(read.p_W[2][1]));
}

TEST(QualisysTable, IsReadWithAndWithoutColumnsOfTime) {
  const std::string head =
      "NO_OF_FRAMES\t2\nNO_OF_MARKERS\t2\nFREQUENCY\t200\nDESCRIPTION\tJane Doe\n"
      "TIME_STAMP\t2026-01-01\nMARKER_NAMES\tA\tB\n";
  const TemporaryFolder folder;
  const auto plain =
      must(read_all(folder.write("p.tsv", head + "1\t2\t3\t4\t5\t6\n1\t2\t3\t0\t0\t0\n")));
  const auto timed = must(read_all(
      folder.write("t.tsv", head + "Frame\tTime\tA X\tA Y\tA Z\tB X\tB Y\tB "
                                   "Z\n1\t0\t1\t2\t3\t4\t5\t6\n2\t0.005\t1\t2\t3\t0\t0\t0\n")));
  for (const Recorded* read : {&plain, &timed}) {
    EXPECT_EQ(read->markers, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(read->t_s, (std::vector<double>{0.0, 0.005}));
    EXPECT_EQ(read->p_W[0][0], Vec3(1e-3 * 1, 1e-3 * 2, 1e-3 * 3));
    EXPECT_TRUE(unseen(read->p_W[1][1]));
  }
}

TEST(MarkerFiles, BadRowsOfTextsAreRefusedWithFileAndLine) {
  const TemporaryFolder folder;
  const auto message = [&folder](const std::string& text) {
    const auto read = read_all(folder.write("f", text));
    return read ? std::string("was read") : read.error().message();
  };
  const std::string csv = "t_s,A_x_m,A_y_m,A_z_m\n0,1,2,3\n";
  for (const auto& [text, expected] :
       {std::pair(csv + "0.01,1,,3\n", "f:3: A: a part of the position"),
        {csv + "0.01,1,x,3\n", "f:3: A_y_m: 'x'"},
        {csv + "0.01,1,nan,3\n", "f:3: A_y_m: 'nan'"},
        {csv + "0.01,1\n", "f:3: A_y_m: the line ends"},
        {csv + "0,1,2,3\n", "f:3: t_s: time does not increase"},
        {csv + ",1,2,3\n", "f:3: t_s: the time is empty"},
        {std::string("t_s,A_x_m,A_y_m\n0,1,2\n"), "f:1: A_x_m: column 'A_z_m'"},
        {std::string("t_s,A_x_m,A_y_m,A_z_m,more\n"), "f:1: more: begins no position"},
        {std::string("A_x_m,A_y_m,A_z_m\n"), "f:1: A_x_m: the first column"},
        {kTrc + "4\t0.03\t1\t2\tx\t4\t5\t6\n", "f:10: A: 'x'"},
        {kTrc + "4\t0.03\t1\t\t2\t4\t5\t6\n", "f:10: A: a part"},
        {kTrc + "4\t0.01\t1\t2\t3\t4\t5\t6\n", "f:10: Time: time does not increase"},
        {kTrc + "4\t0.03\t1\t2\t3\t4\t5\t6\t7\n", "f:10: the line has more fields"},
        {std::string("NO_OF_FRAMES\t2\nMARKER_NAMES\tA\n1\t2\t3\n"), "f:3: its head names no FREQ"},
        {std::string("PathFileType\t4\n"), "f:1: ends within its head"}})
    EXPECT_NE(message(text).find(expected), std::string::npos) << message(text);
}

TEST(MarkerFiles, ATableReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  auto writer = must(MarkerCsvWriter::create(folder.path("m.csv"), {"A", "=B"}));
  const std::vector<Vec3> row{Vec3(1.0 / 3.0, -2, 0), unseen_marker()};
  writer.write(0.1, row);
  must(writer.commit());
  const auto read = must(read_all(folder.path("m.csv")));
  EXPECT_EQ(read.markers, (std::vector<std::string>{"A", "=B"}));
  EXPECT_EQ(read.p_W[0][0], row[0]);
  EXPECT_TRUE(unseen(read.p_W[0][1]));
}

TEST(MarkerFiles, NamesCommentsAndPathsOfPeopleAreNotPassedOn) {
  const TemporaryFolder folder;
  for (const auto& [name, text] :
       {std::pair("a.trc", kTrc),
        {"a.c3d", c3d({"JaneDoe:A", "JaneDoe:B"}, {{{1, 2, 3, 0}, {1, 2, 3, 0}}}, true)}}) {
    const auto reader = must(open_markers(folder.write(name, text)));
    auto writer = must(MarkerCsvWriter::create(folder.path("o.csv"), reader->markers()));
    std::vector<Vec3> p_W(reader->markers().size());
    for (double t_s = 0.0; must(reader->next(t_s, p_W));) writer.write(t_s, p_W);
    must(writer.commit());
    const std::string out = test::read_file(folder.path("o.csv"));
    EXPECT_GT(out.size(), 20U);
    EXPECT_EQ(out.find("Jane"), std::string::npos) << out;
  }
}

}  // namespace
}  // namespace isograsp::marker_files_test
