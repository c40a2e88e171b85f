// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/leap_json.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::leap_json_test {
namespace {

using Kind = LeapDecoder::Kind;

/// Millimetres to metres, microseconds to seconds: one rounding.
constexpr double kRounding = 1e-15;

std::string frame(int time_us, const std::string& hands, const std::string& pointables = "") {
  return "{\"timestamp\":" + std::to_string(time_us) + ",\"hands\":[" + hands +
         "],\"pointables\":[" + pointables + "]}";
}
std::string hand(const std::string& side, int id, const std::string& more = "") {
  return "{\"id\":" + std::to_string(id) + ",\"type\":\"" + side +
         "\",\"palmPosition\":[0,100,0],\"direction\":[0,0,-2]" + more + "}";
}
std::string finger(int hand_id, const std::string& which, int x_mm) {
  const std::string place = "Position\":[" + std::to_string(x_mm) + ",0,";
  return "{" + which + ",\"handId\":" + std::to_string(hand_id) + ",\"carp" + place + "40],\"mcp" +
         place + "30],\"pip" + place + "20],\"dip" + place + "10],\"btip" + place + "0]}";
}
std::string fingers(int hand_id, int first_mm) {
  std::string all;
  for (int type = 0; type < 5; ++type)
    all += (type == 0 ? "" : ",") +
           finger(hand_id, "\"type\":" + std::to_string(type), first_mm + 10 * type);
  return all;
}

TEST(LeapJson, TheWristIsToldOrTheMiddleOfTheCarpalsOrBehindThePalm) {
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  const auto wrist_after = [&](int time_us, const std::string& one, const std::string& digits) {
    EXPECT_EQ(decoder.take(frame(time_us, one, digits), hands), Kind::frame);
    return hands.at(0).joints[kWristJoint];
  };
  EXPECT_WITHIN((wrist_after(1, hand("right", 7, ",\"wrist\":[1,2,3]"), fingers(7, 0)) -
                 Vec3(0.001, 0.002, 0.003))
                    .norm(),
                0.0, kRounding);
  // Of index to little: 10, 20, 30, 40 mm.
  EXPECT_WITHIN((wrist_after(2, hand("right", 7), fingers(7, 0)) - Vec3(0.025, 0.0, 0.04)).norm(),
                0.0, kRounding);
  EXPECT_WITHIN((wrist_after(3, hand("right", 7), "") - Vec3(0.0, 0.1, 0.045)).norm(), 0.0,
                kRounding);
  EXPECT_FALSE(wrist_after(4,
                           "{\"id\":7,\"type\":\"right\",\"palmPosition\":[0,0,0],"
                           "\"direction\":[0,0,0]}",
                           "")
                   .allFinite())
      << "no direction, no wrist";
}

TEST(LeapJson, FingersAreKnownByTheirTypeElseByTheLastDigitOfTheirNumberAndByTheirHand) {
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  const std::string digits = finger(7, "\"id\":72", 33) + "," + finger(8, "\"type\":2", 99) + "," +
                             finger(7, "\"type\":0", 11) + "," + finger(7, "\"id\":77", 55);
  ASSERT_EQ(decoder.take(frame(1, hand("left", 7), digits), hands), Kind::frame);
  ASSERT_EQ(hands.size(), 1u);
  EXPECT_EQ(hands[0].side, Hand::left);
  EXPECT_WITHIN(hands[0].joints[joint_of(Digit::middle, 0)].x(), 0.033, kRounding);
  EXPECT_WITHIN(hands[0].joints[joint_of(Digit::thumb, 3)].x(), 0.011, kRounding);
  EXPECT_FALSE(hands[0].joints[joint_of(Digit::index, 0)].allFinite());
}

TEST(LeapJson, AHandThatWasThereIsARowThatIsNotTrackedAndOneThatNeverWasIsNone) {
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  ASSERT_EQ(decoder.take(frame(1000, ""), hands), Kind::frame);
  EXPECT_TRUE(hands.empty());
  ASSERT_EQ(decoder.take(frame(2000, hand("right", 7) + "," + hand("right", 9)), hands),
            Kind::frame);
  ASSERT_EQ(hands.size(), 1u) << "of two right hands the first";
  ASSERT_EQ(decoder.take(frame(4000, hand("left", 8)), hands), Kind::frame);
  ASSERT_EQ(hands.size(), 2u);
  EXPECT_TRUE(hands[0].tracked);
  EXPECT_FALSE(hands[1].tracked);
  EXPECT_EQ(hands[1].side, Hand::right);
  EXPECT_WITHIN(hands[1].t_s, 0.003, kRounding);
}

TEST(LeapJson, WhatIsNoFrameIsToldApart) {
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  EXPECT_EQ(decoder.take("{\"version\":6}", hands), Kind::notice);
  for (const char* damaged : {"", "[]", "{\"timestamp\":", "{\"timestamp\":\"1\",\"hands\":[]}",
                              "{\"timestamp\":-1,\"hands\":[]}", "{\"timestamp\":1}"})
    EXPECT_EQ(decoder.take(damaged, hands), Kind::damaged) << damaged;
  EXPECT_EQ(decoder.take(std::string(LeapDecoder::kLongestMessage + 1, ' '), hands), Kind::damaged);
  EXPECT_EQ(decoder.take(frame(5, hand("right", 1)), hands), Kind::frame);
  EXPECT_EQ(decoder.take(frame(5, hand("right", 1)), hands), Kind::late);
  EXPECT_TRUE(hands.empty());
}

}  // namespace
}  // namespace isograsp::leap_json_test
