// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "tasks/pace.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr std::uint64_t kPhaseStream = 200;
constexpr std::uint64_t kFormStream = 202;

double breath(double cycles) {
  return 0.5 * (1.0 - std::cos(kTurn_rad * cycles));
}

double trapezoid(const Waveform& w, double t_s) {
  if (t_s < w.rise_s) return t_s / w.rise_s;
  if (t_s < w.rise_s + w.hold_s) return 1.0;
  return std::max(0.0, 1.0 - (t_s - w.rise_s - w.hold_s) / w.fall_s);
}

double between_points(const Waveform& w, double t_s) {
  const auto after = std::upper_bound(w.t_s.begin(), w.t_s.end(), t_s);
  if (after == w.t_s.begin()) return w.values.front();
  if (after == w.t_s.end()) return w.values.back();
  const auto k = static_cast<std::size_t>(after - w.t_s.begin());
  const double share = (t_s - w.t_s[k - 1]) / (w.t_s[k] - w.t_s[k - 1]);
  return std::lerp(w.values[k - 1], w.values[k], share);
}

/// @param start_cycles  lead of a parallel form over form 0 [cycles]
double value_at(const Waveform& w, double duration_s, double t_s, double start_cycles) {
  const double cycles = w.frequency_Hz * t_s + start_cycles;
  switch (w.shape) {
    case Waveform::Shape::constant: return 1.0;
    case Waveform::Shape::ramp: return std::min(1.0, t_s / w.rise_s);
    case Waveform::Shape::trapezoid: return trapezoid(w, t_s);
    case Waveform::Shape::triangle:
      return 1.0 - std::abs(2.0 * (cycles - std::floor(cycles)) - 1.0);
    case Waveform::Shape::sine: return breath(cycles);
    case Waveform::Shape::swept_sine:
      return breath(cycles + 0.5 * (w.last_frequency_Hz - w.frequency_Hz) * t_s * t_s / duration_s);
    case Waveform::Shape::rectangle: return cycles - std::floor(cycles) < 0.5 ? 0.0 : 1.0;
    case Waveform::Shape::multi_sine:
    case Waveform::Shape::random: break;  // a sum: below
    case Waveform::Shape::csv: return between_points(w, t_s);
  }
  return 0.0;
}

std::vector<double> sum_of_sines(const Waveform& w, double duration_s, std::size_t count,
                                 double period_s, std::uint64_t trial_seed) {
  Random random(w.seed.value_or(trial_seed), kPhaseStream);
  std::vector<double> sum(count, 0.0);
  for (const double frequency_Hz : frequencies_of(w, duration_s)) {
    const double phase_rad = kTurn_rad * random.uniform();
    for (std::size_t k = 0; k < count; ++k)
      sum[k] += std::sin(kTurn_rad * frequency_Hz * static_cast<double>(k) * period_s + phase_rad);
  }
  const auto [least, most] = std::minmax_element(sum.begin(), sum.end());
  const double low = *least;
  const double range = *most - low;
  for (double& value : sum) value = range > 0.0 ? (value - low) / range : 0.0;
  return sum;
}

}  // namespace

std::string_view name_of(Waveform::Shape shape) noexcept {
  constexpr std::string_view kNames[] = {"constant", "ramp",       "trapezoid", "triangle",
                                         "sine",     "swept_sine", "rectangle", "multi_sine",
                                         "random",   "csv"};
  return kNames[static_cast<std::size_t>(shape)];
}

int form_of(const Waveform& waveform, std::uint64_t trial_seed) {
  if (waveform.forms <= 1) return 0;
  return static_cast<int>(Random(trial_seed, kFormStream).uniform() * waveform.forms);
}

std::vector<double> frequencies_of(const Waveform& waveform, double duration_s) {
  if (waveform.shape == Waveform::Shape::sine) return {waveform.frequency_Hz};
  if (waveform.shape == Waveform::Shape::multi_sine) return waveform.frequencies;
  if (waveform.shape != Waveform::Shape::random) return {};
  constexpr double kRoundingSlack = 1e-9;
  std::vector<double> lines;
  const double step_Hz = 1.0 / duration_s;
  for (int k = 1; k * step_Hz <= waveform.bandwidth_Hz * (1.0 + kRoundingSlack); ++k)
    lines.push_back(k * step_Hz);
  return lines;
}

std::vector<double> samples_of(const Waveform& waveform, double duration_s, double period_s,
                               std::uint64_t trial_seed) {
  const auto count = static_cast<std::size_t>(frames_in(duration_s, period_s));
  if (waveform.shape == Waveform::Shape::multi_sine || waveform.shape == Waveform::Shape::random)
    return sum_of_sines(waveform, duration_s, count, period_s, trial_seed);
  const double start_cycles = static_cast<double>(form_of(waveform, trial_seed)) / waveform.forms;
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k)
    values[k] = value_at(waveform, duration_s, static_cast<double>(k) * period_s, start_cycles);
  return values;
}

}  // namespace isograsp::tasks
