// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the virtual hand share: reference hands, poses and tables.
#pragma once

#include <string>

#include "core/files.hpp"
#include "tests/support/golden_table.hpp"
#include "virtual_hand/hand_pose.hpp"

namespace isograsp::test {

inline std::string hand_data(const std::string& name) {
  return std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/hand/" + name;
}
inline virtual_hand::HandModel golden_hand(const std::string& name) {
  return must(virtual_hand::parse_hand(must(read_text(hand_data(name + ".toml"))), name));
}
inline Vec3 three_in(const Fields& row, const std::string& prefix, const std::string& ending = "") {
  return {number_in(row, prefix + "x" + ending), number_in(row, prefix + "y" + ending),
          number_in(row, prefix + "z" + ending)};
}
inline Quat quaternion_in(const Fields& row, const std::string& prefix) {
  return Quat(number_in(row, prefix + "w"), number_in(row, prefix + "x"),
              number_in(row, prefix + "y"), number_in(row, prefix + "z"))
      .normalized();
}
inline std::array<virtual_hand::DigitAngles, kDigitCount> angles_in(const Fields& row) {
  std::array<virtual_hand::DigitAngles, kDigitCount> angles{};
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t a = 0; a < virtual_hand::kAngleCount; ++a)
      angles[d][a] = number_in(row, std::string(kDigitNames[d]) + "_" +
                                        std::string(virtual_hand::kDigitAngleNames[a]) + "_rad");
  return angles;
}

}  // namespace isograsp::test
