// SPDX-License-Identifier: GPL-3.0-or-later
// The language of what is written, unless somebody chooses another.
#pragma once

#include "core/text.hpp"

namespace isograsp {

inline const Language kEnglish;

}  // namespace isograsp
