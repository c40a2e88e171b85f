// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen shows what is on it (Stimulus): one instruction, one picture, without a
// window. A simulated person is given the same stimulus; of the session nothing else is drawn.
// Never a name or a code. Frames: W world, O object, C contact. SI units.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "grasp_model/scene.hpp"
#include "gui/picture/arm_space.hpp"
#include "gui/picture/hand_picture.hpp"
#include "gui/picture/presentation.hpp"
#include "gui/picture/target_preview.hpp"
#include "gui/picture/two_hands_picture.hpp"
#include "hand/stimulus.hpp"
#include "session/acquisition/moment.hpp"

namespace isograsp::gui {

/// What the picture depends on. Pointers may be null: nothing of that kind.
struct PatientFacts {
  bool session_open = false;
  bool simulated = false;
  bool device_fault = false;  ///< also while no trial runs
  bool broken_off = false;    ///< the session could not go on and is closed
  Hand hand = Hand::right;    ///< in the device
  // Of the session's clockwork.
  bool arrived = false;  ///< a frame, the first one or a later one
  session::Stage stage = session::Stage::idle;
  session::PauseCause pause_cause = session::PauseCause::none;
  Timestamp published{0};                       ///< when the frame that is shown was
  Stimulus stimulus;                            ///< all that is drawn of the frame
  std::shared_ptr<const tasks::TaskSpec> task;  ///< the running one
  std::shared_ptr<const Scene> scene;           ///< of that task, turned for the hand
  std::shared_ptr<const TargetPreview> preview;
  /// Of an arm seen by cameras, whose real object is drawn; null: there is none.
  std::shared_ptr<const ArmSpace> arm;
  Vec3 centre_W = Vec3::Zero();  ///< of its picture [m]
  bool both_hands = false;       ///< are in devices, each in its own; `hand` says nothing then
  /// Of a tracked hand: beside the stimulus the own hand is drawn, too.
  std::optional<session::HandSnapshot> tracked;
  std::optional<double> maximum_force_N;
  bool just_completed = false;  ///< the last trial ended well and nothing began since
  bool just_missed = false;     ///< it ended before all its targets were reached
  bool example = false;         ///< all of this is a demonstration: nothing is the patient's
  /// How long ago the frame was published: what moves is shown where it is now [s].
  double ahead_s = 0.0;
  /// Until the next part of a protocol may begin [s]; nothing: there is no rest.
  std::optional<double> rest_left_s;
  bool trains = false;  ///< that part is training
  bool calm = false;    ///< less motion: nothing scrolls, nothing approaches
  Viewing viewing;
};

/// A virtual finger: a fingertip that approaches along its axis while force builds up and touches
/// when the contact is on.
struct FingerPicture {
  bool shown = false;
  Vec3 tip_W = Vec3::Zero();    ///< where its tip is [m]
  Vec3 axis_W = Vec3::UnitX();  ///< unit vector in which it presses
  bool touching = false;
  double effort = 0.0;  ///< 0 … 1
};

/// Force asked of one digit, and its own, contact frame [N].
struct DigitPicture {
  bool asked = false;
  Vec3 target_C = Vec3::Zero();
  Vec3 force_C = Vec3::Zero();
  bool on_target = false;
};

struct PatientPicture {
  enum class Page : std::uint8_t {
    message,
    effort,
    tracking,
    directions,
    object,
    range,
    hand,
    two_hands
  };
  /// `act`: what the channel asks for.
  enum class Sign : std::uint8_t { wait, hand_out, rest, act, let_go, memory, good };
  enum class Notice : std::uint8_t { none, pause, fault };

  Timestamp published{0};  ///< of the frame that it shows
  bool calm = false;
  tasks::Look look = tasks::Look::plain;  ///< clothes what is drawn, and changes none of it
  tasks::Daylight light = tasks::Daylight::day;
  Page page = Page::message;
  Sign sign = Sign::wait;
  Notice notice = Notice::none;  ///< over the page, which then stands still
  std::string headline;          ///< the instruction, large
  std::string detail;            ///< one more sentence, or nothing
  std::string notice_words;
  std::optional<double> rest_left_s;  ///< counted down in the place of the sign
  double breath = 0.0;                ///< of a rest: how wide its circle is, 0 … 1
  bool missed = false;                ///< a trial is over whose targets were not all reached
  bool urgent = false;                ///< it is to be done now: the instruction stands out
  bool simulated = false;
  bool example = false;  ///< to be watched: nothing in it is the patient's own
  bool progress_shown = false;
  double progress = 0.0;  ///< of the trial, 0 … 1

  Hand hand = Hand::right;
  ForceChannel channel;      ///< which force the next values are
  bool force_shown = false;  ///< the own force is on the screen
  double force_N = 0.0;      ///< 0 while it is not
  double full_N = 1.0;       ///< effort: about half of the column
  bool line_shown = false;   ///< the force target is on the screen
  double target_N = 0.0;     ///< 0 while it is not
  bool on_target = false;    ///< tracking: the mark is inside the band
  double task_time_s = 0.0;
  ForceAxis axis;  ///< of force and target
  /// Of that axis on this screen [deg of visual angle per N]; nothing: not known, or no force
  /// shown.
  std::optional<double> gain_deg_per_N;
  std::shared_ptr<const TargetPreview> preview;  ///< null: nothing of the target's future
  std::array<DigitPicture, kFingerCount> digits{};
  double digits_N = 1.0;  ///< largest force asked of a digit in this trial

  std::shared_ptr<const Scene> scene;
  bool in_space = false;      ///< a real object, moved in the room before the screen
  bool object_shown = false;  ///< false: cameras have not seen it yet
  bool unseen = false;        ///< it is out of sight: pale, where it was seen last
  bool matched = false;       ///< it is on its target
  Pose X_WO;
  bool target_shown = false;
  Pose X_WT;
  double hold_fraction = 0.0;  ///< 0: no ring
  Vec3 ring_W = Vec3::Zero();  ///< its centre: that of the outline [m]
  int targets_reached = 0;
  int target_count = 0;
  std::array<FingerPicture, kFingerCount> fingers{};
  ShownAngle angle;                          ///< of a range that the own body turns
  std::optional<HandPicture> tracked_hand;   ///< page `hand`
  std::optional<TwoHandsPicture> two_hands;  ///< page `two_hands`
  bool camera_on = false;                    ///< on every page while a camera looks at the person
};

/// Half the band round a force target, of the height of the field.
inline constexpr double kHalfBandShare = 0.055;

[[nodiscard]] PatientPicture picture_for(const PatientFacts& facts);

}  // namespace isograsp::gui
