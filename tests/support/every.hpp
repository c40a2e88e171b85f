// SPDX-License-Identifier: GPL-3.0-or-later
// A loop that asserts proves nothing where it runs zero times: every() and AtLeast fail then.
#pragma once

#include <iterator>
#include <utility>

#include <gtest/gtest.h>

namespace isograsp::test {

/// The range itself, for a loop that asserts something of each element: a failure if there is none.
template <typename Range>
[[nodiscard]] Range every(Range&& range, const char* file = __builtin_FILE(),
                          int line = __builtin_LINE()) {
  using std::begin;
  using std::end;
  if (begin(range) == end(range))
    ADD_FAILURE_AT(file, line) << "there is nothing to look at: the loop proves nothing";
  return std::forward<Range>(range);
}

/// Counts what was looked at, where a loop passes some by or waits for what comes: a failure at the
/// end of its life if that was less than `fewest`.
class AtLeast {
 public:
  explicit AtLeast(int fewest, const char* file = __builtin_FILE(), int line = __builtin_LINE())
      : fewest_(fewest), file_(file), line_(line) {}
  ~AtLeast() {
    if (seen_ < fewest_ && !testing::Test::IsSkipped())
      ADD_FAILURE_AT(file_, line_) << seen_ << " looked at, not " << fewest_ << " at least";
  }
  AtLeast(const AtLeast&) = delete;
  AtLeast& operator=(const AtLeast&) = delete;
  void operator++() noexcept { ++seen_; }

 private:
  int fewest_;
  int seen_ = 0;
  const char* file_;
  int line_;
};

}  // namespace isograsp::test
