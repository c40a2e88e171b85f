// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of forces that answer a cue: steps, letting go, and finding a force again.
#include <cmath>

#include "tasks/kinds/score_kinds.hpp"
#include "tasks/kinds/score_tools.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/force_sense.hpp"
#include "tasks/measures/known_delay.hpp"
#include "tasks/measures/release.hpp"
#include "tasks/measures/step.hpp"

namespace isograsp::tasks {

namespace {

/// 0: not known.
double known_or_zero(const Record& record, const Part& part, std::string_view column) {
  const double value = known_in(record, part, column);
  return std::isnan(value) ? 0.0 : value;
}

/// Times of an event that may be censored, and the same without the known delay: their
/// median, as NAME_corrected.
void add_delayed_times(const std::string& name, const std::string& channel, const Record& record,
                       const Section& section, const std::vector<statistics::EventTime>& times,
                       double limit_s, MeasureList& list) {
  const auto delay_s = record.known_delay_s();
  std::vector<statistics::EventTime> corrected = times;
  for (statistics::EventTime& time : corrected)
    if (time.time_s.value) time.time_s = without_delay(time.time_s, delay_s).corrected_s;
  list.add_times(name, channel, section, times, limit_s);
  list.add(name + "_corrected", channel, "s", section,
           delay_s ? median_time(corrected, limit_s)
                   : statistics::Computed("the delay of the device is not known"));
}

/// Reaction times of several cues: anticipations are excluded and counted, misses are censored.
void add_reactions(const std::string& name, const std::string& channel, const Record& record,
                   const Section& section, const std::vector<Reaction>& reactions, double limit_s,
                   MeasureList& list) {
  std::vector<statistics::EventTime> times;
  int anticipations = 0;
  for (const Reaction& reaction : reactions) {
    if (reaction.anticipated_s)
      ++anticipations;
    else
      times.push_back(reaction.time);
  }
  add_delayed_times(name, channel, record, section, times, limit_s, list);
  list.add("anticipations", channel, "", section,
           reactions.empty() ? statistics::Computed("there was no cue")
                             : statistics::Computed(static_cast<double>(anticipations)));
}

}  // namespace

std::vector<Measure> measures_of(const StepResponseSpec& spec, const Record& record) {
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
    const double from_N = known_in(record, parts[i - 1], "target_force_N");
    const double to_N = known_in(record, part, "target_force_N");
    if (trace.empty() || !(from_N != to_N)) continue;
    const CuedStep step{record.task_time_s(part.first), from_N, to_N};
    const CuedStepResponse response = cued_step_response(
        trace.t_s, trace.force_N, step, known_or_zero(record, part, "resolution_N"));
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

std::vector<Measure> measures_of(const GripReleaseSpec& spec, const Record& record) {
  MeasureList list;
  std::vector<Section> sections;
  std::vector<Reaction> initiations;
  std::vector<statistics::EventTime> releases;
  std::vector<statistics::Computed> residual, fastest, opening;
  int missed = 0;
  const auto parts = parts_of(record);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Part& part = parts[i];
    if (part.phase != Phase::active) continue;
    // An opening is asked for in another channel; letting go is seen in the grip's own.
    const Part& held = parts[i - 1];
    Trace trace = trace_of(record, held.first, part.last);
    if (trace.empty()) continue;
    if (spec.open)
      for (std::size_t k = 0; k < trace.t_s.size(); ++k)
        if (trace.section.rows[k] >= part.first) trace.force_N[k] = -trace.force_N[k];
    const double resting_N = known_in(record, held, "resting_force_N");
    const AskedGrip asked{known_or_zero(record, held, "target_force_N"),
                          known_or_zero(record, held, "resting_force_N"),
                          known_or_zero(record, held, "noise_sd_N"),
                          known_or_zero(record, part, "resolution_N")};
    const Release let_go = release(trace.t_s, trace.force_N, record.task_time_s(part.first), asked);
    if (!let_go.grip_made.value_or(true)) ++missed;
    initiations.push_back(let_go.initiation);
    const bool rested = !std::isnan(resting_N);
    const char* unknown = "the resting force was not measured";
    releases.push_back(rested ? let_go.release : statistics::EventTime{unknown, std::nullopt});
    residual.push_back(rested ? let_go.residual_N : statistics::Computed(unknown));
    fastest.push_back(let_go.fastest_N_per_s);
    const Trace after = trace_of(record, part.first, part.last);
    sections.push_back(after.section);
    if (!spec.open) continue;
    const std::vector<bool> all_count(after.force_N.size(), true);
    constexpr double kWindow_s = 0.5;
    opening.push_back(best_moving_mean(after.force_N, after.weight_s, all_count, kWindow_s));
  }
  const Section all = join(sections);
  const std::string channel = name_of(spec.aim.channel);
  add_reactions("release_initiation", channel, record, all, initiations, spec.after_s, list);
  add_delayed_times("release_time", channel, record, all, releases, spec.after_s, list);
  list.add("grips_missed", channel, "", all,
           initiations.empty() ? statistics::Computed("there was no cue")
                               : statistics::Computed(static_cast<double>(missed)));
  list.add_mean("residual_force", channel, "N", all, residual);
  list.add_mean("fastest_release", channel, "N/s", all, fastest);
  if (spec.open) list.add_mean("opening_force", "opening", "N", all, opening);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

std::vector<Measure> measures_of(const ForceSenseSpec& spec, const Record& record) {
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

}  // namespace isograsp::tasks
