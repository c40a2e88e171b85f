// SPDX-License-Identifier: GPL-3.0-or-later
// Where the hand opens afterwards, the opening has a channel of its own: force_N, positive when the
// digits open, is turned to -force_N, so that one trace goes from the grip through zero.
//   opening force = largest mean of the opening's own force over 0.5 s
#include "tasks/kinds/force/grip_release.hpp"

#include <cmath>

#include "hand/columns.hpp"
#include "tasks/kinds/tools/cue_score.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_force_keys.hpp"
#include "tasks/kinds/tools/segments.hpp"
#include "tasks/measures/error.hpp"
#include "tasks/measures/release.hpp"

namespace isograsp::tasks {

namespace {

KindSpec read_grip_release(TomlReader& reader) {
  GripReleaseSpec spec;
  spec.aim = read_aim(reader);
  spec.level = read_level(reader, spec.aim, "level", spec.level);
  spec.rise_s = read_wait(reader, "rise_s", spec.rise_s);
  read_waits(reader, spec.least_wait_s, spec.most_wait_s);
  spec.after_s = read_duration(reader, "after_s", spec.after_s);
  spec.open = reader.boolean("open", false);
  spec.repetitions = read_count(reader, "repetitions", spec.repetitions, kMostRepetitions);
  if (spec.aim.channel.direction != Direction::plus_z)
    reader.fail("channel", "is not a closing force"_text, "only what is held can be let go"_text);
  return spec;
}

Segments grip_release_segments(const GripReleaseSpec& spec, const Unit& unit, Pace& pace) {
  const double level_N = spec.level * unit(spec.aim.channel);
  ForceChannel opening = spec.aim.channel;
  opening.direction = Direction::minus_z;
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition) {
    const double wait_s = pace.wait(spec.least_wait_s, spec.most_wait_s);
    segments.push_back(to_level(spec.aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace));
    segments.push_back(on_level(spec.aim, level_N, wait_s, Phase::hold, pace));
    Segment release = effort(spec.open ? opening : spec.aim.channel,
                             spec.open ? Cue::squeeze : Cue::let_go, spec.after_s, pace);
    release.force_shown = spec.aim.force_shown;
    segments.push_back(std::move(release));
  }
  return segments;
}

std::vector<Measure> score_grip_release(const GripReleaseSpec& spec, const Record& record) {
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
    const double resting_N = known_in(record, held, columns::resting_force_N);
    const AskedGrip asked{known_or_zero(record, held, columns::target_force_N),
                          known_or_zero(record, held, columns::resting_force_N),
                          known_or_zero(record, held, columns::noise_sd_N),
                          known_or_zero(record, part, columns::resolution_N)};
    const Release released =
        release(trace.t_s, trace.force_N, record.task_time_s(part.first), asked);
    if (!released.grip_made.value_or(true)) ++missed;
    initiations.push_back(released.initiation);
    const bool rested = !std::isnan(resting_N);
    constexpr Words unknown = "the resting force was not measured"_text;
    releases.push_back(rested ? released.release : statistics::EventTime{unknown, std::nullopt});
    residual.push_back(rested ? released.residual_N : statistics::Computed(unknown));
    fastest.push_back(released.fastest_N_per_s);
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
           initiations.empty() ? statistics::Computed("there was no cue"_text)
                               : statistics::Computed(static_cast<double>(missed)));
  list.add_mean("residual_force", channel, "N", all, residual);
  list.add_mean("fastest_release", channel, "N/s", all, fastest);
  if (spec.open) list.add_mean("opening_force", "opening", "N", all, opening);
  add_net_push(record, spec.aim.channel, list);
  return list.take();
}

// How many were let go at all is read before how soon.
constexpr PlacedMeasure kGripReleasePlaces[] = {{"release_time_share", "", Prominence::key},
                                                {"release_time", "", Prominence::key},
                                                {"residual_force", "", Prominence::trend},
                                                {"opening_force", "", Prominence::trend}};

constexpr ComponentMeasure kGripReleaseComponents[] = {
    {Component::release, "release_time_restricted", ""}};

}  // namespace

constinit const KindFacts GripReleaseSpec::kFacts{
    .name = "grip_release",
    .group = TaskGroup::hold_and_let_go,
    .read = read_grip_release,
    .aim = own_aim<GripReleaseSpec>,
    .largest_level = own_level<GripReleaseSpec>,
    .multiply = multiply<GripReleaseSpec>,
    .wardrobe = Wardrobe::curve,
    .repetitions = [](const KindSpec& kind) { return kind.as<GripReleaseSpec>().repetitions; },
    .segments = of_kind<grip_release_segments>,
    .measures = of_kind<score_grip_release>,
    .places = kGripReleasePlaces,
    .components = kGripReleaseComponents,
    .unforeseen_waits = true};

}  // namespace isograsp::tasks
