// SPDX-License-Identifier: GPL-3.0-or-later
// A time in the text of a fault.
#pragma once

#include <string_view>

namespace isograsp {

/// "20ms", "2s", "2", at most 1e6 [s]; false: it is no such time.
[[nodiscard]] bool parse_fault_seconds(std::string_view text, double& seconds);
/// The same of a jump: also "-2s".
[[nodiscard]] bool parse_fault_jump(std::string_view text, double& seconds);

}  // namespace isograsp
