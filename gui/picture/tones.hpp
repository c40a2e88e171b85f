// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient's screen sounds like, as samples: soft tones for begin, success and another try,
// and a tone that says how a force stands to its target. Pure: no device, no clock. Gentle: every
// tone swells and fades, nothing is sudden.
#pragma once

#include <cstdint>
#include <vector>

namespace isograsp::gui {

inline constexpr int kSoundRate_Hz = 44100;

enum class Tone : std::uint8_t {
  begin,      ///< one short tone
  success,    ///< two, the second higher
  try_again,  ///< two, the second lower, softer
  reached     ///< one short, high: a target of several
};

/// Mono samples within ±1 at kSoundRate_Hz; begins and ends at 0.
[[nodiscard]] std::vector<float> samples_of(Tone tone);

/// Where a force stands, for the ear.
struct HeardForce {
  bool heard = false;
  bool on_target = false;
  /// Of force less target, of the range of the trial's targets; what is beyond ±1 sounds like ±1.
  double difference = 0.0;
};

/// A steady tone that is higher while the force is above its target and lower below it, up to an
/// octave, and quiet on it. Pitch and loudness glide: no clicks.
class ForceTone {
 public:
  /// Appends `count` samples.
  void play(const HeardForce& force, std::size_t count, std::vector<float>& samples);
  /// [Hz] of the last sample.
  [[nodiscard]] double pitch_Hz() const noexcept { return pitch_Hz_; }
  [[nodiscard]] double loudness() const noexcept { return loudness_; }

  static constexpr double kOnTarget_Hz = 440.0;
  static constexpr double kLoud = 0.30;
  static constexpr double kQuiet = 0.08;

 private:
  double phase_rad_ = 0.0;
  double pitch_Hz_ = kOnTarget_Hz;
  double loudness_ = 0.0;
};

}  // namespace isograsp::gui
