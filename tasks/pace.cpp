// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/pace.hpp"

namespace isograsp::tasks {

double Pace::wait(double least_s, double most_s) noexcept {
  if (waits_ == Waits::longest) return most_s;
  if (waits_ == Waits::mean) return 0.5 * (least_s + most_s);
  return least_s + (most_s - least_s) * random_.uniform();
}

}  // namespace isograsp::tasks
