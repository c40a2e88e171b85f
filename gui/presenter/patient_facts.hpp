// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient's picture is given of a frame of the session.
#pragma once

#include "gui/picture/patient_picture.hpp"
#include "session/arm/arm_snapshot.hpp"
#include "session/platform/snapshot.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"

namespace isograsp::gui {

/// What every frame has, whatever is measured. The rest is as if nothing else were known.
template <class Seen>
[[nodiscard]] PatientFacts facts_of_frame(const Seen& now) {
  PatientFacts facts;
  facts.arrived = now.frames > 0;
  facts.stage = now.stage;
  facts.pause_cause = now.pause_cause;
  facts.published = now.published;
  facts.stimulus = session::screen_of(now);
  return facts;
}

[[nodiscard]] inline PatientFacts patient_facts(const session::Snapshot& now) {
  return facts_of_frame(now);
}
/// The same of an arm; in the middle of its picture stands where the object was in the start
/// posture, or where it was seen last.
[[nodiscard]] inline PatientFacts patient_facts(const session::ArmSnapshot& now) {
  PatientFacts facts = facts_of_frame(now);
  if (now.start_p_WO.allFinite())
    facts.centre_W = now.start_p_WO;
  else if (now.last_X_WO.p.allFinite())
    facts.centre_W = now.last_X_WO.p;
  return facts;
}
/// The same of a tracked hand.
[[nodiscard]] inline PatientFacts patient_facts(const session::HandSnapshot& now) {
  PatientFacts facts = facts_of_frame(now);
  facts.tracked = now;
  return facts;
}
/// The same of two platforms.
[[nodiscard]] inline PatientFacts patient_facts(const session::TwoPlatformsSnapshot& now) {
  PatientFacts facts = facts_of_frame(now);
  facts.both_hands = true;
  return facts;
}

}  // namespace isograsp::gui
