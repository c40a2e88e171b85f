// SPDX-License-Identifier: GPL-3.0-or-later
// A demonstration clinic: simulated patients who train over weeks.
#pragma once

#include <string>

#include "core/result.hpp"

namespace isograsp {

/// Twelve patients of the library, each on a course of their own, with twenty sessions of the
/// training protocol, made in virtual time on `threads` threads. The content is the same each time
/// and for any number of threads, but for the UUIDs. @pre there is no file `database`
[[nodiscard]] Result<void> make_clinic(const std::string& database, int threads);

}  // namespace isograsp
