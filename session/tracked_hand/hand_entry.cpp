// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_entry.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::session {

double thumb_index_gap(const HandFrame& hand) noexcept {
  constexpr std::size_t kTip = 3;
  return (hand.joints[joint_of(Digit::index, kTip)] - hand.joints[joint_of(Digit::thumb, kTip)])
      .norm();
}

HandEntry::HandEntry(double period_s) noexcept
    : period_s_(period_s),
      standing_(static_cast<std::size_t>(
          std::clamp(std::ceil(kStands_s / period_s), 1.0, static_cast<double>(kMostStanding)))) {}

bool HandEntry::add(bool tracked, double gap_m) noexcept {
  if (stage_ == Stage::ended) return true;
  const bool seen = tracked && std::isfinite(gap_m);
  ++frames_;
  const double passed_s = static_cast<double>(frames_) * period_s_;
  constexpr double kRounding_s = 1e-9;
  if (stage_ == Stage::rest) {
    seen_ += seen ? 1 : 0;
    if (passed_s < kRest_s - kRounding_s) return false;
    if (tracked_share() < kLeastTracked) {
      refusal_ = Refusal::badly_tracked;
      stage_ = Stage::ended;
      return true;
    }
    rest_frames_ = frames_;
    frames_ = 0;
    stage_ = Stage::openings;
    return false;
  }
  if (seen)
    open(gap_m);
  else
    known_ = 0;  // what stands must be seen on end
  if (openings_ == kOpenings || passed_s >= kLongest_s - kRounding_s) end();
  return stage_ == Stage::ended;
}

void HandEntry::open(double gap_m) noexcept {
  last_m_[next_] = gap_m;
  next_ = (next_ + 1) % standing_;
  known_ = std::min(known_ + 1, standing_);
  if (known_ < standing_) return;
  const auto end = last_m_.begin() + static_cast<std::ptrdiff_t>(standing_);
  const double stood_m = *std::min_element(last_m_.begin(), end);
  opening_m_ = std::max(opening_m_, stood_m);
  least_m_ = std::min(least_m_.value_or(stood_m), stood_m);
  most_m_ = std::max(most_m_.value_or(stood_m), stood_m);
  if (!opening_ && stood_m - *least_m_ >= kMovement_m) {
    opening_ = true;
    most_m_ = stood_m;
  } else if (opening_ && *most_m_ - stood_m >= kMovement_m) {
    opening_ = false;
    least_m_ = stood_m;
    ++openings_;
  }
}

void HandEntry::end() noexcept {
  stage_ = Stage::ended;
  if (openings_ == 0 || opening_m_ < kLeastOpening_m) refusal_ = Refusal::opens_little;
}

double HandEntry::tracked_share() const noexcept {
  const std::int64_t frames = stage_ == Stage::rest || rest_frames_ == 0 ? frames_ : rest_frames_;
  return frames == 0 ? 0.0 : static_cast<double>(seen_) / static_cast<double>(frames);
}

Words words_of(HandEntry::Refusal refusal) noexcept {
  switch (refusal) {
    case HandEntry::Refusal::badly_tracked:
      return "The tracker loses this hand at rest: move the camera, take off what shines, light the table evenly."_text;
    case HandEntry::Refusal::opens_little:
      return "This hand opens too little for virtual objects: use the tasks \"Opening force\" and \"Open on cue\" of the force platform."_text;
    default: return "The hand is seen well and opens."_text;
  }
}

}  // namespace isograsp::session
