// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/tools/read_object_keys.hpp"

namespace isograsp::tasks {

std::string read_scene(TomlReader& reader) {
  std::string name = reader.text("scene");
  if (reader.has("scene") && (name.empty() || name.find('/') != std::string::npos))
    reader.fail("scene", "'%1' is not the name of a scene"_text(name),
                "write the name of its file without folder and ending, e.g. \"planar_block\""_text);
  return name;
}

PoseTolerance read_tolerance(TomlReader& reader, PoseTolerance fallback) {
  constexpr double kLeast_m = 1e-4;
  constexpr double kLeast_deg = 0.1;
  return {read_within(reader, "position_tolerance_m", kLeast_m, 1.0, fallback.position_m),
          kRadPerDeg * read_within(reader, "angle_tolerance_deg", kLeast_deg, 180.0,
                                   fallback.angle_rad / kRadPerDeg)};
}

}  // namespace isograsp::tasks
