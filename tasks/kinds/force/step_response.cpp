// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/step_response.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/cue_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_step_response(TomlReader& reader) {
  StepResponseSpec spec;
  spec.aim = read_aim(reader);
  spec.from = read_level(reader, spec.aim, "from", spec.from);
  spec.to = read_levels(reader, spec.aim, "to", spec.to);
  read_waits(reader, spec.least_wait_s, spec.most_wait_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  for (const double to : spec.to)
    if (to == spec.from)
      reader.fail(spec.aim.scale == Scale::newton ? "to_N" : "to_fractions",
                  "has the level that the step begins at"_text, "write another level"_text);
  return spec;
}

Segments step_response_segments(const StepResponseSpec& spec, const Unit& unit, Pace& pace) {
  const double unit_N = unit(spec.aim.channel);
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition)
    for (const double to : spec.to) {
      const double wait_s = pace.wait(spec.least_wait_s, spec.most_wait_s);
      segments.push_back(on_level(spec.aim, spec.from * unit_N, wait_s, Phase::lead_in, pace));
      segments.push_back(on_level(spec.aim, to * unit_N, spec.hold_s, Phase::active, pace));
    }
  return segments;
}

std::vector<Measure> score_step_response(const StepResponseSpec& spec, const Record& record) {
  MeasureList list;
  std::vector<Section> sections, with_target;
  std::vector<Reaction> reactions;
  std::vector<statistics::EventTime> t63, settling;
  std::vector<statistics::Computed> rise, overshoot, error;
  const auto parts = parts_of(record);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Part& part = parts[i];
    if (part.phase != Phase::active) continue;
    const Trace trace = trace_of(record, parts[i - 1].first, part.last);
    const double from_N = known_in(record, parts[i - 1], columns::target_force_N);
    const double to_N = known_in(record, part, columns::target_force_N);
    if (trace.empty() || !(from_N != to_N)) continue;
    const CuedStep step{record.task_time_s(part.first), from_N, to_N};
    const CuedStepResponse response = cued_step_response(
        trace.t_s, trace.force_N, step, known_or_zero(record, part, columns::resolution_N));
    reactions.push_back(response.reaction);
    t63.push_back(response.t63);
    settling.push_back(response.settling);
    rise.push_back(response.rise10_90_s);
    overshoot.push_back(response.overshoot_percent);
    const Trace after = trace_of(record, part.first, part.last, true);
    error.push_back(rmse(after.target_N, after.force_N, after.weight_s));
    with_target.push_back(after.section);
    sections.push_back(trace_of(record, part.first, part.last).section);
  }
  const Section all = join(sections);
  const std::string channel = name_of(spec.aim.channel);
  add_reactions("reaction_time", channel, record, all, reactions, spec.hold_s, list);
  list.add_times("t63", channel, all, t63, spec.hold_s);
  list.add_times("settling_time", channel, all, settling, spec.hold_s);
  list.add_mean("rise_time", channel, "s", all, rise);
  list.add_mean("overshoot", channel, "%", all, overshoot);
  list.add_mean("rmse", channel, "N", join(with_target), error);
  add_force_of_maximum(record, spec.aim.channel, list);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

double step_response_level(const StepResponseSpec& spec) {
  return std::max(largest(spec.to), std::abs(spec.from));
}

int step_response_steps(const StepResponseSpec& spec) {
  return spec.repetitions * static_cast<int>(spec.to.size());
}

constexpr PlacedMeasure kStepResponsePlaces[] = {{"reaction_time", "", Prominence::key},
                                                 {"settling_time", "", Prominence::key},
                                                 {"settling_time_share", "", Prominence::trend},
                                                 {"overshoot", "", Prominence::trend}};

}  // namespace

constinit const KindFacts StepResponseSpec::kFacts{.name = "step_response",
                                                   .group = TaskGroup::follow,
                                                   .read = read_step_response,
                                                   .aim = own_aim<StepResponseSpec>,
                                                   .largest_level = of_kind<step_response_level>,
                                                   .repetitions = of_kind<step_response_steps>,
                                                   .segments = of_kind<step_response_segments>,
                                                   .measures = of_kind<score_step_response>,
                                                   .places = kStepResponsePlaces,
                                                   .unforeseen_waits = true};

}  // namespace isograsp::tasks
