// SPDX-License-Identifier: GPL-3.0-or-later
// One step of soft pads as a file (JSON; docs/bimanual.md, "Pads").
#pragma once

#include <string>

#include "bimanual/pads/pad_step.hpp"
#include "core/result.hpp"

namespace isograsp::app {

/// Bodies and pads. Errors name the file and what is wrong there.
[[nodiscard]] Result<bimanual::PadStep> read_pad_case(const std::string& file);

}  // namespace isograsp::app
