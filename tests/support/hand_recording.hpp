// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a hand that is at rest for eleven seconds, then opens and closes once in five.
#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "device/hand/hand_csv.hpp"
#include "tests/support/must.hpp"
#include "tests/support/scripted_hand.hpp"

namespace isograsp::test {

/// Returns `path`.
inline std::string write_hand_recording(const std::string& path, double duration_s,
                                        double rest_s = 11.0, Hand side = Hand::right) {
  auto writer = must(HandCsvWriter::create(path));
  const auto hand = usual_hand(side);
  constexpr double kRate_Hz = 90.0;
  constexpr double kCycle_s = 5.0;
  for (int k = 0; k < duration_s * kRate_Hz; ++k) {
    const double t_s = k / kRate_Hz;
    const double turn = 2.0 * std::numbers::pi * std::max(0.0, t_s - rest_s) / kCycle_s;
    HandFrame frame = picture_of(hand, hand_posture(0.5 - 0.4 * std::cos(turn), t_s));
    frame.t_s = t_s;
    writer.write(frame);
  }
  must(writer.commit());
  return path;
}

}  // namespace isograsp::test
