// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/column_facts.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "hand/arm_columns.hpp"

namespace isograsp::tasks {

namespace {

/// A column that is named by a body and a component of it: "F1" and "x" of "F1_x_m".
struct BodyColumn {
  std::string body;
  std::string component;
};

/// `front` + component + `ending` behind the body and '_'; nothing: the name is another.
template <std::size_t kCount>
std::optional<BodyColumn> split_column(std::string_view name,
                                       const std::array<std::string_view, kCount>& components,
                                       std::string_view ending) {
  for (const std::string_view component : components) {
    const std::string tail = "_" + std::string(component) + std::string(ending);
    if (name.size() > tail.size() && name.ends_with(tail))
      return BodyColumn{std::string(name.substr(0, name.size() - tail.size())),
                        std::string(component)};
  }
  return std::nullopt;
}

/// Of a column in a group of what cameras see.
std::optional<ColumnFacts> describe_seen(std::string_view name, std::string_view group) {
  constexpr std::array<std::string_view, 4> kAttitude{"qw", "qx", "qy", "qz"};
  if (group == kMarkerGroup && name.starts_with(columns::kMarker))
    name.remove_prefix(columns::kMarker.size());
  const auto facts = [name](const BodyColumn& column, const Text& words, const char* axes) {
    return ColumnFacts{std::string(unit_of(name)), words,       axes,
                       column.component,           column.body, true};
  };
  if (group == kSegmentGroup || group == kMarkerGroup) {
    const bool marker = group == kMarkerGroup;
    if (const auto column = split_column(name, columns::kXyz, "_m"))
      return facts(
          *column,
          marker
              ? "Position of the marker %1 along %2"_text(column->body, column->component)
              : "Position of the segment %1 along %2"_text(Known{column->body}, column->component),
          "cameras");
    if (auto column = split_column(name, kAttitude, ""); column && !marker) {
      const std::string letter = column->component.substr(1);
      column->component = "quat_" + letter;
      return facts(*column,
                   "Attitude of the segment %1, quaternion %2"_text(Known{column->body}, letter),
                   "cameras");
    }
  }
  if (group == kLinkGroup)
    if (const auto column = split_column(name, columns::kXyz, "_rad"))
      return facts(*column,
                   "Rotation vector of the link %1 from its first row on, along %2"_text(
                       column->body, column->component),
                   "link");
  return std::nullopt;
}

}  // namespace

ColumnFacts describe_column(std::string_view name, std::string_view group) {
  const std::string unit(unit_of(name));
  if (const auto seen = describe_seen(name, group)) return *seen;
  if (const Column* column = columns::find(name))
    return {unit,
            column->description.text(),
            std::string(column->axes),
            std::string(column->component),
            std::string(column->body),
            true};
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return {unit, "Column of a recording: %1"_text(words), "", "", "", false};
}

}  // namespace isograsp::tasks
