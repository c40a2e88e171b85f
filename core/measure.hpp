// SPDX-License-Identifier: GPL-3.0-or-later
// One number about one trial, with all that is needed to trust it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace isograsp {

/// Result of one measure (docs/measures.md). A measure that cannot be computed has no value and
/// says why; it is never 0 or NaN as if it were a number.
struct Measure {
  std::string name;     ///< e.g. "rmse"
  std::string channel;  ///< what it was computed from, without unit: "force", "x", "position"
  std::optional<double> value;  ///< in `unit`
  std::string unit;             ///< "N", "s", "%", "" for a dimensionless number
  int version = 1;              ///< raised whenever the same signals could give another value
  std::int64_t samples = 0;     ///< samples used
  std::int64_t excluded = 0;    ///< samples left out: missing, held, saturated
  std::string reason;           ///< why there is no value
  /// From the stored signals, after the trial was scored by an older version.
  bool recomputed = false;

  bool operator==(const Measure&) const = default;
};

}  // namespace isograsp
