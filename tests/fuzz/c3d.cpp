// SPDX-License-Identifier: GPL-3.0-or-later
// A C3D file: its head, then its frames. Whatever is read is whole: a position is finite or
// missing.
#include <algorithm>
#include <cmath>
#include <vector>

#include "device/markers/c3d_codec.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> file(data, size);
  const auto start = c3d_data_start(file);
  if (!start || *start > size) return 0;
  const auto layout = parse_c3d_head(file.first(*start));
  if (!layout) return 0;
  fuzz::require(layout->rate_Hz > 0.0 && layout->frame_bytes > 0, "a layout has a rate and frames");
  std::vector<Vec3> p_W(layout->points.size());
  std::size_t at = *start;
  for (std::size_t k = 0; k < layout->frames && size - at >= layout->frame_bytes; ++k) {
    decode_c3d_frame(*layout, file.subspan(at, layout->frame_bytes), p_W);
    at += layout->frame_bytes;
    for (const Vec3& p : p_W)
      fuzz::require(p.allFinite() || (std::isnan(p.x()) && std::isnan(p.y()) && std::isnan(p.z())),
                    "a position is whole or missing");
  }
  return 0;
}
