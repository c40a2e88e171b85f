// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/known_delay.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tasks/record.hpp"

namespace isograsp::tasks::known_delay_test {
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
  const DelayCorrected lag = without_delay("no peak"_text, 0.032);
  EXPECT_EQ(english(lag.raw_s.reason), "no peak");
  EXPECT_EQ(english(lag.corrected_s.reason), "no peak");
}

TEST(KnownDelay, IsThatOfTheSensorsAndOfADisplayThatWasMeasured) {
  const auto known = [](std::vector<std::string> columns, const std::vector<double>& row) {
    Signals signals(std::move(columns));
    signals.append_row(row);
    return Record(signals).known_delay_s();
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(known({"t_s", "device_delay_s"}, {0.0, 0.032}), 0.032)
      << "as trials were stored before";
  EXPECT_EQ(known({"t_s", "device_delay_s", "display_delay_s"}, {0.0, 0.032, kNone}), 0.032);
  EXPECT_EQ(known({"t_s", "device_delay_s", "display_delay_s"}, {0.0, 0.032, 0.021}),
            0.032 + 0.021);
  EXPECT_EQ(known({"t_s", "device_delay_s", "display_delay_s"}, {0.0, kNone, 0.021}), std::nullopt)
      << "a part of the delay is not the delay";
}

}  // namespace
}  // namespace isograsp::tasks::known_delay_test
