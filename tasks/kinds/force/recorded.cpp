// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings made elsewhere: their keys in a task file and their measures. Weights are how long the
// rows last; of n rows, the window is from row n - window.first to row n - window.last:
//   maximum window mean = weighted mean of |force| in the window
//   sharing of a finger = 100 (weighted mean of its force) / (weighted mean of the sum of all)
//   rhythm = frequency of the largest line of Welch's spectrum of the sum, 0.1 to 5 Hz
#include "tasks/kinds/force/recorded.hpp"

#include <algorithm>
#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/score_tools.hpp"
#include "tasks/measures/coordination/synergy.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/spectrum.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_recorded(TomlReader& reader) {
  using Measures = RecordedSpec::Measures;
  constexpr double kMostRows = 1e6;
  constexpr int kMostBeats = 100;
  constexpr double kShortest_s = 0.01;
  RecordedSpec spec;
  spec.measures = static_cast<Measures>(
      reader.choice("measures", {"corridor", "maximum", "tracking", "finger_forces"}));
  spec.duration_s = read_within(reader, "duration_s", kShortest_s, kLongestPart_s);
  if (spec.measures == Measures::maximum) {
    const auto window = reader.numbers("window_from_end_rows", 2, 2);
    const auto whole = [](double rows) {
      return rows >= 0.0 && rows <= kMostRows && rows == std::floor(rows);
    };
    if (whole(window[0]) && whole(window[1]) && window[0] > window[1])
      spec.window = {static_cast<std::size_t>(window[0]), static_cast<std::size_t>(window[1])};
    else
      reader.fail("window_from_end_rows", "is no window of rows"_text,
                  "write how many rows before the end it begins and ends, e.g. [200, 50]"_text);
  }
  if (spec.measures == Measures::finger_forces) {
    spec.fingers = reader.texts("fingers");
    if (reader.has("fingers") && spec.fingers.size() < 2)
      reader.fail("fingers", "are fewer than two"_text,
                  "name those that have a column X_fz_N"_text);
    spec.beats_per_cycle = read_count(reader, "beats_per_cycle", 1, kMostBeats);
    const auto left_out = reader.integer("cycles_left_out", 0);
    if (left_out < 0 || left_out > kMostBeats)
      reader.fail("cycles_left_out", "is out of range"_text,
                  "write a whole number from 0 to 100"_text);
    else
      spec.cycles_left_out = static_cast<int>(left_out);
  }
  return spec;
}

void add_corridor(const Record& record, MeasureList& list) {
  const Section section = record.select({}, {columns::actual_force_N, "corridor_error_N"});
  // The error is the distance from the nearer edge, so here both edges are at 0.
  const auto error_N =
      section.reason.empty() ? section.values("corridor_error_N") : std::vector<double>();
  const std::vector<double> edge_N(error_N.size(), 0.0);
  const Corridor found = corridor(edge_N, edge_N, error_N, section.weight_s);
  list.add("corridor_rms", "force", "N", section, found.rms_outside);
  list.add("corridor_distance", "force", "N", section, found.mean_outside);
  list.add("time_in_corridor", "force", "%", section, found.time_inside_percent);
}

void add_maximum(const RecordedSpec& spec, const Record& record, MeasureList& list) {
  const std::size_t rows = record.rows();
  if (rows < spec.window.first) {
    Section none;
    none.reason = kTooFewRows(spec.window.first);
    list.add("maximum_window_mean", "force", "N", none, none.reason);
    return;
  }
  const Section section = record.select(rows - spec.window.first, rows - spec.window.last, {},
                                        {columns::actual_force_N});
  statistics::Computed mean = section.reason;
  if (section.reason.empty()) {
    auto size_N = section.values(columns::actual_force_N);
    for (double& force_N : size_N) force_N = std::abs(force_N);
    mean = weighted_mean(size_N, section.weight_s);
  }
  list.add("maximum_window_mean", "force", "N", section, mean);
}

void add_tracking(const Record& record, MeasureList& list) {
  constexpr double kBand = 0.05;  // of the target, as in the tasks of this program
  const Trace trace = trace_of(record, 0, record.rows(), true);
  const auto& [section, t_s, force_N, target_N, weight_s] = trace;
  const auto add = [&](const char* name, const char* unit, const statistics::Computed& computed) {
    list.add(name, "force", unit, trace.section, computed);
  };
  add("rmse", "N", rmse(target_N, force_N, weight_s));
  add("relative_rmse", "%", relative_rmse(target_N, force_N, weight_s));
  add("mae", "N", mae(target_N, force_N, weight_s));
  add("constant_error", "N", constant_error(target_N, force_N, weight_s));
  add("time_in_range", "%",
      time_in_band(target_N, force_N, weight_s, kBand,
                   record.constant(columns::noise_sd_N).value_or(0.0)));
}

/// Forces of all fingers in the rows in which all of them are known.
struct FingerForces {
  Section section;
  std::vector<std::vector<double>> force_N;  ///< [finger][row]
};

FingerForces finger_forces_of(const RecordedSpec& spec, const Record& record) {
  std::vector<std::string> columns;
  for (const std::string& finger : spec.fingers) columns.push_back(finger + "_fz_N");
  FingerForces forces;
  forces.section = record.select({}, columns);
  if (!forces.section.reason.empty()) return forces;
  for (const std::string& column : columns) forces.force_N.push_back(forces.section.values(column));
  return forces;
}

/// When cycles begin [s]: every beats_per_cycle-th beat; empty: there is no column of beats.
std::vector<double> cycle_starts(const RecordedSpec& spec, const Record& record,
                                 const Section& section) {
  constexpr double kBeat = 0.5;  // 0 or 1 is written
  const auto beat = record.signals().column("beat");
  std::vector<double> starts_s;
  if (beat.empty()) return starts_s;
  int beats = 0;
  for (std::size_t k = 0; k < section.rows.size(); ++k) {
    if (!(beat[section.rows[k]] > kBeat)) continue;
    if (beats % spec.beats_per_cycle == 0) starts_s.push_back(section.t_s[k]);
    ++beats;
  }
  return starts_s;
}

/// UCM analysis over the cycles of the metronome, without those at the beginning.
void add_synergy(const RecordedSpec& spec, const Record& record, const FingerForces& forces,
                 MeasureList& list) {
  const auto starts_s = cycle_starts(spec, record, forces.section);
  const auto left_out = static_cast<std::size_t>(spec.cycles_left_out);
  constexpr Words none = "there are no beats that cut the recording into cycles"_text;
  CycleSynergy found{none, none, none, none};
  if (starts_s.size() > left_out + 1 && forces.section.reason.empty())
    found = synergy_over_cycles(forces.section.t_s, forces.force_N,
                                std::span(starts_s).subspan(left_out));
  add_synergy(found, forces.section, list);
}

void add_finger_forces(const RecordedSpec& spec, const Record& record, MeasureList& list) {
  constexpr Band kRhythms{0.1, 5.0};  // from slow swings to as fast as fingers press
  const FingerForces forces = finger_forces_of(spec, record);
  const Section& section = forces.section;
  std::vector<double> sum_N(section.rows.size(), 0.0);
  for (const auto& finger_N : forces.force_N)
    for (std::size_t k = 0; k < sum_N.size(); ++k) sum_N[k] += finger_N[k];
  const bool enough = section.rows.size() >= 2;
  list.add("rhythm", "force", "Hz", section,
           enough ? peak_frequency(welch(statistics::on_uniform_grid(section.t_s, sum_N)), kRhythms)
                  : statistics::Computed("fewer than two samples"_text));
  const statistics::Computed all = weighted_mean(sum_N, section.weight_s);
  for (std::size_t f = 0; f < spec.fingers.size(); ++f) {
    statistics::Computed share = "the fingers did not press"_text;
    if (f < forces.force_N.size() && all.value && *all.value > 0.0)
      share = 100.0 * *weighted_mean(forces.force_N[f], section.weight_s).value / *all.value;
    list.add("sharing", spec.fingers[f], "%", section, share);
  }
  add_synergy(spec, record, forces, list);
}

std::vector<Measure> score_recorded(const RecordedSpec& spec, const Record& record) {
  MeasureList list;
  switch (spec.measures) {
    case RecordedSpec::Measures::corridor: add_corridor(record, list); break;
    case RecordedSpec::Measures::maximum: add_maximum(spec, record, list); break;
    case RecordedSpec::Measures::tracking: add_tracking(record, list); break;
    case RecordedSpec::Measures::finger_forces: add_finger_forces(spec, record, list); break;
  }
  return list.take();
}

Duration recorded_duration(const RecordedSpec& spec) {
  return {spec.duration_s, spec.duration_s};
}

constexpr PlacedMeasure kRecordedPlaces[] = {{"corridor_rms", "", Prominence::key},
                                             {"time_in_corridor", "", Prominence::key},
                                             {"corridor_distance", "", Prominence::trend},
                                             {"maximum_window_mean", "", Prominence::key},
                                             {"relative_rmse", "", Prominence::key},
                                             {"time_in_range", "", Prominence::trend},
                                             {"rhythm", "", Prominence::trend},
                                             {"sharing", "", Prominence::trend}};

}  // namespace

constinit const KindFacts RecordedSpec::kFacts{.name = "recorded",
                                               .group = TaskGroup::follow,
                                               .read = read_recorded,
                                               .duration = of_kind<recorded_duration>,
                                               .measures = of_kind<score_recorded>,
                                               .places = kRecordedPlaces};

}  // namespace isograsp::tasks
