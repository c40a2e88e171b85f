// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of a force that follows a target over time.
//   lag_corrected = lag - known delay of the device
//   slope of a ramp = (last target - first target) / (last time - first time)
//   direction of the target at row k: the sign of target_(k + 1) - target_k, 0 where that is within
//   1e-9 of its range
//   cycle c of frequency f begins c / f after the waveform
#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/tools/hold_score.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/known_delay.hpp"
#include "tasks/measures/rate.hpp"
#include "tasks/measures/regularity.hpp"
#include "tasks/measures/sine.hpp"
#include "tasks/measures/smoothness.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

namespace {

/// Errors of the whole target.
void add_errors(const Record& record, const Trace& trace, double band_fraction,
                const std::string& channel, MeasureList& list) {
  const auto& [section, t_s, force_N, target_N, weight_s] = trace;
  const auto add = [&](const char* name, const char* unit, const statistics::Computed& computed) {
    list.add(name, channel, unit, trace.section, computed);
  };
  const double noise_N = record.constant(columns::noise_sd_N).value_or(0.0);
  add("rmse", "N", rmse(target_N, force_N, weight_s));
  add("relative_rmse", "%", relative_rmse(target_N, force_N, weight_s));
  add("mae", "N", mae(target_N, force_N, weight_s));
  add("constant_error", "N", constant_error(target_N, force_N, weight_s));
  add("time_in_range", "%", time_in_band(target_N, force_N, weight_s, band_fraction, noise_N));
}

/// Lag with the raw value beside the one without the known delay.
void add_lag(const Record& record, const Trace& trace, const std::string& channel,
             MeasureList& list) {
  const statistics::Computed raw = trace.t_s.size() < 2
                                       ? statistics::Computed(kTrackingTooShort)
                                       : lag(statistics::on_uniform_grid(trace.t_s, trace.target_N),
                                             statistics::on_uniform_grid(trace.t_s, trace.force_N));
  list.add("lag", channel, "s", trace.section, raw);
  list.add("lag_corrected", channel, "s", trace.section,
           without_delay(raw, record.known_delay_s()).corrected_s);
}

/// Gain and phase of every sine in the target; one alone keeps the plain channel.
void add_sines(const ForceTrackingSpec& spec, const Trace& trace, MeasureList& list) {
  const auto frequencies_Hz = frequencies_of(spec.waveform, spec.duration_s);
  constexpr std::size_t kMostReported = 20;  // of noise the single lines mean nothing
  if (frequencies_Hz.empty() || frequencies_Hz.size() > kMostReported) return;
  const auto answers = sine_answers(trace.t_s, trace.target_N, trace.force_N, frequencies_Hz);
  for (const SineAnswer& answer : answers) {
    const std::string channel =
        answers.size() == 1 ? "force" : "force_" + format_number(answer.frequency_Hz) + "_Hz";
    list.add("gain", channel, "", trace.section, answer.gain);
    list.add("phase", channel, "rad", trace.section, answer.phase_rad);
    list.add("phase_lag", channel, "s", trace.section, answer.lag_s);
  }
}

void add_smoothness(const Trace& trace, MeasureList& list) {
  statistics::Computed arc = kTrackingTooShort;
  statistics::Computed jerk = kTrackingTooShort;
  statistics::Computed entropy = kTrackingTooShort;
  if (trace.t_s.size() >= 2) {
    const statistics::UniformSamples force = statistics::on_uniform_grid(trace.t_s, trace.force_N);
    const statistics::UniformSamples rate = rate_of(force);
    arc = sparc(rate);
    jerk = ldlj(rate);
    entropy = sample_entropy(force.values);
  }
  list.add("sparc", "force_rate", "", trace.section, arc);
  list.add("ldlj", "force_rate", "", trace.section, jerk);
  list.add("sample_entropy", "force", "", trace.section, entropy);
}

/// Rows from the first active one to the last: those of the waveform, pauses included.
statistics::RowRange waveform_rows(const Record& record) {
  statistics::RowRange rows{0, record.rows()};
  while (rows.first < rows.end && record.phase(rows.first) != Phase::active) ++rows.first;
  while (rows.end > rows.first && record.phase(rows.end - 1) != Phase::active) --rows.end;
  return rows;
}

/// The piece of the waveform from one time after its beginning to another.
Trace piece_of(const Record& record, double from_s, double to_s) {
  const statistics::RowRange wave = waveform_rows(record);
  if (wave.count() == 0) return trace_of(record, 0, 0, true);
  const auto t_s = record.task_times_s().subspan(wave.first, wave.count());
  const statistics::RowRange piece =
      statistics::rows_between(t_s, t_s.front() + from_s, t_s.front() + to_s);
  return trace_of(record, wave.first + piece.first, wave.first + piece.end, true);
}

/// Control of building up, of holding, and of letting go, apart.
void add_part(const ForceTrackingSpec& spec, const Record& record, const std::string& channel,
              const Trace& part, MeasureList& list) {
  list.add("rmse", channel, "N", part.section, rmse(part.target_N, part.force_N, part.weight_s));
  list.add("time_in_range", channel, "%", part.section,
           time_in_band(part.target_N, part.force_N, part.weight_s, spec.aim.band_fraction,
                        record.constant(columns::noise_sd_N).value_or(0.0)));
}

void add_ramps(const ForceTrackingSpec& spec, const Record& record, MeasureList& list) {
  using Wave = Waveform::Shape;
  const Waveform& wave = spec.waveform;
  if (wave.shape != Wave::ramp && wave.shape != Wave::trapezoid) return;
  const auto add = [&](const std::string& channel, const Trace& ramp) {
    add_part(spec, record, channel, ramp, list);
    Pauses held{"fewer than three samples"_text, "fewer than three samples"_text};
    constexpr std::size_t kLeast = 3;
    if (ramp.t_s.size() >= kLeast) {
      const double range_N = ramp.target_N.back() - ramp.target_N.front();
      const double length_s = ramp.t_s.back() - ramp.t_s.front();
      if (range_N != 0.0) held = pauses(ramp.t_s, ramp.force_N, range_N / length_s);
    }
    list.add("pauses", channel, "", ramp.section, held.count);
    list.add("pause_length", channel, "s", ramp.section, held.mean_length_s);
  };
  add("force_rise", piece_of(record, 0.0, wave.rise_s));
  if (wave.shape != Wave::trapezoid) return;
  const double fall_at_s = wave.rise_s + wave.hold_s;
  constexpr double kSettle_s = 1.0;  // the end of the ramp is no steady force yet
  const Trace hold = piece_of(record, wave.rise_s + kSettle_s, fall_at_s);
  add_part(spec, record, "force_hold", hold, list);
  add_steadiness(hold, "force_hold", record.constant(columns::noise_sd_N).value_or(0.0), list);
  add("force_fall", piece_of(record, fall_at_s, fall_at_s + wave.fall_s));
}

/// +1 while the target rises, -1 while it falls, 0 while it does neither: what it does until the
/// next sample; of the last one, what it did since the one before.
std::vector<int> directions_of(std::span<const double> target_N) {
  if (target_N.size() < 2) return std::vector<int>(target_N.size(), 0);
  const auto [least, most] = std::minmax_element(target_N.begin(), target_N.end());
  constexpr double kLevel = 1e-9;  // of the range: two rows at the same height beside a turn
  const double level_N = kLevel * (*most - *least);
  std::vector<int> directions;
  for (std::size_t k = 0; k < target_N.size(); ++k) {
    const std::size_t from = std::min(k, target_N.size() - 2);
    const double change_N = target_N[from + 1] - target_N[from];
    directions.push_back(change_N > level_N ? 1 : change_N < -level_N ? -1 : 0);
  }
  return directions;
}

/// Halves of all cycles in which the target rises, and in which it falls.
void add_halves(const ForceTrackingSpec& spec, const Record& record, const Trace& trace,
                MeasureList& list) {
  using Wave = Waveform::Shape;
  if (spec.waveform.shape != Wave::sine && spec.waveform.shape != Wave::triangle) return;
  const auto directions = directions_of(trace.target_N);
  for (const auto& [channel, sign] : {std::pair{"force_rise", 1}, std::pair{"force_fall", -1}}) {
    Trace half;
    half.section.reason = trace.section.reason;
    half.section.excluded = trace.section.excluded;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      if (directions[k] != sign) continue;
      half.section.rows.push_back(trace.section.rows[k]);
      half.force_N.push_back(trace.force_N[k]);
      half.target_N.push_back(trace.target_N[k]);
      half.weight_s.push_back(trace.weight_s[k]);
    }
    add_part(spec, record, channel, half, list);
  }
}

/// UCM analysis over the cycles of the target, where the sum of the digits is what follows it and
/// there are cycles enough.
void add_cycles(const ForceTrackingSpec& spec, const Record& record, MeasureList& list) {
  using Wave = Waveform::Shape;
  const auto [shape, f_Hz] = std::pair(spec.waveform.shape, spec.waveform.frequency_Hz);
  if (shape != Wave::sine && shape != Wave::triangle && shape != Wave::rectangle) return;
  // A channel that is a minimum of forces has no gradient that is common to all digits.
  const Digits digits = spec.aim.channel.digits;
  if (digits != Digits::sum && digits != Digits::grip_mean) return;
  constexpr std::size_t kLeftOut = 1;  // the person gets in time with the target
  constexpr std::size_t kLeast = 15;   // synergy.hpp
  constexpr double kRoundingSlack = 1e-9;
  const auto cycles =
      static_cast<std::size_t>(std::floor(spec.duration_s * f_Hz * (1.0 + kRoundingSlack)));
  if (cycles < kLeast + kLeftOut) return;
  const NormalForces forces = normal_forces(record, 0, record.rows(), {Phase::active});
  const std::size_t begin = waveform_rows(record).first;
  CycleSynergy found{"no samples"_text, "no samples"_text, "no samples"_text, "no samples"_text};
  if (!forces.section.rows.empty()) {
    std::vector<double> starts_s;
    for (std::size_t c = kLeftOut; c <= cycles; ++c)
      starts_s.push_back(record.task_time_s(begin) + static_cast<double>(c) / f_Hz);
    // A trial that ended early has no later cycles.
    constexpr double kReach_rows = 1.5;  // the last row of a whole trial lies one before its end
    const double end_s = forces.section.t_s.back() + kReach_rows * record.hold_s(begin);
    while (!starts_s.empty() && starts_s.back() > end_s) starts_s.pop_back();
    found = synergy_over_cycles(forces.section.t_s, forces.force_N, starts_s);
  }
  add_synergy(found, forces.section, list);
}

}  // namespace

std::vector<Measure> score_force_tracking(const ForceTrackingSpec& spec, const Record& record) {
  MeasureList list;
  Trace trace;
  trace.section =
      record.select({Phase::active}, {columns::target_force_N, columns::actual_force_N});
  if (trace.section.reason.empty()) {
    trace.t_s = trace.section.t_s;
    trace.weight_s = trace.section.weight_s;
    trace.target_N = trace.section.values(columns::target_force_N);
    trace.force_N = trace.section.values(columns::actual_force_N);
  }
  add_errors(record, trace, spec.aim.band_fraction, "force", list);
  add_lag(record, trace, "force", list);
  add_sines(spec, trace, list);
  add_ramps(spec, record, list);
  add_halves(spec, record, trace, list);
  add_smoothness(trace, list);
  add_cycles(spec, record, list);
  add_sharing(record, spec.aim.channel, list);
  add_force_of_maximum(record, spec.aim.channel, list);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

}  // namespace isograsp::tasks
