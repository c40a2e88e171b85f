// SPDX-License-Identifier: GPL-3.0-or-later
// force of maximum = largest mean over 0.5 s of 100 (force - resting force) / maximum force
// net push = sqrt(net_fx^2 + net_fy^2 + net_fz^2), as a share of |force|
// share of events that came = 100 (number that came) / (number that were asked for)
#include "tasks/kinds/tools/score_tools.hpp"

#include <cmath>
#include <limits>

#include "hand/columns.hpp"
#include "statistics/survival.hpp"
#include "tasks/measures/coordination/direction.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

/// An enumeration stored as a number; anything else reads as its first value.
template <class Enum>
Enum stored(std::span<const double> column, std::size_t row, std::size_t count) {
  if (column.empty() || !(column[row] >= 0.0) || !(column[row] < static_cast<double>(count)))
    return Enum{};
  return static_cast<Enum>(static_cast<int>(column[row]));
}

}  // namespace

std::vector<Part> parts_of(const Record& record) {
  const Signals& signals = record.signals();
  const auto segment = signals.column(columns::segment);
  const auto cue = signals.column(columns::cue);
  const auto digits = signals.column(columns::channel_digits);
  const auto direction = signals.column(columns::channel_direction);
  std::vector<Part> parts;
  double before = std::numeric_limits<double>::quiet_NaN();
  std::size_t rows = 0;
  while (rows < record.rows() && record.phase(rows) != Phase::done) ++rows;  // then it is over
  for (std::size_t row = 0; row < rows; ++row) {
    const bool paused = record.paused(row);
    const double here = paused            ? before
                        : segment.empty() ? static_cast<double>(record.phase(row))
                                          : segment[row];
    if (parts.empty() || here != before) {
      if (!parts.empty()) parts.back().last = row;
      if (paused && parts.empty()) continue;
      Part part;
      part.first = row;
      part.phase = record.phase(row);
      constexpr std::size_t kDigits = 7;
      part.cue = stored<Cue>(cue, row, kCueCount);
      part.channel.digits = stored<Digits>(digits, row, kDigits);
      part.channel.direction = direction.empty()
                                   ? Direction::plus_z
                                   : stored<Direction>(direction, row, kDirectionCount);
      parts.push_back(part);
      before = here;
    }
  }
  if (!parts.empty()) parts.back().last = rows;
  return parts;
}

double end_of(const Record& record, const Part& part) {
  std::size_t row = part.last;
  while (row > part.first + 1 && record.paused(row - 1)) --row;
  return record.task_time_s(row - 1) + record.hold_s(row - 1);
}

Trace trace_of(const Record& record, std::size_t first, std::size_t last, bool with_target) {
  Trace trace;
  trace.section = with_target ? record.select(first, last, {},
                                              {columns::target_force_N, columns::actual_force_N})
                              : record.select(first, last, {}, {columns::actual_force_N});
  if (!trace.section.reason.empty()) return trace;
  trace.t_s = trace.section.t_s;
  trace.weight_s = trace.section.weight_s;
  trace.force_N = trace.section.values(columns::actual_force_N);
  if (with_target) trace.target_N = trace.section.values(columns::target_force_N);
  return trace;
}

Section join(std::span<const Section> sections) {
  Section all;
  for (const Section& section : sections) {
    all.rows.insert(all.rows.end(), section.rows.begin(), section.rows.end());
    all.t_s.insert(all.t_s.end(), section.t_s.begin(), section.t_s.end());
    all.weight_s.insert(all.weight_s.end(), section.weight_s.begin(), section.weight_s.end());
    all.excluded += section.excluded;
    if (all.reason.empty()) all.reason = section.reason;
  }
  return all;
}

DigitForces NormalForces::view() const {
  DigitForces forces;
  for (std::size_t f = 0; f < kFingerCount; ++f) forces.force_N[f] = force_N[f];
  forces.weight = section.weight_s;
  return forces;
}

PerDigit NormalForces::mean() const {
  PerDigit mean{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    mean[f] = weighted_mean(force_N[f], section.weight_s).value.value_or(0.0);
  return mean;
}

NormalForces normal_forces(const Record& record, std::size_t first, std::size_t last,
                           std::initializer_list<Phase> phases) {
  NormalForces forces;
  forces.section = record.select(first, last, phases, names_of(columns::normal_force));
  if (!forces.section.reason.empty()) return forces;
  for (const Finger finger : kFingers)
    forces.force_N[index_of(finger)] =
        forces.section.values(columns::normal_force[index_of(finger)]);
  return forces;
}

Vectors vectors_of(const Record& record, std::size_t first, std::size_t last,
                   const columns::OfAxes& axes) {
  const auto& [x, y, z] = axes;
  Vectors vectors;
  vectors.section = record.select(first, last, {}, {x, y, z});
  for (const std::size_t row : vectors.section.rows)
    vectors.force_N.emplace_back(record.signals().column(x)[row], record.signals().column(y)[row],
                                 record.signals().column(z)[row]);
  return vectors;
}

double known_in(const Record& record, const Part& part, std::string_view column) {
  const auto values = record.signals().column(column);
  if (!values.empty())
    for (std::size_t row = part.first; row < part.last; ++row)
      if (!std::isnan(values[row])) return values[row];
  return std::numeric_limits<double>::quiet_NaN();
}

void MeasureList::add(std::string name, std::string channel, std::string unit,
                      const Section& section, statistics::Computed computed) {
  measures_.push_back(make_measure(std::move(name), std::move(channel), std::move(unit), section,
                                   std::move(computed)));
}

statistics::Computed mean_of_repetitions(std::span<const statistics::Computed> each, Words none) {
  double sum = 0.0;
  int count = 0;
  for (const statistics::Computed& one : each) {
    if (!one.value) continue;
    sum += *one.value;
    ++count;
  }
  if (count > 0) return sum / count;
  return each.empty() ? statistics::Computed(none) : each.front();
}

void MeasureList::add_mean(std::string name, const std::string& channel, std::string unit,
                           const Section& section, std::span<const statistics::Computed> each) {
  add(std::move(name), channel, std::move(unit), section, mean_of_repetitions(each));
}

namespace {

/// Times that end at the event or at the limit; those that could not be looked for are left out.
struct Completions {
  std::vector<statistics::Completion> all;
  Text reason = "there was no repetition"_text;  ///< why there are none
};
Completions completions_of(std::span<const statistics::EventTime> each, double limit_s) {
  Completions completions;
  for (const statistics::EventTime& one : each) {
    if (one.time_s.value)
      completions.all.push_back({*one.time_s.value, true});
    else if (one.longer_than_s)
      completions.all.push_back({limit_s, false});
    else
      completions.reason = one.time_s.reason;
  }
  return completions;
}

}  // namespace

statistics::Computed median_time(std::span<const statistics::EventTime> each, double limit_s) {
  const Completions found = completions_of(each, limit_s);
  return found.all.empty() ? statistics::Computed(found.reason)
                           : statistics::median_completion(found.all);
}

void MeasureList::add_times(const std::string& name, const std::string& channel,
                            const Section& section, std::span<const statistics::EventTime> each,
                            double limit_s) {
  const auto [all, reason] = completions_of(each, limit_s);
  const statistics::Reached reached = statistics::reached_of(all);
  const bool none = all.empty();
  add(name, channel, "s", section, median_time(each, limit_s));
  add(name + "_restricted", channel, "s", section,
      none ? statistics::Computed(reason) : statistics::restricted_mean_time(all, limit_s));
  add(name + "_share", channel, "%", section,
      none ? statistics::Computed(reason)
           : statistics::Computed(100.0 * reached.count / reached.of));
}

void add_net_push(const Record& record, ForceChannel channel, MeasureList& list) {
  if (single_digit(channel)) return;
  const auto& [push_x, push_y, push_z] = columns::net_force;
  const Section section = record.select({Phase::active, Phase::hold},
                                        {push_x, push_y, push_z, columns::actual_force_N});
  const Signals& signals = record.signals();
  if (!signals.has(push_z) || !signals.has(columns::actual_force_N)) return;  // not recorded
  const auto x = section.values(push_x);
  const auto y = section.values(push_y);
  const auto z = section.values(push_z);
  auto grip_N = section.values(columns::actual_force_N);
  std::vector<double> push_N;
  for (std::size_t k = 0; k < x.size(); ++k) {
    push_N.push_back(std::hypot(x[k], y[k], z[k]));
    grip_N[k] = std::abs(grip_N[k]);
  }
  constexpr double kLeastForce_N = 0.5;  // below, a share of the force means nothing
  const PushSummary push = summary_of_push(push_N, grip_N, section.weight_s, kLeastForce_N);
  list.add("net_push", "platform", "%", section, push.median);
  list.add("net_push_time", "platform", "%", section, push.above_20);
}

void add_sharing(const Record& record, ForceChannel channel, MeasureList& list) {
  const bool all_press = channel.digits == Digits::grip || channel.digits == Digits::grip_mean ||
                         channel.digits == Digits::sum;
  if (!all_press || channel.direction != Direction::plus_z) return;
  const NormalForces forces = normal_forces(record, 0, record.rows(), {Phase::active});
  if (!record.signals().has(columns::normal_force[index_of(Finger::middle)]))
    return;  // finger forces were not recorded
  const PerDigit mean_N = forces.mean();
  for (const Finger finger : kFingers)
    list.add("sharing", std::string(name_of(finger)), "%", forces.section, sharing(mean_N, finger));
  list.add("thumb_opposition", "digits", "", forces.section, thumb_opposition(mean_N));
}

void add_force_of_maximum(const Record& record, ForceChannel channel, MeasureList& list) {
  const auto force = record.signals().column(columns::actual_force_N);
  const auto maximum = record.signals().column(columns::maximum_force_N);
  const auto resting = record.signals().column(columns::resting_force_N);
  if (force.empty() || maximum.empty() || resting.empty()) return;
  std::vector<double> of_maximum(record.rows(), 0.0);
  std::vector<double> weight_s(record.rows(), 0.0);
  std::vector<bool> valid(record.rows(), false);
  bool known = false;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    known = known || maximum[row] > 0.0;
    weight_s[row] = record.hold_s(row);
    const Phase phase = record.phase(row);
    const double share = 100.0 * (force[row] - resting[row]) / maximum[row];
    valid[row] = record.counts(row) && std::isfinite(share) &&
                 (phase == Phase::active || phase == Phase::hold);
    if (valid[row]) of_maximum[row] = share;
  }
  if (!known) return;
  constexpr double kWindow_s = 0.5;  // that of the maximum itself
  list.add(
      "force_of_maximum", name_of(channel), "%",
      record.select({Phase::active, Phase::hold},
                    {columns::actual_force_N, columns::resting_force_N, columns::maximum_force_N}),
      best_moving_mean(of_maximum, weight_s, valid, kWindow_s));
}

void add_synergy(const CycleSynergy& found, const Section& section, MeasureList& list) {
  list.add("synergy_index", "force", "", section, found.delta_v);
  list.add("synergy_index_z", "force", "", section, found.delta_v_z);
  list.add("variance_within", "force", "N^2", section, found.v_ucm);
  list.add("variance_across", "force", "N^2", section, found.v_ort);
}

}  // namespace isograsp::tasks
