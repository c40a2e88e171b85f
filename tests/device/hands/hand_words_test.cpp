// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of scripts, faults of emulated trackers, and what a scene shows.
#include "device/hand/hand_json.hpp"
#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/every.hpp"

namespace isograsp::hand_words_test {
namespace {

using namespace isograsp::test;
using Kind = EmulatedHandFault::Kind;

TEST(HandJsonMessage, ReadsWhatItWritesToTheLastBit) {
  for (const bool all : {true, false}) {
    HandFrame sent = made_hand(Hand::left, 5, 1.0 / 3.0);
    if (!all) {
      sent.joints[kPalmJoint].fill(std::nan(""));
      for (const Digit digit : {Digit::index, Digit::middle, Digit::ring, Digit::little})
        sent.joints[metacarpal_joint_of(digit)].fill(std::nan(""));
    }
    const auto read = parse_hand_json(hand_json(sent));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->t_s, sent.t_s);
    EXPECT_EQ(read->side, Hand::left);
    EXPECT_EQ(read->confidence, sent.confidence);
    for (std::size_t j = 0; j < kHandJointCount; ++j) {
      EXPECT_EQ(read->joints[j].allFinite(), sent.joints[j].allFinite()) << j;
      if (sent.joints[j].allFinite()) {
        EXPECT_EQ(read->joints[j], sent.joints[j]);
      }
    }
  }
  const auto unseen = parse_hand_json(R"({"t_s":1,"hand":"right","joints":{}})");
  ASSERT_TRUE(unseen);
  EXPECT_FALSE(unseen->tracked);
}

TEST(HandJsonMessage, WhatIsNotExactlyAHandIsNone) {
  const std::string good = hand_json(made_hand(Hand::right, 1, 2.0));
  ASSERT_TRUE(parse_hand_json(good));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  for (const std::string& text : every(std::vector<std::string>{
           "", "[]", "{}", "7", good.substr(0, good.size() / 2), good + good,
           with("\"hand\":\"right\"", "\"hand\":\"Right\""), with("\"hand\":", "\"side\":"),
           with("\"t_s\":2.0", "\"t_s\":\"2\""), with("\"t_s\":2.0", "\"t_s\":1e300"),
           with("\"wrist\"", "\"carpus\""), with("\"index_tip\"", "\"index_tip2\""),
           with("\"wrist\":[", "\"wrist\":[0.0,"), with("\"wrist\":[", "\"wrist\":[1e9,"),
           with("\"wrist\":[", "\"wrist\":[NaN,"), with("\"confidence\":0.5", "\"confidence\":2"),
           "{\"t_s\":1,\"hand\":\"right\",\"joints\":{\"wrist\":[0,0,0]}}",
           std::string(kLongestHandJson + 1, ' ')}))
    EXPECT_FALSE(parse_hand_json(text)) << text;
}

TEST(HandFaultWords, AreRead) {
  const auto freeze = must(EmulatedHandFault::parse("freeze=200ms@10s"));
  EXPECT_EQ(freeze.kind, Kind::freeze);
  EXPECT_FALSE(freeze.acts_at(9.99));
  EXPECT_TRUE(freeze.acts_at(10.1));
  EXPECT_FALSE(freeze.acts_at(10.2));
  EXPECT_TRUE(must(EmulatedHandFault::parse("silence@1s")).acts_at(1e5)) << "from then on";
  EXPECT_EQ(must(EmulatedHandFault::parse("drop=0.25")).probability, 0.25);
  EXPECT_EQ(must(EmulatedHandFault::parse("clock=-3s@5s")).step_s, -3.0);
  EXPECT_TRUE(must(EmulatedHandFault::parse("split")).of_connection());
}

TEST(HandFaultWords, ThatAreWrongNameTheRemedy) {
  for (const auto& [text, part] : every(std::vector<std::pair<std::string, std::string>>{
           {"explode", "there is no such fault"},
           {"drop=2", "'2' is not a probability"},
           {"drop", "is not a probability"},
           {"freeze=xs@5s", "the duration is not a time"},
           {"freeze=2s", "the instant is missing"},
           {"clock@5s", "the jump is not a time"},
           {"clock=0@5s", "the jump is not a time"},
           {"close", "the instant is missing"},
           {"close=1@5s", "'1' is too much"},
           {"close@soon", "'soon' is not a time"},
           {"close@-1s", "'-1s' is not a time"},
           {"split@5s", "the fault has no instant"}})) {
    const auto fault = EmulatedHandFault::parse(text);
    ASSERT_FALSE(fault) << text;
    EXPECT_NE(fault.error().message().find(part), std::string::npos) << fault.error().message();
    EXPECT_NE(fault.error().message().find("freeze=2s@5s"), std::string::npos);
  }
}

TEST(HandFaultWords, OfAConnectionAreRefusedWhereThereIsNone) {
  const auto sender =
      open_hand_sender({kHandComputer, 9}, hand_scene(hand_play(3, 10.0), {"split"}));
  ASSERT_FALSE(sender);
  EXPECT_NE(sender.error().message().find("--listen"), std::string::npos);
}

TEST(HandScene, PlaysTheSameBitsAgainForTheSameSeed) {
  const auto sent = [] {
    HandScene scene = hand_scene(hand_play(200, 100.0), {"drop=0.3", "malformed=0.1"});
    std::string all;
    while (scene.next_s()) {
      const HandPicture picture = scene.take();
      all += picture.sent ? picture.cut ? 'c' : 's' : '-';
    }
    return all;
  };
  EXPECT_EQ(sent(), sent());
  EXPECT_NE(sent().find('-'), std::string::npos);
  EXPECT_NE(sent().find('c'), std::string::npos);
}

TEST(HandScene, BeginsAgainWhereItIsToRepeatAndItsTimeGoesOn) {
  HandPlay play = hand_play(3, 10.0);
  play.repeat = true;
  HandScene scene = hand_scene(std::move(play));
  for (int k = 0; k < 7; ++k) {
    ASSERT_TRUE(scene.next_s());
    EXPECT_NEAR(scene.take().stamp_s, 0.1 * k, 1e-12);
  }
}

}  // namespace
}  // namespace isograsp::hand_words_test
