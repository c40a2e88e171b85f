// SPDX-License-Identifier: GPL-3.0-or-later
// Counts heap allocations of this thread. Link tests/support/no_alloc.cpp once per test program: it
// replaces the global operator new.
#pragma once

#include <cstdint>

namespace isograsp::test {

/// Allocations by operator new on the calling thread so far.
[[nodiscard]] std::uint64_t allocations() noexcept;

}  // namespace isograsp::test
