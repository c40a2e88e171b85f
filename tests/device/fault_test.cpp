// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/fault.hpp"

#include <gtest/gtest.h>

namespace isograsp::fault_test {
namespace {

TEST(Fault, SaysWhatHappensToWhomAndWhen) {
  const auto lost = Fault::parse("lose=index:tx2:0.01");
  ASSERT_TRUE(lost.ok());
  EXPECT_EQ(lost->kind, Fault::Kind::lose_second);
  EXPECT_EQ(lost->fingers, (std::array{false, true, false}));
  EXPECT_EQ(lost->probability, 0.01);

  const auto frozen = Fault::parse("freeze=thumb:2s@10s");
  ASSERT_TRUE(frozen.ok());
  EXPECT_EQ(frozen->kind, Fault::Kind::freeze);
  EXPECT_EQ(frozen->at_s, 10.0);
  EXPECT_EQ(frozen->duration_s, 2.0);
  EXPECT_FALSE(frozen->acts_at(9.999));
  EXPECT_TRUE(frozen->acts_at(10.0));
  EXPECT_FALSE(frozen->acts_at(12.0));

  const auto late = Fault::parse("delay=all:0.5:20ms");
  ASSERT_TRUE(late.ok());
  EXPECT_EQ(late->fingers, (std::array{true, true, true}));
  EXPECT_DOUBLE_EQ(late->amount, 0.02);

  const auto silent = Fault::parse("silence=middle@5s");
  ASSERT_TRUE(silent.ok());
  EXPECT_TRUE(silent->acts_at(1e6)) << "for ever";

  const auto unplugged = Fault::parse("unplug:1s@5s");
  ASSERT_TRUE(unplugged.ok());
  EXPECT_TRUE(unplugged->of_bus());
  EXPECT_EQ(unplugged->duration_s, 1.0);
}

TEST(Fault, EveryExampleInTheListIsOne) {
  const auto bad = Fault::parse("nonsense");
  ASSERT_FALSE(bad.ok());
  std::string list = english(bad.error().remedy);
  list = list.substr(list.find(": ") + 2);
  int examples = 0;
  for (std::size_t begin = 0; begin < list.size();) {
    const auto end = std::min(list.find(", ", begin), list.size());
    const auto example = list.substr(begin, end - begin);
    EXPECT_TRUE(Fault::parse(example).ok()) << example;
    ++examples;
    begin = end + 2;
  }
  EXPECT_EQ(examples, 24);
}

TEST(Fault, RefusesWhatItCannotPlay) {
  for (const char* text : {"",
                           "lose",
                           "lose=",
                           "lose=index",
                           "lose=index:tx3:0.1",
                           "lose=index:tx1",
                           "lose=toe:tx1:0.1",
                           "lose=index:tx1:2",
                           "lose=index:tx1:-0.1",
                           "lose=index:tx1:nan",
                           "lose=index:tx1:0.1@5s",
                           "freeze=thumb@10s",
                           "freeze=thumb:2s",
                           "freeze:2s@10s",
                           "silence=thumb",
                           "dip=thumb:2s@1s",
                           "busoff",
                           "busoff=thumb@5s",
                           "busoff@-1s",
                           "busoff@5s@6s",
                           "unplug@5s",
                           "stall:x@5s",
                           "burst=thumb:0@1s",
                           "burst=thumb:1e9@1s",
                           "drift=thumb:inf",
                           "swap=index:0.1:0.2",
                           "wrongserial=thumb@1s",
                           "delay=index:0.5:fast"})
    EXPECT_FALSE(Fault::parse(text).ok()) << text;
}

}  // namespace
}  // namespace isograsp::fault_test
