// SPDX-License-Identifier: GPL-3.0-or-later
// Courses of simulated people whose true change is known, judged with pools that were estimated
// from other simulated people.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/random.hpp"
#include "reports/findings/change.hpp"

namespace isograsp::test {

/// How one measure varies; CVs are standard deviations of its logarithm.
struct SimulatedMeasure {
  const char* name;
  tasks::Better better;
  double least_level;
  double most_level;
  double trial_cv;
  int trials;             ///< a day
  bool constant = false;  ///< the error does not grow with the mean: it is that of the middle level
};
/// Strengths, errors, single times; and a lag, whose error is the same for all.
inline constexpr SimulatedMeasure kSimulated[] = {
    {"force", tasks::Better::higher, 2.0, 30.0, 0.06, 2},
    {"error", tasks::Better::lower, 5.0, 40.0, 0.12, 2},
    {"single", tasks::Better::higher, 0.5, 5.0, 0.0, 1},
    {"lag", tasks::Better::near_zero, 0.2, 0.4, 0.06, 3, true}};

/// Days of a pool on which everything was otherwise: a swollen hand, another strap, a wrong person.
struct Outlying {
  double share = 0.0;  ///< of the days
  double size = 0.0;   ///< up or down, in SDs of a day (of the mean variance)
};

/// Who is simulated. Ten people are judged with each pool, so that a pool that came out too small
/// counts; a family of courses has one seed.
struct Simulation {
  const SimulatedMeasure& measure;
  int people = 10;  ///< in a pool
  Outlying outlying{};
  int families = 1;
  int courses = 1000;  ///< of a family
  int assessments = 20;
  double least_cv = 0.10;  ///< from day to day, of people
  double most_cv = 0.20;
  std::optional<double> t975{};  ///< instead of that of the pool
  /// True change of the logarithm (of the measure itself where the error is constant) in assessment
  /// 0, 1, …; `mdc`: that of the pool without its outlying days.
  std::function<double(int assessment, double mdc)> change = [](int, double) { return 0.0; };
};

struct Share {
  double of_courses = 0.0;
  double standard_error = 0.0;   ///< from how much the pools differ
  double farthest_family = 0.0;  ///< of any family from the mean, in its own standard errors
};
struct Outcomes {
  Share possible;   ///< at some time
  Share confirmed;  ///< at some time
  Share improved;   ///< confirmed, at some time
  Share worsened;
  Share improved_at_end;
  Share worsened_at_end;
  Share useless;  ///< the MDC is more than twice that without the outlying days
};
[[nodiscard]] Outcomes simulate(const Simulation& simulation);

/// Share of pools whose plain mean of squares of day means gives more than twice the SD that it
/// gives without the outlying days.
[[nodiscard]] double plain_sd_doubled(const Simulation& simulation);

}  // namespace isograsp::test
