// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/maximum.hpp"

#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/effort_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/onset.hpp"
#include "tasks/measures/rate.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_maximum(TomlReader& reader) {
  MaximumSpec spec;
  spec.channel = read_channel(reader);
  spec.comfortable = reader.choice("effort", {"maximum", "comfortable"}, 0) == 1;
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.squeeze_s = read_duration(reader, "squeeze_s", spec.squeeze_s);
  spec.window_s = read_duration(reader, "window_s", spec.window_s);
  spec.force_shown = reader.boolean("force_shown", true);
  if (spec.window_s > spec.squeeze_s)
    reader.fail("window_s", "is longer than squeeze_s"_text, "make it shorter"_text);
  return spec;
}

Segments maximum_segments(const MaximumSpec& spec, const Unit&, Pace& pace) {
  const Cue cue = spec.comfortable ? Cue::press : Cue::squeeze;
  Segments segments{relaxed(spec.channel, spec.lead_in_s, pace),
                    effort(spec.channel, cue, spec.squeeze_s, pace)};
  segments.back().force_shown = spec.force_shown;
  return segments;
}

Duration maximum_duration(const MaximumSpec& spec) {
  return {spec.lead_in_s + spec.squeeze_s, spec.lead_in_s + spec.squeeze_s};
}

/// Rates of force development of one effort that begins at rest.
void add_rates(const Record& record, const Part& part, const std::string& channel,
               MeasureList& list) {
  const Trace trace = trace_of(record, part.first, part.last);
  list.add("peak_rate", channel, "N/s", trace.section, peak_rate(trace.t_s, trace.force_N));
  statistics::Computed early = "the force before the cue is not known"_text;
  const auto before = trace_of(record, 0, part.first);
  if (const auto rest = resting_level(before.force_N)) {
    const double resolution_N = known_in(record, part, columns::resolution_N);
    const double lsb_N = std::isnan(resolution_N) ? 0.0 : resolution_N;
    const auto begin =
        onset(trace.t_s, trace.force_N, rest->mean + rest->margin(lsb_N), Change::rise);
    early = begin ? early_rate(trace.t_s, trace.force_N, *begin)
                  : statistics::Computed("the force never rose above rest"_text);
  }
  list.add("early_rate", channel, "N/s", trace.section, early);
}

std::vector<Measure> score_maximum(const MaximumSpec& spec, const Record& record) {
  MeasureList list;
  const std::string channel = name_of(spec.channel);
  const auto efforts = efforts_of(record);
  const Section squeeze = record.select({Phase::active}, {columns::actual_force_N});
  const EffortForces effort =
      efforts.empty() ? EffortForces{} : effort_of(record, efforts.front(), spec.window_s);
  const std::string kind = spec.comfortable ? "comfortable_force" : "maximum_force";
  list.add(kind, channel, "N", squeeze, effort.above_rest);
  list.add(kind + "_total", channel, "N", squeeze, effort.total);
  list.add("peak_force", channel, "N", squeeze, effort.peak);
  if (efforts.empty() || spec.comfortable) return list.take();
  add_rates(record, efforts.front(), channel, list);
  if (spec.channel.direction == Direction::minus_z)
    add_coflexion(record, efforts.front(), channel, spec.window_s, list);
  add_sharing(record, spec.channel, list);
  add_net_push(record, spec.channel, list);
  return list.take();
}

std::vector<ForceChannel> maximum_measured(const MaximumSpec& spec, Scale scale) {
  if (scale != (spec.comfortable ? Scale::of_comfortable : Scale::of_maximum)) return {};
  return {spec.channel};
}

constexpr PlacedMeasure kMaximumPlaces[] = {{"maximum_force", "", Prominence::key},
                                            {"comfortable_force", "", Prominence::key},
                                            {"coflexion", "", Prominence::trend}};

constexpr ComponentMeasure kMaximumComponents[] = {
    {Component::strength, "maximum_force", "grip"},
    {Component::strength, "maximum_force", "pinch", 1},
    {Component::opening, "maximum_force", "opening"}};

}  // namespace

constinit const KindFacts MaximumSpec::kFacts{
    .name = "maximum",
    .group = TaskGroup::rest_and_maximum,
    .read = read_maximum,
    .duration = of_kind<maximum_duration>,
    .effort = [](const KindSpec& kind) { return &kind.as<MaximumSpec>().channel; },
    .measured = of_kind<maximum_measured>,
    .segments = of_kind<maximum_segments>,
    .measures = of_kind<score_maximum>,
    .places = kMaximumPlaces,
    .components = kMaximumComponents};

}  // namespace isograsp::tasks
