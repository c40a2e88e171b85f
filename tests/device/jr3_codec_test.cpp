// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/jr3_codec.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/candump_log.hpp"
#include "device/protocol/jr3_decoder.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::jr3_codec_test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kNode = 1;
constexpr Jr3Calibration kPaper{{150, 150, 300}, {80, 80, 80}};
constexpr double kPrinted = 0.51e-6;  // half of the last digit of the worked examples
constexpr double kExact = 0.0;

BusFrame frame(const std::string& text) {
  const auto entry = parse_candump_line("(1700000000.000000) can0 " + text);
  return entry.value()->frame;
}

TEST(Jr3Codec, RoundTripsEveryCountOfEveryAxisAndEveryNumber) {
  Jr3Pairing pairing;
  Timestamp t = 1s;
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (int value = INT16_MIN; value <= INT16_MAX; ++value, t += 10ms) {
      Jr3Reading reading;
      reading.number = static_cast<std::uint16_t>(value);
      reading.raw = {1, -2, 3, -4, 5, -6};
      reading.raw[axis] = value;
      const auto frames = jr3_reading_frames(kNode, reading);
      ASSERT_FALSE(pairing.push(frames[0], t).has_value());
      const auto back = pairing.push(frames[1], t + 130us);
      ASSERT_TRUE(back.has_value());
      ASSERT_EQ(back->reading, reading);
      ASSERT_EQ(back->stamp, t + 130us);
    }
  EXPECT_EQ(pairing.torn() + pairing.duplicate(), 0u);
}

struct Example {
  const char* force;
  const char* moment;
  Vec3 force_N;
  Vec3 moment_Nm;
  int number;
  double tolerance;
};

TEST(Jr3Codec, DecodesTheWorkedExamples) {
  const std::vector<Example> examples{
      {"601#0000000000000100", "681#0000000000000100", Vec3::Zero(), Vec3::Zero(), 1, kExact},
      {"601#4405A7FDC2F5A1A1",
       "681#FD0000FA5300A1A1",
       {12.34131, -5.50232, -48.01025},
       {0.123535, -0.75, 0.040527},
       41377,
       10 * kPrinted},
      {"601#004000C000C0FFFF",
       "681#004000C00020FFFF",
       {150, -150, -300},
       {8, -8, 4},
       65535,
       kExact}};
  for (const auto& e : examples) {
    Jr3Pairing pairing;
    EXPECT_FALSE(pairing.push(frame(e.force), 1s).has_value());
    const auto back = pairing.push(frame(e.moment), 1s + 130us);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->reading.number, e.number);
    EXPECT_FALSE(back->reading.saturated());
    const Wrench wrench = wrench_of(back->reading, kPaper);
    EXPECT_LE((wrench.force - e.force_N).cwiseAbs().maxCoeff(), e.tolerance) << e.force;
    EXPECT_LE((wrench.torque - e.moment_Nm).cwiseAbs().maxCoeff(), e.tolerance) << e.force;
    const auto frames = jr3_reading_frames(kNode, back->reading);
    EXPECT_EQ(frames[0], frame(e.force));
    EXPECT_EQ(frames[1], frame(e.moment));
  }
}

TEST(Jr3Codec, OneCountIsTheFullScaleOver16384) {
  const Vec6 units = kPaper.units_per_count();
  EXPECT_EQ(units, (Vec6() << 150.0 / 16384, 150.0 / 16384, 300.0 / 16384, 8.0 / 16384, 8.0 / 16384,
                    8.0 / 16384)
                       .finished());
}

TEST(Jr3Codec, OnlyTheEndsOfTheNumbersAreSaturated) {
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const int value : {-32768, -32767, -16385, -16384, 0, 16384, 16385, 32766, 32767}) {
      Jr3Reading reading;
      reading.raw[axis] = value;
      EXPECT_EQ(reading.saturated(), value == -32768 || value == 32767) << value;
    }
}

TEST(Jr3Codec, EncodesTheRequestsAndAnswersOfTheExamples) {
  EXPECT_EQ(jr3_cutoff(31.25), 3125);
  EXPECT_EQ(jr3_cutoff(0.0), 0);
  EXPECT_EQ(jr3_cutoff(655.35), 65535);
  EXPECT_FALSE(jr3_cutoff(655.36).has_value());
  EXPECT_FALSE(jr3_cutoff(-0.01).has_value());
  EXPECT_FALSE(jr3_cutoff(std::nan("")).has_value());
  EXPECT_EQ(jr3_start_async(kNode, 3125, 10'000), frame("201#350C10270000"));
  EXPECT_EQ(jr3_start_async(kNode, 200, 10'000), frame("201#C80010270000"));
  EXPECT_EQ(jr3_start_sync(kNode, 3125), frame("181#350C"));
  EXPECT_EQ(jr3_set_filter(kNode, 3125), frame("381#350C"));
  EXPECT_EQ(jr3_sync(), frame("080#"));
  EXPECT_TRUE(is_jr3_sync(frame("080#")));
  EXPECT_FALSE(is_jr3_sync(frame("00000080#")));
  EXPECT_EQ(jr3_request(kNode, Jr3Opcode::force_scales), frame("481#"));
  EXPECT_EQ(jr3_request(kNode, Jr3Opcode::moment_scales), frame("501#"));
  EXPECT_EQ(jr3_request(127, Jr3Opcode::stop), frame("2FF#"));
  EXPECT_EQ(jr3_request(kNode, Jr3Opcode::boot_up), frame("701#"));

  EXPECT_EQ(jr3_acknowledge(kNode, {}), frame("101#00"));
  EXPECT_EQ(jr3_acknowledge(kNode, {true, kPaper.force_N}), frame("101#00960096002C01"));
  EXPECT_EQ(jr3_acknowledge(kNode, {true, kPaper.moment_dNm}), frame("101#00500050005000"));
  EXPECT_EQ(jr3_acknowledge_of(frame("101#00960096002C01")).scales, kPaper.force_N);
  EXPECT_EQ(jr3_acknowledge_of(frame("101#00500050005000")).scales, kPaper.moment_dNm);
  EXPECT_TRUE(jr3_acknowledge_of(frame("101#00")).ready);
  EXPECT_FALSE(jr3_acknowledge_of(frame("101#01")).ready);
  EXPECT_FALSE(jr3_acknowledge_of(frame("101#00")).scales.has_value());
}

TEST(Jr3Codec, KnowsEveryWordByIdentifierAndLength) {
  struct Word {
    std::uint32_t opcode;
    std::vector<int> lengths;
    Jr3Word word;
  };
  const std::vector<Word> words{{0x100, {1, 7}, Jr3Word::answer}, {0x180, {2}, Jr3Word::request},
                                {0x200, {6}, Jr3Word::request},   {0x280, {0}, Jr3Word::request},
                                {0x300, {0}, Jr3Word::request},   {0x380, {2}, Jr3Word::request},
                                {0x400, {0}, Jr3Word::request},   {0x480, {0}, Jr3Word::request},
                                {0x500, {0}, Jr3Word::request},   {0x580, {0}, Jr3Word::request},
                                {0x600, {8}, Jr3Word::answer},    {0x680, {8}, Jr3Word::answer},
                                {0x700, {0}, Jr3Word::answer},    {0x780, {4}, Jr3Word::request}};
  for (const auto& word : words)
    for (int length = 0; length <= 8; ++length)
      for (const std::uint32_t node : {1U, 3U, 127U}) {
        BusFrame f;
        f.id = word.opcode + node;
        f.length = static_cast<std::uint8_t>(length);
        EXPECT_TRUE(jr3_owns(static_cast<std::uint8_t>(node), f));
        const bool good =
            std::find(word.lengths.begin(), word.lengths.end(), length) != word.lengths.end();
        EXPECT_EQ(jr3_word(f), good ? word.word : Jr3Word::foreign) << f.id << " " << length;
        f.extended = true;
        EXPECT_EQ(jr3_word(f), Jr3Word::foreign);
      }
  EXPECT_FALSE(jr3_owns(1, frame("081#")));
  EXPECT_FALSE(jr3_owns(1, frame("602#0000000000000100")));
  EXPECT_FALSE(jr3_owns(1, frame("00000E01#0000000000000100")));
}

// ---- pairing

struct Event {
  BusFrame frame;
  Timestamp stamp;
};

Jr3Reading numbered(int k) {
  Jr3Reading reading;
  reading.number = static_cast<std::uint16_t>(65535 - 160 + 80 * k);  // wraps after two samples
  for (int i = 0; i < 6; ++i) reading.raw[static_cast<std::size_t>(i)] = 100 * k + i;
  return reading;
}

std::vector<Event> train() {
  std::vector<Event> events;
  for (int k = 0; k < 5; ++k) {
    const auto frames = jr3_reading_frames(kNode, numbered(k));
    events.push_back({frames[0], 1s + k * 10ms});
    events.push_back({frames[1], 1s + k * 10ms + 130us});
  }
  return events;
}

std::size_t play(const std::vector<Event>& events) {
  Jr3Pairing pairing;
  std::vector<int> came;
  for (const auto& [f, stamp] : test::every(events)) {
    const auto reading = pairing.push(f, stamp);
    if (!reading) continue;
    const int k = reading->reading.raw[0] / 100;
    EXPECT_EQ(reading->reading, numbered(k)) << "halves of two samples";
    EXPECT_EQ(std::count(came.begin(), came.end(), k), 0) << "twice";
    came.push_back(k);
  }
  pairing.forget();
  EXPECT_EQ(2 * came.size() + pairing.torn() + pairing.duplicate(), events.size())
      << "a half is unaccounted";
  return came.size();
}

TEST(Jr3Pairing, NoTwoLossesMixSamplesOrCostMoreThanTwo) {
  EXPECT_EQ(play(train()), 5u);
  for (std::size_t a = 0; a < 10; ++a) {
    auto events = train();
    events.erase(events.begin() + static_cast<std::ptrdiff_t>(a));
    EXPECT_EQ(play(events), 4u);
    for (std::size_t b = 0; b < a; ++b) {
      auto two = events;
      two.erase(two.begin() + static_cast<std::ptrdiff_t>(b));
      EXPECT_EQ(play(two), a / 2 == b / 2 ? 4u : 3u);
    }
  }
}

TEST(Jr3Pairing, AFrameThatComesTwiceWithinItsSampleMakesNoSecondSample) {
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t place = i + 1; place <= (i / 2 + 1) * 2; ++place) {
      auto events = train();
      events.insert(events.begin() + static_cast<std::ptrdiff_t>(place),
                    {events[i].frame, events[place - 1].stamp + 50us});
      EXPECT_EQ(play(events), 5u) << i << place;
    }
}

TEST(Jr3Pairing, AFrameMovedByUpToTwoSamplesCostsNothingAndElsewhereMixesNothing) {
  for (std::size_t from = 0; from < 10; ++from)
    for (std::size_t to = 0; to < 10; ++to) {
      const auto whole = train();
      std::vector<BusFrame> frames;
      for (const auto& event : whole) frames.push_back(event.frame);
      const BusFrame moved = frames[from];
      frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(from));
      frames.insert(frames.begin() + static_cast<std::ptrdiff_t>(to), moved);
      auto events = whole;
      for (std::size_t i = 0; i < 10; ++i) events[i].frame = frames[i];
      const std::size_t distance = from > to ? from - to : to - from;
      EXPECT_GE(play(events), distance <= 4 ? 5u : 4u) << from << " to " << to;
    }
}

TEST(Jr3Pairing, TheOrderOfForceAndMomentDoesNotMatter) {
  auto events = train();
  for (std::size_t i = 0; i < 10; i += 2) std::swap(events[i].frame, events[i + 1].frame);
  EXPECT_EQ(play(events), 5u);
}

TEST(Jr3Pairing, TheSameNumberAfterAWrapIsAnotherSample) {
  const auto frames = jr3_reading_frames(kNode, numbered(0));
  Jr3Pairing pairing;
  EXPECT_FALSE(pairing.push(frames[0], 1s));
  EXPECT_FALSE(pairing.push(frames[1], 1s + 8192ms)) << "half of a sample one round later";
  EXPECT_EQ(pairing.torn(), 1u);
  EXPECT_TRUE(pairing.push(frames[0], 1s + 8193ms));
  EXPECT_FALSE(pairing.push(frames[0], 1s + 16385ms));
  EXPECT_TRUE(pairing.push(frames[1], 1s + 16386ms)) << "a whole sample one round later";
  EXPECT_EQ(pairing.duplicate(), 0u);
}

TEST(Jr3Pairing, OnlyWhatComesAgainAtOnceIsADuplicate) {
  const auto frames = jr3_reading_frames(kNode, numbered(0));
  Jr3Pairing pairing;
  EXPECT_FALSE(pairing.push(frames[0], 1s));
  EXPECT_TRUE(pairing.push(frames[1], 1s));
  EXPECT_FALSE(pairing.push(frames[0], 1s + 2ms));
  EXPECT_FALSE(pairing.push(frames[1], 1s + 2ms));
  EXPECT_EQ(pairing.duplicate(), 2u);
  EXPECT_FALSE(pairing.push(frames[0], 1s + 10ms));
  EXPECT_TRUE(pairing.push(frames[1], 1s + 10ms)) << "the sensor stands still";
}

// ---- decoder of logs

struct Decoded {
  std::vector<Jr3Sample> samples;
  std::optional<Jr3Calibration> learned;
  std::uint64_t uncalibrated;
  std::uint64_t answers;
  std::uint64_t requests;
};

Decoded decode(const std::vector<std::string>& log,
               const std::optional<Jr3Calibration>& known = std::nullopt) {
  Jr3Decoder decoder(kNode, known);
  Decoded out;
  Timestamp t = 1s;
  for (const auto& text : log) {
    t += 1ms;
    const BusFrame f = frame(text);
    if (!decoder.owns(f)) {
      EXPECT_TRUE(is_jr3_sync(f)) << text;
      continue;
    }
    if (const auto sample = decoder.push(f, t)) out.samples.push_back(*sample);
  }
  decoder.finish();
  EXPECT_EQ(decoder.foreign() + decoder.torn() + decoder.duplicate(), 0u);
  out.learned = decoder.learned();
  out.uncalibrated = decoder.uncalibrated();
  out.answers = decoder.answers();
  out.requests = decoder.requests();
  return out;
}

const std::vector<std::string> kSample{"601#4405A7FDC2F5A1A1", "681#FD0000FA5300A1A1"};

TEST(Jr3Decoder, LearnsTheFullScalesFromTheLogEvenAfterTheSamples) {
  // The order that the adaptor's own host has: start, then the full scales.
  const std::vector<std::string> log{"401#",
                                     "101#00",
                                     "181#350C",
                                     "101#00",
                                     "080#",
                                     kSample[0],
                                     kSample[1],
                                     "481#",
                                     "101#00960096002C01",
                                     "501#",
                                     "101#00500050005000"};
  const auto first = decode(log);
  EXPECT_TRUE(first.samples.empty()) << "nothing is invented";
  EXPECT_EQ(first.uncalibrated, 1u);
  EXPECT_EQ(first.learned, kPaper);
  EXPECT_EQ(first.answers, 4u);
  EXPECT_EQ(first.requests, 4u);
  const auto second = decode(log, first.learned);
  ASSERT_EQ(second.samples.size(), 1u);
  EXPECT_TRUE(second.samples[0].valid);
  EXPECT_WITHIN(second.samples[0].wrench_S.force.x(), 12.34131, 10 * kPrinted);
  EXPECT_WITHIN(second.samples[0].wrench_S.torque.z(), 0.040527, kPrinted);
}

TEST(Jr3Decoder, TellsFullScalesOfForceAndMomentByTheRequest) {
  const auto moment_first =
      decode({"501#", "101#00500050005000", "481#", "101#00960096002C01", kSample[0], kSample[1]});
  EXPECT_EQ(moment_first.learned, kPaper);
  EXPECT_EQ(moment_first.samples.size(), 1u);
  const auto without_requests =
      decode({"101#00", "101#00960096002C01", "101#00500050005000", kSample[0], kSample[1]});
  EXPECT_EQ(without_requests.learned, kPaper);
  EXPECT_EQ(without_requests.samples.size(), 1u);
}

TEST(Jr3Decoder, FullScalesOfZeroAreNone) {
  const auto decoded =
      decode({"481#", "101#00960096000000", "501#", "101#00500050005000", kSample[0], kSample[1]});
  EXPECT_FALSE(decoded.learned.has_value());
  EXPECT_EQ(decoded.uncalibrated, 1u);
}

TEST(Jr3Decoder, AClippedAxisIsNotValid) {
  Jr3Decoder decoder(kNode, kPaper);
  EXPECT_FALSE(decoder.push(frame("601#FF7F000000000100"), 1s).has_value());
  const auto sample = decoder.push(frame("681#0000000000000100"), 1s);
  ASSERT_TRUE(sample.has_value());
  EXPECT_FALSE(sample->valid);
}

TEST(Jr3Decoder, ABootUpTearsWhatWaits) {
  Jr3Decoder decoder(kNode, kPaper);
  EXPECT_FALSE(decoder.push(frame(kSample[0]), 1s).has_value());
  EXPECT_FALSE(decoder.push(frame("701#"), 1s).has_value());
  EXPECT_FALSE(decoder.push(frame(kSample[1]), 1s).has_value());
  EXPECT_FALSE(decoder.push(frame("00000601#0000000000000100"), 1s).has_value());
  decoder.finish();
  EXPECT_EQ(decoder.torn(), 2u);
  EXPECT_EQ(decoder.foreign(), 1u);
}

}  // namespace
}  // namespace isograsp::jr3_codec_test
