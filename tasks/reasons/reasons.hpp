// SPDX-License-Identifier: GPL-3.0-or-later
// Why a measure has no value: the reasons with places, and the reader of those that are stored.
// Measure::reason is the English sentence that stands in databases and exports.
#pragma once

#include <string_view>

#include "core/text.hpp"

namespace isograsp::tasks {

inline constexpr auto kColumnMissing = "the column %1 is missing"_text;
inline constexpr auto kNotReached = "not reached within %1 s"_text;
inline constexpr auto kTooFewRows = "fewer than %1 rows"_text;
inline constexpr auto kMaximumUnknown = "the maximum of the %1 was not measured"_text;

/// What a stored reason says. One that no measure gives stays as it is.
[[nodiscard]] Text reason_words(std::string_view stored);

}  // namespace isograsp::tasks
