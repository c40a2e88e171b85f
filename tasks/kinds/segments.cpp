// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/segments.hpp"

#include "tasks/kinds/make_task.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

std::int64_t Pace::frames(double duration_s) const noexcept {
  return frames_in(duration_s, period_s_);
}

double Pace::wait(double least_s, double most_s) noexcept {
  if (waits_ == Waits::longest) return most_s;
  if (waits_ == Waits::mean) return 0.5 * (least_s + most_s);
  return least_s + (most_s - least_s) * random_.uniform();
}

namespace {

Segment relaxed(ForceChannel channel, double duration_s, const Pace& pace,
                Phase phase = Phase::lead_in) {
  Segment segment;
  segment.phase = phase;
  segment.cue = Cue::relax;
  segment.channel = channel;
  segment.frames = pace.frames(duration_s);
  return segment;
}

Segment effort(ForceChannel channel, Cue cue, double duration_s, const Pace& pace) {
  Segment segment;
  segment.cue = cue;
  segment.channel = channel;
  segment.frames = pace.frames(duration_s);
  return segment;
}

/// A target that stays at `level_N`.
Segment on_level(const Aim& aim, double level_N, double duration_s, Phase phase, const Pace& pace) {
  Segment segment;
  segment.phase = phase;
  segment.cue = Cue::follow;
  segment.channel = aim.channel;
  segment.force_shown = aim.force_shown;
  segment.frames = pace.frames(duration_s);
  segment.target_N = {level_N};
  return segment;
}

/// A straight target from one level to another; its end is the first value of what follows.
Segment to_level(const Aim& aim, double from_N, double to_N, double duration_s, Phase phase,
                 const Pace& pace) {
  Segment segment = on_level(aim, to_N, duration_s, phase, pace);
  if (segment.frames == 0) return segment;
  segment.target_N.resize(static_cast<std::size_t>(segment.frames));
  for (std::size_t k = 0; k < segment.target_N.size(); ++k)
    segment.target_N[k] =
        std::lerp(from_N, to_N, static_cast<double>(k) / static_cast<double>(segment.frames));
  return segment;
}

}  // namespace

Segments segments_of(const RestSpec& spec, const Unit&, Pace& pace) {
  return {relaxed({}, spec.duration_s, pace, Phase::active)};
}

Segments segments_of(const MaximumSpec& spec, const Unit&, Pace& pace) {
  const Cue cue = spec.comfortable ? Cue::press : Cue::squeeze;
  Segments segments{relaxed(spec.channel, spec.lead_in_s, pace),
                    effort(spec.channel, cue, spec.squeeze_s, pace)};
  segments.back().force_shown = spec.force_shown;
  return segments;
}

Segments segments_of(const DirectionalMaximaSpec& spec, const Unit&, Pace& pace) {
  Segments segments;
  for (const Finger digit : spec.digits)
    for (const Direction direction : spec.directions) {
      const ForceChannel channel = channel_of(digit, direction);
      segments.push_back(relaxed(channel, spec.lead_in_s, pace));
      segments.push_back(effort(channel, Cue::squeeze, spec.push_s, pace));
      segments.push_back(relaxed(channel, spec.rest_s, pace));
    }
  return segments;
}

Segments segments_of(const ForceTrackingSpec& spec, const Unit& unit, Pace& pace) {
  const double unit_N = unit(spec.aim.channel);
  const double least_N = spec.least * unit_N;
  const double range_N = (spec.most - spec.least) * unit_N;
  auto target_N = samples_of(spec.waveform, spec.duration_s, pace.period_s(), pace.seed());
  for (double& value : target_N) value = least_N + range_N * value;
  Segments segments{on_level(spec.aim, target_N.empty() ? least_N : target_N.front(),
                             spec.lead_in_s, Phase::lead_in, pace),
                    on_level(spec.aim, 0.0, spec.duration_s, Phase::active, pace)};
  segments.back().target_N = std::move(target_N);
  return segments;
}

Segments segments_of(const SteadinessSpec& spec, const Unit& unit, Pace& pace) {
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

Segments segments_of(const StepResponseSpec& spec, const Unit& unit, Pace& pace) {
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

Segments segments_of(const GripReleaseSpec& spec, const Unit& unit, Pace& pace) {
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

Segments segments_of(const ForceSenseSpec& spec, const Unit& unit, Pace& pace) {
  const double level_N = spec.level * unit(spec.aim.channel);
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition) {
    segments.push_back(on_level(spec.aim, level_N, spec.learn_s, Phase::lead_in, pace));
    segments.back().force_shown = true;
    segments.push_back(relaxed(spec.aim.channel, spec.pause_s, pace));
    Segment again = on_level(spec.aim, level_N, spec.reproduce_s, Phase::active, pace);
    again.cue = Cue::reproduce;
    again.force_shown = false;
    again.target_shown = false;
    segments.push_back(std::move(again));
    segments.push_back(relaxed(spec.aim.channel, spec.pause_s, pace));
  }
  return segments;
}

Segments segments_of(const FatigueSpec& spec, const Unit& unit, Pace& pace) {
  const double level_N = spec.level * unit(spec.aim.channel);
  return {to_level(spec.aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace),
          on_level(spec.aim, level_N, spec.hold_s, Phase::active, pace)};
}

Segments segments_of(const IndividuationSpec& spec, const Unit& unit, Pace& pace) {
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition)
    for (const double level : spec.levels)
      for (const Finger digit : spec.digits) {
        Aim aim = spec.aim;
        aim.channel = channel_of(digit);
        const double level_N = level * unit(aim.channel);
        segments.push_back(relaxed(aim.channel, spec.rest_s, pace));
        segments.push_back(to_level(aim, 0.0, level_N, spec.rise_s, Phase::lead_in, pace));
        segments.push_back(on_level(aim, level_N, spec.hold_s, Phase::active, pace));
      }
  return segments;
}

Segments segments_of(const ForceDirectionSpec& spec, const Unit& unit, Pace& pace) {
  Segments segments;
  for (int repetition = 0; repetition < spec.repetitions; ++repetition)
    for (const ForceDirectionTarget& target : spec.targets) {
      Segment push;
      push.cue = Cue::follow;
      push.force_shown = spec.aim.force_shown;
      push.digits.shown = target.asked;
      for (const Finger digit : kFingers) {
        const std::size_t f = index_of(digit);
        if (!target.asked[f]) continue;
        push.channel = channel_of(digit);  // of the last one asked: its level stands for the trial
        push.digits.force_C[f] = target.level * unit(channel_of(digit)) * target.direction_C[f];
      }
      push.phase = Phase::lead_in;
      push.frames = pace.frames(spec.rise_s);
      segments.push_back(push);
      push.phase = Phase::active;
      push.frames = pace.frames(spec.hold_s);
      segments.push_back(push);
      segments.push_back(relaxed(push.channel, spec.rest_s, pace));
    }
  return segments;
}

}  // namespace isograsp::tasks
