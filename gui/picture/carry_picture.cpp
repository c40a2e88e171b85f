// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/carry_picture.hpp"

#include <QCoreApplication>
#include <cmath>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

namespace {

using Sign = PatientPicture::Sign;

struct CarryTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

void say_of_box(PatientPicture& picture, Sign sign, const QString& headline,
                const QString& detail) {
  picture.sign = sign;
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

void say_carry(const PatientFacts& facts, const CarryPicture& seen, PatientPicture& picture) {
  if (seen.fetched)
    return say_of_box(picture, Sign::rest, CarryTexts::tr("It was let go: let both hands rest"),
                      CarryTexts::tr("You may take it again in a moment"));
  if (facts.stimulus.page_cue == Cue::let_go)
    return say_of_box(picture, Sign::rest, CarryTexts::tr("Let go"),
                      CarryTexts::tr("Leave it there"));
  if (picture.hold_fraction > 0.0)
    return say_of_box(picture, Sign::act, CarryTexts::tr("Hold it still"),
                      CarryTexts::tr("Until the ring is full"));
  if (seen.clutch)
    return say_of_box(picture, Sign::act, CarryTexts::tr("Your hands stay where they are"),
                      CarryTexts::tr("Relax them, then leave the pedal"));
  if (!seen.held)
    return say_of_box(picture, Sign::act, CarryTexts::tr("Press both hands against the box"),
                      CarryTexts::tr("One from each side"));
  say_of_box(picture, Sign::act, CarryTexts::tr("Carry it to the outline"),
             CarryTexts::tr("Keep pressing from both sides"));
}

void look_at(const Vec3& p_W, const Vec3& half_m, CarryPicture& seen) {
  seen.low_W = seen.low_W.cwiseMin(p_W - half_m);
  seen.high_W = seen.high_W.cwiseMax(p_W + half_m);
}

}  // namespace

void add_carry(const PatientFacts& facts, PatientPicture& picture) {
  const ShownCarry& carry = *facts.stimulus.hands->carry;
  CarryPicture& seen = picture.two_hands->carry.emplace();
  seen.size_m = carry.size_m;
  seen.p_W = carry.X_WO.p + facts.ahead_s * carry.v_WO_W;
  seen.angle_rad = 2.0 * std::atan2(carry.X_WO.q.z(), carry.X_WO.q.w());
  seen.half_size_m = carry.half_size_m;
  seen.held = carry.held;
  seen.clutch = carry.clutch;
  seen.target_shown = carry.target_shown;
  seen.target_W = carry.X_WT.p;
  seen.tolerance_m = carry.tolerance_m;
  seen.on_target = carry.target_shown && (seen.p_W - seen.target_W).norm() <= carry.tolerance_m;
  seen.fetched = carry.fetched;
  seen.low_W = seen.high_W = seen.p_W;
  look_at(seen.p_W, 0.5 * seen.size_m, seen);
  for (const Hand hand : kBothHands) {
    const ShownPoint& of = carry.of[hand];
    seen.of[hand] = {of.p_W, of.bubble_W, of.beyond};
    look_at(of.bubble_W, seen.half_size_m, seen);
  }
  look_at(seen.target_W, seen.size_m, seen);
  if (facts.task != nullptr)
    for (const tasks::TargetPlace& target : facts.task->targets())
      look_at(target.p_WT, seen.size_m, seen);
  const ShownProgress& progress = facts.stimulus.progress;
  picture.targets_reached = progress.targets_reached;
  picture.target_count = progress.target_count;
  if (progress.holding && seen.on_target) picture.hold_fraction = progress.hold_fraction;
  if (seen.target_shown) say_carry(facts, seen, picture);
}

}  // namespace isograsp::gui
