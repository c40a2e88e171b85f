// SPDX-License-Identifier: GPL-3.0-or-later
// Several tests of one question: p values corrected for their number (Holm 1979).
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace isograsp::statistics {

/// In the order of `p`; nothing where a test gave none, which then does not count.
[[nodiscard]] std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p);

}  // namespace isograsp::statistics
