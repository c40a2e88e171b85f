// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/date.hpp"

#include <gtest/gtest.h>

namespace isograsp::date_test {
namespace {

Date date(const char* text) {
  return date_from_iso(text).value();
}

TEST(Date, EveryDayOfFourCenturiesReadsBackAsItWasWritten) {
  const auto first = std::chrono::sys_days(date("1800-01-01"));
  for (int day = 0; day < 146097; ++day) {  // days in 400 years
    const Date written{first + std::chrono::days(day)};
    ASSERT_EQ(date_from_iso(iso_text(written)), written) << iso_text(written);
  }
}

TEST(Date, DaysThatNoCalendarHasAndOtherFormsAreNone) {
  for (const char* wrong :
       {"", "2026-02-29", "1900-02-29", "2026-13-01", "2026-00-10", "2026-04-31", "2026-01-00",
        "2026-1-05", "05.03.2026", "2026/03/05", "2026-03-05 ", " 2026-03-05",
        "2026-03-05T09:30:00Z", "20260305", "+026-03-05", "2026-03-0x", "-026-03-05"})
    EXPECT_FALSE(date_from_iso(wrong).has_value()) << wrong;
  EXPECT_TRUE(date_from_iso("2024-02-29").has_value());
  EXPECT_TRUE(date_from_iso("2000-02-29").has_value());
}

TEST(Date, DaysAreCountedOverLeapDaysAndBackwards) {
  EXPECT_EQ(days_between(date("2024-02-28"), date("2024-03-01")), 2);
  EXPECT_EQ(days_between(date("2025-02-28"), date("2025-03-01")), 1);
  EXPECT_EQ(days_between(date("2026-03-05"), date("2026-03-05")), 0);
  EXPECT_EQ(days_between(date("2026-03-05"), date("2025-03-05")), -365);
}

}  // namespace
}  // namespace isograsp::date_test
