// SPDX-License-Identifier: GPL-3.0-or-later
// C3D files as this program writes them: by the public layout (c3d.org, user guide), byte by byte,
// and read back.
#include "device/markers/c3d_writer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "device/markers/c3d_codec.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/marker_reader.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::c3d_writer_test {
namespace {

using test::must;
using test::TemporaryFolder;

struct Recording {
  std::vector<std::string> markers;
  std::vector<double> t_s;
  std::vector<std::vector<Vec3>> p_W;
};

Recording read_back(const std::string& path) {
  const auto reader = must(open_markers(path));
  Recording all;
  all.markers = reader->markers();
  std::vector<Vec3> p_W(all.markers.size());
  for (double t_s = 0.0; must(reader->next(t_s, p_W));) {
    all.t_s.push_back(t_s);
    all.p_W.push_back(p_W);
  }
  return all;
}

/// Random positions within a metre, a tenth of them not seen.
std::string random_table(const TemporaryFolder& folder, std::size_t markers, int rows,
                         double rate_Hz) {
  Random random(1);
  std::vector<std::string> labels;
  for (std::size_t k = 0; k < markers; ++k) labels.push_back("M" + std::to_string(k));
  const std::string path = folder.path("table.csv");
  auto writer = must(MarkerCsvWriter::create(path, labels));
  for (int row = 0; row < rows; ++row) {
    std::vector<Vec3> p_W;
    for (std::size_t k = 0; k < markers; ++k) {
      const Vec3 p(2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0, random.uniform());
      p_W.push_back(random.uniform() < 0.1 ? unseen_marker() : p);
    }
    writer.write(row / rate_Hz, p_W);
  }
  must(writer.commit());
  return path;
}

/// Of single precision, in metres up to one.
constexpr double kSingle_m = 1e-7;

void expect_equal(const Recording& written, const Recording& read, double tolerance_m) {
  EXPECT_EQ(read.markers, written.markers);
  ASSERT_EQ(read.t_s.size(), written.t_s.size());
  test::AtLeast compared(1);
  for (std::size_t row = 0; row < read.t_s.size(); ++row) {
    EXPECT_WITHIN(read.t_s[row], written.t_s[row] - written.t_s[0],
                  kSingle_m * (1.0 + read.t_s[row]));
    for (std::size_t k = 0; k < read.markers.size(); ++k) {
      ASSERT_EQ(read.p_W[row][k].allFinite(), written.p_W[row][k].allFinite()) << row << " " << k;
      if (!read.p_W[row][k].allFinite()) continue;
      ++compared;
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_WITHIN(read.p_W[row][k][axis], written.p_W[row][k][axis], tolerance_m);
    }
  }
}

TEST(C3dWriter, EveryRecordingComesBackFromFloatsAndToHalfAStepFromIntegers) {
  const TemporaryFolder folder;
  const std::string qualisys =
      "NO_OF_FRAMES\t2\nNO_OF_MARKERS\t2\nFREQUENCY\t200\nMARKER_NAMES\tA\tB\n"
      "1\t2\t3\t4\t5\t6\n1\t2\t3\t0\t0\t0\n";
  const std::string trc =
      "PathFileType\t4\t(X/Y/Z)\tf.trc\n"
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\n"
      "120\t120\t3\t1\tmm\t120\nFrame#\tTime\tA\t\t\n\t\tX1\tY1\tZ1\n\n"
      "1\t0.000\t1\t2\t3\n2\t0.008\t\t\t\n3\t0.017\t4\t5\t-900\n";
  const std::string table = random_table(folder, 5, 300, 100.0);
  must(convert_to_c3d(table, folder.path("own.c3d"), C3dNumbers::floats));
  test::AtLeast files(4);
  for (const std::string& in : {table, folder.write("q.tsv", qualisys), folder.write("t.trc", trc),
                                folder.path("own.c3d")}) {
    ++files;
    const Recording written = read_back(in);
    must(convert_to_c3d(in, folder.path("f.c3d"), C3dNumbers::floats));
    must(convert_to_c3d(in, folder.path("i.c3d"), C3dNumbers::integers));
    const Recording floats = read_back(folder.path("f.c3d"));
    const Recording integers = read_back(folder.path("i.c3d"));
    double largest_m = 0.0;
    for (const auto& row : written.p_W)
      for (const Vec3& p : row)
        if (p.allFinite()) largest_m = std::max(largest_m, p.cwiseAbs().maxCoeff());
    if (in.ends_with(".trc")) {  // its times are rounded to a millisecond, C3D counts frames
      EXPECT_WITHIN(floats.t_s[2], written.t_s[2], 1e-3);
    } else {
      expect_equal(written, floats, kSingle_m);
    }
    expect_equal(floats, integers, largest_m / 32000.0 / 2.0 + kSingle_m);
  }
}

std::size_t word_at(const std::string& bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]) |
         static_cast<std::size_t>(static_cast<std::uint8_t>(bytes[at + 1])) << 8U;
}
float float_at(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(
      static_cast<std::uint32_t>(word_at(bytes, at) | word_at(bytes, at + 2) << 16U));
}

TEST(C3dWriter, TheHeadStandsWhereThePublicDocumentSays) {
  const C3dRecording recording{{"A", "Wrist"}, 250, 120.0, 0.64, C3dNumbers::integers};
  const std::string head = must(c3d_head(recording));
  EXPECT_EQ(head.size() % 512, 0U);
  EXPECT_EQ(head[0], 2) << "word 1: the parameters begin in block 2";
  EXPECT_EQ(head[1], 0x50);
  EXPECT_EQ(word_at(head, 2), 2U) << "word 2: points";
  EXPECT_EQ(word_at(head, 4), 0U) << "word 3: analog values";
  EXPECT_EQ(word_at(head, 6), 1U) << "word 4: first frame";
  EXPECT_EQ(word_at(head, 8), 250U) << "word 5: last frame";
  EXPECT_EQ(word_at(head, 10), 0U) << "word 6: no interpolation";
  EXPECT_EQ(float_at(head, 12), 0.02F) << "words 7, 8: 640 mm / 32000";
  EXPECT_EQ(word_at(head, 16), 1 + head.size() / 512) << "word 9: block of the data";
  EXPECT_EQ(word_at(head, 18), 0U) << "word 10";
  EXPECT_EQ(float_at(head, 20), 120.0F) << "words 11, 12: rate";
  for (std::size_t at = 24; at < 512; ++at) ASSERT_EQ(head[at], 0) << at;
  EXPECT_EQ(head[512], 1);
  EXPECT_EQ(head[513], 0x50);
  EXPECT_EQ(static_cast<std::size_t>(head[514]), head.size() / 512 - 1) << "its blocks";
  EXPECT_EQ(head[515], 84) << "Intel";
  C3dRecording floating = recording;
  floating.numbers = C3dNumbers::floats;
  EXPECT_EQ(float_at(must(c3d_head(floating)), 12), -0.02F) << "below zero: floats";
}

/// The parameters of a head: type, then dimensions and values as they stand.
std::map<std::string, std::pair<int, std::string>> parameters_in(const std::string& head) {
  std::map<int, std::string> groups;
  std::map<std::string, std::pair<int, std::string>> all;
  std::size_t at = 516;
  for (;;) {
    const auto length = static_cast<std::size_t>(std::abs(head.at(at)));
    const int group = head.at(at + 1);
    const std::string name = head.substr(at + 2, length);
    const std::size_t behind = at + 2 + length;
    const std::size_t step = word_at(head, behind);
    if (group < 0) {
      groups[-group] = name;
    } else {
      const int type = head.at(behind + 2);
      std::size_t size = static_cast<std::size_t>(std::abs(type));
      const auto dimensions = static_cast<std::size_t>(head.at(behind + 3));
      for (std::size_t d = 0; d < dimensions; ++d)
        size *= static_cast<std::uint8_t>(head.at(behind + 4 + d));
      const std::size_t end = behind + 4 + dimensions + size;
      EXPECT_EQ(head.at(end), 0) << name << " has no description";
      if (step != 0) {
        EXPECT_EQ(behind + step, end + 1) << name;
      }
      all[groups.at(group) + ":" + name] = {type, head.substr(behind + 3, 1 + dimensions + size)};
    }
    if (step == 0) return all;
    at = behind + step;
  }
}

TEST(C3dWriter, TheParametersAreThoseThatReadersAskFor) {
  const C3dRecording recording{{"A", "Wrist"}, 70'000, 120.0, 0.64, C3dNumbers::floats};
  const auto parameters = parameters_in(must(c3d_head(recording)));
  std::vector<std::string> names;
  for (const auto& [name, value] : parameters) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "ANALOG:GEN_SCALE", "ANALOG:RATE", "ANALOG:USED", "FORCE_PLATFORM:USED",
                       "POINT:DATA_START", "POINT:DESCRIPTIONS", "POINT:FRAMES", "POINT:LABELS",
                       "POINT:LONG_FRAMES", "POINT:RATE", "POINT:SCALE", "POINT:UNITS",
                       "POINT:USED", "TRIAL:ACTUAL_END_FIELD", "TRIAL:ACTUAL_START_FIELD"}));
  using Value = std::pair<int, std::string>;
  const auto bytes = [](std::initializer_list<int> all) {
    std::string text;
    for (const int byte : all) text += static_cast<char>(byte);
    return text;
  };
  EXPECT_EQ(parameters.at("POINT:LABELS"), Value(-1, bytes({2, 5, 2}) + "A    Wrist"));
  EXPECT_EQ(parameters.at("POINT:UNITS"), Value(-1, bytes({2, 2, 1}) + "mm"));
  EXPECT_EQ(parameters.at("POINT:USED"), Value(2, bytes({0, 2, 0})));
  EXPECT_EQ(parameters.at("POINT:FRAMES"), Value(2, bytes({0, 0xFF, 0xFF})));
  EXPECT_EQ(parameters.at("TRIAL:ACTUAL_END_FIELD"),
            Value(2, bytes({1, 2, 70'000 % 256, 70'000 / 256 % 256, 1, 0})));
}

TEST(C3dWriter, AFrameHoldsMillimetresAndWhatWasNotSeenHasTheResidualMinusOne) {
  const C3dRecording integers{{"A", "B"}, 1, 100.0, 0.64, C3dNumbers::integers};
  const std::vector<Vec3> p_W{Vec3(0.01, -0.64, 0.0), unseen_marker()};
  std::string bytes;
  append_c3d_frame(bytes, integers, p_W);
  ASSERT_EQ(bytes.size(), 16U);
  EXPECT_EQ(word_at(bytes, 0), 500U);
  EXPECT_EQ(static_cast<std::int16_t>(word_at(bytes, 2)), -32000);
  EXPECT_EQ(word_at(bytes, 4), 0U);
  EXPECT_EQ(word_at(bytes, 6), 0U) << "seen";
  EXPECT_EQ(word_at(bytes, 14), 0xFFFFU) << "-1";
  C3dRecording floats = integers;
  floats.numbers = C3dNumbers::floats;
  bytes.clear();
  append_c3d_frame(bytes, floats, p_W);
  ASSERT_EQ(bytes.size(), 32U);
  EXPECT_EQ(float_at(bytes, 0), 10.0F);
  EXPECT_EQ(float_at(bytes, 4), -640.0F);
  EXPECT_EQ(float_at(bytes, 12), 0.0F);
  EXPECT_EQ(float_at(bytes, 28), -1.0F);
}

TEST(C3dWriter, ManyMarkersAndLongRecordingsAreWhole) {
  const TemporaryFolder folder;
  const std::string many = random_table(folder, 700, 3, 50.0);
  const Recording written = read_back(many);
  must(convert_to_c3d(many, folder.path("many.c3d"), C3dNumbers::floats));
  expect_equal(written, read_back(folder.path("many.c3d")), kSingle_m);
  const std::string lasting = random_table(folder, 1, 66'000, 500.0);
  must(convert_to_c3d(lasting, folder.path("long.c3d"), C3dNumbers::integers));
  EXPECT_EQ(read_back(folder.path("long.c3d")).t_s.size(), 66'000U);
}

TEST(C3dWriter, RowsThatAreMissingBecomeFramesWithoutAMarkerAndOthersNeedAGrid) {
  const TemporaryFolder folder;
  const std::string head = "t_s,A_x_m,A_y_m,A_z_m\n";
  const std::string holes = head + "3.00,1,2,3\n3.01,1,2,3\n3.02,1,2,3\n3.05,1,2,3\n3.06,1,2,3\n";
  must(convert_to_c3d(folder.write("h.csv", holes), folder.path("h.c3d"), C3dNumbers::floats));
  const Recording read = read_back(folder.path("h.c3d"));
  ASSERT_EQ(read.t_s.size(), 7U);
  for (std::size_t row = 0; row < 7; ++row)
    EXPECT_EQ(read.p_W[row][0].allFinite(), row != 3 && row != 4) << row;
  const std::string uneven = head + "0,1,2,3\n0.010,1,2,3\n0.020,1,2,3\n0.0345,1,2,3\n0.05,1,2,3\n";
  const auto refused =
      convert_to_c3d(folder.write("u.csv", uneven), folder.path("u.c3d"), C3dNumbers::floats);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Error::Code::bad_input);
  EXPECT_NE(refused.error().message().find("u.csv: the row at "), std::string::npos)
      << refused.error().message();
  EXPECT_FALSE(
      convert_to_c3d(folder.write("n.csv", head), folder.path("n.c3d"), C3dNumbers::floats));
  EXPECT_FALSE(std::filesystem::exists(folder.path("n.c3d"))) << "nothing half-written";
}

TEST(C3dWriter, LabelsThatDoNotFitAreRefused) {
  const C3dRecording long_label{{std::string(128, 'A')}, 1, 100.0, 1.0, C3dNumbers::floats};
  EXPECT_FALSE(c3d_head(long_label));
  C3dRecording many{{}, 1, 100.0, 1.0, C3dNumbers::floats};
  for (int k = 0; k < 3000; ++k)
    many.markers.push_back("a marker with a name of forty letters " + std::to_string(1000 + k));
  EXPECT_TRUE(c3d_head(many)) << "126 kB";
  for (std::string& marker : many.markers) marker += "-left";
  EXPECT_FALSE(c3d_head(many));
}

TEST(C3dWriter, NobodyIsNamed) {
  const TemporaryFolder folder;
  const std::string trc =
      "PathFileType\t4\t(X/Y/Z)\tC:\\Jane Doe\\2026-03-04.trc\n"
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\n"
      "100\t100\t2\t1\tmm\t100\nFrame#\tTime\tJaneDoe:A\t\t\n\t\tX1\tY1\tZ1\n\n"
      "1\t0.00\t1\t2\t3\n2\t0.01\t1\t2\t3\n";
  const std::string out = folder.path("secret_name.c3d");
  must(convert_to_c3d(folder.write("Jane.trc", trc), out, C3dNumbers::floats));
  const std::string bytes = test::read_file(out);
  EXPECT_GT(bytes.size(), 512U);
  test::AtLeast words(4);
  for (const char* word : {"Jane", "Doe", "2026", "secret"}) {
    ++words;
    EXPECT_EQ(bytes.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(read_back(out).markers, std::vector<std::string>{"A"});
}

}  // namespace
}  // namespace isograsp::c3d_writer_test
