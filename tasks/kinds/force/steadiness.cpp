// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/force/steadiness.hpp"

#include <cmath>
#include <map>

#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "tasks/kinds/tools/hold_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/regularity.hpp"
#include "tasks/measures/spectrum.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_steadiness(TomlReader& reader) {
  SteadinessSpec spec;
  spec.aim = read_aim(reader);
  spec.levels = read_levels(reader, spec.aim, "levels", spec.levels);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  spec.settle_s = read_wait(reader, "settle_s", spec.settle_s);
  spec.hold_s = read_duration(reader, "hold_s", spec.hold_s);
  spec.rest_s = read_wait(reader, "rest_s", spec.rest_s);
  return spec;
}

Segments steadiness_segments(const SteadinessSpec& spec, const Unit& unit, Pace& pace) {
  Segments segments;
  for (const double level : spec.levels) {
    const double level_N = level * unit(spec.aim.channel);
    segments.push_back(to_level(spec.aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace));
    segments.push_back(on_level(spec.aim, level_N, spec.settle_s, Phase::lead_in, pace));
    segments.push_back(on_level(spec.aim, level_N, spec.hold_s, Phase::active, pace));
    segments.push_back(relaxed(spec.aim.channel, spec.rest_s, pace));
  }
  return segments;
}

/// "force_25_percent" or "force_5_N"; if the name is taken already, "force_5_N_2" and so on.
std::vector<std::string> channels_of_levels(const SteadinessSpec& spec) {
  std::vector<std::string> channels;
  std::map<std::string, int> known;
  for (const double level : spec.levels) {
    const bool newton = spec.aim.scale == Scale::newton;
    const std::string name =
        "force_" + (newton ? format_number(level) + "_N"
                           : format_number(std::round(1000.0 * level) / 10.0) + "_percent");
    const int count = ++known[name];
    channels.push_back(count == 1 ? name : name + "_" + std::to_string(count));
  }
  return channels;
}

std::vector<Measure> score_steadiness(const SteadinessSpec& spec, const Record& record) {
  MeasureList list;
  const auto channels = channels_of_levels(spec);
  std::size_t level = 0;
  for (const Part& part : parts_of(record)) {
    if (part.phase != Phase::active || level == channels.size()) continue;
    const std::string& channel = channels[level++];
    const Trace hold = trace_of(record, part.first, part.last, true);
    const double noise_N = known_in(record, part, columns::noise_sd_N);
    add_steadiness(hold, channel, noise_N, list);
    list.add("constant_error", channel, "N", hold.section,
             constant_error(hold.target_N, hold.force_N, hold.weight_s));
    list.add("time_in_range", channel, "%", hold.section,
             time_in_band(hold.target_N, hold.force_N, hold.weight_s, spec.aim.band_fraction,
                          std::isnan(noise_N) ? 0.0 : noise_N));
    const bool enough = hold.t_s.size() >= 2;
    const statistics::UniformSamples force =
        enough ? statistics::on_uniform_grid(hold.t_s, hold.force_N) : statistics::UniformSamples{};
    list.add("sample_entropy", channel, "", hold.section,
             enough ? sample_entropy(force.values) : statistics::Computed(kTrackingTooShort));
    const PowerSpectrum spectrum =
        enough ? welch(force) : PowerSpectrum{0.0, {}, kTrackingTooShort};
    for (const auto& [name, band] :
         {std::pair{"power_0.1_0.3_Hz", kVerySlowBand}, std::pair{"power_0.5_0.8_Hz", kSlowBand},
          std::pair{"power_2_8_Hz", kTremorBand}, std::pair{"power_8_12_Hz", kFastTremorBand}})
      list.add(name, channel, "%", hold.section, band_share(spectrum, band));
  }
  add_sharing(record, spec.aim.channel, list);
  add_force_of_maximum(record, spec.aim.channel, list);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

int steadiness_levels(const SteadinessSpec& spec) {
  return static_cast<int>(spec.levels.size());
}

constexpr PlacedMeasure kSteadinessPlaces[] = {{"cv", "", Prominence::key},
                                               {"time_in_range", "", Prominence::trend}};

}  // namespace

constinit const KindFacts SteadinessSpec::kFacts{
    .name = "steadiness",
    .group = TaskGroup::hold_and_let_go,
    .read = read_steadiness,
    .aim = own_aim<SteadinessSpec>,
    .largest_level = [](const KindSpec& kind) { return largest(kind.as<SteadinessSpec>().levels); },
    .repetitions = of_kind<steadiness_levels>,
    .segments = of_kind<steadiness_segments>,
    .measures = of_kind<score_steadiness>,
    .places = kSteadinessPlaces};

}  // namespace isograsp::tasks
