// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/every.hpp"

#include <vector>

#include <gtest/gtest-spi.h>

namespace isograsp::every_test {
namespace {

TEST(Every, FailsWhereThereIsNothingToLookAtAndElseGivesEachElement) {
  EXPECT_NONFATAL_FAILURE((void)test::every(std::vector<int>{}), "proves nothing");
  const std::vector<int> numbers{3, 4};
  int sum = 0;
  for (const int number : test::every(numbers)) sum += number;
  EXPECT_EQ(sum, 7);
  EXPECT_EQ(&test::every(numbers), &numbers) << "no copy";
}

TEST(AtLeast, FailsAtTheEndOfItsLifeWhereTooFewWereLookedAt) {
  EXPECT_NONFATAL_FAILURE(
      {
        test::AtLeast looked(2);
        ++looked;
      },
      "1 looked at, not 2 at least");
  test::AtLeast looked(1);
  ++looked;
}

}  // namespace
}  // namespace isograsp::every_test
