// SPDX-License-Identifier: GPL-3.0-or-later
// The direction error of an effort counts rows with |force| > total / 2; total: the largest mean
// force over window_s.
#include "tasks/kinds/force/directional_maxima.hpp"

#include <algorithm>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/effort_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/coordination/direction.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_directional_maxima(TomlReader& reader) {
  constexpr std::array<std::string_view, kDirectionCount> kNames{"+x", "-x", "+y",
                                                                 "-y", "+z", "-z"};
  DirectionalMaximaSpec spec;
  spec.digits = read_digits(reader, "digits");
  for (const std::string& name : reader.texts("directions")) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
      reader.fail("directions", "'%1' is not a direction"_text(name), "write +x, -x, … -z"_text);
    else
      spec.directions.push_back(static_cast<Direction>(found - kNames.begin()));
  }
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.push_s = read_duration(reader, "push_s", spec.push_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  if (spec.window_s > spec.push_s)
    reader.fail("window_s", "is longer than push_s"_text, "make it shorter"_text);
  if (spec.directions.empty())
    reader.fail("directions", "is empty"_text, "name at least one direction"_text);
  return spec;
}

Segments directional_maxima_segments(const DirectionalMaximaSpec& spec, const Unit&, Pace& pace) {
  Segments segments;
  for (const Finger digit : spec.digits)
    for (const Direction direction : spec.directions) {
      const ForceChannel channel = channel_of(digit, direction);
      segments.push_back(relaxed(channel, spec.lead_in_s, pace));
      segments.push_back(effort(channel, Cue::squeeze, spec.push_s, pace));
      segments.push_back(relaxed(channel, spec.rest_s, pace));
    }
  return segments;
}

std::vector<Measure> score_directional_maxima(const DirectionalMaximaSpec& spec,
                                              const Record& record) {
  MeasureList list;
  for (const Part& part : efforts_of(record)) {
    const std::string channel = name_of(part.channel);
    const EffortForces effort = effort_of(record, part, spec.window_s);
    const Section section = record.select(part.first, part.last, {}, {columns::actual_force_N});
    list.add("maximum_force", channel, "N", section, effort.above_rest);
    const auto digit = single_digit(part.channel);
    if (!digit || !effort.total.value) continue;
    const auto [vectors, force_N] =
        vectors_of(record, part.first, part.last, columns::finger_force[index_of(*digit)]);
    // While the force builds up its direction is not the one that was meant.
    constexpr double kOfMaximum = 0.5;
    list.add("direction_error", channel, "rad", vectors,
             *effort.total.value > 0.0
                 ? direction_error(force_N, axis_of(part.channel.direction), vectors.weight_s,
                                   kOfMaximum * *effort.total.value)
                 : statistics::Computed("no force in this direction"_text));
    if (part.channel.direction == Direction::minus_z)
      add_coflexion(record, part, channel, spec.window_s, list);
  }
  return list.take();
}

std::vector<ForceChannel> directional_maxima_measured(const DirectionalMaximaSpec& spec,
                                                      Scale scale) {
  std::vector<ForceChannel> channels;
  if (scale != Scale::of_maximum) return channels;
  for (const Finger digit : spec.digits)
    for (const Direction direction : spec.directions)
      channels.push_back(channel_of(digit, direction));
  return channels;
}

int directional_maxima_efforts(const DirectionalMaximaSpec& spec) {
  return static_cast<int>(spec.digits.size() * spec.directions.size());
}

// The compass and its table show all directions.
constexpr PlacedMeasure kDirectionalMaximaPlaces[] = {
    {"maximum_force", "thumb_opening", Prominence::trend},
    {"maximum_force", "index_opening", Prominence::trend},
    {"maximum_force", "middle_opening", Prominence::trend},
    {"coflexion", "", Prominence::trend}};

constexpr ComponentMeasure kDirectionalMaximaComponents[] = {
    {Component::opening, "maximum_force", "_opening", 1},
    {Component::direction, "direction_error", "", 1}};

}  // namespace

constinit const KindFacts DirectionalMaximaSpec::kFacts{
    .name = "directional_maxima",
    .group = TaskGroup::rest_and_maximum,
    .read = read_directional_maxima,
    .measured = of_kind<directional_maxima_measured>,
    .repetitions = of_kind<directional_maxima_efforts>,
    .segments = of_kind<directional_maxima_segments>,
    .measures = of_kind<score_directional_maxima>,
    .places = kDirectionalMaximaPlaces,
    .components = kDirectionalMaximaComponents,
    .all_directions = true};

}  // namespace isograsp::tasks
