// SPDX-License-Identifier: GPL-3.0-or-later
// s: the force after a 5 Hz low-pass, forwards and backwards, step dt:
//   rate_k = (s_(k + 1) - s_(k - 1)) / (2 dt)
//   early rate = (force 0.2 s after the onset - force at the onset) / 0.2 s
#include "tasks/measures/rate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/butterworth.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kCutoff_Hz = 5.0;
constexpr Words kTooFew = "too few samples for a 5 Hz low-pass"_text;

std::optional<statistics::UniformSamples> rate_on_grid(std::span<const double> t_s,
                                                       std::span<const double> force_N) {
  assert(t_s.size() == force_N.size());
  if (t_s.size() < 2) return std::nullopt;
  return rate_of_change(statistics::on_uniform_grid(t_s, force_N));
}

}  // namespace

std::optional<statistics::UniformSamples> rate_of_change(const statistics::UniformSamples& x) {
  const std::size_t n = x.values.size();
  if (n < 3 || 2.0 * kCutoff_Hz * x.step_s >= 1.0) return std::nullopt;
  const auto smooth = filtered_zero_phase(butterworth2(1.0 / x.step_s, kCutoff_Hz), x.values);
  statistics::UniformSamples rate{x.step_s, std::vector<double>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1;
    const std::size_t after = k + 1 == n ? k : k + 1;
    rate.values[k] =
        (smooth[after] - smooth[before]) / (static_cast<double>(after - before) * x.step_s);
  }
  return rate;
}

statistics::Computed peak_rate(std::span<const double> t_s, std::span<const double> force_N) {
  const auto rate = rate_on_grid(t_s, force_N);
  if (!rate) return kTooFew;
  const double largest = *std::max_element(rate->values.begin(), rate->values.end());
  if (!(largest > 0.0)) return "the force never rises"_text;
  return largest;
}

statistics::Computed peak_relaxation(std::span<const double> t_s, std::span<const double> force_N) {
  const auto rate = rate_on_grid(t_s, force_N);
  if (!rate) return kTooFew;
  const double least = *std::min_element(rate->values.begin(), rate->values.end());
  if (!(least < 0.0)) return "the force never falls"_text;
  return -least;
}

statistics::Computed early_rate(std::span<const double> t_s, std::span<const double> force_N,
                                std::size_t onset) {
  assert(t_s.size() == force_N.size() && onset < t_s.size());
  constexpr double kEarly_s = 0.2;
  const double end_s = t_s[onset] + kEarly_s;
  const std::size_t k = statistics::first_row_from(t_s, end_s);
  if (k == t_s.size()) return "the record ends within 0.2 s of the onset"_text;
  const double share = (end_s - t_s[k - 1]) / (t_s[k] - t_s[k - 1]);
  const double end_N = force_N[k - 1] + share * (force_N[k] - force_N[k - 1]);
  return (end_N - force_N[onset]) / kEarly_s;
}

Pauses pauses(std::span<const double> t_s, std::span<const double> force_N, double ramp_N_per_s) {
  assert(ramp_N_per_s != 0.0);
  constexpr double kPause_s = 0.15;
  constexpr double kShareOfRamp = 0.4;
  const auto rate = rate_on_grid(t_s, force_N);
  if (!rate) return {kTooFew, kTooFew};
  std::vector<bool> slow(rate->values.size());
  for (std::size_t k = 0; k < slow.size(); ++k)
    slow[k] = std::abs(rate->values[k]) < kShareOfRamp * std::abs(ramp_N_per_s);
  const auto found = statistics::stretches(statistics::grid_times(*rate), slow, kPause_s);
  if (found.empty()) return {0.0, "no pauses"_text};
  double total_s = 0.0;
  for (const statistics::Stretch& pause : found) total_s += pause.length_s;
  const auto count = static_cast<double>(found.size());
  return {count, total_s / count};
}

}  // namespace isograsp::tasks
