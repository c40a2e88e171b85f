// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a trial on the platform, and a row of it, without a trial.
#pragma once

#include <string>
#include <vector>

#include "session/platform/platform_row.hpp"

namespace isograsp::test {

/// A frame in which nothing happens.
struct StillFrame {
  FingerFrame forces;
  session::NetPush push;
  tasks::SpecialView special;
  session::TrialConstants constants;
  ObjectState object;
  GraspWrench grasp;
  [[nodiscard]] session::PlatformFrame seen(bool with_object) const {
    return {forces, push, special, constants, with_object ? &object : nullptr, grasp};
  }
};

/// Their names, group by group.
inline std::vector<std::string> platform_columns(bool with_object) {
  const StillFrame still;
  std::vector<std::string> names;
  for (const auto& group : columns_of(still.seen(with_object)))
    names.insert(names.end(), group.columns.begin(), group.columns.end());
  return names;
}

}  // namespace isograsp::test
