// SPDX-License-Identifier: GPL-3.0-or-later
// A recording of markers as text (TRC, TSV of Qualisys, CSV): times increase, a position is whole
// or missing, and the table of what was read gives the same rows again.
#include <cmath>
#include <utility>
#include <vector>

#include "core/csv.hpp"
#include "device/markers/marker_csv.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

struct MarkerRows {
  std::vector<std::string> markers;
  std::vector<std::pair<double, std::vector<Vec3>>> rows;
};

/// Up to its end, or to what cannot be read.
MarkerRows read_all(MarkerReader& reader, std::string_view text) {
  MarkerRows read{reader.markers(), {}};
  std::vector<Vec3> p_W(read.markers.size());
  for (double t_s = 0.0;;) {
    const auto more = reader.next(t_s, p_W);
    if (!more) fuzz::require_helpful(more.error(), text);
    if (!more || !*more) return read;
    fuzz::require(std::isfinite(t_s) && (read.rows.empty() || t_s > read.rows.back().first),
                  "times increase");
    for (const Vec3& p : p_W)
      fuzz::require(p.allFinite() || (std::isnan(p.x()) && std::isnan(p.y()) && std::isnan(p.z())),
                    "a position is whole or missing");
    read.rows.emplace_back(t_s, p_W);
  }
}

void require_same(const MarkerRows& a, const MarkerRows& b) {
  fuzz::require(a.markers == b.markers && a.rows.size() == b.rows.size(), "no row is lost");
  for (std::size_t row = 0; row < a.rows.size(); ++row) {
    fuzz::require(fuzz::same_bits(a.rows[row].first, b.rows[row].first), "a time comes back");
    for (std::size_t m = 0; m < a.markers.size(); ++m)
      for (int axis = 0; axis < 3; ++axis) {
        const double here = a.rows[row].second[m][axis];
        const double there = b.rows[row].second[m][axis];
        fuzz::require(fuzz::same_bits(here, there) || (std::isnan(here) && std::isnan(there)),
                      "a position comes back");
      }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const std::string_view text = fuzz::as_text(data, size);
  file.write(text);
  auto reader = open_markers(file.path());
  if (!reader) {
    fuzz::require_helpful(reader.error(), text);
    return 0;
  }
  const MarkerRows read = read_all(**reader, text);
  if (read.rows.empty()) return 0;
  std::string table = "t_s";
  for (const std::string& name : read.markers)
    for (const char* axis : {"_x_m", "_y_m", "_z_m"}) table += "," + without_formula(name + axis);
  table += "\n";
  for (const auto& [t_s, p_W] : read.rows) {
    table += format_number(t_s);
    for (const Vec3& p : p_W)
      for (int axis = 0; axis < 3; ++axis)
        table += "," + (std::isnan(p[axis]) ? std::string() : format_number(p[axis]));
    table += "\n";
  }
  file.write(table);
  auto again = open_marker_csv(file.path());
  fuzz::require(again.ok(), "what was read can be written and read");
  require_same(read, read_all(**again, table));
  return 0;
}
