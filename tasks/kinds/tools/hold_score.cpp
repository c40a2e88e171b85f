// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/tools/hold_score.hpp"

#include "tasks/measures/steadiness.hpp"

namespace isograsp::tasks {

void add_steadiness(const Trace& hold, const std::string& channel, double noise_N,
                    MeasureList& list) {
  const Steadiness steady = steadiness(
      hold.t_s, hold.force_N, noise_N > 0.0 ? std::optional<double>(noise_N) : std::nullopt);
  list.add("force_sd", channel, "N", hold.section, steady.sd);
  list.add("cv", channel, "%", hold.section, steady.cv_percent);
  list.add("cv_noise_floor", channel, "%", hold.section, steady.noise_floor_percent);
  list.add("fall", channel, "%", hold.section, steady.fall_percent);
}

}  // namespace isograsp::tasks
