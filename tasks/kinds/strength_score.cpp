// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of rest, of maxima in any channel, and of a force that fades.
#include <algorithm>
#include <cmath>

#include "tasks/kinds/score_kinds.hpp"
#include "tasks/kinds/score_tools.hpp"
#include "tasks/measures/digits.hpp"
#include "tasks/measures/direction.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/fatigue.hpp"
#include "tasks/measures/onset.hpp"
#include "tasks/measures/rate.hpp"

namespace isograsp::tasks {

std::vector<Measure> measures_of(const RestSpec&, const Record& record) {
  struct Axis {
    const char* name;
    const char* unit;
  };
  constexpr Axis kAxes[] = {{"fx", "N"},  {"fy", "N"},  {"fz", "N"},
                            {"tx", "Nm"}, {"ty", "Nm"}, {"tz", "Nm"}};
  MeasureList list;
  const auto add = [&](const std::string& channel, const std::string& column, const char* unit) {
    const Section rest = record.select({Phase::active}, {column});
    list.add("resting_force", channel, unit, rest, mean_over(rest, column));
  };
  add("grip", "actual_force_N", "N");
  for (const Finger finger : kFingers)
    for (const Axis& axis : kAxes) {
      const std::string channel = std::string(name_of(finger)) + "_" + axis.name;
      add(channel, channel + "_" + axis.unit, axis.unit);
    }
  return list.take();
}

namespace {

/// Best window of one effort, above rest and in total, and the highest sample.
struct EffortForces {
  statistics::Computed above_rest = "no samples";
  statistics::Computed total = "no samples";
  statistics::Computed peak = "no samples";
};
EffortForces effort_of(const Record& record, const Part& part, double window_s) {
  const auto force = record.signals().column("actual_force_N");
  // A window must be uninterrupted, so this list keeps the rows that do not count.
  std::vector<double> force_N;
  std::vector<double> weight_s;
  std::vector<bool> valid;
  EffortForces effort;
  if (force.empty()) return effort;
  for (std::size_t row = part.first; row < part.last; ++row) {
    force_N.push_back(force[row]);
    weight_s.push_back(record.hold_s(row));
    valid.push_back(record.counts(row) && !std::isnan(force[row]));
    if (valid.back() && (!effort.peak.value || force[row] > *effort.peak.value))
      effort.peak = force[row];
  }
  effort.total = best_moving_mean(force_N, weight_s, valid, window_s);
  effort.above_rest = effort.total;
  const double resting_N = known_in(record, part, "resting_force_N");
  if (effort.total.value)
    effort.above_rest = std::isnan(resting_N)
                            ? statistics::Computed("the resting force was not measured")
                            : statistics::Computed(*effort.total.value - resting_N);
  return effort;
}

/// Rates of force development of one effort that begins at rest.
void add_rates(const Record& record, const Part& part, const std::string& channel,
               MeasureList& list) {
  const Trace trace = trace_of(record, part.first, part.last);
  list.add("peak_rate", channel, "N/s", trace.section, peak_rate(trace.t_s, trace.force_N));
  statistics::Computed early = "the force before the cue is not known";
  const auto before = trace_of(record, 0, part.first);
  if (const auto rest = resting_level(before.force_N)) {
    const double resolution_N = known_in(record, part, "resolution_N");
    const double lsb_N = std::isnan(resolution_N) ? 0.0 : resolution_N;
    const auto begin =
        onset(trace.t_s, trace.force_N, rest->mean + rest->margin(lsb_N), Change::rise);
    early = begin ? early_rate(trace.t_s, trace.force_N, *begin)
                  : statistics::Computed("the force never rose above rest");
  }
  list.add("early_rate", channel, "N/s", trace.section, early);
}

/// Press, above what the digits did in the lead-in, of those that were to open.
void add_coflexion(const Record& record, const Part& part, const std::string& channel,
                   double window_s, MeasureList& list) {
  std::size_t first = part.first;
  while (first > 0 && record.phase(first - 1) == Phase::lead_in) --first;
  const NormalForces before = normal_forces(record, first, part.first);
  const Section opening =
      record.select(part.first, part.last, {}, {"thumb_fz_N", "index_fz_N", "middle_fz_N"});
  statistics::Computed share = "the force before the cue is not known";
  if (!before.section.rows.empty() && opening.reason.empty()) {
    // A window must be uninterrupted, so these lists keep the rows that do not count.
    const std::size_t rows = part.last - part.first;
    std::array<std::vector<double>, kFingerCount> force_N;
    std::vector<double> weight_s;
    std::vector<bool> valid(rows, false);
    for (const std::size_t row : opening.rows) valid[row - part.first] = true;
    for (std::size_t k = 0; k < rows; ++k) weight_s.push_back(record.hold_s(part.first + k));
    const PerDigit resting_N = before.mean();
    DigitForces forces;
    for (const Finger finger : kFingers) {
      const std::size_t f = index_of(finger);
      const auto column = record.signals().column(std::string(name_of(finger)) + "_fz_N");
      for (std::size_t k = 0; k < rows; ++k)
        force_N[f].push_back(valid[k] ? column[part.first + k] - resting_N[f] : 0.0);
      forces.force_N[f] = force_N[f];
    }
    forces.weight = weight_s;
    share = coflexion(forces, valid, window_s);
  }
  list.add("coflexion", channel, "%", opening, share);
}

/// Rows of an effort; of old records without segments, those that are active.
std::vector<Part> efforts_of(const Record& record) {
  std::vector<Part> efforts;
  for (const Part& part : parts_of(record))
    if (part.phase == Phase::active) efforts.push_back(part);
  return efforts;
}

}  // namespace

std::vector<Measure> measures_of(const MaximumSpec& spec, const Record& record) {
  MeasureList list;
  const std::string channel = name_of(spec.channel);
  const auto efforts = efforts_of(record);
  const Section squeeze = record.select({Phase::active}, {"actual_force_N"});
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

std::vector<Measure> measures_of(const DirectionalMaximaSpec& spec, const Record& record) {
  MeasureList list;
  for (const Part& part : efforts_of(record)) {
    const std::string channel = name_of(part.channel);
    const EffortForces effort = effort_of(record, part, spec.window_s);
    const Section section = record.select(part.first, part.last, {}, {"actual_force_N"});
    list.add("maximum_force", channel, "N", section, effort.above_rest);
    const auto digit = single_digit(part.channel);
    if (!digit || !effort.total.value) continue;
    const std::string name(name_of(*digit));
    const auto [vectors, force_N] = vectors_of(record, part.first, part.last, name);
    // While the force builds up its direction is not the one that was meant.
    constexpr double kOfMaximum = 0.5;
    list.add("direction_error", channel, "rad", vectors,
             *effort.total.value > 0.0
                 ? direction_error(force_N, axis_of(part.channel.direction), vectors.weight_s,
                                   kOfMaximum * *effort.total.value)
                 : statistics::Computed("no force in this direction"));
    if (part.channel.direction == Direction::minus_z)
      add_coflexion(record, part, channel, spec.window_s, list);
  }
  return list.take();
}

std::vector<Measure> measures_of(const FatigueSpec& spec, const Record& record) {
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
                     record.constant("noise_sd_N").value_or(0.0)));
  }
  add_force_of_maximum(record, spec.aim.channel, list);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

}  // namespace isograsp::tasks
