// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/marker_reader.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "core/files.hpp"
#include "device/markers/c3d_file.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/text_markers.hpp"

namespace isograsp {

std::string_view without_subject(std::string_view label) noexcept {
  if (const auto colon = label.rfind(':'); colon != std::string_view::npos)
    label.remove_prefix(colon + 1);
  const auto first = label.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return label.substr(first, label.find_last_not_of(' ') - first + 1);
}

Result<void> check_labels(const std::vector<std::string>& labels, const std::string& path) {
  if (labels.empty())
    return refused("names no marker"_text, "label the markers before the export"_text).at(path);
  if (labels.size() > MarkerReader::kMostMarkers)
    return refused("names %1 markers"_text(labels.size()),
                   "give at most %1"_text(MarkerReader::kMostMarkers))
        .at(path);
  std::set<std::string> seen;
  for (const std::string& label : labels) {
    if (label.empty() || label.find_first_of(",\"\n\r") != std::string::npos)
      return refused("marker '%1' has no name for a table"_text(label),
                     "rename it, without commas and quotes"_text)
          .at(path);
    if (!seen.insert(label).second)
      return refused("marker '%1' appears twice"_text(label), "keep one of them"_text).at(path);
  }
  return {};
}

Result<std::unique_ptr<MarkerReader>> open_markers(const std::string& path) {
  auto file = InputFile::open(path);
  if (!file) return file.error();
  std::array<char, 16> first{};
  const auto count = file->read(first);
  if (count < 0) return failed("cannot be read"_text, "check the disk"_text).at(path);
  const std::string_view text(first.data(), static_cast<std::size_t>(count));
  constexpr char kC3dMark = 0x50;
  if (text.size() > 1 && text[1] == kC3dMark && text[0] > 0 && text[0] < ' ') return open_c3d(path);
  if (text.starts_with("PathFileType")) return open_trc(path);
  if (text.starts_with("NO_OF_FRAMES")) return open_qualisys_tsv(path);
  return open_marker_csv(path);
}

}  // namespace isograsp
