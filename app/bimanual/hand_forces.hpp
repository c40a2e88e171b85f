// SPDX-License-Identifier: GPL-3.0-or-later
// One hand in a file of forces of two hands (docs/file_formats.md): its net push, or its fingers.
// Columns begin with the side, "left_" or "right_".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bimanual/pads/side.hpp"
#include "core/result.hpp"
#include "hand/finger.hpp"
#include "hand/finger_forces.hpp"

namespace isograsp::app {

/// What one hand does in one row.
struct HandForcesRow {
  double t_s = 0.0;
  /// Net push: forces (and, of fingers, torques about the platform's origin), axes of the view
  /// [N, N m].
  std::optional<Wrench> push_W = std::nullopt;  ///< nothing: no valid sample
  FingerForcesRow fingers;                      ///< if the file has them
  bool clutch = false;                          ///< held
};

/// What must be known of a hand.
struct HandNeeds {
  bool push = false;
  std::array<bool, kFingerCount> fingers{};
};

/// Streams one hand of a table (app/table_files.hpp) in constant memory. Fingers stand as on the
/// platform (device/config/platform.hpp), of the left hand turned by pi about y; their net push is
/// their sum.
class HandForcesReader {
 public:
  /// Pushes and fingers of one hand in one file are an error.
  [[nodiscard]] static Result<HandForcesReader> open(const std::string& path, bimanual::Side side,
                                                     const HandNeeds& needs);
  /// False at the end.
  [[nodiscard]] Result<bool> next(HandForcesRow& row);
  /// Of what it reads, at the row read last.
  [[nodiscard]] Error no_sample() const;

 private:
  HandForcesReader(std::unique_ptr<TableReader> table, bimanual::Side side)
      : table_(std::move(table)), side_(side) {}

  std::unique_ptr<TableReader> table_;
  bimanual::Side side_;
  std::size_t time_ = 0;
  std::array<std::optional<std::size_t>, 3> push_;
  std::optional<std::size_t> clutch_;
  std::optional<FingerForcesReader> fingers_;
  std::vector<double> fields_;
};

/// "left_", "right_".
[[nodiscard]] std::string prefix_of(bimanual::Side side);

}  // namespace isograsp::app
