// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/waiting_frames.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isograsp::waiting_frames_test {
namespace {

using namespace std::chrono_literals;

BusFrame numbered(std::uint32_t number) {
  BusFrame frame;
  frame.id = number;
  return frame;
}

TEST(WaitingFrames, LeaveInTheirOrder) {
  WaitingFrames waiting;
  for (std::uint32_t k = 0; k < 5; ++k) ASSERT_TRUE(waiting.push(numbered(k), 1ms));
  std::vector<std::uint32_t> left;
  waiting.leave(2ms, [&](const BusFrame& frame) {
    if (left.size() == 3) return false;
    left.push_back(frame.id);
    return true;
  });
  EXPECT_EQ(left, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_FALSE(waiting.empty());
  EXPECT_EQ(waiting.given_up(), 0u);
}

TEST(WaitingFrames, NoneLeavesAfterTheLongestWait) {
  WaitingFrames waiting;
  ASSERT_TRUE(waiting.push(numbered(1), 0ms));
  ASSERT_TRUE(waiting.push(numbered(2), 1ns));
  std::vector<std::uint32_t> left;
  const auto write = [&](const BusFrame& frame) {
    left.push_back(frame.id);
    return true;
  };
  waiting.leave(WaitingFrames::kLongestWait, write);
  EXPECT_EQ(left, std::vector<std::uint32_t>{2});
  EXPECT_EQ(waiting.given_up(), 1u);
}

TEST(WaitingFrames, AFrameWithoutRoomIsCounted) {
  WaitingFrames waiting;
  std::uint32_t taken = 0;
  while (waiting.push(numbered(taken), 0ms)) ++taken;
  EXPECT_GT(taken, 12u) << "a burst of all sensors must fit";
  EXPECT_FALSE(waiting.push(numbered(taken), 0ms));
  EXPECT_EQ(waiting.given_up(), 2u);
  waiting.give_up_all();
  EXPECT_TRUE(waiting.empty());
  EXPECT_EQ(waiting.given_up(), 2u + taken);
}

TEST(WaitingFrames, EveryFrameLeavesOnceInTimeOrIsCounted) {
  WaitingFrames waiting;
  std::mt19937_64 random(4);
  std::vector<Timestamp> pushed_at;
  std::uint32_t left = 0;
  std::uint32_t next = 0;
  Timestamp now{0};
  for (int step = 0; step < 100'000; ++step) {
    now += Timestamp(static_cast<std::int64_t>(random() % 3'000'000));
    if (random() % 2 == 0) {
      (void)waiting.push(numbered(static_cast<std::uint32_t>(pushed_at.size())), now);
      pushed_at.push_back(now);
    } else {
      auto room = random() % 4;
      waiting.leave(now, [&](const BusFrame& frame) {
        EXPECT_GE(frame.id, next);
        EXPECT_LT(now - pushed_at[frame.id], WaitingFrames::kLongestWait);
        if (room-- == 0) return false;
        next = frame.id + 1;
        ++left;
        return true;
      });
    }
  }
  waiting.give_up_all();
  EXPECT_EQ(left + waiting.given_up(), pushed_at.size());
  EXPECT_GT(left, 10'000u);
  EXPECT_GT(waiting.given_up(), 1'000u);
}

}  // namespace
}  // namespace isograsp::waiting_frames_test
