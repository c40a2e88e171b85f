// SPDX-License-Identifier: GPL-3.0-or-later
// Counts heap allocations of this thread. Link tests/support/no_alloc.cpp once per test program: it
// replaces the global operator new.
#pragma once

#include <cstdint>

namespace isograsp::test {

/// Allocations by operator new on the calling thread so far.
[[nodiscard]] std::uint64_t allocations() noexcept;

/// While it lives, allocations of this thread are not counted: the other end of a simulated wire
/// may allocate.
class Uncounted {
 public:
  Uncounted() noexcept;
  ~Uncounted();
  Uncounted(const Uncounted&) = delete;
  Uncounted& operator=(const Uncounted&) = delete;

 private:
  std::uint64_t before_;
};

}  // namespace isograsp::test
