// SPDX-License-Identifier: GPL-3.0-or-later
// First block, 16-bit words from 1: 1 block of the parameters (low byte) and 0x50, 2 points, 3
// analog values of a frame, 4 and 5 first and last frame, 7-8 scale (float, below zero: the data
// are floats), 9 block of the data, 11-12 rate (float). Parameters: 4 bytes (the third: blocks, the
// fourth: 84 for Intel), then records
//   length of the name (below zero: locked), group (below zero: the record names a group), name,
//   16-bit offset from here to the next record (0: the last one), then of a parameter
//   type (-1 text, 1 byte, 2 integer, 4 float), dimensions, their sizes, the values
// A point in a frame: x, y, z and a fourth word whose sign says whether it was seen.
#include "device/markers/c3d_codec.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "device/markers/little_endian.hpp"

namespace isograsp {

namespace {

constexpr std::uint8_t kC3dMark = 0x50;
constexpr std::uint8_t kIntel = 84;
constexpr Words kWholeFile = "give a whole C3D file"_text;

struct C3dParameter {
  int type = 0;
  std::vector<std::size_t> dimensions;
  std::span<const std::uint8_t> values;

  [[nodiscard]] std::size_t count() const noexcept {
    return values.size() / static_cast<std::size_t>(std::abs(type));
  }
  [[nodiscard]] std::optional<double> number(std::size_t i = 0) const noexcept {
    if (i >= count()) return std::nullopt;
    switch (type) {
      case 1: return values[i];
      case 2: return little_endian<std::uint16_t>(values, 2 * i);
      case 4: return static_cast<double>(little_endian_float(values, 4 * i));
      default: return std::nullopt;
    }
  }
  /// Texts of equal length, one behind the other.
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> all;
    if (type != -1 || dimensions.empty() || dimensions[0] == 0) return all;
    for (std::size_t at = 0; at + dimensions[0] <= values.size(); at += dimensions[0])
      all.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(at),
                       values.begin() + static_cast<std::ptrdiff_t>(at + dimensions[0]));
    return all;
  }
};

/// By "GROUP:NAME", in capitals.
using C3dParameters = std::map<std::string, C3dParameter>;

std::string capitals(std::span<const std::uint8_t> bytes) {
  std::string text(bytes.begin(), bytes.end());
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

Result<C3dParameter> parse_parameter(std::span<const std::uint8_t> record) {
  const Error broken = refused("a parameter of it is broken"_text, kWholeFile);
  if (record.size() < 2) return broken;
  C3dParameter parameter;
  parameter.type = static_cast<std::int8_t>(record[0]);
  if (parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4)
    return broken;
  const std::size_t dimensions = record[1];
  if (dimensions > 7 || record.size() < 2 + dimensions) return broken;
  std::size_t size = static_cast<std::size_t>(std::abs(parameter.type));
  for (std::size_t d = 0; d < dimensions; ++d) {
    parameter.dimensions.push_back(record[2 + d]);
    size *= record[2 + d];
    if (size > record.size()) return broken;
  }
  if (record.size() < 2 + dimensions + size) return broken;
  parameter.values = record.subspan(2 + dimensions, size);
  return parameter;
}

/// Reads records from `at` on, until one has no offset to a next record.
Result<C3dParameters> parse_parameters(std::span<const std::uint8_t> head, std::size_t at) {
  std::map<int, std::string> groups;
  std::vector<std::pair<int, std::pair<std::string, C3dParameter>>> found;
  while (at + 2 < head.size()) {
    const int length = std::abs(static_cast<int>(static_cast<std::int8_t>(head[at])));
    const int group = static_cast<std::int8_t>(head[at + 1]);
    if (length == 0) break;
    const std::size_t behind = at + 2 + static_cast<std::size_t>(length);
    if (behind + 2 > head.size()) return refused("its parameters end within one"_text, kWholeFile);
    const std::string name = capitals(head.subspan(at + 2, static_cast<std::size_t>(length)));
    const std::size_t step = little_endian<std::uint16_t>(head, behind);
    if (group < 0) {
      groups[-group] = name;
    } else if (name != "DESCRIPTIONS") {
      auto parameter = parse_parameter(head.subspan(behind + 2));
      if (!parameter) return parameter.error();
      found.push_back({group, {name, std::move(*parameter)}});
    }
    if (step == 0) break;
    at = behind + step;
  }
  C3dParameters parameters;
  for (auto& [group, named] : found)
    parameters[groups[group] + ":" + named.first] = std::move(named.second);
  return parameters;
}

std::optional<double> number_of(const C3dParameters& parameters, const std::string& name,
                                std::size_t i = 0) {
  const auto at = parameters.find(name);
  return at == parameters.end() ? std::nullopt : at->second.number(i);
}

std::string_view trimmed_label(std::string_view text) {
  constexpr std::string_view kBlanks("\0 \t\r\n", 5);
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// POINT:LABELS, LABELS2, …
std::vector<C3dPoint> labelled_points(const C3dParameters& parameters, std::size_t points) {
  std::vector<std::string> labels;
  for (int part = 1;; ++part) {
    const auto at = parameters.find("POINT:LABELS" + (part == 1 ? "" : std::to_string(part)));
    if (at == parameters.end()) break;
    for (std::string& label : at->second.texts()) labels.push_back(std::move(label));
  }
  std::vector<C3dPoint> named;
  for (std::size_t k = 0; k < points && k < labels.size(); ++k)
    if (const auto label = trimmed_label(labels[k]); !label.empty())
      named.push_back({k, std::string(label)});
  return named;
}

/// Frames of the trial: a 16-bit count of the first block overflows within minutes.
std::size_t frame_count(std::span<const std::uint8_t> head, const C3dParameters& parameters) {
  const auto field = [&parameters](const std::string& name) -> std::optional<double> {
    const auto low = number_of(parameters, name, 0);
    const auto high = number_of(parameters, name, 1);
    if (!low || !high) return std::nullopt;
    return *low + 65536.0 * *high;
  };
  double frames = 1.0 + little_endian<std::uint16_t>(head, 8) -
                  static_cast<double>(little_endian<std::uint16_t>(head, 6));
  constexpr double kOverflown = 65535.0;  // what writers store for a count that does not fit
  if (const auto stored = number_of(parameters, "POINT:FRAMES");
      stored && *stored > frames && *stored != kOverflown)
    frames = *stored;
  const auto first = field("TRIAL:ACTUAL_START_FIELD");
  const auto last = field("TRIAL:ACTUAL_END_FIELD");
  if (first && last && *last >= *first) frames = *last - *first + 1.0;
  constexpr double kMostFrames = 4e9;
  return std::isfinite(frames) && frames > 0.0 && frames < kMostFrames
             ? static_cast<std::size_t>(frames)
             : 0;
}

Result<double> metres_in(const C3dParameters& parameters) {
  const auto at = parameters.find("POINT:UNITS");
  const auto units = at == parameters.end() ? std::vector<std::string>() : at->second.texts();
  const std::string unit(trimmed_label(units.empty() ? std::string_view() : units[0]));
  if (unit == "mm" || unit.empty()) return 1e-3;
  if (unit == "cm") return 1e-2;
  if (unit == "m") return 1.0;
  return refused("its lengths are in '%1'"_text(unit), "export them in m, cm or mm"_text);
}

}  // namespace

Result<std::size_t> c3d_data_start(std::span<const std::uint8_t> first_block) {
  if (first_block.size() < kC3dBlock || first_block[1] != kC3dMark || first_block[0] == 0)
    return refused("is no C3D file"_text, kWholeFile);
  const std::size_t parameters = (first_block[0] - std::size_t{1}) * kC3dBlock;
  const std::size_t data = little_endian<std::uint16_t>(first_block, 16);
  if (data < 2 || (data - 1) * kC3dBlock <= parameters)
    return refused("its data do not begin behind its parameters"_text, kWholeFile);
  return (data - 1) * kC3dBlock;
}

Result<C3dLayout> parse_c3d_head(std::span<const std::uint8_t> head) {
  const auto start = c3d_data_start(head);
  if (!start) return start.error();
  if (head.size() < *start) return refused("ends before its data"_text, kWholeFile);
  const std::size_t section = (head[0] - std::size_t{1}) * kC3dBlock;
  if (section + 4 > head.size()) return refused("ends before its parameters"_text, kWholeFile);
  if (head[section + 3] != kIntel)
    return refused(
        "has the byte order of another processor (%1)"_text(static_cast<int>(head[section + 3])),
        "export it again for Intel (84)"_text);
  const auto parameters = parse_parameters(head, section + 4);
  if (!parameters) return parameters.error();

  C3dLayout layout;
  const std::size_t points = little_endian<std::uint16_t>(head, 2);
  const std::size_t analog = little_endian<std::uint16_t>(head, 4);
  double scale = static_cast<double>(little_endian_float(head, 12));
  if (const auto stored = number_of(*parameters, "POINT:SCALE"); stored && *stored != 0.0)
    scale = *stored;
  layout.floating = scale < 0.0;
  layout.frame_bytes = (4 * points + analog) * (layout.floating ? 4 : 2);
  layout.rate_Hz = number_of(*parameters, "POINT:RATE").value_or(0.0);
  if (!(layout.rate_Hz > 0.0)) layout.rate_Hz = static_cast<double>(little_endian_float(head, 20));
  layout.frames = frame_count(head, *parameters);
  layout.points = labelled_points(*parameters, points);
  const auto metres = metres_in(*parameters);
  if (!metres) return metres.error();
  layout.scale_m = layout.floating ? *metres : *metres * scale;
  if (!(layout.rate_Hz > 0.0) || !std::isfinite(layout.rate_Hz))
    return refused("does not say its rate"_text, "export it again"_text);
  if (!std::isfinite(layout.scale_m) || layout.scale_m == 0.0)
    return refused("does not say its scale"_text, "export it again"_text);
  if (layout.points.empty())
    return refused("names no point"_text, "label the markers before the export"_text);
  return layout;
}

void decode_c3d_frame(const C3dLayout& layout, std::span<const std::uint8_t> frame,
                      std::span<Vec3> p_W) noexcept {
  const std::size_t word = layout.floating ? 4 : 2;
  const auto number = [&](std::size_t at) {
    return layout.floating ? static_cast<double>(little_endian_float(frame, at))
                           : static_cast<double>(static_cast<std::int16_t>(
                                 little_endian<std::uint16_t>(frame, at)));
  };
  for (std::size_t k = 0; k < layout.points.size(); ++k) {
    const std::size_t at = layout.points[k].index * 4 * word;
    const Vec3 p(number(at), number(at + word), number(at + 2 * word));
    const bool seen = number(at + 3 * word) >= 0.0 && p.allFinite() && p != Vec3::Zero();
    p_W[k] =
        seen ? Vec3(layout.scale_m * p) : Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace isograsp
