// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/tools/read_force_keys.hpp"

#include <cmath>

#include "core/csv.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::size_t kMostLevels = 50;
constexpr double kMostLevel_N = 300.0;  ///< range of the largest sensors

}  // namespace

ForceChannel read_channel(TomlReader& reader) {
  const std::string name = reader.text("channel", "grip");
  if (const auto channel = force_channel_from_name(name)) return *channel;
  reader.fail(
      "channel", "'%1' is not a force"_text(name),
      "write grip, grip_mean, pinch, sum, thumb, index, middle, opening, index_opening or e.g. "
      "thumb_-x"_text);
  return {};
}

Aim read_aim(TomlReader& reader, bool with_channel) {
  constexpr double kMostBand = 0.5;
  constexpr double kMostPreview_s = 60.0;
  constexpr double kMostGain_deg = 90.0;
  Aim aim;
  if (with_channel) aim.channel = read_channel(reader);
  aim.scale = static_cast<Scale>(
      reader.choice("scale", {"newton", "maximum", "comfortable", "baseline"}, 1));
  aim.band_fraction = read_within(reader, "band_fraction", 0.01, kMostBand, aim.band_fraction);
  aim.force_shown = reader.boolean("force_shown", true);
  aim.preview_s = read_within(reader, "preview_s", 0.0, kMostPreview_s, 0.0);
  const char* gain = aim.scale == Scale::newton ? "gain_deg_per_N" : "gain_deg_per_unit";
  if (reader.has(gain)) aim.gain_deg = read_within(reader, gain, 0.001, kMostGain_deg);
  aim.viewing_distance_m =
      read_within(reader, "viewing_distance_m", 0.2, 5.0, aim.viewing_distance_m);
  return aim;
}

double read_level(TomlReader& reader, const Aim& aim, const std::string& name, double fallback) {
  const bool newton = aim.scale == Scale::newton;
  const double most = newton ? kMostLevel_N : 1.0;
  if (newton) return read_within(reader, name + "_N", -most, most);
  return read_within(reader, name + "_fraction", -most, most, fallback);
}

std::vector<double> read_levels(TomlReader& reader, const Aim& aim, const std::string& name,
                                std::vector<double> fallback) {
  const bool newton = aim.scale == Scale::newton;
  const std::string key = name + (newton ? "_N" : "_fractions");
  if (!newton && !reader.has(key)) return fallback;
  auto levels = reader.numbers(key, 1, kMostLevels);
  const double most = newton ? kMostLevel_N : 1.0;
  for (const double level : levels)
    if (!(std::abs(level) <= most))
      reader.fail(key, "%1 is out of range"_text(shortest(level)),
                  "write numbers up to %1"_text(shortest(most)));
  return levels;
}

std::vector<Finger> read_digits(TomlReader& reader, std::string_view key) {
  if (!reader.has(key)) return {kFingers.begin(), kFingers.end()};
  std::vector<Finger> digits;
  for (const std::string& name : reader.texts(key)) {
    if (const auto finger = finger_from_name(name))
      digits.push_back(*finger);
    else
      reader.fail(key, "'%1' is not a digit"_text(name), "write thumb, index or middle"_text);
  }
  if (digits.empty()) reader.fail(key, "is empty"_text, "name at least one digit"_text);
  return digits;
}

void read_waits(TomlReader& reader, double& least_s, double& most_s) {
  least_s = read_wait(reader, "least_wait_s", least_s);
  most_s = read_wait(reader, "most_wait_s", most_s);
  if (most_s < least_s)
    reader.fail("most_wait_s", "is below least_wait_s"_text, "write a longer time"_text);
}

}  // namespace isograsp::tasks
