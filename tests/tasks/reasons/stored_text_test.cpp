// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence that was stored is read by the words that wrote it, and by no others.
#include "tasks/reasons/stored_text.hpp"

#include <gtest/gtest.h>

namespace isograsp::tasks::stored_text_test {
namespace {

constexpr auto kNear = "not reached within %1 s"_text;
constexpr auto kBetween = "from %1 to %2, of %3"_text;

TEST(StoredText, IsTheTextThatWroteIt) {
  EXPECT_EQ(stored_text("not reached within 2.5 s", kNear, kBetween), kNear(Number{"2.5"}));
  EXPECT_EQ(stored_text("from 1e-05 to -3, of thumb", kNear, kBetween),
            kBetween(Number{"1e-05"}, Number{"-3"}, Known{"thumb"}));
}

TEST(StoredText, SaysInEnglishWhatWasStored) {
  for (const char* sentence : {"not reached within 2.5 s", "from 1 to 2, of the s", "another one",
                               "not reached within  s", "100 %1", ""})
    EXPECT_EQ(english(stored_text(sentence, kNear, kBetween)), sentence);
}

TEST(StoredText, IsLookedUpAsAWholeWhereNoWordsWroteIt) {
  for (const char* sentence :
       {"not reached within 2 s or more", "Not reached within 2 s", "not reached within  s",
        "not reached within 2", "from 1 to 2", "there was no grip"})
    EXPECT_EQ(stored_text(sentence, kNear, kBetween), Text(Known{sentence}));
}

}  // namespace
}  // namespace isograsp::tasks::stored_text_test
