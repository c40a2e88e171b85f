// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tasks/waveform.hpp"

namespace isograsp::tasks {

namespace {

/// Largest target of the segment [N].
double largest_N(const Segment& segment) {
  double largest = 0.0;
  for (const double value : segment.target_N) largest = std::max(largest, std::abs(value));
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (segment.digits.shown[f]) largest = std::max(largest, segment.digits.force_C[f].norm());
  return largest;
}

Result<void> check_effort(const TaskSpec& spec, const Timeline& timeline,
                          const ForceReferences& references) {
  if (spec.kind->rests) return {};
  if (references.allowed == Effort::none)
    return refused("the screening allows this hand no effort"_text,
                   "leave the task out, or repeat the screening"_text)
        .at(spec.file)
        .about("kind");
  if (references.allowed == Effort::maximum) return {};
  const bool squeezes = std::any_of(timeline.segments.begin(), timeline.segments.end(),
                                    [](const Segment& s) { return s.cue == Cue::squeeze; });
  if (squeezes || spec.kind->tires)
    return refused(
               "the screening allows this hand comfortable force only"_text,
               "use the comfortable-force task, and targets in newtons or of comfortable force"_text)
        .at(spec.file)
        .about("kind");
  return {};
}

/// For people: three significant digits.
std::string newtons(double force_N) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g N", force_N);
  return text;
}

/// Refuses a target whose band the sensors cannot resolve: they must tell a force on the target
/// from one beside it (clinical rule).
Result<void> check_resolution(const TaskSpec& spec, const Segment& segment,
                              const ForceReferences& references) {
  constexpr double kLeastSteps = 5.0;
  constexpr double kLeastNoise = 3.0;
  const Aim* aim = spec.aim();
  const double target_N = largest_N(segment);
  if (aim == nullptr || segment.phase != Phase::active || target_N == 0.0) return {};
  const double least_band_N =
      std::max(kLeastSteps * references.resolution_N.value_or(0.0),
               kLeastNoise * references.noise(segment.channel).value_or(0.0));
  const double band = aim->band_fraction * target_N;
  constexpr double kRounding = 1e-9;
  if (band >= least_band_N * (1.0 - kRounding)) return {};
  return refused("the target of %1 has a band of +-%2, which the sensors cannot resolve"_text(
                     newtons(target_N), newtons(band)),
                 "choose a level of at least %1, or a wider band"_text(
                     newtons(least_band_N / aim->band_fraction)))
      .at(spec.file)
      .about("band_fraction");
}

Result<void> check(const TaskSpec& spec, const Timeline& timeline,
                   const ForceReferences& references) {
  if (auto allowed = check_effort(spec, timeline, references); !allowed) return allowed;
  for (const Segment& segment : timeline.segments) {
    if (references.ceiling_N && largest_N(segment) > *references.ceiling_N)
      return refused("the target of %1 is above the ceiling of %2 for this hand"_text(
                         newtons(largest_N(segment)), newtons(*references.ceiling_N)),
                     "choose a lower level"_text)
          .at(spec.file);
    if (auto resolved = check_resolution(spec, segment, references); !resolved) return resolved;
  }
  return {};
}

class Play final : public Task {
 public:
  Play(Timeline timeline, const TaskContext& context)
      : timeline_(std::move(timeline)), period_s_(context.period_s), frames_(timeline_.frames()) {
    for (const Segment& segment : timeline_.segments)
      views_.push_back(view_of(segment, context.references));
    skip_empty();
  }

  TaskView step(const TaskInput& input) noexcept override {
    const bool over = current_ == timeline_.segments.size();
    const std::size_t here = over ? current_ - 1 : current_;
    TaskView view = views_[here];
    auto& force = std::get<ForceView>(view.special);
    view.segment = static_cast<int>(here);
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    force = with_force(force, input);
    if (over) {
      view.phase = Phase::done;
      view.cue = Cue::relax;
      force.has_force_target = force.force_target_shown = false;
      return view;
    }
    const auto& target_N = timeline_.segments[here].target_N;
    if (target_N.size() > 1)
      force.target_force_N = target_N[static_cast<std::size_t>(frame_ - begin_)];
    ++frame_;
    skip_empty();
    return view;
  }

 private:
  static TaskView view_of(const Segment& segment, const ForceReferences& references) {
    ForceView force = blank_force(references, segment.channel);
    force.force_shown = segment.force_shown;
    force.digit_targets = segment.digits;
    force.has_force_target = !segment.target_N.empty();
    force.force_target_shown = force.has_force_target && segment.target_shown;
    if (force.has_force_target) force.target_force_N = segment.target_N.front();
    TaskView view;
    view.phase = segment.phase;
    view.cue = segment.cue;
    view.special = force;
    return view;
  }
  /// To the segment of the present frame.
  void skip_empty() noexcept {
    while (current_ < timeline_.segments.size() &&
           frame_ - begin_ >= timeline_.segments[current_].frames)
      begin_ += timeline_.segments[current_++].frames;
  }

  Timeline timeline_;
  std::vector<TaskView> views_;  ///< one per segment: all that does not change in it
  double period_s_;
  std::int64_t frames_;
  std::size_t current_ = 0;
  std::int64_t begin_ = 0;  ///< first frame of the current segment
  std::int64_t frame_ = 0;
};

}  // namespace

std::int64_t Timeline::frames() const noexcept {
  std::int64_t sum = 0;
  for (const Segment& segment : segments) sum += segment.frames;
  return sum;
}

Result<Timeline> timeline_of(const TaskSpec& spec, const TaskContext& context) {
  if (const Waveform* wave = spec.waveform();
      wave != nullptr && wave->shape == Waveform::Shape::csv && wave->values.empty())
    return refused("the points of %1 were not loaded"_text(wave->csv),
                   "put the file beside the task"_text)
        .at(spec.file)
        .about("csv");
  std::optional<Error> problem;
  const Aim* aim = spec.aim();
  const Unit unit = [&](ForceChannel channel) {
    if (aim == nullptr) return 1.0;
    auto found = context.references.unit_N(aim->scale, channel, spec.largest_level());
    if (found) return *found;
    if (!problem) problem = found.error();
    return 1.0;
  };
  Pace pace(context.period_s, context.seed);
  Timeline timeline;
  if (spec.kind->segments != nullptr)
    timeline.segments = spec.kind->segments(spec.kind, unit, pace);
  if (problem) {
    problem->file = spec.file;
    return *problem;
  }
  if (auto good = check(spec, timeline, context.references); !good) return good.error();
  return timeline;
}

std::unique_ptr<Task> play(Timeline timeline, const TaskContext& context) {
  return std::make_unique<Play>(std::move(timeline), context);
}

}  // namespace isograsp::tasks
