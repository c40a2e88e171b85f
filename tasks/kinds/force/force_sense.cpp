// SPDX-License-Identifier: GPL-3.0-or-later
// reproduced = mean of the force over the last window_s of a repetition, weighted by how long the
// rows last; it is compared with the target of that repetition.
#include "tasks/kinds/force/force_sense.hpp"

#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/force_sense.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_force_sense(TomlReader& reader) {
  ForceSenseSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.learn_s = read_duration(reader, "learn_s", spec.learn_s);
  spec.pause_s = read_wait(reader, "pause_s", spec.pause_s);
  spec.reproduce_s = read_duration(reader, "reproduce_s", spec.reproduce_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  if (spec.window_s > spec.reproduce_s)
    reader.fail("window_s", "is longer than reproduce_s"_text, "make it shorter"_text);
  return spec;
}

Segments force_sense_segments(const ForceSenseSpec& spec, const Unit& unit, Pace& pace) {
  const double level_N = spec.level * unit(spec.aim.channel);
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition) {
    segments.push_back(on_level(spec.aim, level_N, spec.learn_s, Phase::lead_in, pace));
    segments.back().force_shown = true;
    segments.push_back(relaxed(spec.aim.channel, spec.pause_s, pace));
    Segment again = on_level(spec.aim, level_N, spec.reproduce_s, Phase::active, pace);
    again.cue = Cue::reproduce;
    again.force_shown = false;
    again.target_shown = false;
    segments.push_back(std::move(again));
    segments.push_back(relaxed(spec.aim.channel, spec.pause_s, pace));
  }
  return segments;
}

std::vector<Measure> score_force_sense(const ForceSenseSpec& spec, const Record& record) {
  MeasureList list;
  std::vector<double> target_N, reproduced_N;
  std::vector<Section> sections;
  for (const Part& part : parts_of(record)) {
    if (part.phase != Phase::active) continue;
    const Trace trace = trace_of(record, part.first, part.last, true);
    if (trace.empty()) continue;
    const std::size_t first =
        statistics::first_row_from(trace.t_s, end_of(record, part) - spec.window_s);
    const statistics::Computed mean = weighted_mean(std::span(trace.force_N).subspan(first),
                                                    std::span(trace.weight_s).subspan(first));
    if (!mean.value) continue;
    target_N.push_back(trace.target_N.front());
    reproduced_N.push_back(*mean.value);
    sections.push_back(trace.section);
  }
  const Section all = join(sections);
  const std::string channel = name_of(spec.aim.channel);
  const ForceSense sense = force_sense(target_N, reproduced_N);
  list.add("constant_error", channel, "N", all, sense.constant_error);
  list.add("absolute_error", channel, "N", all, sense.absolute_error);
  list.add("variable_error", channel, "N", all, sense.variable_error);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

constexpr PlacedMeasure kForceSensePlaces[] = {{"absolute_error", "", Prominence::key},
                                               {"constant_error", "", Prominence::trend},
                                               {"variable_error", "", Prominence::trend}};

}  // namespace

constinit const KindFacts ForceSenseSpec::kFacts{
    .name = "force_sense",
    .group = TaskGroup::hold_and_let_go,
    .read = read_force_sense,
    .aim = own_aim<ForceSenseSpec>,
    .largest_level = own_level<ForceSenseSpec>,
    .multiply = multiply<ForceSenseSpec>,
    .repetitions = [](const KindSpec& kind) { return kind.as<ForceSenseSpec>().repetitions; },
    .segments = of_kind<force_sense_segments>,
    .measures = of_kind<score_force_sense>,
    .places = kForceSensePlaces};

}  // namespace isograsp::tasks
