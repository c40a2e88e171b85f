// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/attempts.hpp"

#include <algorithm>
#include <functional>

namespace isograsp {

namespace {

constexpr double kAgreement_percent = 10.0;
constexpr double kRoundingSlack_percent = 1e-9;  // 20 and 18 differ by exactly 10 %

}  // namespace

Computed best_attempt(std::span<const double> attempts) {
  if (attempts.empty()) return "no attempts";
  return *std::max_element(attempts.begin(), attempts.end());
}

Computed mean_of_attempts(std::span<const double> attempts) {
  if (attempts.empty()) return "no attempts";
  double sum = 0.0;
  for (const double attempt : attempts) sum += attempt;
  return sum / static_cast<double>(attempts.size());
}

Computed best_two_difference(std::span<const double> attempts) {
  if (attempts.size() < 2) return "fewer than two attempts";
  std::vector<double> best(2);
  std::partial_sort_copy(attempts.begin(), attempts.end(), best.begin(), best.end(),
                         std::greater<>());
  if (!(best[0] > 0.0)) return "no attempt has force";
  return 100.0 * (best[0] - best[1]) / best[0];
}

bool attempts_agree(std::span<const double> attempts) {
  const Computed difference = best_two_difference(attempts);
  return difference.value && *difference.value <= kAgreement_percent + kRoundingSlack_percent;
}

bool is_submaximal(std::span<const double> attempts, double later) {
  const Computed best = best_attempt(attempts);
  return best.value && 100.0 * (later - *best.value) >
                           (kAgreement_percent + kRoundingSlack_percent) * *best.value;
}

}  // namespace isograsp
