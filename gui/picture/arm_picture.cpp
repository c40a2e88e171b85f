// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/arm_picture.hpp"

#include <QCoreApplication>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct ArmPictureTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

void say_of_arm(PatientPicture& picture, const QString& headline, const QString& detail = {}) {
  picture.sign = PatientPicture::Sign::wait;
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

/// The instruction of the task: its first sentence large, the others below.
void say_instruction(const PatientFacts& facts, PatientPicture& picture) {
  const QString words = translated(facts.task->instruction);
  const auto end = words.indexOf(QStringLiteral(". "));
  if (end < 0) return say_of_arm(picture, words);
  say_of_arm(picture, words.left(end), words.mid(end + 2));
}

/// Of a task that looks at single markers: nothing of it is drawn, and what is out of sight stops
/// nothing.
void say_alone(const PatientFacts& facts, PatientPicture& picture) {
  say_instruction(facts, picture);
  if (facts.stimulus.progress.getting_ready)
    picture.detail = ArmPictureTexts::tr("Get ready").toStdString();
}

void say_to_show(PatientPicture& picture) {
  say_of_arm(picture, ArmPictureTexts::tr("Turn the hand towards the cameras"),
             ArmPictureTexts::tr("It goes on by itself"));
}

/// Out of sight for longer than its last pose may stand in.
bool is_lost(const PatientFacts& facts) {
  return facts.stimulus.sight == ObjectSight::unseen ||
         facts.pause_cause == session::PauseCause::occluded;
}

void add_range_of_arm(const PatientFacts& facts, PatientPicture& picture) {
  picture.page = PatientPicture::Page::range;
  picture.angle = facts.stimulus.angle;
  if (is_lost(facts)) return say_to_show(picture);
  say_instruction(facts, picture);
  if (facts.stimulus.progress.getting_ready)
    picture.detail = ArmPictureTexts::tr("Get ready").toStdString();
}

void say_of_object(const PatientFacts& facts, PatientPicture& picture) {
  if (is_lost(facts)) return say_to_show(picture);
  if (facts.pause_cause == session::PauseCause::object_lost)
    return say_of_arm(picture, ArmPictureTexts::tr("Take it in your hand again"),
                      ArmPictureTexts::tr("It goes on by itself"));
  if (picture.matched)
    return say_of_arm(picture, ArmPictureTexts::tr("Well done"),
                      ArmPictureTexts::tr("Stay there until the next picture"));
  if (facts.stimulus.progress.holding)
    return say_of_arm(picture, ArmPictureTexts::tr("Hold it still"),
                      ArmPictureTexts::tr("Until the ring is full"));
  say_instruction(facts, picture);
}

}  // namespace

void add_arm(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  if (facts.task->kind->markers != nullptr) return say_alone(facts, picture);
  if (seen.angle.shown) return add_range_of_arm(facts, picture);
  if (seen.sight == ObjectSight::unknown && !seen.pose_target_shown) return say_to_show(picture);
  picture.page = PatientPicture::Page::object;
  picture.in_space = true;
  picture.scene = facts.arm->box();
  picture.object_shown = seen.sight != ObjectSight::unknown;
  picture.unseen = is_lost(facts);
  if (picture.object_shown) picture.X_WO = facts.arm->box_at(seen.X_WO, facts.centre_W);
  picture.target_shown = seen.pose_target_shown;
  if (picture.target_shown) {
    picture.X_WT = facts.arm->box_at(seen.X_WT, facts.centre_W);
    picture.matched = seen.pose_matched && !picture.unseen;
    if (!picture.matched && !picture.unseen) picture.hold_fraction = seen.progress.hold_fraction;
  }
  picture.ring_W = picture.X_WT.p;
  picture.targets_reached = seen.progress.targets_reached;
  picture.target_count = seen.progress.target_count;
  if (picture.target_count > 0)
    picture.progress = static_cast<double>(picture.targets_reached) / picture.target_count;
  say_of_object(facts, picture);
}

}  // namespace isograsp::gui
