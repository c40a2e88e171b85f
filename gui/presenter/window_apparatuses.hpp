// SPDX-License-Identifier: GPL-3.0-or-later
// What the windows can measure with: the platform. An arm seen by markers is refused with the way
// to measure it, before a session begins.
#pragma once

#include <span>

#include "session/open_apparatus.hpp"

namespace isograsp::gui {

[[nodiscard]] std::span<const session::ApparatusRow> window_apparatuses();

}  // namespace isograsp::gui
