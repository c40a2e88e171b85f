// SPDX-License-Identifier: GPL-3.0-or-later
// Markers as a table of this program: t_s, then NAME_x_m, NAME_y_m, NAME_z_m for each marker. Three
// empty fields: the marker was not seen.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/files.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

[[nodiscard]] Result<std::unique_ptr<MarkerReader>> open_marker_csv(const std::string& path);

/// Writes row by row, in constant memory.
class MarkerCsvWriter {
 public:
  [[nodiscard]] static Result<MarkerCsvWriter> create(const std::string& path,
                                                      const std::vector<std::string>& markers);
  void write(double t_s, std::span<const Vec3> p_W);
  /// Without commit() no file is left under the path.
  [[nodiscard]] Result<void> commit();

 private:
  explicit MarkerCsvWriter(FileWriter file) : file_(std::move(file)) {}
  FileWriter file_;
  std::string text_;
};

}  // namespace isograsp
