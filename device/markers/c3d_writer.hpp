// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of markers as a C3D file (c3d.org): points only, byte order of Intel, lengths in mm,
// floats or integers. Nothing in it says who, when or where.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

enum class C3dNumbers : std::uint8_t {
  floats,   ///< single precision
  integers  ///< 16 bits, in steps of the largest coordinate / 32000
};

/// What must be known of a recording before its first frame is written.
struct C3dRecording {
  std::vector<std::string> markers;
  std::size_t frames = 0;
  double rate_Hz = 0.0;
  double largest_m = 0.0;  ///< of all coordinates, without sign
  C3dNumbers numbers = C3dNumbers::floats;
};

/// The file up to its data. Errors (without a file): a label of more than 127 bytes, more labels
/// than a head can hold, no rate.
[[nodiscard]] Result<std::string> c3d_head(const C3dRecording& recording);
/// Appends one frame. A marker that was not seen (NaN) has the residual -1, one that was seen 0:
/// how well a camera saw it is not known. @pre p_W.size() == recording.markers.size(), no
/// coordinate above largest_m
void append_c3d_frame(std::string& bytes, const C3dRecording& recording, std::span<const Vec3> p_W);

/// The recording at `in`, of any format that open_markers() reads, as a C3D file. It is read twice;
/// only its times are kept. C3D has a rate and no times: the first row is time 0, rows must lie on
/// a grid, and what is missing in it becomes frames without a marker. Errors: also that they do
/// not.
[[nodiscard]] Result<void> convert_to_c3d(const std::string& in, const std::string& out,
                                          C3dNumbers numbers);

}  // namespace isograsp
