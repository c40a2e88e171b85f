// SPDX-License-Identifier: GPL-3.0-or-later
// The stream of Qualisys Track Manager.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/random.hpp"
#include "device/markers/marker_reader.hpp"
#include "device/markers/qtm_rt_codec.hpp"
#include "device/markers/qtm_rt_log.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::qtm_rt_test {
namespace {

using test::must;
using test::TemporaryFolder;

std::string data_file(const std::string& name) {
  return std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/isotonic/" + name;
}

using Bytes = std::vector<std::uint8_t>;

void put(Bytes& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}
Bytes packet(std::uint32_t type, const Bytes& body) {
  Bytes bytes;
  put(bytes, 8 + body.size(), 4);
  put(bytes, type, 4);
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}
Bytes labels(const std::vector<std::string>& names) {
  std::string xml = "<QTM_Parameters_Ver_1.23><The_3D>";
  for (const auto& name : names) xml += "<Label><Name>" + name + "</Name></Label>";
  xml += "</The_3D></QTM_Parameters_Ver_1.23>";
  Bytes body(xml.begin(), xml.end());
  body.push_back(0);
  return packet(2, body);
}
struct Sent {
  float x, y, z, residual;
};
/// A frame with an unknown component in front of the markers.
Bytes frame(std::uint32_t number, const std::vector<Sent>& sent, bool with_residual) {
  Bytes body;
  put(body, 1'000'000 + 10'000 * std::uint64_t{number}, 8);
  put(body, number, 4);
  put(body, 2, 4);
  put(body, 12, 4);
  put(body, 77, 4);
  put(body, 0, 4);
  put(body, 16 + sent.size() * (with_residual ? 16 : 12), 4);
  put(body, with_residual ? 9 : 1, 4);
  put(body, sent.size(), 4);
  put(body, 0, 4);
  for (const Sent& one : sent) {
    for (const float value : {one.x, one.y, one.z})
      put(body, std::bit_cast<std::uint32_t>(value), 4);
    if (with_residual) put(body, std::bit_cast<std::uint32_t>(one.residual), 4);
  }
  return packet(3, body);
}
Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// All numbers of all rows of a stream that comes in pieces of `size` bytes.
std::vector<double> received(const Bytes& bytes, std::size_t size, QtmRtStream& stream) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < bytes.size(); at += size)
    must(stream.take(std::span(bytes).subspan(at, std::min(size, bytes.size() - at)),
                     [&numbers](const QtmRtStream::Row& row) {
                       numbers.push_back(static_cast<double>(row.stamp_us));
                       for (const Vec3& p : row.p_W)
                         for (const double c : p) numbers.push_back(std::isnan(c) ? -1e9 : c);
                     }));
  return numbers;
}
std::vector<double> received(const Bytes& bytes, std::size_t size) {
  QtmRtStream stream;
  return received(bytes, size, stream);
}

TEST(QtmRt, ALogThatTcpHasCutAndMergedGivesTheReference) {
  const TemporaryFolder folder;
  const auto counts = must(convert_qtm_rt_log(data_file("qtm_a.log"), folder.path("o.csv")));
  auto got = must(CsvReader::open(folder.path("o.csv")));
  auto expected = must(CsvReader::open(data_file("qtm_a_expected.csv")));
  ASSERT_EQ(got.columns(), expected.columns());
  std::vector<double> one(got.columns().size()), other(one.size());
  constexpr double kSame = 1e-12;  // m and s, of single floats
  std::size_t rows = 0;
  while (must(expected.next(other))) {
    ASSERT_TRUE(must(got.next(one)));
    ++rows;
    for (std::size_t c = 0; c < one.size(); ++c) {
      ASSERT_EQ(std::isnan(one[c]), std::isnan(other[c])) << rows << " " << got.columns()[c];
      if (!std::isnan(one[c])) {
        EXPECT_WITHIN(one[c], other[c], kSame);
      }
    }
  }
  EXPECT_FALSE(must(got.next(one)));
  EXPECT_EQ(counts.frames, rows);
  EXPECT_GT(counts.repeated, 0U);
  EXPECT_GT(counts.passed_over, 0U);
}

TEST(QtmRt, WhereTheStreamIsCutDoesNotCount) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Bytes bytes = joined({packet(1, {'Q', 'T', 'M', 0}), labels({"A", "B"}),
                              frame(1, {{1, 2, 3, 0}, {nan, nan, nan, nan}}, true),
                              packet(9, {1, 2, 3}), frame(2, {{4, 5, 6, 0}, {7, 8, 9, 0}}, false)});
  const auto whole = received(bytes, bytes.size());
  ASSERT_EQ(whole.size(), 14U);
  EXPECT_EQ(whole[1], 1e-3 * 1.0);
  EXPECT_EQ(whole[4], -1e9) << "not seen";
  for (std::size_t size = 1; size < bytes.size(); ++size) EXPECT_EQ(received(bytes, size), whole);
}

TEST(QtmRt, WhatWasNotSeenIsMissingHoweverItIsSent) {
  const Bytes bytes = joined({labels({"A", "B"}), frame(1, {{1, 2, 3, -1}, {0, 0, 0, 0}}, true)});
  const auto numbers = received(bytes, bytes.size());
  ASSERT_EQ(numbers.size(), 7U);
  for (std::size_t i = 1; i < 7; ++i) EXPECT_EQ(numbers[i], -1e9);
}

TEST(QtmRt, FramesWithoutLabelsOrOfAnotherNumberAreCountedAndLeftOut) {
  QtmRtStream stream;
  const Bytes bytes = joined({frame(1, {{1, 2, 3, 0}}, false), labels({"A"}),
                              frame(2, {{1, 2, 3, 0}, {1, 2, 3, 0}}, false),
                              frame(3, {{1, 2, 3, 0}}, false), frame(3, {{1, 2, 3, 0}}, false)});
  EXPECT_EQ(received(bytes, 11, stream).size(), 4U);
  EXPECT_EQ(stream.counts().unlabelled, 2U);
  EXPECT_EQ(stream.counts().repeated, 1U);
  EXPECT_EQ(stream.counts().frames, 1U);
}

TEST(QtmRt, StepByStepItSaysWhatEachPacketWas) {
  using Step = QtmRtStream::Step;
  QtmRtStream stream;
  QtmRtStream::Row row;
  stream.add(
      joined({packet(1, {'H', 'i', 0}), packet(0, {'N', 'o', 0}), packet(2, {'<', 'a', '/', '>'}),
              labels({"A", "B"}), frame(9, {{1, 2, 3, 0}, {4, 5, 6, 0}}, true),
              frame(9, {{1, 2, 3, 0}, {4, 5, 6, 0}}, true), labels({"A", "C"}),
              frame(10, {{1, 2, 3, 0}, {4, 5, 6, 0}}, true), labels({"A", "B"}),
              frame(11, {{1, 2, 3, 0}, {4, 5, 6, 0}}, true)}));
  EXPECT_EQ(stream.next(row), Step::message);
  EXPECT_EQ(stream.message(), "Hi");
  EXPECT_EQ(stream.next(row), Step::refusal);
  EXPECT_EQ(stream.message(), "No");
  EXPECT_EQ(stream.next(row), Step::no_labels);
  EXPECT_EQ(stream.next(row), Step::labels);
  EXPECT_EQ(stream.next(row), Step::row);
  EXPECT_EQ(stream.next(row), Step::row) << "who reads live numbers them himself";
  EXPECT_EQ(row.frame, 9U);
  EXPECT_EQ(stream.next(row), Step::other_labels);
  EXPECT_EQ(stream.next(row), Step::labels) << "the frame between them has other markers";
  EXPECT_EQ(stream.next(row), Step::row);
  EXPECT_EQ(row.frame, 11U);
  EXPECT_EQ(stream.next(row), Step::more);
  EXPECT_EQ(stream.labels(), (std::vector<std::string>{"A", "B"}));
}

TEST(QtmRt, ANewConnectionKeepsTheLabelsAndForgetsWhatWaited) {
  using Step = QtmRtStream::Step;
  QtmRtStream stream;
  QtmRtStream::Row row;
  stream.add(joined({labels({"A"}), {1, 2, 3}}));
  EXPECT_EQ(stream.next(row), Step::labels);
  EXPECT_EQ(stream.next(row), Step::more);
  stream.restart();
  stream.add(frame(1, {{1, 2, 3, 0}}, false));
  EXPECT_EQ(stream.next(row), Step::row);
  stream.add(Bytes{9, 0, 0, 0xF0, 0, 0, 0, 0});
  EXPECT_EQ(stream.next(row), Step::lost);
  stream.add(frame(2, {{1, 2, 3, 0}}, false));
  EXPECT_EQ(stream.next(row), Step::lost) << "until it begins anew";
  stream.restart();
  stream.add(frame(3, {{1, 2, 3, 0}}, false));
  EXPECT_EQ(stream.next(row), Step::row);
}

TEST(QtmRt, RowsAllocateNothingHoweverTheyAreCut) {
  QtmRtStream stream;
  QtmRtStream::Row row;
  const Bytes told = labels({"A", "B"});
  stream.add(told);
  EXPECT_EQ(stream.next(row), QtmRtStream::Step::labels);
  const Bytes bytes = frame(1, {{1, 2, 3, 0}, {4, 5, 6, 0}}, true);
  std::size_t rows = 0;
  const auto before = test::allocations();
  for (int round = 0; round < 3000; ++round) {  // more than the room that is kept
    for (std::size_t at = 0; at < bytes.size(); at += 7) {
      stream.add(std::span(bytes).subspan(at, std::min<std::size_t>(7, bytes.size() - at)));
      while (stream.next(row) == QtmRtStream::Step::row) ++rows;
    }
    if (round % 100 != 0) continue;
    stream.add(told);
    static_cast<void>(stream.next(row));
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(rows, 3000U);
}

TEST(QtmRt, AStreamThatHasLostItsWayIsRefused) {
  const auto problem = [](const Bytes& bytes) {
    QtmRtStream stream;
    const auto taken = stream.take(bytes, [](const QtmRtStream::Row&) {});
    return taken ? std::string() : taken.error().message();
  };
  EXPECT_NE(problem({4, 0, 0, 0, 1, 0, 0, 0}).find("no packet begins"), std::string::npos);
  EXPECT_NE(problem({0, 0, 0, 0xC1, 1, 0, 0, 0}).find("no packet begins"), std::string::npos);
  EXPECT_NE(problem(packet(2, {'<', 'a'})).find("broken"), std::string::npos);
  EXPECT_NE(problem(joined({labels({"A"}), labels({"B"})})).find("labels change"),
            std::string::npos);
}

TEST(QtmRt, ParametersThatAreNestedTooDeeplyAreRefusedNotParsed) {
  const auto taken = [](const std::string& xml) {
    QtmRtStream stream;
    const auto done =
        stream.take(packet(2, Bytes(xml.begin(), xml.end())), [](const QtmRtStream::Row&) {});
    return done ? std::string("taken") : done.error().message();
  };
  std::string deep, hidden;
  for (int k = 0; k < 200'000; ++k) {
    deep += "<a b='>'>";
    hidden += "<a><!-- </a> -->";
  }
  EXPECT_NE(taken(deep).find("nested too deeply"), std::string::npos);
  EXPECT_NE(taken(hidden).find("nested too deeply"), std::string::npos);
  std::string wide = "<a>";
  for (int k = 0; k < 1000; ++k) wide += "<b c=\"/>\"/><![CDATA[<d><d>]]><!-- <e> --><f>1</f>";
  EXPECT_EQ(taken(wide + "</a>"), "taken");
}

TEST(QtmRt, DamagedPacketsNeverReadBeyondTheirEnd) {
  const Bytes good = joined({labels({"A", "B"}), frame(1, {{1, 2, 3, 0}, {1, 2, 3, 0}}, true),
                             frame(2, {{1, 2, 3, 0}, {1, 2, 3, 0}}, false)});
  Random random(3);
  std::uint64_t frames = 0;
  for (int i = 0; i < 20'000; ++i) {
    Bytes bytes = good;
    for (int k = 0; k < 3; ++k)
      bytes[static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()))] =
          static_cast<std::uint8_t>(256.0 * random.uniform());
    QtmRtStream stream;
    static_cast<void>(stream.take(bytes, [](const QtmRtStream::Row&) {}));
    frames += stream.counts().frames;
  }
  EXPECT_GT(frames, 0U);
}

TEST(QtmRt, ALogWithoutMarkersLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string log =
      folder.write("a.log", "(1700000000.000000) 192.0.2.1:22223 0c00000001000000514d5400\n");
  const auto converted = convert_qtm_rt_log(log, folder.path("o.csv"));
  ASSERT_FALSE(converted);
  EXPECT_EQ(converted.error().code, Error::Code::bad_input);
  EXPECT_FALSE(std::filesystem::exists(folder.path("o.csv")));
}

}  // namespace
}  // namespace isograsp::qtm_rt_test
