// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped people, and a screen for them without sensors: 100 pictures a second, 1 kHz forces.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "virtual_patient/patient_file.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::test {

inline const std::string kPatients = ISOGRASP_SOURCE_DIR "/library/patients";

/// Names of the TOML files of a folder, sorted.
inline std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

inline virtual_patient::PatientTraits shipped(const std::string& name) {
  const std::string path = kPatients + "/" + name + ".toml";
  const auto text = read_text(path);
  EXPECT_TRUE(text) << path;
  const auto patient = virtual_patient::parse_patient(*text, path);
  EXPECT_TRUE(patient) << patient.error().message();
  return patient->traits;
}

/// A person before a screen.
class Played {
 public:
  Played(const virtual_patient::PatientTraits& traits, std::uint64_t seed) : person(traits, seed) {}

  using EachForce = std::function<void(double t_s, const FingerWrenches& wrench_C)>;
  /// Shows `screen` for a while, with its time and the channel's force set; `each` sees every
  /// millisecond, its time counted from the start of this call.
  void show(Stimulus screen, double duration_s, const EachForce& each = {}) {
    const auto steps = static_cast<int>(std::lround(1000.0 * duration_s));
    for (int step = 0; step < steps; ++step, ++ms_) {
      pressed = person.press(0.001 * ms_);
      if (ms_ % 10 == 0) {
        screen.t_s = 0.001 * ms_;
        screen.shown_force_N = force_of(pressed, screen.channel);
        person.see(screen);
      }
      if (each) each(0.001 * step, pressed);
    }
  }
  void show(Cue cue, ForceChannel channel, double duration_s, const EachForce& each = {}) {
    Stimulus screen;
    screen.cue = cue;
    screen.channel = channel;
    show(screen, duration_s, each);
  }
  /// Mean force of a channel [N] over the last `mean_s` of a while.
  double mean_N(const Stimulus& screen, double duration_s, double mean_s) {
    show(screen, duration_s - mean_s);
    double sum = 0.0;
    show(screen, mean_s,
         [&](double, const FingerWrenches& w) { sum += force_of(w, screen.channel); });
    return sum / std::round(1000.0 * mean_s);
  }

  virtual_patient::VirtualPatient person;
  FingerWrenches pressed;

 private:
  int ms_ = 0;
};

inline Stimulus screen_of(Cue cue, ForceChannel channel = {}) {
  Stimulus screen;
  screen.cue = cue;
  screen.channel = channel;
  return screen;
}
inline Stimulus following(ForceChannel channel, double target_N, bool force_shown = true) {
  Stimulus screen = screen_of(Cue::follow, channel);
  screen.force_target_shown = true;
  screen.target_force_N = target_N;
  screen.force_shown = force_shown;
  return screen;
}

/// All channels.
inline std::vector<ForceChannel> every_channel() {
  std::vector<ForceChannel> channels;
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    for (std::size_t direction = 0; direction < kDirectionCount; ++direction)
      channels.push_back({static_cast<Digits>(digits), static_cast<Direction>(direction)});
  return channels;
}

}  // namespace isograsp::test
