// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/patient_picture.hpp"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gui/picture/arm_picture.hpp"
#include "gui/picture/hand_picture.hpp"
#include "gui/words/cue_words.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

using Page = PatientPicture::Page;
using Sign = PatientPicture::Sign;
using Notice = PatientPicture::Notice;

struct PictureTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

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

/// Where the object is `ahead_s` after the frame, at the velocity that it had then.
Pose moved(const Stimulus& seen, double ahead_s) {
  Pose X_WO = seen.X_WO;
  X_WO.p += ahead_s * seen.v_WO_W;
  const double angle_rad = ahead_s * seen.w_WO_W.norm();
  if (angle_rad > 0.0) X_WO.q = Eigen::AngleAxisd(angle_rad, seen.w_WO_W.normalized()) * X_WO.q;
  return X_WO;
}

FingerPicture picture_finger(const Contact& contact, const PatientFacts& facts) {
  const Stimulus& seen = facts.stimulus;
  const auto f = index_of(contact.finger);
  FingerPicture finger;
  finger.shown = true;
  finger.touching = seen.contact[f];
  const double normal_N = seen.press_N[f];
  const double maximum_N = facts.maximum_force_N > 0.0 ? *facts.maximum_force_N : kAssumedMaximum_N;
  finger.effort = std::clamp(normal_N / maximum_N, 0.0, 1.0);
  const double reach_N = contact.threshold_N > 0.0 ? contact.threshold_N : kApproach_N;
  const double approach = facts.calm ? 0.0 : 0.8 * std::min(1.0, normal_N / reach_N);
  const double gap_m = finger.touching ? 0.0 : kStandOff_m * (1.0 - approach);
  const Vec3 normal_O = contact.R_OC.col(2);
  const Pose X_WO = moved(seen, facts.ahead_s);
  finger.axis_W = X_WO.q * normal_O;
  finger.tip_W = X_WO.p + X_WO.q * (contact.p_OC - gap_m * normal_O);
  return finger;
}

/// Is the object, as it is drawn, near enough to the outline, and is it to be held there?
bool is_held(const PatientFacts& facts, const PatientPicture& picture) {
  const auto tolerance = facts.task->tolerance();
  if (!tolerance || !tolerance->holds(picture.X_WT, picture.X_WO)) return false;
  const auto targets = facts.task->targets();
  const auto target = static_cast<std::size_t>(facts.stimulus.progress.target_index);
  return target < targets.size() && targets[target].held;
}

void add_object(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  picture.page = Page::object;
  picture.scene = facts.scene;
  picture.object_shown = true;
  picture.X_WO = moved(seen, facts.ahead_s);
  picture.target_shown = seen.pose_target_shown;
  picture.X_WT = seen.X_WT;
  if (seen.pose_target_shown && is_held(facts, picture))
    picture.hold_fraction = seen.progress.hold_fraction;
  picture.ring_W = picture.X_WT.p;
  picture.targets_reached = seen.progress.targets_reached;
  picture.target_count = seen.progress.target_count;
  for (const auto& contact : facts.scene->contacts)
    picture.fingers[index_of(contact.finger)] = picture_finger(contact, facts);
}

void say(PatientPicture& picture, Sign sign, const QString& headline, const QString& detail = {}) {
  picture.sign = sign;
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

void say(PatientPicture& picture, Sign sign, CueWords words) {
  picture.sign = sign;
  picture.headline = std::move(words.headline);
  picture.detail = std::move(words.detail);
}

void add_object_words(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  const ShownProgress& progress = seen.progress;
  if (facts.task->kind->course != nullptr)
    return say(picture, Sign::wait, PictureTexts::tr("Stay on the outline"),
               PictureTexts::tr("It moves: go with it"));
  if (progress.target_count == 0)
    return say(picture, Sign::wait, translated(facts.task->instruction));
  picture.progress = static_cast<double>(progress.targets_reached) / progress.target_count;
  if (seen.page_cue == Cue::let_go)
    return say(picture, Sign::wait, PictureTexts::tr("Let go"), PictureTexts::tr("Leave it there"));
  if (progress.holding && picture.hold_fraction > 0.0)
    return say(picture, Sign::wait, PictureTexts::tr("Hold it still"),
               PictureTexts::tr("Until the ring is full"));
  if (facts.task->kind->carries)
    return say(picture, Sign::wait, PictureTexts::tr("Bring it to the outline"),
               PictureTexts::tr("Take it and carry it there"));
  say(picture, Sign::wait, words_of(Cue::move, seen.channel, facts.hand));
}

/// "Next: thumb, push up".
std::string next_words(const TargetPreview::Part& part, Hand hand) {
  QString words = QString::fromStdString(part.cue == Cue::squeeze
                                             ? act_of(part.channel, hand)
                                             : words_of(part.cue, part.channel, hand).headline);
  // One colon is enough.
  static const QRegularExpression kColon(QStringLiteral("[\\s\u00a0]*:\\s*"));
  words.replace(kColon, QStringLiteral(", "));
  return PictureTexts::tr("Next: %1").arg(in_sentence(words)).toStdString();
}

void add_rest(const PatientFacts& facts, PatientPicture& picture) {
  const int segment = facts.stimulus.progress.segment;
  say(picture, Sign::rest, words_of(Cue::relax, picture.channel, facts.hand));
  const auto* effort = facts.preview == nullptr ? nullptr : facts.preview->next_effort(segment);
  if (effort == nullptr) return;
  const bool at_once = effort == &facts.preview->parts[static_cast<std::size_t>(segment) + 1];
  if (at_once && (effort->cue == Cue::squeeze || effort->cue == Cue::press))
    picture.headline = PictureTexts::tr("Get ready").toStdString();
  picture.detail = next_words(*effort, facts.hand);
}

void add_directions(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  picture.page = Page::directions;
  picture.digits_N = facts.preview == nullptr ? 0.0 : facts.preview->digits_N;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (seen.digit_targets.shown[f])
      picture.digits_N = std::max(picture.digits_N, seen.digit_targets.force_C[f].norm());
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    DigitPicture& digit = picture.digits[f];
    digit.asked = seen.digit_targets.shown[f];
    if (!digit.asked) continue;
    digit.target_C = seen.digit_targets.force_C[f];
    if (!seen.force_shown) continue;
    digit.force_C = seen.digit_force_C[f];
    digit.on_target = (digit.force_C - digit.target_C).norm() <= kOnTarget * picture.digits_N;
  }
  say(picture, Sign::act, words_of_digits(seen.digit_targets.shown));
}

void add_follow(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  picture.page = Page::tracking;
  say(picture, Sign::act, words_of(Cue::follow, seen.channel, facts.hand));
  if (!seen.force_shown) {
    picture.detail = PictureTexts::tr("Without seeing your force").toStdString();
    return;
  }
  const auto segment = static_cast<std::size_t>(seen.progress.segment);
  const bool steady = facts.preview != nullptr && segment < facts.preview->parts.size() &&
                      facts.preview->parts[segment].steady;
  if (seen.progress.getting_ready && facts.task->kind->follows_curve)
    picture.detail = PictureTexts::tr("Get ready").toStdString();
  else if (seen.progress.holding)
    picture.detail = PictureTexts::tr("Hold it and wait for the word").toStdString();
  else if (steady)
    picture.detail = PictureTexts::tr("Hold it steady on the line").toStdString();
}

void add_force(const PatientFacts& facts, PatientPicture& picture) {
  const Stimulus& seen = facts.stimulus;
  const auto words = [&] { return words_of(seen.page_cue, seen.channel, facts.hand); };
  switch (seen.page_cue) {
    case Cue::relax: return add_rest(facts, picture);
    case Cue::squeeze:
    case Cue::press:
      picture.page = Page::effort;
      picture.urgent = seen.page_cue == Cue::squeeze;
      return say(picture, Sign::act, words());
    case Cue::follow:
      if (seen.digit_targets.any()) return add_directions(facts, picture);
      return add_follow(facts, picture);
    case Cue::let_go:
      // The mark falls where it was held.
      if (seen.force_shown) picture.page = Page::tracking;
      picture.urgent = true;
      return say(picture, Sign::let_go, words());
    case Cue::reproduce: return say(picture, Sign::memory, words());
    case Cue::hand_out: return say(picture, Sign::hand_out, words());
    case Cue::move:
    case Cue::open:
    case Cue::close: return say(picture, Sign::wait, words());
  }
}

void add_trial(const PatientFacts& facts, PatientPicture& picture) {
  picture.look = facts.task->look;
  if (facts.task->difficulty && facts.task->difficulty->chosen)
    picture.light = tasks::daylight_at(*facts.task->difficulty->chosen);
  const Stimulus& seen = facts.stimulus;
  picture.hand = facts.hand;
  picture.channel = seen.channel;
  picture.force_shown = seen.force_shown;
  if (seen.force_shown) picture.force_N = seen.shown_force_N;
  picture.line_shown = seen.force_target_shown;
  if (seen.force_target_shown) picture.target_N = seen.target_force_N;
  picture.task_time_s = seen.progress.task_time_s + facts.ahead_s;
  const ForceChannel* effort = facts.task->effort();
  const bool of_grip = effort != nullptr && *effort == ForceChannel{};
  picture.full_N = of_grip ? kFullGrip_N : kFullOther_N;
  if (facts.preview != nullptr && facts.preview->has_target())
    picture.axis = facts.preview->axis;
  else
    picture.axis = {std::min(0.0, picture.target_N), std::max(1.0, picture.target_N)};
  const bool angles_known = facts.viewing.known();
  if (angles_known && facts.preview != nullptr && facts.preview->gain_deg_per_N)
    picture.axis = with_gain(picture.axis, *facts.preview->gain_deg_per_N, facts.viewing);
  if (facts.preview != nullptr && facts.preview->ahead_s > 0.0) picture.preview = facts.preview;
  picture.progress_shown = seen.progress.duration_s > 0.0;
  if (picture.progress_shown)
    picture.progress = std::clamp(seen.progress.task_time_s / seen.progress.duration_s, 0.0, 1.0);
  if (seen.hands) {
    add_two_hands(facts, picture);
  } else if (facts.tracked) {
    add_hand_trial(facts, picture);
    if (picture.tracked_hand) picture.tracked_hand->look = picture.look;
  } else if (facts.arm != nullptr) {
    add_arm(facts, picture);
  } else if (facts.scene != nullptr && seen.object_shown) {
    add_object(facts, picture);
    add_object_words(facts, picture);
  } else {
    add_force(facts, picture);
  }
  picture.on_target = picture.page == Page::tracking && picture.force_shown && picture.line_shown &&
                      std::abs(picture.axis.share(picture.force_N) -
                               picture.axis.share(picture.target_N)) <= kHalfBandShare;
  if (picture.page == Page::tracking && seen.force_shown && angles_known)
    picture.gain_deg_per_N = gain_of(picture.axis, facts.viewing);
}

/// A rest counts down; between parts of a training its circle breathes slowly, six times a minute,
/// and ends breathed out.
void add_rest_circle(const PatientFacts& facts, PatientPicture& picture) {
  constexpr double kBreath_s = 10.0;
  if (!facts.rest_left_s || !(*facts.rest_left_s > 0.0) || picture.page != Page::message) return;
  picture.rest_left_s = facts.rest_left_s;
  if (facts.trains && !facts.calm)
    picture.breath = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * *facts.rest_left_s / kBreath_s);
}

/// What is measured may rest.
QString relax_words(const PatientFacts& facts) {
  if (facts.both_hands) return PictureTexts::tr("Relax both hands.");
  return facts.arm != nullptr ? PictureTexts::tr("Relax your arm.")
                              : PictureTexts::tr("Relax your hand.");
}

void add_idle(const PatientFacts& facts, PatientPicture& picture) {
  if (facts.both_hands && facts.session_open && facts.arrived &&
      add_two_hands_between(facts, picture))
    return;
  if (!facts.session_open || !facts.arrived)
    return say(picture, Sign::wait, PictureTexts::tr("Welcome"),
               PictureTexts::tr("We will begin in a moment."));
  if (facts.stage == session::Stage::zeroing && facts.arm != nullptr)
    return say(picture, Sign::wait, PictureTexts::tr("Hold your arm still"),
               PictureTexts::tr("For a moment, in the start posture"));
  if (facts.stage == session::Stage::zeroing && facts.tracked)
    return add_hand_between(facts, picture);
  if (facts.stage == session::Stage::zeroing)
    return say(picture, Sign::hand_out, PictureTexts::tr("Hands off, please"),
               PictureTexts::tr("The device measures itself."));
  if (facts.just_completed && facts.just_missed) {
    picture.missed = true;
    return say(picture, Sign::rest, PictureTexts::tr("Good try"), relax_words(facts));
  }
  if (facts.just_completed)
    return say(picture, Sign::good, PictureTexts::tr("Well done"), relax_words(facts));
  if (facts.stimulus.cue == Cue::hand_out)
    return say(picture, Sign::hand_out,
               PictureTexts::tr("Please take your hand out of the device"));
  say(picture, Sign::wait,
      facts.arm != nullptr ? PictureTexts::tr("Relax your arm")
                           : PictureTexts::tr("Relax your hand"),
      PictureTexts::tr("The next task will begin in a moment."));
  if (facts.tracked) add_hand_between(facts, picture);
}

void add_notice(const PatientFacts& facts, PatientPicture& picture) {
  const bool paused = facts.stage == session::Stage::paused;
  const bool by_fault = paused && session::is_fault(facts.pause_cause);
  if (facts.device_fault || facts.broken_off || by_fault) {
    picture.notice = Notice::fault;
    picture.notice_words =
        (facts.arm != nullptr
             ? PictureTexts::tr("The cameras need help. You did nothing wrong. Relax your arm.")
         : facts.tracked
             ? PictureTexts::tr("The camera needs help. You did nothing wrong. Relax your hand.")
         : facts.both_hands
             ? PictureTexts::tr("The device needs help. You did nothing wrong. Relax both hands.")
             : PictureTexts::tr("The device needs help. You did nothing wrong. Relax your hand."))
            .toStdString();
  } else if (paused && !((facts.arm != nullptr || facts.tracked) &&
                         session::goes_on_by_itself(facts.pause_cause))) {
    picture.notice = Notice::pause;
    picture.notice_words = (facts.arm != nullptr ? PictureTexts::tr("Pause. Relax your arm.")
                            : facts.both_hands   ? PictureTexts::tr("Pause. Relax both hands.")
                                                 : PictureTexts::tr("Pause. Relax your hand."))
                               .toStdString();
  }
}

}  // namespace

PatientPicture picture_for(const PatientFacts& facts) {
  PatientPicture picture;
  picture.simulated = facts.simulated && !facts.example;
  picture.example = facts.example;
  picture.published = facts.published;
  picture.calm = facts.calm;
  picture.camera_on = facts.tracked && facts.tracked->camera_on;
  const bool in_trial =
      facts.session_open &&
      (facts.stage == session::Stage::trial || facts.stage == session::Stage::paused) &&
      facts.task != nullptr;
  if (in_trial)
    add_trial(facts, picture);
  else
    add_idle(facts, picture);
  if (!in_trial && facts.session_open && facts.stage == session::Stage::idle)
    add_rest_circle(facts, picture);
  if (facts.session_open || facts.broken_off) add_notice(facts, picture);
  if (facts.example) picture.detail = PictureTexts::tr("Watch how it is done").toStdString();
  return picture;
}

}  // namespace isograsp::gui
