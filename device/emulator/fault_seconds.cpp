// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/fault_seconds.hpp"

#include <cmath>

#include "core/csv.hpp"

namespace isograsp {

bool parse_fault_jump(std::string_view text, double& seconds) {
  double unit = 1.0;
  if (text.ends_with("ms")) {
    unit = 1e-3;
    text.remove_suffix(2);
  } else if (text.ends_with('s')) {
    text.remove_suffix(1);
  }
  constexpr double kLongest = 1e6;
  if (!parse_number(text, seconds) || !(std::abs(seconds) <= kLongest)) return false;
  seconds *= unit;
  return true;
}

bool parse_fault_seconds(std::string_view text, double& seconds) {
  return parse_fault_jump(text, seconds) && seconds >= 0.0;
}

}  // namespace isograsp
