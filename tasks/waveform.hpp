// SPDX-License-Identifier: GPL-3.0-or-later
// The shapes of targets over time, 0 … 1. All begin where a lead-in can hold them; none jumps
// except rectangles and files. Pure: same shape, same seed, same values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isograsp::tasks {

/// The shape of a target over time, from 0 (least) to 1 (most).
struct Waveform {
  enum class Shape : std::uint8_t {
    constant,
    ramp,
    trapezoid,
    triangle,
    sine,
    swept_sine,
    rectangle,
    multi_sine,
    random,
    csv
  };
  Shape shape = Shape::sine;
  double frequency_Hz = 0.2;        ///< sine, triangle, rectangle; swept sine: at the start
  double last_frequency_Hz = 1.0;   ///< swept sine: at the end
  std::vector<double> frequencies;  ///< multi-sine [Hz]
  int forms = 1;                    ///< sine, triangle: parallel forms; the trial's seed chooses
  double rise_s = 5.0;              ///< ramp, trapezoid
  double hold_s = 15.0;             ///< trapezoid
  double fall_s = 5.0;              ///< trapezoid
  double bandwidth_Hz = 0.5;        ///< random
  /// Random and multi-sine: the seed of the repeated sequence; nothing: a fresh one every trial.
  std::optional<std::uint64_t> seed;
  std::string csv;          ///< csv: name of a file with t_s and target (0 … 1), beside the task
  std::vector<double> t_s;  ///< csv: its times …
  std::vector<double> values;  ///< … and values
  [[nodiscard]] bool operator==(const Waveform&) const = default;
};
[[nodiscard]] std::string_view name_of(Waveform::Shape shape) noexcept;

/// Value k is at k * period_s, for `duration_s`. `trial_seed` makes a fresh sequence where the
/// shape has no seed of its own.
///   sine         (1 - cos(2 pi f t)) / 2
///   swept sine   the same with f growing linearly from first to last frequency
///   triangle     0 to 1 to 0 once per cycle;   rectangle  0, then 1 in the second half of a cycle
///   ramp         t / rise, then 1;   trapezoid  rise, hold, fall, then 0
///   multi-sine   sum of sines of equal amplitude with random phases, scaled into 0 … 1
///   random       the same with all multiples of 1 / duration up to the bandwidth (flat, then zero)
///   csv          linear between its points, the last one from its end on
/// Sine and triangle begin form_of() / forms of a cycle further on than said here.
[[nodiscard]] std::vector<double> samples_of(const Waveform& waveform, double duration_s,
                                             double period_s, std::uint64_t trial_seed);

/// The parallel form of a trial, 0 … forms - 1: each as likely. Over whole cycles all forms take
/// the same values at the same speeds, in another order.
[[nodiscard]] int form_of(const Waveform& waveform, std::uint64_t trial_seed);

/// The frequencies in the target; empty: not a sum of sines.
[[nodiscard]] std::vector<double> frequencies_of(const Waveform& waveform, double duration_s);

/// Most lines that a random target may have: beyond, noise is no longer a movement to follow.
inline constexpr double kMostSines = 200.0;

}  // namespace isograsp::tasks
