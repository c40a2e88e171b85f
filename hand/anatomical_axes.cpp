// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/anatomical_axes.hpp"

#include <algorithm>

namespace isograsp {

Vec3 anatomical(const Vec3& force_C, Finger finger, Hand hand) noexcept {
  // Adding 0 turns the -0 of a turned zero into 0.
  return {force_C.z(), force_C.x(), distal_sign(finger, hand) * force_C.y() + 0.0};
}

const Column& anatomical_column(Finger finger, HandAxis axis) noexcept {
  return columns::hand_force[index_of(finger)][static_cast<std::size_t>(axis)];
}

void add_anatomical_forces(Signals& signals, Hand hand) {
  for (const Finger finger : kFingers) {
    const columns::OfAxes& from = columns::finger_force[index_of(finger)];
    const bool known =
        std::all_of(from.begin(), from.end(), [&](const auto& c) { return signals.has(c); });
    const bool present = std::any_of(kHandAxes.begin(), kHandAxes.end(), [&](HandAxis axis) {
      return signals.has(anatomical_column(finger, axis));
    });
    if (!known || present) continue;
    std::array<std::vector<double>, 3> to;
    for (auto& column : to) column.reserve(signals.rows());
    for (std::size_t row = 0; row < signals.rows(); ++row) {
      const Vec3 force_C(signals.column(from[0])[row], signals.column(from[1])[row],
                         signals.column(from[2])[row]);
      const Vec3 force = anatomical(force_C, finger, hand);
      for (const HandAxis axis : kHandAxes) {
        const auto a = static_cast<std::size_t>(axis);
        to[a].push_back(force[static_cast<Eigen::Index>(a)]);
      }
    }
    for (const HandAxis axis : kHandAxes)
      signals.add_column(anatomical_column(finger, axis),
                         std::move(to[static_cast<std::size_t>(axis)]));
  }
}

}  // namespace isograsp
