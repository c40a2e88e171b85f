// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/kinds/ only: what KindFacts asks of any kind, from what is written for one.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

template <auto kFunction>
struct OfKind;
template <class R, class Spec, class... More, R (*kFunction)(const Spec&, More...)>
struct OfKind<kFunction> {
  static R call(const KindSpec& kind, More... more) {
    return kFunction(kind.as<Spec>(), std::forward<More>(more)...);
  }
};
/// A function of the spec of one kind as KindFacts has it: `.duration = of_kind<rest_duration>`.
template <auto kFunction>
inline constexpr auto of_kind = &OfKind<kFunction>::call;

// For specs with members of these names.

template <class Spec>
const Aim* own_aim(const KindSpec& kind) {
  return &kind.as<Spec>().aim;
}
template <class Spec>
std::string own_scene(const KindSpec& kind) {
  return kind.as<Spec>().scene;
}
template <class Spec>
double own_level(const KindSpec& kind) {
  return std::abs(kind.as<Spec>().level);
}

/// The largest size of a level.
[[nodiscard]] inline double largest(const std::vector<double>& levels) {
  double most = 0.0;
  for (const double level : levels) most = std::max(most, std::abs(level));
  return most;
}

/// KindFacts::multiply, of what the spec has.
template <class Spec>
bool multiply(KindSpec& kind, Difficulty::Factor factor, double by) {
  using Factor = Difficulty::Factor;
  Spec& task = kind.as<Spec>();
  if constexpr (requires { task.position_tolerance_m; }) {
    if (factor == Factor::tolerance) {
      task.position_tolerance_m *= by;
      task.angle_tolerance_rad *= by;
      return true;
    }
  }
  if constexpr (requires { task.targets.front().p_WT; }) {
    if (factor == Factor::distance) {
      for (auto& target : task.targets) target.p_WT *= by;
      return true;
    }
  }
  if constexpr (requires { task.affected_share; }) {
    if (factor == Factor::affected_share) {
      task.affected_share *= by;
      return true;
    }
  }
  if constexpr (requires { task.waveform; }) {
    if (factor == Factor::frequency) {
      task.waveform.frequency_Hz *= by;
      return true;
    }
  }
  if constexpr (requires {
                  task.most;
                  task.least;
                }) {
    if (factor == Factor::level) {
      task.most *= by;
      task.least *= by;
      return true;
    }
  } else if constexpr (requires { task.level; }) {
    if (factor == Factor::level) {
      task.level *= by;
      return true;
    }
  }
  return false;
}

}  // namespace isograsp::tasks
