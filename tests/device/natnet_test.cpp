// SPDX-License-Identifier: GPL-3.0-or-later
// The NatNet stream of Motive, in every version, against the emulator's own layouts.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/random.hpp"
#include "device/bus/datagram_log.hpp"
#include "device/emulator/emulated_natnet.hpp"
#include "device/markers/little_endian.hpp"
#include "device/markers/natnet_codec.hpp"
#include "device/markers/natnet_log.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::natnet_test {
namespace {

using test::must;
using test::TemporaryFolder;
using Bytes = std::vector<std::uint8_t>;
using Step = NatNetStream::Step;

const std::vector<std::string> kLabels{"F1", "F2", "EL"};
const std::vector<Vec3> kSeen{{0.1, -0.2, 1.0 / 3.0}, {1.5, 0.25, -0.75}, {7.0, 8.0, 9.0}};
const std::vector<NatNetVersion> kVersions{{2, 5},  {2, 6}, {2, 7}, {2, 9}, {2, 10}, {2, 11},
                                           {2, 12}, {3, 0}, {3, 1}, {4, 0}, {4, 1}};

EmulatedNatNet motive(NatNetVersion version) {
  return EmulatedNatNet({version, 1511, 0});
}
Bytes answer(const EmulatedNatNet& motive, std::uint16_t kind, std::string_view text = "",
             const std::vector<std::string>& labels = kLabels) {
  Bytes request(kLongestNatNetRequest);
  request.resize(encode_natnet_request(kind, text, request));
  bool stays = false;
  return motive.answer(request, labels, 120.0, stays);
}
Bytes frame(const EmulatedNatNet& motive, std::uint32_t number, double stamp_s,
            const std::vector<Vec3>& p_W = kSeen) {
  return motive.frame({number, stamp_s, stamp_s, true, p_W});
}
/// A stream that knows server and labels.
NatNetStream greeted(const EmulatedNatNet& motive) {
  NatNetStream stream;
  NatNetStream::Row row;
  EXPECT_EQ(stream.take(answer(motive, NatNetMessage::kConnect), row), Step::server);
  EXPECT_EQ(stream.take(answer(motive, NatNetMessage::kAskModels), row), Step::labels);
  return stream;
}
Vec3 on_wire(const Vec3& p) {
  const auto rounded = [](double value) {
    // At -O3 GCC 12 leaves out a cast there and back.
    const volatile float number = static_cast<float>(value);
    return static_cast<double>(number);
  };
  return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
}

TEST(NatNet, EveryVersionGivesTheSameMarkersToTheLastBit) {
  for (const NatNetVersion version : kVersions) {
    const auto server = motive(version);
    NatNetStream stream = greeted(server);
    EXPECT_EQ(*stream.version(), version);
    EXPECT_EQ(stream.labels(), kLabels) << version.text();
    EXPECT_EQ(stream.data_port().has_value(), version.at_least(3, 0));
    NatNetStream::Row row;
    EXPECT_EQ(stream.take(answer(server, NatNetMessage::kRequest, "FrameRate"), row), Step::rate);
    EXPECT_EQ(stream.rate_Hz(), 120.0);
    ASSERT_EQ(stream.take(frame(server, 17, 2.5), row), Step::row) << version.text();
    EXPECT_EQ(row.frame, 17);
    EXPECT_EQ(row.stamp_s, 2.5);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(row.p_W[k], on_wire(kSeen[k]));
    EXPECT_EQ(stream.counts().damaged, 0U);
  }
}

TEST(NatNet, WhatWasNotSeenIsMissingHoweverItIsSent) {
  for (const NatNetVersion version : kVersions) {
    const auto server = motive(version);
    NatNetStream stream = greeted(server);
    NatNetStream::Row row;
    auto lost = kSeen;
    lost[1] = Vec3::Constant(std::nan(""));  // the origin on the wire
    ASSERT_EQ(stream.take(frame(server, 1, 0.0, lost), row), Step::row);
    EXPECT_TRUE(row.p_W[1].array().isNaN().all());
    EXPECT_EQ(row.p_W[0], on_wire(kSeen[0]));
  }
}

/// Where a list of the frame begins: behind the number and, for the labelled markers, what is
/// before them. The first byte of a float that stands there, searched from the end.
std::size_t last_place_of(const Bytes& bytes, float value) {
  Bytes wanted(4);
  put_little_endian(std::span(wanted), 0, std::bit_cast<std::uint32_t>(value));
  const auto at = std::find_end(bytes.begin(), bytes.end(), wanted.begin(), wanted.end());
  return static_cast<std::size_t>(at - bytes.begin());
}

TEST(NatNet, AMarkerThatWasComputedAndNotSeenIsMissing) {
  const auto server = motive({4, 1});
  NatNetStream stream = greeted(server);
  NatNetStream::Row row;
  Bytes bytes = frame(server, 1, 0.0);
  // The labelled marker EL: x y z size flags.
  const std::size_t x = last_place_of(bytes, 7.0F);
  put_little_endian(std::span(bytes), x + 16, std::uint16_t{1});
  ASSERT_EQ(stream.take(bytes, row), Step::row);
  EXPECT_TRUE(row.p_W[2].array().isNaN().all()) << "though its set holds a position";
  EXPECT_EQ(row.p_W[0], on_wire(kSeen[0]));
}

TEST(NatNet, CountsThatTheBytesCannotHoldAreNotBelieved) {
  constexpr auto kAbsurd = static_cast<std::uint32_t>(-1'097'420'973);
  const std::size_t first_list = 8;
  {  // Sizes are told: they count.
    const auto server = motive({4, 1});
    NatNetStream stream = greeted(server);
    NatNetStream::Row row;
    Bytes bytes = frame(server, 1, 0.0);
    put_little_endian(std::span(bytes), first_list, kAbsurd);
    ASSERT_EQ(stream.take(bytes, row), Step::row);
    EXPECT_EQ(row.p_W[2], on_wire(kSeen[2]));
  }
  {
    const auto server = motive({3, 1});
    NatNetStream stream = greeted(server);
    NatNetStream::Row row;
    Bytes bytes = frame(server, 1, 0.0);
    put_little_endian(std::span(bytes), first_list, kAbsurd);
    EXPECT_EQ(stream.take(bytes, row), Step::nothing);
    EXPECT_EQ(stream.counts().damaged, 1U);
  }
}

TEST(NatNet, NoFrameIsGivenWithoutServerAndLabels) {
  const auto server = motive({4, 0});
  NatNetStream stream;
  NatNetStream::Row row;
  EXPECT_EQ(stream.take(frame(server, 1, 0.0), row), Step::nothing);
  EXPECT_EQ(stream.take(answer(server, NatNetMessage::kConnect), row), Step::server);
  EXPECT_EQ(stream.take(frame(server, 2, 0.0), row), Step::nothing);
  EXPECT_EQ(stream.counts().unlabelled, 2U);
  EXPECT_EQ(stream.take(answer(server, NatNetMessage::kAskModels), row), Step::labels);
  EXPECT_EQ(stream.take(frame(server, 3, 0.0, {{1, 1, 1}}), row), Step::nothing) << "other markers";
  EXPECT_EQ(stream.counts().unlabelled, 3U);
}

TEST(NatNet, OtherLabelsGiveNoFrameUntilTheFirstOnesComeAgain) {
  const auto server = motive({4, 1});
  NatNetStream stream = greeted(server);
  NatNetStream::Row row;
  EXPECT_EQ(stream.take(answer(server, NatNetMessage::kAskModels, "", {"X", "F2", "EL"}), row),
            Step::other_labels);
  EXPECT_EQ(stream.take(frame(server, 1, 0.0), row), Step::nothing);
  EXPECT_EQ(stream.take(answer(server, NatNetMessage::kAskModels), row), Step::labels);
  EXPECT_EQ(stream.take(frame(server, 2, 0.0), row), Step::row);
}

TEST(NatNet, VersionsThatAreNotKnownAreSaid) {
  for (const NatNetVersion version : {NatNetVersion{2, 4}, {4, 2}, {5, 0}}) {
    NatNetStream stream;
    NatNetStream::Row row;
    EXPECT_EQ(stream.take(answer(motive(version), NatNetMessage::kConnect), row),
              Step::unknown_version);
    EXPECT_EQ(*stream.version(), version);
  }
}

TEST(NatNet, RowsAllocateNothing) {
  const auto server = motive({4, 1});
  NatNetStream stream = greeted(server);
  NatNetStream::Row row;
  const Bytes models = answer(server, NatNetMessage::kAskModels);
  const Bytes bytes = frame(server, 1, 0.0);
  const auto before = test::allocations();
  EXPECT_EQ(stream.take(bytes, row), Step::row);
  EXPECT_EQ(stream.take(models, row), Step::labels);
  EXPECT_EQ(test::allocations(), before);
}

TEST(NatNet, DamagedDatagramsNeverReadBeyondTheirEnd) {
  Random random(3);
  for (const NatNetVersion version : kVersions) {
    const auto server = motive(version);
    const Bytes messages[] = {answer(server, NatNetMessage::kConnect),
                              answer(server, NatNetMessage::kAskModels), frame(server, 1, 0.0)};
    std::uint64_t whole = 0;
    for (int i = 0; i < 1500; ++i) {
      NatNetStream stream = greeted(server);
      NatNetStream::Row row;
      for (const Bytes& message : messages) {
        Bytes bytes = message;
        for (int k = 0; k < 2; ++k)
          bytes[static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()))] =
              static_cast<std::uint8_t>(256.0 * random.uniform());
        if (i % 2 == 0) {  // cut off; the vector has no byte more
          bytes.resize(
              static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size())));
          bytes.shrink_to_fit();
          if (bytes.size() >= 4)
            put_little_endian(std::span(bytes), 2, static_cast<std::uint16_t>(bytes.size() - 4));
        }
        static_cast<void>(stream.take(bytes, row));
      }
      whole += stream.counts().frames;
    }
    EXPECT_GT(whole, 0U);
  }
}

// ------------------------------------------------------------------------------------ models

Bytes models_of(const std::vector<std::pair<std::string, std::vector<std::string>>>& sets) {
  Bytes body(4);
  put_little_endian(std::span(body), 0, static_cast<std::uint32_t>(sets.size()));
  const auto number = [&](std::size_t value) {
    body.resize(body.size() + 4);
    put_little_endian(std::span(body), body.size() - 4, static_cast<std::uint32_t>(value));
  };
  const auto text = [&](const std::string& value) {
    body.insert(body.end(), value.begin(), value.end());
    body.push_back(0);
  };
  for (const auto& [name, markers] : sets) {
    number(0);
    text(name);
    number(markers.size());
    for (const auto& marker : markers) text(marker);
  }
  return body;
}

TEST(NatNetModels, MarkersOfTwoSetsThatAreCalledAlikeGetTheNameOfTheirSet) {
  const auto models = parse_natnet_models(models_of({{"all", {"Marker1", "Marker1", "Tip"}},
                                                     {"Hand", {"Marker1", "person:Tip"}},
                                                     {"Object", {"Marker1", ""}}}),
                                          {3, 1});
  ASSERT_TRUE(models);
  EXPECT_EQ(models->labels,
            (std::vector<std::string>{"Hand_Marker1", "Tip", "Object_Marker1", "Object_2"}));
  const auto alone = parse_natnet_models(models_of({{"all", {"A", "B"}}}), {3, 1});
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->labels, (std::vector<std::string>{"A", "B"}));
}

TEST(NatNetModels, AreNothingWhereTheyAreCutOffOrTooMany) {
  const Bytes body = models_of({{"Hand", {"A", "B"}}});
  for (std::size_t size = 0; size < body.size(); ++size)
    EXPECT_FALSE(parse_natnet_models(std::span(body).first(size), {3, 1})) << size;
  EXPECT_FALSE(
      parse_natnet_models(models_of({{"Hand", std::vector<std::string>(3001, "A")}}), {3, 1}));
}

// --------------------------------------------------------------------------------------- log

TEST(NatNetLog, BecomesATableOfMarkers) {
  const TemporaryFolder folder;
  const auto server = motive({4, 1});
  const Endpoint at{0xC0000201, 1510}, data{0xC0000201, 54321}, other{0xC0000202, 1511};
  std::string log;
  const auto add = [&](const Endpoint& from, const Bytes& bytes) {
    log += format_datagram_line(std::chrono::seconds(1'700'000'000), from, bytes) + "\n";
  };
  add(at, answer(server, NatNetMessage::kConnect));
  add(at, answer(server, NatNetMessage::kAskModels));
  auto lost = kSeen;
  lost[0] = Vec3::Constant(std::nan(""));
  add(data, frame(server, 10, 3.0));
  add(other, frame(server, 11, 3.01));
  add(data, frame(server, 12, 3.02, lost));
  add(data, frame(server, 12, 3.02, lost));
  add(data, {7, 0, 200, 0, 1});
  const auto counts = must(convert_natnet_log(folder.write("a.log", log), folder.path("o.csv")));
  EXPECT_EQ(counts.rows, 2U);
  EXPECT_EQ(counts.repeated, 1U);
  EXPECT_EQ(counts.stream.damaged, 1U);
  auto table = must(CsvReader::open(folder.path("o.csv")));
  EXPECT_EQ(table.columns().size(), 10U);
  std::vector<double> row(10);
  ASSERT_TRUE(must(table.next(row)));
  EXPECT_EQ(row[0], 0.0);
  EXPECT_EQ(row[1], on_wire(kSeen[0]).x());
  ASSERT_TRUE(must(table.next(row)));
  EXPECT_EQ(row[0], 3.02 - 3.0);
  EXPECT_TRUE(std::isnan(row[1]));
  EXPECT_FALSE(must(table.next(row)));
}

TEST(NatNetLog, OfAnUnknownVersionOrWithoutMarkersLeavesNoFile) {
  const TemporaryFolder folder;
  const auto problem = [&](NatNetVersion version) {
    const auto log = folder.write(
        "a.log", format_datagram_line(std::chrono::seconds(1), {1, 1510},
                                      answer(motive(version), NatNetMessage::kConnect)) +
                     "\n");
    const auto converted = convert_natnet_log(log, folder.path("o.csv"));
    return converted ? std::string() : converted.error().message();
  };
  EXPECT_NE(problem({4, 2}).find("NatNet 4.2, which is not known"), std::string::npos);
  EXPECT_NE(problem({4, 1}).find("holds no frame of labelled markers"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path("o.csv")));
}

}  // namespace
}  // namespace isograsp::natnet_test
