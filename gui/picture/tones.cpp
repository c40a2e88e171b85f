// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/tones.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace isograsp::gui {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kSoft = 0.5;
constexpr double kSofter = 0.3;
/// Time in which pitch and loudness of the force come 63 % nearer to where they should be.
constexpr double kGlide_s = 0.03;

struct Note {
  double pitch_Hz;
  double duration_s;
  double loudness;
};

/// A sine under a raised cosine.
void append(const Note& note, std::vector<float>& samples) {
  const auto count = static_cast<std::size_t>(note.duration_s * kSoundRate_Hz);
  for (std::size_t k = 0; k < count; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(count - 1);
    const double swell = 0.5 - 0.5 * std::cos(kTwoPi * part);
    const double t_s = static_cast<double>(k) / kSoundRate_Hz;
    samples.push_back(
        static_cast<float>(note.loudness * swell * std::sin(kTwoPi * note.pitch_Hz * t_s)));
  }
}

std::vector<Note> notes_of(Tone tone) {
  switch (tone) {
    case Tone::begin: return {{523.25, 0.25, kSoft}};
    case Tone::success: return {{523.25, 0.22, kSoft}, {783.99, 0.40, kSoft}};
    case Tone::try_again: return {{392.00, 0.25, kSofter}, {329.63, 0.40, kSofter}};
    case Tone::reached: return {{783.99, 0.20, kSoft}};
  }
  return {};
}

}  // namespace

std::vector<float> samples_of(Tone tone) {
  std::vector<float> samples;
  for (const Note& note : notes_of(tone)) append(note, samples);
  return samples;
}

void ForceTone::play(const HeardForce& force, std::size_t count, std::vector<float>& samples) {
  const double wanted_Hz = kOnTarget_Hz * std::exp2(std::clamp(force.difference, -1.0, 1.0));
  const double wanted_loudness = !force.heard ? 0.0 : force.on_target ? kQuiet : kLoud;
  constexpr double kStep = 1.0 / (kGlide_s * kSoundRate_Hz);
  for (std::size_t k = 0; k < count; ++k) {
    if (force.heard) pitch_Hz_ += kStep * (wanted_Hz - pitch_Hz_);
    loudness_ += kStep * (wanted_loudness - loudness_);
    phase_rad_ = std::fmod(phase_rad_ + kTwoPi * pitch_Hz_ / kSoundRate_Hz, kTwoPi);
    samples.push_back(static_cast<float>(loudness_ * std::sin(phase_rad_)));
  }
}

}  // namespace isograsp::gui
