// SPDX-License-Identifier: GPL-3.0-or-later
// What is heard: soft tones without clicks, a pitch that tells high from low, and nothing where
// nothing is wanted.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "gui/picture/soundtrack.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::sound_test {
namespace {

using Sign = PatientPicture::Sign;

/// Largest change from one sample to the next of a full sine at the highest pitch (880 Hz).
constexpr float kSteepest = 2.0F * 3.15F * 880.0F / kSoundRate_Hz;
constexpr std::size_t kSecond = kSoundRate_Hz;

float steepest(const std::vector<float>& samples) {
  float most = 0.0F;
  for (std::size_t k = 1; k < samples.size(); ++k)
    most = std::max(most, std::abs(samples[k] - samples[k - 1]));
  return most;
}

TEST(Tones, SwellAndFadeWithoutAClick) {
  for (const auto tone : {Tone::begin, Tone::success, Tone::try_again, Tone::reached}) {
    const auto samples = samples_of(tone);
    ASSERT_FALSE(samples.empty());
    constexpr float kSilent = 1e-3F;  // a thousandth of full loudness
    EXPECT_LT(std::abs(samples.front()), kSilent);
    EXPECT_LT(std::abs(samples.back()), kSilent);
    EXPECT_LT(steepest(samples), kSteepest);
    EXPECT_LT(*std::max_element(samples.begin(), samples.end()), 0.6F) << "soft";
    EXPECT_LT(static_cast<double>(samples.size()) / kSoundRate_Hz, 1.0);
  }
}

TEST(ForceTone, IsHigherAboveTheTargetAndLowerBelowIt) {
  for (const double difference : {-3.0, -1.0, -0.2, 0.0, 0.2, 1.0, 3.0}) {
    ForceTone tone;
    std::vector<float> samples;
    tone.play({true, false, difference}, kSecond, samples);
    const double octaves = std::clamp(difference, -1.0, 1.0);
    constexpr double kGlided = 1e-6;  // after 33 times the time of the glide
    EXPECT_WITHIN(tone.pitch_Hz() / (ForceTone::kOnTarget_Hz * std::exp2(octaves)), 1.0, kGlided);
    const auto crossings = std::count_if(samples.begin() + 1, samples.end(), [&](const float& s) {
      return s >= 0.0F && *(&s - 1) < 0.0F;
    });
    constexpr double kGlideAndEnds = 25;  // periods that differ while the pitch glides
    EXPECT_NEAR(static_cast<double>(crossings), tone.pitch_Hz(), kGlideAndEnds);
  }
}

TEST(ForceTone, IsQuietOnTheTargetAndSilentWhenNothingIsHeard) {
  ForceTone tone;
  std::vector<float> samples;
  tone.play({true, false, 0.5}, kSecond, samples);
  EXPECT_WITHIN(tone.loudness(), ForceTone::kLoud, 1e-6);
  tone.play({true, true, 0.0}, kSecond, samples);
  EXPECT_WITHIN(tone.loudness(), ForceTone::kQuiet, 1e-6);
  tone.play({}, kSecond, samples);
  EXPECT_WITHIN(tone.loudness(), 0.0, 1e-6);
  EXPECT_LT(steepest(samples), kSteepest) << "changes glide";
}

PatientPicture with_words(const char* headline) {
  PatientPicture picture;
  picture.headline = headline;
  return picture;
}

TEST(Soundtrack, SoundsOnlyWhatThePatientIsToHear) {
  PatientPicture squeeze = with_words("Squeeze");
  squeeze.urgent = true;
  for (const bool sound : {false, true})
    for (const bool voice : {false, true}) {
      Presentation presentation;
      presentation.sound = sound;
      presentation.voice = voice;
      Soundtrack track;
      (void)track.next(with_words("Relax"), presentation);
      const auto sounds = track.next(squeeze, presentation);
      EXPECT_EQ(sounds.tone.has_value(), sound);
      EXPECT_EQ(sounds.words.has_value(), voice);
      EXPECT_FALSE(track.next(squeeze, presentation).tone.has_value()) << "once";
      EXPECT_FALSE(sounds.force.heard);
    }
}

TEST(Soundtrack, EveryTargetThatIsReachedAndTheEndHaveATone) {
  Presentation presentation;
  presentation.sound = true;
  Soundtrack track;
  PatientPicture picture;
  (void)track.next(picture, presentation);
  picture.targets_reached = 1;
  EXPECT_EQ(track.next(picture, presentation).tone, Tone::reached);
  picture.targets_reached = 0;
  picture.sign = Sign::good;
  EXPECT_EQ(track.next(picture, presentation).tone, Tone::success);
  picture.sign = Sign::rest;
  picture.missed = true;
  EXPECT_EQ(track.next(picture, presentation).tone, Tone::try_again);
}

TEST(Soundtrack, APauseIsSilentButIsSaid) {
  Presentation presentation{Presentation::Half::whole, false, true, true, true};
  Soundtrack track;
  PatientPicture picture = with_words("Follow the line");
  picture.page = PatientPicture::Page::tracking;
  picture.sign = Sign::act;
  picture.force_shown = picture.line_shown = true;
  picture.force_N = 2.0;
  picture.axis = {0.0, 4.0};
  (void)track.next(picture, presentation);
  EXPECT_TRUE(track.next(picture, presentation).force.heard);
  EXPECT_EQ(track.next(picture, presentation).force.difference, 0.5);
  picture.notice = PatientPicture::Notice::pause;
  picture.notice_words = "Pause. Relax your hand.";
  const auto paused = track.next(picture, presentation);
  EXPECT_FALSE(paused.force.heard);
  EXPECT_EQ(paused.words, "Pause. Relax your hand.");
  EXPECT_FALSE(track.next(picture, presentation).words.has_value()) << "once";
}

}  // namespace
}  // namespace isograsp::gui::sound_test
