// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions: every cue of every channel has words, short enough to be read from afar, and what
// is asked differently is said differently.
#include "gui/words/cue_words.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::gui::cue_words_test {
namespace {

constexpr std::size_t kDigitsCount = 7;

std::vector<ForceChannel> every_channel() {
  std::vector<ForceChannel> channels;
  for (std::size_t d = 0; d < kDigitsCount; ++d)
    for (std::size_t a = 0; a < kDirectionCount; ++a)
      channels.push_back({static_cast<Digits>(d), static_cast<Direction>(a)});
  return channels;
}

std::vector<Cue> every_cue() {
  std::vector<Cue> cues;
  for (std::size_t c = 0; c < kCueCount; ++c) cues.push_back(static_cast<Cue>(c));
  return cues;
}

std::string whole(Cue cue, ForceChannel channel, Hand hand = Hand::right) {
  const auto words = words_of(cue, channel, hand);
  return words.headline + " / " + words.detail;
}

/// Told apart by what the patient does: these three are one instruction to a hand.
Digits told_as(ForceChannel channel) {
  const bool together = channel.digits == Digits::grip_mean ||
                        (channel.digits == Digits::sum && channel.direction != Direction::plus_z);
  return together ? Digits::grip : channel.digits;
}

TEST(CueWords, AreThereAndShortForEveryCueChannelAndHand) {
  for (const Cue cue : test::every(every_cue()))
    for (const ForceChannel channel : test::every(every_channel()))
      for (const Hand hand : {Hand::right, Hand::left}) {
        const auto [headline, detail] = words_of(cue, channel, hand);
        const std::string where =
            std::string(name_of(cue)) + ", " + name_of(channel) + ": " + headline + " / " + detail;
        EXPECT_FALSE(headline.empty()) << where;
        EXPECT_FALSE(detail.empty()) << where;
        EXPECT_LE(headline.size(), kMostHeadline) << where;
        EXPECT_LE(detail.size(), kMostDetail) << where;
        EXPECT_LE(std::count(headline.begin(), headline.end(), ' '), 5) << where;
      }
}

TEST(CueWords, SayEveryForceDifferently) {
  for (const Cue cue : {Cue::squeeze, Cue::press, Cue::follow})
    for (const Hand hand : {Hand::right, Hand::left})
      for (const ForceChannel a : test::every(every_channel()))
        for (const ForceChannel b : test::every(every_channel())) {
          const bool same = told_as(a) == told_as(b) && a.direction == b.direction;
          EXPECT_EQ(whole(cue, a, hand) == whole(cue, b, hand), same)
              << name_of(cue) << ": " << name_of(a) << " and " << name_of(b);
        }
}

TEST(CueWords, SayEveryCueDifferentlyInTheLargeLineOfTheGrip) {
  for (const ForceChannel channel : {ForceChannel{}, channel_of(Finger::index)})
    for (const Cue a : test::every(every_cue()))
      for (const Cue b : test::every(every_cue()))
        EXPECT_EQ(words_of(a, channel, Hand::right).headline ==
                      words_of(b, channel, Hand::right).headline,
                  a == b)
            << name_of(a) << " and " << name_of(b);
}

TEST(CueWords, ComfortableForceNeverReadsLikeAMaximum) {
  for (const ForceChannel channel : test::every(every_channel())) {
    const auto words = words_of(Cue::press, channel, Hand::right);
    EXPECT_NE(words.headline.find("comfortably"), std::string::npos);
    EXPECT_EQ(whole(Cue::press, channel).find('!'), std::string::npos);
    EXPECT_EQ(whole(Cue::press, channel).find("hard"), std::string::npos);
  }
}

TEST(CueWords, OnlyDirectionsAlongTheForearmAreMirroredWithTheHand) {
  for (const ForceChannel channel : test::every(every_channel())) {
    const bool along =
        channel.direction == Direction::plus_y || channel.direction == Direction::minus_y;
    EXPECT_EQ(act_of(channel, Hand::right) == act_of(channel, Hand::left), !along)
        << name_of(channel);
  }
  EXPECT_EQ(act_of({Digits::thumb, Direction::plus_y}, Hand::right), "Thumb: pull toward you");
  EXPECT_EQ(act_of({Digits::index, Direction::plus_y}, Hand::right), "Index finger: push away");
  EXPECT_EQ(act_of({Digits::thumb, Direction::plus_x}, Hand::left), "Thumb: push up");
}

}  // namespace
}  // namespace isograsp::gui::cue_words_test
