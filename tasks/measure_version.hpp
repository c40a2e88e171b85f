// SPDX-License-Identifier: GPL-3.0-or-later
// Versions of measures: one place for all of them. A corrected measure does not interrupt a series:
// results of an older version are scored again from their signals.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/measure.hpp"

namespace isograsp::tasks {

/// Version of a measure as docs/measures.md tells it: raised whenever the same signals could give
/// another value. NAME_share, NAME_restricted and NAME_corrected have that of NAME.
[[nodiscard]] int measure_version(std::string_view name) noexcept;

/// Made by an older definition than this program's. False for measures that it does not know.
[[nodiscard]] bool is_older(const Measure& stored) noexcept;
[[nodiscard]] bool any_is_older(std::span<const Measure> stored) noexcept;

/// Puts in the place of each stored measure that is older the one of `scored`, the score() of the
/// same trial, if that holds it; all others stay. Returns how many.
int renew(std::vector<Measure>& stored, const std::vector<Measure>& scored);

}  // namespace isograsp::tasks
