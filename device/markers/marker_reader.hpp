// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of markers, row by row: positions [m] in the frame of the cameras. A marker that was
// not seen is NaN in all three places, whatever the format writes for it.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

class MarkerReader {
 public:
  /// Most markers of a recording.
  static constexpr std::size_t kMostMarkers = 3000;

  MarkerReader() = default;
  virtual ~MarkerReader() = default;
  MarkerReader(const MarkerReader&) = delete;
  MarkerReader& operator=(const MarkerReader&) = delete;

  /// Labels, without the "subject:" that some systems write in front.
  [[nodiscard]] const std::vector<std::string>& markers() const noexcept { return markers_; }
  /// The file says of itself that software made it: reports of it carry a watermark.
  [[nodiscard]] bool simulated() const noexcept { return simulated_; }
  /// The next row; false at the end. Times [s] increase strictly. Errors name the file and, of a
  /// text, the line. @pre p_W.size() == markers().size()
  [[nodiscard]] virtual Result<bool> next(double& t_s, std::span<Vec3> p_W) = 0;

 protected:
  std::vector<std::string> markers_;
  bool simulated_ = false;
};

/// Opens a recording; its first bytes say of which format it is: C3D, TRC, a table of Qualisys
/// (TSV), else a table of this program (CSV).
[[nodiscard]] Result<std::unique_ptr<MarkerReader>> open_markers(const std::string& path);

/// "Daphnee:EPICl" -> "EPICl", without blanks around it.
[[nodiscard]] std::string_view without_subject(std::string_view label) noexcept;
/// Labels that can stand in a table: not empty, each once, not too many. Errors name the file.
[[nodiscard]] Result<void> check_labels(const std::vector<std::string>& labels,
                                        const std::string& path);
[[nodiscard]] inline Vec3 unseen_marker() noexcept {
  return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
}
/// Of a format in which the origin, exactly, stands for a marker that was not seen.
[[nodiscard]] inline Vec3 unseen_at_origin(const Vec3& p) noexcept {
  return p == Vec3::Zero() || !p.allFinite() ? unseen_marker() : p;
}

}  // namespace isograsp
