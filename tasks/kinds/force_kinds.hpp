// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of tasks about force alone, as a task file says them (docs/file_formats.md). Levels are
// numbers in the unit of the aim's scale. SI units.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hand/force_channel.hpp"

namespace isograsp::tasks {

/// What the number 1 of a level stands for.
enum class Scale : std::uint8_t {
  newton,          ///< 1 N
  of_maximum,      ///< the maximum of the same channel in this session
  of_comfortable,  ///< the comfortable force of the same channel in this session
  of_baseline      ///< the maximum of the patient's first assessments: the same load every time
};

/// Which force follows the target, and how both are shown.
struct Aim {
  ForceChannel channel;
  Scale scale = Scale::of_maximum;
  double band_fraction = 0.05;  ///< of the target: half the width of the band that counts as on it
  bool force_shown = true;      ///< feedback: the own force is on the screen
  double preview_s = 0.0;       ///< how much of the target's future is on the screen
  /// Visual gain [deg of visual angle per unit of the scale]; nothing: the screen fits the target.
  std::optional<double> gain_deg;
  double viewing_distance_m = 0.6;
};

/// Hand in, relaxed: the resting force of each finger is measured and stored, never subtracted.
struct RestSpec {
  double duration_s = 10.0;
};

/// One attempt at a force as large as possible, or as large as is comfortable.
struct MaximumSpec {
  ForceChannel channel;
  bool comfortable = false;
  double lead_in_s = 1.0;
  double squeeze_s = 3.0;
  double window_s = 0.5;    ///< best moving mean over this window counts
  bool force_shown = true;  ///< a live bar
};

/// Every named digit in every named direction, one after the other.
struct DirectionalMaximaSpec {
  std::vector<Finger> digits;
  std::vector<Direction> directions;
  double lead_in_s = 1.0;
  double push_s = 3.0;
  double rest_s = 3.0;  ///< relaxed, after each
  double window_s = 0.5;
};

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

/// The force follows a target between two levels.
struct ForceTrackingSpec {
  Aim aim;
  Waveform waveform;
  double least = 0.1;
  double most = 0.3;
  double lead_in_s = 2.0;    ///< constant at the first value of the target; not scored
  double duration_s = 30.0;  ///< of the target after it
};

/// Levels held one after the other; the spread of the force around its trend is what counts.
struct SteadinessSpec {
  Aim aim;
  std::vector<double> levels{0.05, 0.25};
  double rise_s = 3.0;    ///< ramp to the level, not scored
  double settle_s = 2.0;  ///< on the level, not scored
  double hold_s = 12.0;
  double rest_s = 5.0;  ///< relaxed, after each level
};

/// From one level to another at once, after a wait that cannot be foreseen.
struct StepResponseSpec {
  Aim aim;
  double from = 0.1;
  std::vector<double> to{0.3};
  double least_wait_s = 1.0;
  double most_wait_s = 3.0;
  double hold_s = 4.0;
  int repetitions = 3;  ///< of every level
};

/// A grip is held and let go on cue; perhaps the hand opens then.
struct GripReleaseSpec {
  Aim aim;
  double level = 0.25;
  double rise_s = 2.0;        ///< time to come to the level
  double least_wait_s = 1.0;  ///< on the level: a foreperiod that cannot be foreseen
  double most_wait_s = 3.0;
  double after_s = 6.0;  ///< relaxed after the cue: release is measured
  bool open = false;     ///< the cue is "open": force against the straps
  int repetitions = 5;
};

/// A force is felt with feedback and made again without.
struct ForceSenseSpec {
  Aim aim;
  double level = 0.2;
  double learn_s = 5.0;
  double pause_s = 3.0;
  double reproduce_s = 5.0;
  double window_s = 2.0;  ///< the end of the reproduction that counts
  int repetitions = 3;
};

/// A level is held for as long as asked.
struct FatigueSpec {
  Aim aim;
  double level = 0.5;
  double rise_s = 2.0;
  double hold_s = 30.0;
};

/// One digit presses, the others are watched.
struct IndividuationSpec {
  Aim aim;  ///< its channel is not used: each digit in turn
  std::vector<Finger> digits{Finger::thumb, Finger::index, Finger::middle};
  std::vector<double> levels{0.2};
  double rest_s = 1.5;  ///< before each: the forces from which changes count
  double rise_s = 1.5;
  double hold_s = 2.0;
  int repetitions = 3;
};

/// Forces of given size and direction, for one digit or several at once.
struct ForceDirectionTarget {
  std::array<bool, kFingerCount> asked{};
  std::array<Vec3, kFingerCount> direction_C{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< unit
  double level = 0.2;
};
struct ForceDirectionSpec {
  Aim aim;  ///< its channel is not used
  std::vector<ForceDirectionTarget> targets;
  double rise_s = 2.0;
  double hold_s = 3.0;
  double rest_s = 2.0;
  int repetitions = 1;
};

}  // namespace isograsp::tasks
