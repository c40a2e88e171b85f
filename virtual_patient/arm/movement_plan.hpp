// SPDX-License-Identifier: GPL-3.0-or-later
// How the joints move: a sum of movements with least jerk, each of which may begin while others
// last (superposition: Flash, Henis 1991). So there is never a jump of speed.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "virtual_patient/arm/arm_body.hpp"

namespace isograsp::virtual_patient {

class MovementPlan {
 public:
  /// The arm stands still at `q`.
  void stand(const Joints& q) noexcept;
  /// Every joint goes on by its part of `way` from start_s on, later by lag · duration; lag >= 0.
  /// Real-time safe.
  void add(const Joints& way, const Joints& lag, double start_s, double duration_s) noexcept;

  /// Where the joints are at a time up to kLookBack_s before the last movement was added.
  [[nodiscard]] Joints at(double t_s) const noexcept;
  /// Where they come to rest.
  [[nodiscard]] const Joints& end() const noexcept { return end_; }
  /// When all of them stand, and when the last movement began; before the first: minus infinity.
  [[nodiscard]] double ends_s() const noexcept { return ends_s_; }
  [[nodiscard]] double began_s() const noexcept { return began_s_; }

  static constexpr double kLookBack_s = 2.0;

 private:
  struct Part {
    Joints way = Joints::Zero();
    Joints lag = Joints::Zero();
    double start_s = 0.0;
    double duration_s = 1.0;
    double ends_s = 0.0;
  };
  static constexpr std::size_t kMostParts = 16;
  static constexpr double kNever_s = -std::numeric_limits<double>::infinity();

  Joints before_ = Joints::Zero();  ///< of movements long over
  Joints end_ = Joints::Zero();
  std::array<Part, kMostParts> parts_;  ///< in the order in which they began
  std::size_t count_ = 0;
  double began_s_ = kNever_s;
  double ends_s_ = kNever_s;
};

}  // namespace isograsp::virtual_patient
