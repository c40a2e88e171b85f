// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/named_scene.hpp"

#include <utility>

#include "core/files.hpp"
#include "session/library/library.hpp"

namespace isograsp::session {

Result<NamedScene> named_scene(const tasks::TaskSpec& spec, const std::string& library) {
  auto path = find_in_library(library, "scenes", spec.scene(), spec.file);
  if (!path) return path.error();
  auto text = read_text(*path);
  if (!text) return text.error();
  auto scene = bimanual::parse_hands_scene(*text, *path);
  if (!scene) return scene.error();
  return NamedScene{*std::move(path), *std::move(text), *std::move(scene)};
}

}  // namespace isograsp::session
