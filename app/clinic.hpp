// SPDX-License-Identifier: GPL-3.0-or-later
// A demonstration clinic: simulated people whose sessions are made in virtual time.
#pragma once

#include <string>
#include <vector>

#include "app/demo_people.hpp"
#include "app/run.hpp"
#include "core/result.hpp"

namespace isograsp::app {

/// Makes all sessions on `threads` threads, and what is known of the people. The same people give
/// the same bytes, whatever the number of threads. @pre there is no file `database`
[[nodiscard]] Result<void> make_clinic(const std::string& database,
                                       const std::vector<DemoGroup>& groups, int threads);

/// How the visit of a person is made; database, printing and syncing are up to the caller.
[[nodiscard]] RunOptions options_of(const DemoVisit& visit, const std::string& code);

}  // namespace isograsp::app
