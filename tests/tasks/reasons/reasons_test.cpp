// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reasons/reasons.hpp"

#include <gtest/gtest.h>

namespace isograsp::tasks::reasons_test {
namespace {

TEST(Reasons, AreReadFromADatabaseWithTheirValues) {
  for (const Text& reason : {kColumnMissing(Known{"thumb_fz_N"}), kNotReached(Number{"2.5"}),
                             kTooFewRows(500), kMaximumUnknown(Known{"index"})})
    EXPECT_EQ(reason_words(english(reason)), reason) << english(reason);
}

TEST(Reasons, WithoutValuesAreLookedUpAsAWhole) {
  for (const char* reason : {"no samples", "a reason of tomorrow", ""})
    EXPECT_EQ(reason_words(reason), Text(Known{reason}));
}

}  // namespace
}  // namespace isograsp::tasks::reasons_test
