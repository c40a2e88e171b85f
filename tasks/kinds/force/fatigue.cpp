// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/fatigue.hpp"

#include "hand/columns.hpp"
#include "tasks/kinds/tools/effort_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/fatigue.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_fatigue(TomlReader& reader) {
  FatigueSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  return spec;
}

Segments fatigue_segments(const FatigueSpec& spec, const Unit& unit, Pace& pace) {
  const double level_N = spec.level * unit(spec.aim.channel);
  return {to_level(spec.aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace),
          on_level(spec.aim, level_N, spec.hold_s, Phase::active, pace)};
}

std::vector<Measure> score_fatigue(const FatigueSpec& spec, const Record& record) {
  MeasureList list;
  const std::string channel = name_of(spec.aim.channel);
  for (const Part& part : efforts_of(record)) {
    const Trace trace = trace_of(record, part.first, part.last, true);
    const auto add = [&](const char* name, const char* unit, const statistics::Computed& computed) {
      list.add(name, channel, unit, trace.section, computed);
    };
    add("fatigue_slope", "%/s", fatigue_slope(trace.t_s, trace.force_N));
    const statistics::EventTime fading = time_to_fatigue(trace.t_s, trace.force_N);
    add("endurance", "s", fading.time_s);
    add("rmse", "N", rmse(trace.target_N, trace.force_N, trace.weight_s));
    add("mean_force", "N", weighted_mean(trace.force_N, trace.weight_s));
    add("time_in_range", "%",
        time_in_band(trace.target_N, trace.force_N, trace.weight_s, spec.aim.band_fraction,
                     record.constant(columns::noise_sd_N).value_or(0.0)));
  }
  add_force_of_maximum(record, spec.aim.channel, list);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

constexpr PlacedMeasure kFatiguePlaces[] = {{"fatigue_slope", "", Prominence::key},
                                            {"endurance", "", Prominence::trend}};

}  // namespace

constinit const KindFacts FatigueSpec::kFacts{.name = "fatigue",
                                              .group = TaskGroup::hold_and_let_go,
                                              .read = read_fatigue,
                                              .aim = own_aim<FatigueSpec>,
                                              .largest_level = own_level<FatigueSpec>,
                                              .multiply = multiply<FatigueSpec>,
                                              .segments = of_kind<fatigue_segments>,
                                              .measures = of_kind<score_fatigue>,
                                              .places = kFatiguePlaces,
                                              .tires = true};

}  // namespace isograsp::tasks
