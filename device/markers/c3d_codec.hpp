// SPDX-License-Identifier: GPL-3.0-or-later
// The C3D format (c3d.org) as far as it holds positions of points: what the head of a file says,
// and one frame of its data. Pure: bytes in, values out. Only the byte order of Intel processors.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

/// Bytes of a block; everything in a file begins at one.
inline constexpr std::size_t kC3dBlock = 512;

/// Where the data begin [bytes from the start of the file], by the first block. Errors: no C3D
/// file.
[[nodiscard]] Result<std::size_t> c3d_data_start(std::span<const std::uint8_t> first_block);

struct C3dPoint {
  std::size_t index = 0;  ///< in the frame
  std::string label;
};

struct C3dLayout {
  std::vector<C3dPoint> points;  ///< those that have a label
  std::size_t frames = 0;
  std::size_t frame_bytes = 0;  ///< points, then analog samples, which are passed over
  double rate_Hz = 0.0;
  bool floating = false;
  double scale_m = 1.0;  ///< from a number of the file to metres
};

/// `head` is the file up to its data. Errors carry no file.
[[nodiscard]] Result<C3dLayout> parse_c3d_head(std::span<const std::uint8_t> head);

/// Positions [m] of layout.points in one frame. Not seen: a residual below zero, the exact origin,
/// or no number. @pre frame.size() == layout.frame_bytes, p_W.size() == layout.points.size()
void decode_c3d_frame(const C3dLayout& layout, std::span<const std::uint8_t> frame,
                      std::span<Vec3> p_W) noexcept;

}  // namespace isograsp
