// SPDX-License-Identifier: GPL-3.0-or-later
// One press of a digit; start: its mean force in the rest before, mean: that in the press:
//   rise = mean - start
// The index and the slope are of the points (rise of the digit asked for, uninstructed deviation of
// the others). Enslaving counts presses whose rise is above 3 noise_sd.
#include "tasks/kinds/force/individuation.hpp"

#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/coordination/digits.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_individuation(TomlReader& reader) {
  IndividuationSpec spec;
  spec.aim = read_aim(reader, false);
  spec.digits = read_digits(reader, "digits");
  spec.levels = read_levels(reader, spec.aim, "levels", spec.levels);
  spec.rest_s = read_duration(reader, "rest_s", spec.rest_s);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  return spec;
}

Segments individuation_segments(const IndividuationSpec& spec, const Unit& unit, Pace& pace) {
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition)
    for (const double level : spec.levels)
      for (const Finger digit : spec.digits) {
        Aim aim = spec.aim;
        aim.channel = channel_of(digit);
        const double level_N = level * unit(aim.channel);
        segments.push_back(relaxed(aim.channel, spec.rest_s, pace));
        segments.push_back(to_level(aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace));
        segments.push_back(on_level(aim, level_N, spec.hold_s, Phase::active, pace));
      }
  return segments;
}

std::vector<Measure> score_individuation(const IndividuationSpec& spec, const Record& record) {
  MeasureList list;
  std::vector<DigitHold> holds;
  std::vector<Individuation> points;
  std::vector<Section> sections;
  std::array<double, kFingerCount> maximum_N;
  maximum_N.fill(std::nan(""));
  PerDigit start_N{};
  bool rested = false;
  for (const Part& part : parts_of(record)) {
    const auto digit = single_digit(part.channel);
    const NormalForces forces = normal_forces(record, part.first, part.last);
    if (part.cue == Cue::relax) {
      rested = !forces.section.rows.empty();
      start_N = forces.mean();
    }
    if (part.phase != Phase::active || !digit) continue;
    maximum_N[index_of(*digit)] = known_in(record, part, columns::maximum_force_N);
    sections.push_back(forces.section);
    if (forces.section.rows.empty() || !rested) continue;
    holds.push_back({*digit, start_N, forces.mean()});
    const statistics::Computed off = uninstructed_deviation(forces.view(), *digit, start_N);
    if (off.value)
      points.push_back(
          {holds.back().mean_N[index_of(*digit)] - start_N[index_of(*digit)], *off.value});
  }
  const Section all = join(sections);
  const double noise_N = record.constant(columns::noise_sd_N).value_or(0.0);
  constexpr double kLeastRise_sd = 3.0;  // a smaller rise is not above the noise
  list.add("individuation_index", "digits", "", all, individuation_index(points));
  list.add("individuation_slope", "digits", "", all, individuation_slope(points));
  for (const Finger j : spec.digits)
    for (const Finger i : kFingers) {
      if (i == j) continue;
      const std::string channel = std::string(name_of(j)) + "_to_" + std::string(name_of(i));
      list.add("enslaving", channel, "", all, enslaving(holds, i, j, kLeastRise_sd * noise_N));
      const double most_N = maximum_N[index_of(i)];
      list.add("enslaving_of_maximum", channel, "", all,
               most_N > 0.0
                   ? enslaving_of_maximum(holds, i, j, most_N)
                   : statistics::Computed(kMaximumUnknown(Known{std::string(name_of(i))})));
    }
  return list.take();
}

std::vector<ForceChannel> individuation_channels(const IndividuationSpec& spec) {
  std::vector<ForceChannel> channels;
  for (const Finger digit : spec.digits) channels.push_back(channel_of(digit));
  return channels;
}

int individuation_presses(const IndividuationSpec& spec) {
  return spec.repetitions * static_cast<int>(spec.digits.size() * spec.levels.size());
}

constexpr PlacedMeasure kIndividuationPlaces[] = {{"individuation_index", "", Prominence::key}};

constexpr ComponentMeasure kIndividuationComponents[] = {
    {Component::individuation, "individuation_index", ""}};

}  // namespace

constinit const KindFacts IndividuationSpec::kFacts{
    .name = "individuation",
    .group = TaskGroup::fingers_and_directions,
    .read = read_individuation,
    .aim = own_aim<IndividuationSpec>,
    .largest_level =
        [](const KindSpec& kind) { return largest(kind.as<IndividuationSpec>().levels); },
    .channels = of_kind<individuation_channels>,
    .repetitions = of_kind<individuation_presses>,
    .segments = of_kind<individuation_segments>,
    .measures = of_kind<score_individuation>,
    .places = kIndividuationPlaces,
    .components = kIndividuationComponents};

}  // namespace isograsp::tasks
