// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/arm/read_posture_keys.hpp"

#include <algorithm>

namespace isograsp::tasks {

std::vector<std::string> read_sequence(TomlReader& reader) {
  auto names = reader.texts("sequence");
  if (names.empty())
    reader.fail("sequence", "names no posture"_text, "name the postures in their order"_text);
  return names;
}

LinkAngle read_own_range(TomlReader& reader) {
  constexpr int kAngles = 3;
  LinkAngle asked;
  asked.link = static_cast<ArmLink>(reader.choice("own_range", kArmLinkNames));
  asked.angle = read_count(reader, "own_angle", std::nullopt, kAngles);
  if (reader.has("postures"))
    reader.fail("postures", "stands beside own_range"_text, "leave one of them out"_text);
  return asked;
}

double read_way(TomlReader& reader) {
  constexpr double kPercent = 100.0;
  constexpr double kLeastWay_percent = 10.0;
  return read_within(reader, "way_percent", kLeastWay_percent, kPercent, kPercent) / kPercent;
}

SizeScale read_scale(TomlReader& reader) {
  return reader.choice("scale", {"none", "length"}, 0) == 0 ? SizeScale::none : SizeScale::length;
}

Result<std::vector<std::size_t>> places_of(const std::vector<std::string>& names,
                                           const std::string& file,
                                           const std::optional<ArmPostures>& arm) {
  if (!arm)
    return failed("the start posture of this arm is not known"_text,
                  "hold the start posture for a second first"_text)
        .about("start_posture");
  const auto& postures = arm->library.postures;
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    const auto at = std::find_if(postures.begin(), postures.end(),
                                 [&name](const Posture& posture) { return posture.name == name; });
    if (at == postures.end())
      return refused("'%1' is no posture of %2"_text(name, Known{file}),
                     "name a [[posture]] of that file"_text)
          .about("sequence");
    places.push_back(static_cast<std::size_t>(at - postures.begin()));
  }
  return places;
}

}  // namespace isograsp::tasks
