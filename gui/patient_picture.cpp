// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_picture.hpp"

#include <algorithm>
#include <cctype>

#include "gui/cue_words.hpp"

namespace isograsp {

namespace {

using Page = PatientPicture::Page;
using Sign = PatientPicture::Sign;
using Notice = PatientPicture::Notice;

/// A finger that does not touch stands off at most this far [m].
constexpr double kStandOff_m = 0.030;
/// Force that brings a finger to the surface when the scene has no threshold [N].
constexpr double kApproach_N = 1.0;
/// Effort is shown full at this force when no maximum was measured [N].
constexpr double kAssumedMaximum_N = 30.0;
/// Where the column of an effort is about two thirds full. It is the same for every patient and
/// attempt, so that more force always looks like more; opening, sideways and single digits are
/// weaker than the whole grip.
constexpr double kFullGrip_N = 30.0;
constexpr double kFullOther_N = 12.0;
/// Distance of a digit's force from its target that looks like "on it", of the largest target.
constexpr double kOnTarget = 0.15;

FingerPicture picture_finger(const Contact& contact, const PatientFacts& facts) {
  const Snapshot& now = facts.snapshot;
  const auto f = index_of(contact.finger);
  FingerPicture finger;
  finger.shown = true;
  finger.touching = now.grasp.contact[f];
  const double normal_N = std::max(0.0, now.forces.wrench_C[f].force.z());
  const double maximum_N = facts.maximum_force_N > 0.0 ? facts.maximum_force_N : kAssumedMaximum_N;
  finger.effort = std::clamp(normal_N / maximum_N, 0.0, 1.0);
  const double reach_N = contact.threshold_N > 0.0 ? contact.threshold_N : kApproach_N;
  const double gap_m =
      finger.touching ? 0.0 : kStandOff_m * (1.0 - 0.8 * std::min(1.0, normal_N / reach_N));
  const Vec3 normal_O = contact.R_OC.col(2);
  finger.axis_W = now.object.pose.q_WO * normal_O;
  finger.tip_W = now.object.pose.p_WO + now.object.pose.q_WO * (contact.p_OC - gap_m * normal_O);
  return finger;
}

void add_object(const PatientFacts& facts, PatientPicture& picture) {
  const Snapshot& now = facts.snapshot;
  picture.page = Page::object;
  picture.scene = facts.scene;
  picture.object = now.object.pose;
  picture.target_shown = now.task.pose_target_shown;
  picture.target = now.task.target;
  picture.hold_fraction = now.task.hold_fraction;
  picture.targets_reached = now.task.targets_reached;
  picture.target_count = now.task.target_count;
  for (const auto& contact : facts.scene->contacts)
    picture.fingers[index_of(contact.finger)] = picture_finger(contact, facts);
}

void say(PatientPicture& picture, Sign sign, std::string headline, std::string detail = "") {
  picture.sign = sign;
  picture.headline = std::move(headline);
  picture.detail = std::move(detail);
}

void say(PatientPicture& picture, Sign sign, CueWords words) {
  say(picture, sign, std::move(words.headline), std::move(words.detail));
}

void add_object_words(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  if (std::holds_alternative<PoseTrackingSpec>(facts.task->kind))
    return say(picture, Sign::wait, "Stay on the outline", "It moves: go with it");
  if (task.target_count == 0) return say(picture, Sign::wait, facts.task->instruction);
  picture.progress = static_cast<double>(task.targets_reached) / task.target_count;
  if (task.cue == Cue::let_go) return say(picture, Sign::wait, "Let go", "Leave it there");
  if (task.phase == Phase::hold && task.hold_fraction > 0.0)
    return say(picture, Sign::wait, "Hold it still", "Until the ring is full");
  if (std::holds_alternative<PickPlaceSpec>(facts.task->kind))
    return say(picture, Sign::wait, "Bring it to the outline", "Take it and carry it there");
  say(picture, Sign::wait, words_for(Cue::move, task.channel, facts.hand));
}

/// "Next: thumb, push up".
std::string next_words(const TargetPreview::Part& part, Hand hand) {
  std::string words = part.cue == Cue::squeeze ? act_of(part.channel, hand)
                                               : words_for(part.cue, part.channel, hand).headline;
  words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
  if (const auto colon = words.find(':'); colon != std::string::npos) words[colon] = ',';
  return "Next: " + words;
}

void add_rest(const PatientFacts& facts, PatientPicture& picture) {
  const int segment = facts.snapshot.task.segment;
  say(picture, Sign::rest, words_for(Cue::relax, picture.channel, facts.hand));
  const auto* effort = facts.preview == nullptr ? nullptr : facts.preview->next_effort(segment);
  if (effort == nullptr) return;
  const bool at_once = effort == &facts.preview->parts[static_cast<std::size_t>(segment) + 1];
  if (at_once && (effort->cue == Cue::squeeze || effort->cue == Cue::press))
    picture.headline = "Get ready";
  picture.detail = next_words(*effort, facts.hand);
}

void add_directions(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  picture.page = Page::directions;
  picture.digits_N = facts.preview == nullptr ? 0.0 : facts.preview->digits_N;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (task.digit_targets.shown[f])
      picture.digits_N = std::max(picture.digits_N, task.digit_targets.force_C[f].norm());
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    DigitPicture& digit = picture.digits[f];
    digit.asked = task.digit_targets.shown[f];
    if (!digit.asked) continue;
    digit.target_C = task.digit_targets.force_C[f];
    if (!task.force_shown) continue;
    digit.force_C = facts.snapshot.forces.wrench_C[f].force;
    digit.on_target = (digit.force_C - digit.target_C).norm() <= kOnTarget * picture.digits_N;
  }
  say(picture, Sign::act, words_for_digits(task.digit_targets.shown));
}

void add_follow(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  picture.page = Page::tracking;
  say(picture, Sign::act, words_for(Cue::follow, task.channel, facts.hand));
  if (!task.force_shown) {
    picture.detail = "Without seeing your force";
    return;
  }
  const auto segment = static_cast<std::size_t>(task.segment);
  const bool steady = facts.preview != nullptr && segment < facts.preview->parts.size() &&
                      facts.preview->parts[segment].steady;
  if (task.phase == Phase::lead_in && std::holds_alternative<ForceTrackingSpec>(facts.task->kind))
    picture.detail = "Get ready";
  else if (task.phase == Phase::hold)
    picture.detail = "Hold it and wait for the word";
  else if (steady)
    picture.detail = "Hold it steady on the line";
}

void add_force(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  const auto words = [&] { return words_for(task.cue, task.channel, facts.hand); };
  switch (task.cue) {
    case Cue::relax: return add_rest(facts, picture);
    case Cue::squeeze:
    case Cue::press:
      picture.page = Page::effort;
      picture.urgent = task.cue == Cue::squeeze;
      return say(picture, Sign::act, words());
    case Cue::follow:
      if (task.digit_targets.any()) return add_directions(facts, picture);
      return add_follow(facts, picture);
    case Cue::let_go:
      // The mark falls where it was held.
      if (task.force_shown) picture.page = Page::tracking;
      picture.urgent = true;
      return say(picture, Sign::let_go, words());
    case Cue::reproduce: return say(picture, Sign::memory, words());
    case Cue::hand_out: return say(picture, Sign::hand_out, words());
    case Cue::move: return say(picture, Sign::wait, words());
  }
}

void add_trial(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  picture.hand = facts.hand;
  picture.channel = task.channel;
  picture.force_shown = task.force_shown;
  if (task.force_shown) picture.force_N = task.actual_force_N;
  picture.line_shown = task.force_target_shown;
  if (task.force_target_shown) picture.target_N = task.target_force_N;
  picture.task_time_s = task.task_time_s;
  const auto* maximum = std::get_if<MaximumSpec>(&facts.task->kind);
  const bool of_grip = maximum != nullptr && maximum->channel == ForceChannel{};
  picture.full_N = of_grip ? kFullGrip_N : kFullOther_N;
  if (facts.preview != nullptr && facts.preview->has_target())
    picture.axis = facts.preview->axis;
  else
    picture.axis = {std::min(0.0, task.target_force_N), std::max(1.0, task.target_force_N)};
  if (facts.preview != nullptr && facts.preview->ahead_s > 0.0) picture.preview = facts.preview;
  picture.progress_shown = task.duration_s > 0.0;
  if (picture.progress_shown)
    picture.progress = std::clamp(task.task_time_s / task.duration_s, 0.0, 1.0);
  if (facts.scene != nullptr && facts.snapshot.has_object) {
    add_object(facts, picture);
    add_object_words(facts, picture);
  } else {
    add_force(facts, picture);
  }
}

void add_idle(const PatientFacts& facts, PatientPicture& picture) {
  const Snapshot& now = facts.snapshot;
  if (!facts.session_open || now.frames == 0)
    return say(picture, Sign::wait, "Welcome", "We will begin in a moment.");
  if (now.stage == Stage::zeroing)
    return say(picture, Sign::hand_out, "Hands off, please", "The device measures itself.");
  if (facts.just_completed) return say(picture, Sign::good, "Well done", "Relax your hand.");
  if (!now.zeroed) return say(picture, Sign::hand_out, "Please take your hand out of the device");
  say(picture, Sign::wait, "Relax your hand", "The next task will begin in a moment.");
}

void add_notice(const PatientFacts& facts, PatientPicture& picture) {
  const Snapshot& now = facts.snapshot;
  const bool paused = now.stage == Stage::paused;
  if (facts.device_fault || (paused && now.pause_cause != PauseCause::therapist)) {
    picture.notice = Notice::fault;
    picture.notice_words = "The device needs help. You did nothing wrong. Relax your hand.";
  } else if (paused) {
    picture.notice = Notice::pause;
    picture.notice_words = "Pause. Relax your hand.";
  }
}

}  // namespace

PatientPicture picture_for(const PatientFacts& facts) {
  PatientPicture picture;
  picture.simulated = facts.simulated && !facts.example;
  picture.example = facts.example;
  const Stage stage = facts.snapshot.stage;
  const bool in_trial = facts.session_open && (stage == Stage::trial || stage == Stage::paused) &&
                        facts.task != nullptr;
  if (in_trial)
    add_trial(facts, picture);
  else
    add_idle(facts, picture);
  if (facts.session_open) add_notice(facts, picture);
  if (facts.example) picture.detail = "Watch how it is done";
  return picture;
}

}  // namespace isograsp
