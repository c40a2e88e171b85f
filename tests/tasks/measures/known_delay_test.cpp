// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/known_delay.hpp"

#include <gtest/gtest.h>

namespace isograsp {
namespace {

TEST(KnownDelay, IsTakenOffAndTheRawValueStaysBeside) {
  const DelayCorrected lag = without_delay(0.282, 0.032);
  EXPECT_EQ(lag.raw_s.value, 0.282);
  EXPECT_DOUBLE_EQ(lag.corrected_s.value.value(), 0.25);
}

TEST(KnownDelay, AnUnknownDelayIsNeverTakenForZero) {
  const DelayCorrected lag = without_delay(0.282, std::nullopt);
  EXPECT_EQ(lag.raw_s.value, 0.282);
  EXPECT_FALSE(lag.corrected_s.value);
  EXPECT_FALSE(lag.corrected_s.reason.empty());
  EXPECT_EQ(without_delay(0.282, 0.0).corrected_s.value, 0.282);
}

TEST(KnownDelay, WithoutARawValueItsReasonIsTheReasonForBoth) {
  const DelayCorrected lag = without_delay("no peak", 0.032);
  EXPECT_EQ(lag.raw_s.reason, "no peak");
  EXPECT_EQ(lag.corrected_s.reason, "no peak");
}

}  // namespace
}  // namespace isograsp
