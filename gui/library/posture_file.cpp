// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library/posture_file.hpp"

#include <algorithm>
#include <utility>

namespace isograsp::gui {

namespace {

/// Lines that are empty or a comment, up to the first other one.
std::string_view head_of(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size()) {
    const auto first = text.find_first_not_of(" \t\r", end);
    if (first == std::string_view::npos || (text[first] != '#' && text[first] != '\n')) break;
    const auto line_break = text.find('\n', first);
    end = line_break == std::string_view::npos ? text.size() : line_break + 1;
  }
  return text.substr(0, end);
}

bool has_name(const Postures& postures, const std::string& name) {
  return std::any_of(postures.postures.begin(), postures.postures.end(),
                     [&](const Posture& posture) { return posture.name == name; });
}

}  // namespace

Result<PostureFile> read_posture_file(std::string_view text, const std::string& path) {
  auto postures = parse_postures(text, path);
  if (!postures) return postures.error();
  return PostureFile{std::string(head_of(text)), *std::move(postures)};
}

std::string posture_file_text(const PostureFile& file) {
  return file.head + postures_text(file.postures);
}

std::string free_posture_name(const Postures& postures, const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; has_name(postures, name); ++n) name = wanted + " " + std::to_string(n);
  return name;
}

Postures with_added(Postures postures, std::size_t index, Posture posture) {
  posture.name = free_posture_name(postures, posture.name);
  postures.postures.insert(postures.postures.begin() + static_cast<std::ptrdiff_t>(index) + 1,
                           std::move(posture));
  return postures;
}

Result<Postures> with_renamed(Postures postures, std::size_t index, const std::string& name) {
  if (name.empty())
    return refused("a posture needs a name"_text, "write one: tasks call it by that"_text);
  if (name != postures.postures[index].name && has_name(postures, name))
    return refused("another posture is called '%1'"_text(name), "choose another name"_text);
  postures.postures[index].name = name;
  return postures;
}

Result<Postures> without(Postures postures, std::size_t index) {
  if (index == 0)
    return refused("the initial posture stays: all others are seen from it"_text,
                   "remove another one"_text);
  postures.postures.erase(postures.postures.begin() + static_cast<std::ptrdiff_t>(index));
  return postures;
}

}  // namespace isograsp::gui
