// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/entry_capture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/tracked_hand/hand_size.hpp"
#include "virtual_hand/hand_frame.hpp"

namespace isograsp::session {

EntryCapture::EntryCapture(double period_s, double settle_s, Hand side,
                           const virtual_hand::HandModel& model,
                           std::optional<virtual_hand::HandModel> of_other)
    : period_s_(period_s),
      wait_s_(settle_s),
      side_(side),
      model_(model),
      of_other_(std::move(of_other)),
      entry_(period_s) {
  at_rest_.reserve(static_cast<std::size_t>(std::ceil(HandEntry::kRest_s / period_s)) + 1);
}

bool EntryCapture::add(const ShownHand& hand, double gap_m) noexcept {
  if (wait_s_ > 0.0) {
    wait_s_ -= period_s_;
    return false;
  }
  const bool seen = !hand.held;
  if (entry_.stage() == HandEntry::Stage::rest) {
    if (seen && at_rest_.size() < at_rest_.capacity()) at_rest_.push_back(hand.frame);
  } else {
    ++opening_frames_;
  }
  return entry_.add(seen, gap_m);
}

double EntryCapture::progress() const noexcept {
  constexpr double kRestShare = 0.5;
  if (entry_.stage() == HandEntry::Stage::ended) return 1.0;
  if (entry_.stage() == HandEntry::Stage::rest)
    return kRestShare * entry_.stage_s() / HandEntry::kRest_s;
  return kRestShare + (1.0 - kRestShare) * entry_.openings() / HandEntry::kOpenings;
}

EntryShown EntryCapture::shown() const noexcept {
  const double t_s = static_cast<double>(opening_frames_) * period_s_;
  return {entry_.stage(), std::fmod(t_s, 2.0 * kEach_s) < kEach_s, entry_.openings()};
}

Result<virtual_hand::HandModel> EntryCapture::hand() const {
  if (of_other_) return *of_other_;
  auto measured = virtual_hand::calibrated_hand(at_rest_, side_, model_);
  if (!measured) return measured.error();
  return std::move(measured->hand);
}

PreparationOutcome EntryCapture::outcome() const {
  PreparationOutcome outcome;
  outcome.name = "entry test of the hand";
  storage::PreparationRecord& record = outcome.record;
  record.kind = kHandEntry;
  record.samples = static_cast<std::int64_t>(at_rest_.size());
  outcome.accepted = entry_.refusal() == HandEntry::Refusal::none;
  if (!outcome.accepted) {
    outcome.reason = words_of(entry_.refusal());
    return outcome;
  }
  const auto measured = hand();
  if (!measured) {
    outcome.accepted = false;
    outcome.reason = measured.error().what;
    return outcome;
  }
  add_hand_size(*measured, record);
  record.references.emplace("opening_m", entry_.opening_m());
  record.references.emplace("widest_object_m", entry_.widest_object_m());
  record.references.emplace("tracked_share", entry_.tracked_share());
  record.references.emplace("openings", static_cast<double>(entry_.openings()));
  record.references.emplace(kSizeOfOtherHand, of_other_ ? 1.0 : 0.0);
  return outcome;
}

}  // namespace isograsp::session
