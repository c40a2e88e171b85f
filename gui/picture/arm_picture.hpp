// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/picture/ only: the patient's picture of a trial with an arm seen by cameras.
#pragma once

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

/// Page, object, target and words. @pre facts.arm, facts.task
void add_arm(const PatientFacts& facts, PatientPicture& picture);

}  // namespace isograsp::gui
