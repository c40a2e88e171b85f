// SPDX-License-Identifier: GPL-3.0-or-later
// The language of all texts, unless another one is chosen.
#pragma once

#include "core/text.hpp"

namespace isograsp {

inline const Language kEnglish;

}  // namespace isograsp
