// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_picture.hpp"

#include <algorithm>

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

void add_trial(const PatientFacts& facts, PatientPicture& picture) {
  const TaskView& task = facts.snapshot.task;
  picture.force_N = facts.snapshot.grip_N;
  picture.target_N = task.target_force_N;
  picture.task_time_s = task.task_time_s;
  picture.top_N = facts.maximum_force_N > 0.0 ? facts.maximum_force_N : kAssumedMaximum_N;
  picture.progress_shown = task.duration_s > 0.0;
  if (picture.progress_shown)
    picture.progress = std::clamp(task.task_time_s / task.duration_s, 0.0, 1.0);
  if (facts.scene != nullptr && facts.snapshot.has_object) {
    add_object(facts, picture);
    if (task.target_count > 0) {
      picture.progress = static_cast<double>(task.targets_reached) / task.target_count;
      const bool holding = task.phase == Phase::hold && task.hold_fraction > 0.0;
      say(picture, Sign::wait, holding ? "Hold it still" : "Bring the block to the outline",
          holding ? "Until the ring is full" : "Slowly and level");
    } else {
      say(picture, Sign::wait, facts.task->instruction);
    }
    return;
  }
  if (facts.preview != nullptr && !facts.preview->empty()) {
    picture.page = Page::tracking;
    picture.preview = facts.preview;
    picture.top_N = 1.35 * facts.preview->most_N();
    say(picture, Sign::wait, "Keep the dot on the line",
        task.phase == Phase::lead_in ? "Get ready" : "Press harder: the dot goes up");
    return;
  }
  if (task.cue == Cue::squeeze) {
    picture.page = Page::effort;
    say(picture, Sign::squeeze, "Squeeze!", "As hard as you can. Breathe out.");
    return;
  }
  if (facts.task != nullptr && std::holds_alternative<MaximumSpec>(facts.task->kind)) {
    say(picture, Sign::rest, "Get ready to squeeze", "Wait for the word");
    return;
  }
  say(picture, Sign::rest, "Let your hand rest", "Do nothing. Breathe calmly.");
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
  picture.simulated = facts.simulated;
  const Stage stage = facts.snapshot.stage;
  const bool in_trial = facts.session_open && (stage == Stage::trial || stage == Stage::paused) &&
                        facts.task != nullptr;
  if (in_trial)
    add_trial(facts, picture);
  else
    add_idle(facts, picture);
  if (facts.session_open) add_notice(facts, picture);
  return picture;
}

}  // namespace isograsp
