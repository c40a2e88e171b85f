// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/latest.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace isograsp::latest_test {
namespace {

struct Pair {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
};

TEST(Latest, TheReaderNeverSeesATornOrAnOlderValue) {
  constexpr std::uint64_t kLast = 200000;
  Latest<Pair> latest;
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kLast; ++i) latest.publish({i, ~i});
  });
  std::uint64_t seen = 0;
  while (seen < kLast) {
    const Pair pair = latest.read();
    if (pair.a == 0) continue;
    ASSERT_EQ(pair.b, ~pair.a);
    ASSERT_GE(pair.a, seen);
    seen = pair.a;
  }
  writer.join();
}

TEST(Latest, ReadingTwiceGivesTheSameValue) {
  Latest<int> latest;
  latest.publish(5);
  EXPECT_EQ(latest.read(), 5);
  EXPECT_EQ(latest.read(), 5);
}

}  // namespace
}  // namespace isograsp::latest_test
