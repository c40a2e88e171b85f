// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/ati_codec.hpp"

#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/candump_log.hpp"
#include "device/emulator/emulated_ati.hpp"
#include "device/protocol/ati_decoder.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::ati_codec_test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint8_t kBase = 0x20;
// Printed with six decimals: half of the last one, and a little for the sum of six products.
constexpr double kPrinted = 0.51e-6;

BusFrame frame(const std::string& text) {
  const auto entry = parse_candump_line("(1700000000.000000) can0 " + text);
  return entry.value()->frame;
}

AtiReading reading_of(const std::string& even, const std::string& odd) {
  AtiPairing pairing;
  EXPECT_FALSE(pairing.push(frame(even), 1s));
  const auto reading = pairing.push(frame(odd), 1s + 500us);
  EXPECT_TRUE(reading.has_value()) << even;
  return reading ? reading->reading : AtiReading{};
}

const Vec6& example_bias() {
  static const Vec6 bias = (Vec6() << 112, -87, 45, 301, -260, 19).finished();
  return bias;
}

struct Row {
  AtiRow values;
  const char* frames[3];
};
const std::vector<Row>& example_rows() {
  static const std::vector<Row> rows{
      {{1250.5F, -310.25F, 95.75F, -16820, -140.5F, 16455.25F},
       {"202#449C5000C39B2000", "203#42BF8000C6836800", "204#C30C800046808E80"}},
      {{-702, 19850.5F, 388.25F, -9702.75F, 512.5F, -9533},
       {"202#C42F8000469B1500", "203#43C22000C6179B00", "204#44002000C614F400"}},
      {{20110.75F, 205.5F, 20455, -88.25F, 20290.5F, 401.75F},
       {"202#469D1D80434D8000", "203#469FCE00C2B08000", "204#469E850043C8E000"}},
      {{-8.5F, 128.75F, -322.5F, -61.25F, 331.75F, -64.5F},
       {"202#C10800004300C000", "203#C3A14000C2750000", "204#43A5E000C2810000"}},
      {{371.25F, 4.5F, -190, 109.75F, -183.25F, -112.5F},
       {"202#43B9A00040900000", "203#C33E000042DB8000", "204#C3374000C2E10000"}},
      {{11.75F, -196.5F, 7.25F, -193.25F, 9.5F, -197.75F},
       {"202#413C0000C3448000", "203#40E80000C3414000", "204#41180000C345C000"}}};
  return rows;
}

TEST(AtiCodec, RoundTripsEveryCountOfEveryGage) {
  AtiPairing pairing;
  Timestamp t = 1s;
  for (std::size_t gage = 0; gage < 6; ++gage)
    for (int value = INT16_MIN; value <= INT16_MAX; ++value, t += 10ms) {
      AtiReading reading;
      reading.status = static_cast<std::uint16_t>(value * 7);
      reading.gages = {1, -2, 3, -4, 5, -6};
      reading.gages[gage] = value;
      const auto frames = ati_reading_frames(kBase, reading);
      ASSERT_EQ(frames[0].length, 8);
      ASSERT_EQ(frames[1].length, 6);
      ASSERT_FALSE(pairing.push(frames[0], t).has_value());
      const auto back = pairing.push(frames[1], t + 400us);
      ASSERT_TRUE(back.has_value());
      ASSERT_EQ(back->reading, reading);
      ASSERT_EQ(back->stamp, t + 400us);
    }
  EXPECT_EQ(pairing.torn() + pairing.duplicate(), 0u);
}

TEST(AtiCodec, CarriesEvenGagesInTheFirstFrameAndOddOnesInTheSecond) {
  const auto reading = reading_of("200#0000FEB4FEB2FE56", "201#FF0D008800BA");
  EXPECT_EQ(reading.gages, (RawCounts{-332, -243, -334, 136, -426, 186}));
  const auto frames = ati_reading_frames(kBase, reading);
  EXPECT_EQ(frames[0], frame("200#0000FEB4FEB2FE56"));
  EXPECT_EQ(frames[1], frame("201#FF0D008800BA"));
}

TEST(AtiCodec, DecodesAndEncodesTheRowsOfTheExample) {
  AtiRowAssembly assembly;
  for (const auto& row : test::every(example_rows())) {
    EXPECT_FALSE(assembly.push(frame(row.frames[0])).has_value());
    EXPECT_FALSE(assembly.push(frame(row.frames[1])).has_value());
    const auto back = assembly.push(frame(row.frames[2]));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(*back, row.values);
    const auto frames = ati_row_frames(kBase, row.values);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(frames[i], frame(row.frames[i]));
  }
}

TEST(AtiCodec, JoinsARowOnlyFromItsThreePartsInOrder) {
  const auto& row = example_rows()[0];
  const std::array parts{frame(row.frames[0]), frame(row.frames[1]), frame(row.frames[2])};
  const std::vector<std::vector<std::size_t>> wrong{
      {1, 2}, {0, 2}, {0, 2, 1}, {2, 1, 0}, {0, 1, 0}};
  for (const auto& order : wrong) {
    AtiRowAssembly assembly;
    for (const auto part : test::every(order)) EXPECT_FALSE(assembly.push(parts[part]).has_value());
  }
  AtiRowAssembly assembly;  // each part twice
  for (const std::size_t part : {0U, 0U, 1U, 1U})
    EXPECT_FALSE(assembly.push(parts[part]).has_value());
  EXPECT_EQ(assembly.push(parts[2]), row.values);
  EXPECT_FALSE(assembly.push(parts[2]).has_value());
}

struct Example {
  const char* even;
  const char* odd;
  Vec3 force_N;
  Vec3 torque_Nm;
  double tolerance;
};

TEST(AtiCodec, ComputesTheWrenchesOfTheExamples) {
  const std::vector<Example> examples{
      {"200#00000070002DFEFC", "201#FFA9012D0013", Vec3::Zero(), Vec3::Zero(), 0.0},
      {"200#000005DC05A0FFD8",
       "201#F7680C1CF8AD",
       {-75.75151, -51.366619, 59.470208},
       {-0.710025, 0.720687, 0.277349},
       kPrinted},
      {"200#0000FEB4FEB2FE56",
       "201#FF0D008800BA",
       {5.003538, -3.008269, -20.000245},
       {0.050181, -0.100004, 0.019974},
       kPrinted}};
  for (const auto& e : examples) {
    const auto reading = reading_of(e.even, e.odd);
    EXPECT_TRUE(reading.valid());
    const Wrench wrench = wrench_of(reading.gages, example_bias(), synthetic_ati_calibration());
    EXPECT_LE((wrench.force - e.force_N).cwiseAbs().maxCoeff(), e.tolerance) << e.even;
    EXPECT_LE((wrench.torque - e.torque_Nm).cwiseAbs().maxCoeff(), e.tolerance) << e.even;
  }
}

TEST(AtiCodec, RefusesThePlausibleLookingValuesOfASaturatedSensor) {
  const auto reading = reading_of("200#80407FFF002DFEFC", "201#8000012D0013");
  EXPECT_EQ(reading.status, 0x8040);
  EXPECT_EQ(reading.gages[0], 32767);
  EXPECT_EQ(reading.gages[1], -32768);
  EXPECT_TRUE(reading.saturated());
  EXPECT_TRUE(reading.critical());
  EXPECT_FALSE(reading.valid());
  const Wrench wrench = wrench_of(reading.gages, example_bias(), synthetic_ati_calibration());
  constexpr double kTwoDecimals = 0.05;
  EXPECT_WITHIN(wrench.force.x(), 50.97, kTwoDecimals);
  EXPECT_WITHIN(wrench.force.y(), -671.7, kTwoDecimals);
  EXPECT_WITHIN(wrench.force.z(), 650.0, kTwoDecimals);
  EXPECT_EQ(ati_flags(reading), "saturated+status_bad_active_calibration+status_any_error");
}

TEST(AtiCodec, OneSaturatedGageMakesEveryReadingInvalid) {
  for (std::size_t gage = 0; gage < 6; ++gage)
    for (const int value : {-32768, -32767, 0, 32766, 32767}) {
      AtiReading reading;
      reading.gages[gage] = value;
      const bool end = value == -32768 || value == 32767;
      EXPECT_EQ(reading.saturated(), end) << gage << " " << value;
      EXPECT_EQ(reading.valid(), !end);
      EXPECT_EQ(ati_flags(reading), end ? "saturated" : "");
    }
}

TEST(AtiCodec, RefusesValuesForExactlyTheCriticalBits) {
  const std::vector<unsigned> critical{1, 2, 3, 4, 5, 6, 7, 11, 12};
  for (unsigned bit = 0; bit < 16; ++bit) {
    AtiReading reading;
    reading.status = static_cast<std::uint16_t>(1U << bit);
    const bool expected = std::find(critical.begin(), critical.end(), bit) != critical.end();
    EXPECT_EQ(reading.critical(), expected) << bit;
    EXPECT_EQ(reading.valid(), !expected) << bit;
  }
  for (unsigned status = 0; status <= 0xFFFF; ++status) {
    AtiReading reading;
    reading.status = static_cast<std::uint16_t>(status);
    bool expected = false;
    for (const unsigned bit : critical) expected |= (status >> bit & 1U) != 0;
    ASSERT_EQ(reading.critical(), expected) << status;
  }
}

TEST(AtiCodec, NamesEveryBitThatHasAName) {
  AtiReading reading;
  reading.status = 0xFFFF;
  EXPECT_EQ(ati_flags(reading),
            "status_watchdog_reset+status_dac_adc_check_too_high+status_dac_adc_check_too_low+"
            "status_artificial_analog_ground_out_of_range+status_supply_too_high+"
            "status_supply_too_low+status_bad_active_calibration+status_eeprom_failure+"
            "status_configuration_invalid+status_temperature_too_high+status_temperature_too_low+"
            "status_can_bus_error+status_any_error");
}

TEST(AtiCodec, TellsRequestsFromAnswersByTheirLengthAlone) {
  struct Lengths {
    int request;
    int answer;
  };
  constexpr int kNone = -1;
  constexpr std::array<Lengths, 16> kLengths{{{0, 8},
                                              {kNone, 6},
                                              {1, 8},
                                              {kNone, 8},
                                              {kNone, 8},
                                              {0, 8},
                                              {1, 1},
                                              {0, 8},
                                              {0, 2},
                                              {1, 2},
                                              {kNone, kNone},
                                              {kNone, kNone},
                                              {0, kNone},
                                              {1, 0},
                                              {1, 0},
                                              {0, 4}}};
  for (std::uint32_t opcode = 0; opcode < 16; ++opcode)
    for (std::uint8_t length = 0; length <= 8; ++length) {
      BusFrame f;
      f.id = 0x200 + opcode;
      f.length = length;
      const auto [request, answer] = kLengths[opcode];
      const AtiWord expected = length == request && length == answer ? AtiWord::either
                               : length == request                   ? AtiWord::request
                               : length == answer                    ? AtiWord::answer
                                                                     : AtiWord::foreign;
      EXPECT_EQ(ati_word(f), expected) << opcode << " " << int{length};
      f.extended = true;
      EXPECT_EQ(ati_word(f), AtiWord::foreign);
      f.extended = false;
      f.remote = true;
      EXPECT_EQ(ati_word(f), AtiWord::foreign);
    }
}

TEST(AtiCodec, OwnsItsSixteenIdentifiersAndNoOthers) {
  for (std::uint32_t id = 0; id < 0x1000; ++id) {
    BusFrame f;
    f.id = id;
    EXPECT_EQ(ati_owns(0x21, f), id >= 0x210 && id <= 0x21F) << id;
  }
}

TEST(AtiCodec, EncodesTheRequestsAndAnswersOfTheManual) {
  EXPECT_EQ(ati_request(kBase, AtiOpcode::gages), frame("200#"));
  EXPECT_EQ(ati_request(kBase, AtiOpcode::matrix_row, {5}), frame("202#05"));
  EXPECT_EQ(ati_request(kBase, AtiOpcode::calibration, {3}), frame("206#03"));
  EXPECT_EQ(ati_request(kBase, AtiOpcode::set_baud, {1}), frame("20E#01"));
  EXPECT_EQ(ati_request(kBase, AtiOpcode::set_baud), frame("20E#"));
  EXPECT_EQ(ati_request(kBase, AtiOpcode::set_base, {0x21}), frame("20D#21"));
  EXPECT_EQ(ati_request(0x7F, AtiOpcode::firmware), frame("7FF#"));

  const AtiCounts counts{1'000'000, 1'000'000};
  EXPECT_EQ(ati_counts_frame(kBase, counts), frame("207#000F4240000F4240"));
  EXPECT_EQ(ati_counts_of(frame("207#000F4240000F4240")), counts);
  EXPECT_EQ(ati_counts_of(frame("207#FFFFFFFF00000001")), (AtiCounts{0xFFFFFFFF, 1}));
  EXPECT_EQ(ati_units_frame(kBase, {2, 3}), frame("208#0203"));
  EXPECT_EQ(ati_units_of(frame("208#0203")), (AtiUnits{2, 3}));
  EXPECT_EQ(ati_serial_frame(kBase, "FT12345"), frame("205#4654313233343500"));
  EXPECT_EQ(ati_serial_of(frame("205#4654313233343500")), std::string_view("FT12345\0", 8));
  EXPECT_EQ(ati_firmware_frame(kBase, {3, 8, 2}), frame("20F#03080002"));
  EXPECT_EQ(ati_firmware_of(frame("20F#03080002")), (AtiFirmware{3, 8, 2}));
  EXPECT_EQ(ati_diagnostic_frame(kBase, 0xABCD), frame("209#ABCD"));
  EXPECT_EQ(ati_diagnostic_of(frame("209#ABCD")), 0xABCD);
  EXPECT_TRUE((AtiFirmware{3, 7, 0}.tells_counts()));
  EXPECT_TRUE((AtiFirmware{4, 0, 0}.tells_counts()));
  EXPECT_FALSE((AtiFirmware{3, 6, 9}.tells_counts()));
  EXPECT_FALSE((AtiFirmware{2, 9, 0}.tells_counts()));
}

TEST(AtiCodec, UnitsAreTheExactOnes) {
  constexpr double kPoundForce_N = 4.4482216152605;
  constexpr double kInch_m = 0.0254;
  constexpr double kFoot_m = 0.3048;
  constexpr double kGravity = 9.80665;
  const std::vector<double> forces{kPoundForce_N, 1.0,      1000 * kPoundForce_N,
                                   1000.0,        kGravity, 1e-3 * kGravity};
  const std::vector<double> torques{
      kPoundForce_N * kInch_m, kPoundForce_N * kFoot_m, 1.0, 1e-3, 1e-2 * kGravity, 1000.0};
  for (std::uint8_t code = 1; code <= 6; ++code) {
    EXPECT_DOUBLE_EQ(*ati_newton(code), forces[code - 1U]) << int{code};
    EXPECT_DOUBLE_EQ(*ati_newton_metre(code), torques[code - 1U]) << int{code};
  }
  for (const std::uint8_t code : {std::uint8_t{0}, std::uint8_t{7}, std::uint8_t{255}}) {
    EXPECT_FALSE(ati_newton(code).has_value());
    EXPECT_FALSE(ati_newton_metre(code).has_value());
  }
  // The same gages read in other units and counts are the same wrench.
  AtiCalibration pounds = synthetic_ati_calibration();
  pounds.units = {1, 2};
  pounds.counts = {500'000, 250'000};
  const RawCounts gages{1500, -2200, 1440, 3100, -40, -1875};
  const Wrench in_pounds = wrench_of(gages, example_bias(), pounds);
  const Wrench in_newton = wrench_of(gages, example_bias(), synthetic_ati_calibration());
  EXPECT_TRUE(in_pounds.force.isApprox(in_newton.force * 2 * kPoundForce_N));
  EXPECT_TRUE(in_pounds.torque.isApprox(in_newton.torque * 4 * kPoundForce_N * kFoot_m));
}

TEST(AtiCodec, RefusesCalibrationsThatCannotMeasure) {
  EXPECT_TRUE(synthetic_ati_calibration().usable());
  EXPECT_FALSE(AtiCalibration{}.usable()) << "all zeros";
  for (const auto value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int i = 0; i < 36; ++i) {
      AtiCalibration bad = synthetic_ati_calibration();
      bad.matrix(i / 6, i % 6) = value;
      EXPECT_FALSE(bad.usable()) << i;
    }
  for (int axis = 0; axis < 6; ++axis) {
    AtiCalibration bad = synthetic_ati_calibration();
    bad.matrix.row(axis).setZero();
    EXPECT_FALSE(bad.usable()) << "a row of zeros";
    bad = synthetic_ati_calibration();
    bad.matrix.row(axis) = 2.0 * bad.matrix.row((axis + 1) % 6) - bad.matrix.row((axis + 2) % 6);
    EXPECT_FALSE(bad.usable()) << "rows that depend on each other";
  }
  AtiCalibration bad = synthetic_ati_calibration();
  bad.counts.per_force = 0;
  EXPECT_FALSE(bad.usable());
  bad = synthetic_ati_calibration();
  bad.counts.per_torque = 0;
  EXPECT_FALSE(bad.usable());
  bad = synthetic_ati_calibration();
  bad.units.torque = 0;
  EXPECT_FALSE(bad.usable());
  // The scale of the numbers is no reason.
  AtiCalibration scaled = synthetic_ati_calibration();
  scaled.matrix *= 1e-9;
  EXPECT_TRUE(scaled.usable());
}

TEST(AtiCodec, GagesOfTheEmulatorGiveTheWrenchBackWithinHalfACount) {
  EmulatedAtiSettings settings;
  settings.bias = {112, -87, 45, 301, -260, 19};
  const EmulatedAti sensor(0, settings);
  Wrench example;
  example.force = {5, -3, -20};
  example.torque = {0.05, -0.1, 0.02};
  EXPECT_EQ(sensor.gages_of(example), (RawCounts{-332, -243, -334, 136, -426, 186}));
  // Each gage is off by at most half a count.
  const Vec6 bound =
      0.5 * 1e-6 * synthetic_ati_calibration().matrix.cwiseAbs().rowwise().sum() * (1 + 1e-9);
  std::mt19937_64 random(5);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  for (int k = 0; k < 20000; ++k) {
    Wrench wrench;
    for (int i = 0; i < 3; ++i) {
      wrench.force[i] = 100 * uniform();
      wrench.torque[i] = 1.5 * uniform();
    }
    const RawCounts gages = sensor.gages_of(wrench);
    const Wrench back = wrench_of(gages, example_bias(), synthetic_ati_calibration());
    for (int i = 0; i < 3; ++i) {
      ASSERT_LE(std::abs(back.force[i] - wrench.force[i]), bound[i]);
      ASSERT_LE(std::abs(back.torque[i] - wrench.torque[i]), bound[i + 3]);
    }
  }
}

// ---- pairing

struct Event {
  BusFrame frame;
  Timestamp stamp;
};

AtiReading numbered(int k) {
  AtiReading reading;
  for (int i = 0; i < 6; ++i) reading.gages[static_cast<std::size_t>(i)] = 100 * k + i;
  return reading;
}

/// Four samples, 10 ms apart: question, even gages, odd gages.
std::vector<Event> train() {
  std::vector<Event> events;
  for (int k = 0; k < 4; ++k) {
    const Timestamp t = 1s + k * 10ms;
    const auto frames = ati_reading_frames(kBase, numbered(k));
    events.push_back({ati_request(kBase, AtiOpcode::gages), t});
    events.push_back({frames[0], t + 700us});
    events.push_back({frames[1], t + 1200us});
  }
  return events;
}

/// Plays events; fails on a sample that nobody sent, returns how many came.
std::size_t play(const std::vector<Event>& events, bool with_questions) {
  AtiPairing pairing;
  std::size_t samples = 0;
  std::uint64_t halves = 0;
  int newest = -1;
  for (const auto& [f, stamp] : test::every(events)) {
    if (ati_word(f) == AtiWord::request) {
      if (with_questions) pairing.ask();
      continue;
    }
    ++halves;
    const auto reading = pairing.push(f, stamp);
    if (!reading) continue;
    ++samples;
    const int k = reading->reading.gages[0] / 100;
    EXPECT_EQ(reading->reading, numbered(k)) << "halves of two samples";
    EXPECT_GT(k, newest) << "out of order or twice";
    newest = k;
  }
  pairing.ask();
  EXPECT_EQ(2 * samples + pairing.torn() + pairing.duplicate(), halves) << "a half is unaccounted";
  return samples;
}

TEST(AtiPairing, NoSingleLossMixesSamplesOrCostsMoreThanOne) {
  for (const bool questions : {false, true})
    for (std::size_t lost = 0; lost < train().size(); ++lost) {
      auto events = train();
      const bool question = ati_word(events[lost].frame) == AtiWord::request;
      events.erase(events.begin() + static_cast<std::ptrdiff_t>(lost));
      EXPECT_EQ(play(events, questions), question ? 4u : 3u) << lost;
    }
}

TEST(AtiPairing, NoTwoLossesMixSamples) {
  for (const bool questions : {false, true})
    for (std::size_t a = 0; a < train().size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        auto events = train();
        events.erase(events.begin() + static_cast<std::ptrdiff_t>(a));
        events.erase(events.begin() + static_cast<std::ptrdiff_t>(b));
        EXPECT_GE(play(events, questions), 2u) << a << " " << b;
      }
}

TEST(AtiPairing, AFrameThatComesTwiceMakesNoSecondSample) {
  for (const bool questions : {false, true})
    for (std::size_t i = 0; i < train().size(); ++i) {
      const auto whole = train();
      const std::size_t end = i - i % 3 + 3;  // of its sample
      for (std::size_t place = i + 1; place <= end; ++place) {
        auto events = whole;
        const Event again{whole[i].frame, whole[place - 1].stamp + 100us};
        events.insert(events.begin() + static_cast<std::ptrdiff_t>(place), again);
        const bool late_question = ati_word(again.frame) == AtiWord::request && place == end - 1;
        EXPECT_EQ(play(events, questions), questions && late_question ? 3u : 4u) << i << place;
      }
    }
}

TEST(AtiPairing, FramesOfOneSampleInAnyOrderMixNothing) {
  for (const bool questions : {false, true})
    for (std::size_t sample = 0; sample < 4; ++sample) {
      std::array<std::size_t, 3> order{0, 1, 2};
      do {
        const auto whole = train();
        auto events = whole;
        for (std::size_t i = 0; i < 3; ++i)
          events[3 * sample + i].frame = whole[3 * sample + order[i]].frame;
        EXPECT_GE(play(events, questions), 3u);
      } while (std::next_permutation(order.begin(), order.end()));
    }
}

TEST(AtiPairing, HalvesThatAreTooFarApartAreTwo) {
  const auto frames = ati_reading_frames(kBase, numbered(1));
  AtiPairing pairing;
  EXPECT_FALSE(pairing.push(frames[0], 1s));
  EXPECT_TRUE(pairing.push(frames[1], 1s + 5ms));
  EXPECT_FALSE(pairing.push(frames[0], 2s));
  EXPECT_FALSE(pairing.push(frames[1], 2s + 5ms + 1ns));
  EXPECT_FALSE(pairing.push(frames[0], 3s));
  EXPECT_FALSE(pairing.push(frames[1], 3s - 1ns)) << "time went back";
  EXPECT_EQ(pairing.torn(), 4u);
}

TEST(AtiPairing, ConstantForcesAreNoDuplicates) {
  const auto frames = ati_reading_frames(kBase, numbered(1));
  AtiPairing pairing;
  for (int k = 0; k < 100; ++k) {
    EXPECT_FALSE(pairing.push(frames[0], 1s + k * 10ms));
    EXPECT_TRUE(pairing.push(frames[1], 1s + k * 10ms + 500us));
  }
  EXPECT_EQ(pairing.duplicate() + pairing.torn(), 0u);
}

// ---- decoder of logs

std::vector<std::string> set_up_log(bool with_requests) {
  std::vector<std::string> log{"206#00", "206#00"};
  if (!with_requests) log.pop_back();
  const auto ask = [&](const std::string& text) {
    if (with_requests) log.push_back(text);
  };
  for (std::size_t row = 0; row < 6; ++row) {
    ask("202#0" + std::to_string(row));
    for (const char* text : example_rows()[row].frames) log.push_back(text);
  }
  ask("207#");
  log.push_back("207#000F4240000F4240");
  ask("208#");
  log.push_back("208#0203");
  return log;
}

const std::vector<std::string> kTwoSamples{"200#", "200#000005DC05A0FFD8", "201#F7680C1CF8AD",
                                           "200#", "200#80407FFF002DFEFC", "201#8000012D0013"};

std::vector<AtiSample> decode(AtiDecoder& decoder, const std::vector<std::string>& log) {
  std::vector<AtiSample> samples;
  Timestamp t = 1s;
  for (const auto& text : log) {
    const BusFrame f = frame(text);
    EXPECT_TRUE(decoder.owns(f));
    if (const auto sample = decoder.push(f, t += 1ms)) samples.push_back(*sample);
  }
  decoder.finish();
  return samples;
}

void expect_two_samples(const std::vector<AtiSample>& samples) {
  ASSERT_EQ(samples.size(), 2u);
  const Wrench expected =
      wrench_of({1500, -2200, 1440, 3100, -40, -1875}, Vec6::Zero(), synthetic_ati_calibration());
  EXPECT_EQ(samples[0].wrench_S.force, expected.force);
  EXPECT_EQ(samples[0].wrench_S.torque, expected.torque);
  EXPECT_TRUE(samples[0].valid);
  EXPECT_FALSE(samples[1].valid);
}

TEST(AtiDecoder, LearnsTheCalibrationFromTheAnswersInTheLog) {
  for (const bool with_requests : {true, false}) {
    auto log = set_up_log(with_requests);
    log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
    AtiDecoder decoder(kBase);
    expect_two_samples(decode(decoder, log));
    EXPECT_EQ(decoder.learned(), synthetic_ati_calibration());
    EXPECT_EQ(decoder.uncalibrated() + decoder.torn() + decoder.duplicate() + decoder.foreign(),
              0u);
    EXPECT_EQ(decoder.answers(), with_requests ? 21u : 20u);
    EXPECT_EQ(decoder.requests(), with_requests ? 11u : 3u);
  }
}

TEST(AtiDecoder, TakesRowsInAnyOrderWhenTheLogSaysWhichWereAsked) {
  std::vector<std::string> log;
  for (const std::size_t row : {3U, 0U, 5U, 1U, 4U, 2U}) {
    log.push_back("202#0" + std::to_string(row));
    for (const char* text : example_rows()[row].frames) log.push_back(text);
  }
  AtiDecoder decoder(kBase);
  (void)decode(decoder, log);
  EXPECT_EQ(decoder.learned(), synthetic_ati_calibration());
}

TEST(AtiDecoder, InventsNothingBeforeTheCalibrationIsKnown) {
  auto log = kTwoSamples;
  const auto set_up = set_up_log(true);
  log.insert(log.end(), set_up.begin(), set_up.end());
  AtiDecoder first(kBase);
  EXPECT_TRUE(decode(first, log).empty());
  EXPECT_EQ(first.uncalibrated(), 2u);
  AtiDecoder second(kBase, first.learned());
  expect_two_samples(decode(second, log));
  EXPECT_EQ(second.uncalibrated(), 0u);
}

TEST(AtiDecoder, CountsAndUnitsMayComeAfterTheSamples) {
  std::vector<std::string> log = set_up_log(true);
  log.resize(log.size() - 4);  // without counts and units
  log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
  log.insert(log.end(), {"207#", "207#0007A1200003D090", "208#", "208#0102"});
  AtiDecoder first(kBase);
  (void)decode(first, log);
  const auto learned = first.learned();
  ASSERT_TRUE(learned.has_value());
  EXPECT_EQ(learned->counts, (AtiCounts{500'000, 250'000}));
  EXPECT_EQ(learned->units, (AtiUnits{1, 2}));
  AtiDecoder second(kBase, learned);
  const auto samples = decode(second, log);
  ASSERT_EQ(samples.size(), 2u);
  const Wrench expected = wrench_of({1500, -2200, 1440, 3100, -40, -1875}, Vec6::Zero(), *learned);
  EXPECT_EQ(samples[0].wrench_S.force, expected.force);
  EXPECT_EQ(samples[0].wrench_S.torque, expected.torque);
}

TEST(AtiDecoder, AnotherCalibrationOrAResetEndsTheOldOne) {
  auto log = set_up_log(true);
  log.insert(log.end(), {"206#03", "206#03"});
  log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
  AtiDecoder decoder(kBase);
  EXPECT_TRUE(decode(decoder, log).empty());
  EXPECT_EQ(decoder.uncalibrated(), 2u);

  log = set_up_log(true);
  log[0] = log[1] = "206#03";
  log.push_back("20C#");
  log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
  AtiDecoder after_reset(kBase);
  EXPECT_TRUE(decode(after_reset, log).empty());

  log = set_up_log(true);
  log.push_back("20C#");
  log.insert(log.end(), {"206#00", "206#00"});  // the same again
  log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
  AtiDecoder same(kBase);
  expect_two_samples(decode(same, log));
}

TEST(AtiDecoder, AMatrixWithoutAllItsRowsIsNone) {
  for (std::size_t missing = 0; missing < 6; ++missing) {
    std::vector<std::string> log;
    for (std::size_t row = 0; row < 6; ++row) {
      log.push_back("202#0" + std::to_string(row));
      for (std::size_t part = 0; part < 3; ++part)
        if (row != missing || part != row % 3) log.push_back(example_rows()[row].frames[part]);
    }
    log.insert(log.end(), kTwoSamples.begin(), kTwoSamples.end());
    AtiDecoder decoder(kBase);
    EXPECT_TRUE(decode(decoder, log).empty());
    EXPECT_FALSE(decoder.learned().has_value());
  }
}

TEST(AtiDecoder, CountsForeignTornAndDuplicateFrames) {
  AtiDecoder decoder(kBase, synthetic_ati_calibration());
  const auto samples =
      decode(decoder, {"200#00", "00000200#", "201#R6", "20A#", "203#00", "200#000005DC05A0FFD8",
                       "200#000005DC05A0FFD8", "201#F7680C1CF8AD", "201#F7680C1CF8AD",
                       "200#000105DC05A0FFD8", "200#", "201#F7680C1CF8AD"});
  EXPECT_EQ(samples.size(), 1u);
  EXPECT_EQ(decoder.foreign(), 5u);
  EXPECT_EQ(decoder.duplicate(), 2u);
  EXPECT_EQ(decoder.torn(), 2u);
}

}  // namespace
}  // namespace isograsp::ati_codec_test
