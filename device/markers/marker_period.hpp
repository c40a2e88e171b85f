// SPDX-License-Identifier: GPL-3.0-or-later
// The period of the cameras that made a recording, from its times.
#pragma once

#include <vector>

namespace isograsp {

/// Median step [s], made exact by the mean of all steps that are whole numbers of it: times with
/// few digits (0.008, 0.017, 0.025) would drift otherwise. A whole number of pictures a second is
/// meant where it lies within the digits of the file. @pre t_s increases, t_s.size() > 1
[[nodiscard]] double period_of(const std::vector<double>& t_s);

}  // namespace isograsp
