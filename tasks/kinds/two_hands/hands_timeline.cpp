// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/two_hands/hands_timeline.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace isograsp::tasks {

namespace {

constexpr double kMostOfMaximum = 0.5;  // asked of either hand
constexpr double kLeastSteps = 5.0;     // of the sensors in half a band …
constexpr double kLeastNoise = 3.0;     // … and standard deviations of the empty device
constexpr double kSlack = 1e-9;         // sums of shares round

double largest_of(const std::vector<double>& levels) {
  return levels.empty() ? 0.0 : *std::max_element(levels.begin(), levels.end());
}

Known word_of(Hand hand) {
  return Known{std::string(name_of(hand))};
}

/// What a segment asks of a hand at most; of a sum its part by what both can do.
/// @pre both maxima are known where there is a sum
double asked_N(const HandsSegment& segment, Hand hand, const OfHands<HandReferences>& of) {
  const double own_N = largest_of(segment.each_N[hand]);
  if (segment.sum_N.empty()) return own_N;
  const double share = *of[hand].maximum_N / (*of.left.maximum_N + *of.right.maximum_N);
  return std::max(own_N, share * largest_of(segment.sum_N));
}

bool has_target(const HandsSegment& segment) {
  return !segment.sum_N.empty() || !segment.each_N.left.empty() || !segment.each_N.right.empty();
}

Result<void> check_effort(const HandsTimeline& timeline, Effort allowed) {
  if (timeline.rests || allowed == Effort::maximum) return {};
  if (auto good = check_any_effort(allowed); !good) return good;
  for (const HandsSegment& segment : timeline.segments)
    for (const Hand hand : kBothHands)
      if (segment.cue[hand] == Cue::squeeze)
        return refused("the screening allows these hands comfortable force only"_text,
                       "leave the maxima out, and use targets in newtons"_text)
            .about("kind");
  return {};
}

Result<void> check_target(const HandsTimeline& timeline, const HandsSegment& segment,
                          const OfHands<HandReferences>& of) {
  if (auto good = check_maxima(of); !good) return good;
  OfHands<AskedOfHand> asked;
  for (const Hand hand : kBothHands) {
    const double force_N = asked_N(segment, hand, of);
    asked[hand] = {force_N, std::nullopt};
    if (segment.phase == Phase::active && force_N != 0.0)
      asked[hand].band_N = timeline.band_fraction * force_N;
  }
  return check_asked(asked, of, {timeline.level_key, "band_fraction"});
}

/// Of the frame `k` of its segment.
std::optional<double> level_at(const std::vector<double>& levels, std::int64_t k) noexcept {
  if (levels.empty()) return std::nullopt;
  return levels.size() == 1 ? levels.front() : levels[static_cast<std::size_t>(k)];
}

/// What a screen says of both: what either hand is to do, if one of them is at rest.
Cue cue_of(const OfHands<Cue>& cue) noexcept {
  return cue.left == Cue::relax ? cue.right : cue.left;
}

class PlayHands final : public Task {
 public:
  PlayHands(HandsTimeline timeline, const TaskContext& context)
      : timeline_(std::move(timeline)), period_s_(context.period_s) {
    blank_.references = context.two_hands;
    for (const HandsSegment& segment : timeline_.segments) frames_ += segment.frames;
    skip_empty();
  }

  TaskView step(const TaskInput& input) noexcept override {
    const bool over = current_ == timeline_.segments.size();
    const std::size_t here = over ? current_ - 1 : current_;
    TaskView view;
    view.segment = static_cast<int>(here);
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    TwoHandsView hands = blank_;
    if (const auto* of = std::get_if<TwoHandsInput>(&input))
      for (const Hand hand : kBothHands) hands.of[hand].force_N = force_of(of->wrench_C[hand], {});
    if (over) {
      view.phase = Phase::done;
      view.special = hands;
      return view;
    }
    const HandsSegment& segment = timeline_.segments[here];
    view.phase = segment.phase;
    view.cue = cue_of(segment.cue);
    hands.sum_shown = segment.sum_shown;
    hands.target_sum_N = level_at(segment.sum_N, frame_ - begin_);
    for (const Hand hand : kBothHands) {
      HandAsked& of = hands.of[hand];
      of.cue = segment.cue[hand];
      of.force_shown = segment.each_shown[hand];
      of.target_N = level_at(segment.each_N[hand], frame_ - begin_);
    }
    view.special = hands;
    ++frame_;
    skip_empty();
    return view;
  }

 private:
  void skip_empty() noexcept {
    while (current_ < timeline_.segments.size() &&
           frame_ - begin_ >= timeline_.segments[current_].frames)
      begin_ += timeline_.segments[current_++].frames;
  }

  HandsTimeline timeline_;
  TwoHandsView blank_;
  double period_s_;
  std::int64_t frames_ = 0;
  std::size_t current_ = 0;
  std::int64_t begin_ = 0;  ///< first frame of the current segment
  std::int64_t frame_ = 0;
};

}  // namespace

Result<void> check_any_effort(Effort allowed) {
  if (allowed != Effort::none) return {};
  return refused("the screening allows these hands no effort"_text,
                 "leave the task out, or repeat the screening"_text)
      .about("kind");
}

Result<void> check_maxima(const OfHands<HandReferences>& of) {
  for (const Hand hand : kBothHands)
    if (!(of[hand].maximum_N.value_or(0.0) > 0.0))
      return refused("the maximum force of the %1 hand was not measured in this session"_text(
                         word_of(hand)),
                     "run the resting-force task and the maximum task of both hands first"_text)
          .about("scale");
  return {};
}

Result<void> check_asked(const OfHands<AskedOfHand>& asked, const OfHands<HandReferences>& of,
                         const AskedKeys& keys) {
  for (const Hand hand : kBothHands) {
    const auto& [force_N, band_N] = asked[hand];
    if (force_N > kMostOfMaximum * *of[hand].maximum_N * (1.0 + kSlack))
      return refused("asks the %1 hand for %2 N, more than half of its maximum of %3 N"_text(
                         word_of(hand), fixed(force_N, 1), fixed(*of[hand].maximum_N, 1)),
                     "choose a lower level, or another ratio"_text)
          .about(keys.level);
    if (of[hand].ceiling_N && force_N > *of[hand].ceiling_N * (1.0 + kSlack))
      return refused("asks the %1 hand for %2 N, above its ceiling of %3 N"_text(
                         word_of(hand), fixed(force_N, 1), fixed(*of[hand].ceiling_N, 1)),
                     "choose a lower level"_text)
          .about(keys.level);
    if (!band_N) continue;
    const double least_band_N = std::max(kLeastSteps * of[hand].resolution_N.value_or(0.0),
                                         kLeastNoise * of[hand].noise_sd_N.value_or(0.0));
    if (*band_N < least_band_N * (1.0 - kSlack))
      return refused(
                 "the target of %1 N for the %2 hand has a band that its sensors cannot resolve"_text(
                     fixed(force_N, 1), word_of(hand)),
                 "choose a level of at least %1 N, or a wider band"_text(
                     fixed(least_band_N * force_N / *band_N, 1)))
          .about(keys.band);
  }
  return {};
}

HandsSegment hands_relaxed(std::int64_t frames, Phase phase) {
  HandsSegment segment;
  segment.phase = phase;
  segment.frames = frames;
  return segment;
}

Result<std::unique_ptr<Task>> play_hands(HandsTimeline timeline, const TaskContext& context) {
  if (auto good = check_effort(timeline, context.references.allowed); !good) return good.error();
  for (const HandsSegment& segment : timeline.segments)
    if (has_target(segment))
      if (auto good = check_target(timeline, segment, context.two_hands.of); !good)
        return good.error();
  return std::unique_ptr<Task>(std::make_unique<PlayHands>(std::move(timeline), context));
}

}  // namespace isograsp::tasks
