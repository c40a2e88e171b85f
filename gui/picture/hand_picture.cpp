// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/hand_picture.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/picture/patient_picture.hpp"
#include "gui/words/texts.hpp"
#include "session/tracked_hand/hand_sight.hpp"
#include "virtual_hand/study_plan.hpp"

namespace isograsp::gui {

namespace {

using virtual_hand::AssistanceLevel;
using virtual_hand::Capsule;
using virtual_hand::capsule_contact;
using virtual_hand::DigitState;
using virtual_hand::HandInSpace;
using virtual_hand::kLinkCount;
using virtual_hand::ObjectShape;

struct HandPictureTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

/// Out of sight for longer than its last pose may stand in.
bool hand_is_lost(const session::HandSnapshot& now) {
  return session::hand_reception(now.hand, now.health.fault).sight !=
         session::Reception::Sight::clear;
}

HandPicture::Tip tip_of(const hand_world::DigitGrasp& digit) {
  if (digit.state == DigitState::attached) return HandPicture::Tip::tied;
  return digit.touching ? HandPicture::Tip::touches : HandPicture::Tip::bare;
}

/// Where the link of the digit that is nearest to the object has it.
HandPicture::Mark mark_of(const HandPicture& picture, std::size_t digit) {
  const auto& joints = picture.hand->digits[digit].joints;
  const Quat q_OW = picture.X_WO.q.conjugate();
  const auto to_O = [&](const Vec3& p_W) -> Vec3 { return q_OW * (p_W - picture.X_WO.p); };
  virtual_hand::CapsuleContact nearest;
  HandPicture::Mark mark;
  for (std::size_t k = 0; k < kLinkCount; ++k) {
    const double radius_m = picture.radii_m[digit][k];
    const auto contact =
        capsule_contact(Capsule{to_O(joints[k]), to_O(joints[k + 1]), radius_m}, *picture.object);
    if (k > 0 && contact.distance_m >= nearest.distance_m) continue;
    nearest = contact;
    mark.radius_m = radius_m;
  }
  mark.p_W = picture.X_WO.p + picture.X_WO.q * nearest.point;
  mark.normal_W = picture.X_WO.q * nearest.normal;
  return mark;
}

void add_hands(const session::HandSnapshot& now, HandPicture& picture) {
  picture.radii_m = now.link_radii_m;
  picture.hand = now.seen_hand;
  picture.frozen = picture.hand && hand_is_lost(now);
  if (!now.grasp.hand_there || !now.grasping_hand) return;
  picture.hand = now.grasping_hand;
  const double apart = (now.grasp.tracked_gap_m - kSamePlace_m) / (kClearlyApart_m - kSamePlace_m);
  picture.tracked_opacity = kMostOpacity * std::clamp(apart, 0.0, 1.0);
  if (picture.tracked_opacity > 0.0) picture.tracked = now.seen_hand;
}

void add_virtual_object(const session::HandSnapshot& now, HandPicture& picture) {
  const tasks::HandView& task = now.special.hand();
  if (task.object < 0 || !now.grasp.object_there) return;
  picture.object = virtual_hand::study_objects()[static_cast<std::size_t>(task.object)].shape;
  picture.X_WO = now.grasp.object.X_WO;
  picture.placed = task.let_go_asked;
  picture.assistance = task.assistance;
  if (task.target_shown && !picture.placed) {
    picture.target = task.at_target ? HandPicture::Target::within : HandPicture::Target::away;
    picture.X_WT = task.X_WT;
  }
  if (!picture.hand) return;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    picture.tips[d] = tip_of(now.grasp.digits[d]);
    if (picture.tips[d] != HandPicture::Tip::bare) picture.marks[d] = mark_of(picture, d);
  }
}

void say_of_hand(PatientPicture& picture, const QString& headline, const QString& detail = {}) {
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

/// It stands still; nobody is to do anything in a hurry.
bool say_unseen(const session::HandSnapshot& now, Hand side, PatientPicture& picture) {
  if (!hand_is_lost(now)) return false;
  if (now.health.fault == HandFault::other_hand)
    say_of_hand(picture,
                side == Hand::right ? HandPictureTexts::tr("Please show your right hand")
                                    : HandPictureTexts::tr("Please show your left hand"),
                HandPictureTexts::tr("It goes on by itself"));
  else if (!now.hand.known)
    say_of_hand(picture, HandPictureTexts::tr("Show your hand to the camera"),
                HandPictureTexts::tr("It appears here by itself"));
  else
    say_of_hand(picture, HandPictureTexts::tr("Your hand is out of sight"),
                HandPictureTexts::tr("It stands still here and goes on by itself"));
  return true;
}

/// All of a hand is under the table on the screen, where nothing of it can be seen.
bool below_table(const HandPicture& picture) {
  if (!picture.hand) return false;
  const auto below = [&](const Vec3& p_W) { return p_W.y() < picture.ground.table_m; };
  return below(picture.hand->X_WP.p) &&
         std::all_of(picture.hand->digits.begin(), picture.hand->digits.end(),
                     [&](const auto& digit) { return below(digit.joints.back()); });
}

void say_of_placing(const session::HandSnapshot& now, PatientPicture& picture) {
  const tasks::HandView& task = now.special.hand();
  if (!picture.tracked_hand->object)
    return say_of_hand(picture, HandPictureTexts::tr("Relax your hand"),
                       HandPictureTexts::tr("The next object comes in a moment"));
  if (task.helped)
    return say_of_hand(picture, HandPictureTexts::tr("Well done"),
                       HandPictureTexts::tr("The object lets go by itself"));
  if (task.let_go_asked)
    return say_of_hand(picture, HandPictureTexts::tr("Let go"),
                       HandPictureTexts::tr("It is in place: open your hand"));
  if (below_table(*picture.tracked_hand))
    return say_of_hand(picture, HandPictureTexts::tr("Lift your hand"),
                       HandPictureTexts::tr("It is below the table"));
  if (task.at_target)
    return say_of_hand(picture, HandPictureTexts::tr("Hold it still"),
                       HandPictureTexts::tr("Until the ring is full"));
  if (now.grasp.held)
    return say_of_hand(picture, HandPictureTexts::tr("Bring it to the blue shape"),
                       HandPictureTexts::tr("The line shows the way"));
  say_of_hand(picture, HandPictureTexts::tr("Take the object"),
              HandPictureTexts::tr("Then bring it to the blue shape"));
}

void say_to_open(Cue cue, PatientPicture& picture) {
  if (cue == Cue::open)
    return say_of_hand(picture, HandPictureTexts::tr("Open your hand"),
                       HandPictureTexts::tr("As far as it goes"));
  if (cue == Cue::close) return say_of_hand(picture, HandPictureTexts::tr("Close your hand"));
  say_of_hand(picture, HandPictureTexts::tr("Relax your hand"), HandPictureTexts::tr("Get ready"));
}

void say_of_entry(const session::EntryShown& entry, double progress, PatientPicture& picture) {
  using Stage = session::HandEntry::Stage;
  if (entry.stage != Stage::openings) {
    picture.progress_shown = true;
    picture.progress = progress;
    return say_of_hand(picture, HandPictureTexts::tr("Rest your hand"),
                       HandPictureTexts::tr("Keep it still, where it can be seen"));
  }
  picture.targets_reached = std::min(entry.openings, session::HandEntry::kOpenings);
  picture.target_count = session::HandEntry::kOpenings;
  say_to_open(entry.open ? Cue::open : Cue::close, picture);
  picture.detail = HandPictureTexts::tr("Opened %1 of %2 times")
                       .arg(picture.targets_reached)
                       .arg(picture.target_count)
                       .toStdString();
}

void add_opening(const session::HandSnapshot& now, PatientPicture& picture) {
  const double gap_m = now.thumb_index_gap_m;
  if (!picture.tracked_hand->hand || !std::isfinite(gap_m)) return;
  picture.tracked_hand->opening =
      HandPicture::Opening{gap_m, std::clamp(gap_m / kFullOpening_m, 0.0, 1.0)};
}

void add_page(const session::HandSnapshot& now, PatientPicture& picture) {
  picture.page = PatientPicture::Page::hand;
  picture.sign = PatientPicture::Sign::wait;
  picture.tracked_hand = hand_picture(now);
}

}  // namespace

HandPicture hand_picture(const session::HandSnapshot& now) {
  HandPicture picture;
  if (now.ground) picture.ground = *now.ground;
  add_hands(now, picture);
  add_virtual_object(now, picture);
  return picture;
}

std::string help_words(AssistanceLevel level) {
  switch (level) {
    case AssistanceLevel::full: return HandPictureTexts::tr("Help: full").toStdString();
    case AssistanceLevel::softer: return HandPictureTexts::tr("Help: a little").toStdString();
    case AssistanceLevel::off: break;
  }
  return HandPictureTexts::tr("Without help").toStdString();
}

void add_hand_trial(const PatientFacts& facts, PatientPicture& picture) {
  const session::HandSnapshot& now = *facts.tracked;
  const ShownProgress& progress = facts.stimulus.progress;
  add_page(now, picture);
  picture.targets_reached = progress.targets_reached;
  picture.target_count = progress.target_count;
  // Placements take as long as they take.
  const bool about_object = now.special.hand().about_object;
  picture.progress_shown = !about_object && progress.duration_s > 0.0;
  if (!about_object) add_opening(now, picture);
  if (say_unseen(now, facts.hand, picture)) return;
  if (!about_object) return say_to_open(facts.stimulus.page_cue, picture);
  picture.matched = picture.tracked_hand->placed;
  if (picture.tracked_hand->target == HandPicture::Target::within)
    picture.hold_fraction = progress.hold_fraction;
  picture.ring_W = picture.tracked_hand->X_WT.p;
  picture.X_WO = picture.tracked_hand->X_WO;
  say_of_placing(now, picture);
}

void add_hand_between(const PatientFacts& facts, PatientPicture& picture) {
  const session::HandSnapshot& now = *facts.tracked;
  add_page(now, picture);
  if (now.entry) {
    add_opening(now, picture);
    if (now.entry->stage != session::HandEntry::Stage::openings)
      picture.tracked_hand->opening.reset();  // nothing of it counts yet
  }
  if (say_unseen(now, facts.hand, picture)) return;
  if (now.entry) say_of_entry(*now.entry, now.zero_progress, picture);
}

}  // namespace isograsp::gui
