// SPDX-License-Identifier: GPL-3.0-or-later
// Results that no signals gave.
#pragma once

namespace isograsp::test {

/// A version of a measure that the program has not reached: a made-up result with it is never
/// computed again from the signals that stand beside it.
inline constexpr int kMadeUpVersion = 1000;

}  // namespace isograsp::test
