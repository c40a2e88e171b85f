// SPDX-License-Identifier: GPL-3.0-or-later
// Movement after movement (Woodworth 1899; Meyer et al. 1988): a first one that brings most of the
// way, then a look at what is left, and a smaller one. A look takes time, so sight is late by its
// delay and the loop cannot swing. A target that moves is followed by one movement after the other
// to where it will be (Miall et al. 1993: intermittent pursuit).
#include "virtual_patient/arm/virtual_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "grasp_model/rotation.hpp"
#include "kinematics/attitude.hpp"
#include "virtual_patient/arm/movement_plan.hpp"
#include "virtual_patient/arm/reach.hpp"
#include "virtual_patient/arm/seen_markers.hpp"
#include "virtual_patient/traits.hpp"
#include "virtual_patient/visual_memory.hpp"

namespace isograsp::virtual_patient {

namespace {

/// A target that differs by more than this is another one.
constexpr double kSameTarget_m = 0.001;
constexpr double kSameTarget_rad = 0.01;
constexpr double kScreenDelay_s = 0.05;  ///< from the arm to its picture, as people learn it
constexpr double kLook_s = 0.15;         ///< how long they look at an error before they correct it
constexpr double kPatience_s = 1.0;      ///< nothing is reached: even a small error is corrected
constexpr double kLost_s = 1.0;          ///< without the object on the screen they turn back …
constexpr double kBack = 0.3;            ///< … by this share of the way to the start
constexpr double kShortest = 0.3;        ///< of movement_s: no movement is shorter
constexpr double kReturn_s = 1.2;        ///< to the start posture, times movement_s
constexpr double kLargestFactor = 3.0;   ///< of a random duration
constexpr int kMovesFor = 3;             ///< pictures in which a target moves before it is moving
constexpr double kStands_s = 0.1;        ///< so long it has not moved: it stands
constexpr double kMoves = 1e-9;          ///< by more than rounding [m or rad]
constexpr double kJumps_m = 0.005;       ///< by more from one picture to the next: it jumps
constexpr double kJumps_rad = 0.05;
constexpr double kSpeedMemory_s = 0.1;  ///< over which the speed of a target is seen
constexpr double kAtTheEnd_s = 0.4;     ///< a joint is kept at the end of its range
constexpr double kArmTurn_rad = 2.0 * std::numbers::pi;

double reflected_if(Hand hand, double x) noexcept {
  return hand == Hand::left ? -x : x;
}

/// Shares of the unsteadiness: pronation has all of it.
Joints unsteadiness() noexcept {
  Joints share = Joints::Zero();
  share[joint::pronation] = 1.0;
  share[joint::swing_up] = share[joint::swing_in] = 0.3;
  share[joint::flexion] = share[joint::ulnar] = 0.6;
  share[joint::turn_x] = share[joint::turn_y] = share[joint::turn_z] = 0.3;
  share[joint::shift_x] = share[joint::shift_y] = share[joint::shift_z] = 0.03;  // m / rad
  share[joint::lift] = 0.05;
  share[joint::lean_x] = share[joint::lean_y] = share[joint::lean_z] = 0.03;  // m / rad
  return share;
}

Joints lags_of(const ArmTraits& traits) noexcept {
  Joints lag = Joints::Zero();
  for (const auto k : {joint::pronation, joint::swing_up, joint::swing_in, joint::lift,
                       joint::lean_x, joint::lean_y, joint::lean_z})
    lag[k] = traits.forearm_lag;
  lag[joint::flexion] = lag[joint::ulnar] = traits.wrist_lag;
  return lag;
}

/// Which joint turns an angle of the rigs of the library; nothing: none does alone.
std::optional<joint::Index> joint_of(LinkAngle asked) noexcept {
  using Turns = std::array<std::optional<joint::Index>, 3>;
  constexpr Turns kForearm{joint::swing_up, joint::swing_in, joint::pronation};
  constexpr Turns kWrist{joint::flexion, joint::ulnar, std::nullopt};
  constexpr Turns kFingers{joint::turn_x, joint::turn_z, joint::turn_y};
  const auto angle = static_cast<std::size_t>(std::clamp(asked.angle, 1, 3) - 1);
  switch (asked.link) {
    case ArmLink::forearm: return kForearm[angle];
    case ArmLink::wrist: return kWrist[angle];
    case ArmLink::fingers: break;
  }
  return kFingers[angle];
}

}  // namespace

struct VirtualArm::Mind {
  enum class Aim : std::uint8_t { stay, start, target, turn };
  /// What the screen asks for.
  struct Intention {
    Aim aim = Aim::stay;
    Pose X_WT;
    LinkAngle turn;
    [[nodiscard]] bool same(const Intention& other) const noexcept {
      if (aim != other.aim) return false;
      if (aim == Aim::turn) return turn == other.turn;
      return aim != Aim::target || ((X_WT.p - other.X_WT.p).norm() < kSameTarget_m &&
                                    angle_between(X_WT.q, other.X_WT.q) < kSameTarget_rad);
    }
  };

  /// An error of the object: how it must move and turn, axes of W.
  struct PoseError {
    Vec3 p = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
  };
  [[nodiscard]] static PoseError error_between(const Pose& X_WO, const Pose& X_WT) noexcept {
    return {X_WT.p - X_WO.p, rotation_vector(X_WT.q * X_WO.q.conjugate())};
  }

  Mind(const ArmTraits& today, std::uint64_t seed, Hand whose)
      : person(today),
        hand(whose),
        placing(seed, 201),
        body(person, placing, whose),
        reach(person, body),
        lag(lags_of(person)),
        unsteady(unsteadiness()),
        attention(seed, 202),
        eyes(seed, 203),
        muscles(seed, 204),
        cameras(person, seed) {
    for (const ArmMarker& marker : body.markers) labels.emplace_back(marker.label);
    posture = body.rest;
    plan.stand(body.rest);
    for (int k = 0; k < kJoints; ++k) wander[k] = muscles.gaussian();
    tremor_phase_rad = kArmTurn_rad * muscles.uniform();
  }

  [[nodiscard]] Intention asked(const Stimulus& picture) const noexcept;
  void perceive(const Stimulus& picture, double t_s) noexcept;
  void watch(const Stimulus& picture, double t_s) noexcept;
  void act(double t_s) noexcept;
  void correct(double t_s) noexcept;
  void watch_target(const Intention& next, double picture_s, double t_s) noexcept;
  void follow(double t_s) noexcept;
  void turn_to_the_end(double t_s) noexcept;
  void move(const PoseError& error, const Pose& X_now, double gain, const Joints& lags,
            double t_s) noexcept;
  void go(const Joints& way, const Joints& lags, double t_s) noexcept;
  [[nodiscard]] PoseError as_seen(PoseError error) noexcept;
  [[nodiscard]] Pose object_at(double t_s) const noexcept;
  [[nodiscard]] bool standing(double t_s) const noexcept { return t_s >= plan.ends_s(); }
  void forget_error() noexcept;
  void begin_again(double t_s) noexcept;
  [[nodiscard]] Joints unsteady_posture(double t_s, double dt_s) noexcept;

  ArmTraits person;
  Hand hand;
  Random placing;
  ArmBody body;
  Reach reach;
  Joints lag, unsteady;
  Random attention, eyes, muscles;  // separate: more draws of one never change another
  SeenMarkers cameras;
  std::vector<std::string> labels;
  VisualMemory memory;
  MovementPlan plan;

  Intention seen;        ///< perceived
  Intention acting;      ///< being done
  bool waiting = false;  ///< seen is acted on at act_s
  double act_s = 0.0;

  bool object_seen = false;  ///< in the last picture
  Pose X_WO;                 ///< in the last picture that showed it
  double pictured_s = 0.0;   ///< of that picture
  double answered_s = 0.0;   ///< of the last picture in which it had moved
  double missing_since_s = 0.0;
  bool content = false;  ///< what was asked for is reached, or is being held

  // A target that moves from picture to picture.
  bool moving = false;
  int moves = 0;              ///< pictures on end in which it did
  Pose X_WT;                  ///< in the last picture
  double target_s = 0.0;      ///< of that picture
  double moved_s = 0.0;       ///< of the last picture in which it moved
  PoseError target_speed;     ///< per second
  double next_step_s = 0.0;   ///< when the next movement after it begins
  bool towards_most = false;  ///< to which end of its range a joint is turned

  double error_since_s = 0.0;  ///< pictures of an arm that stands, and their errors
  int looks = 0;
  PoseError error_sum;

  Joints posture = Joints::Zero();
  Joints wander = Joints::Zero();  ///< slow noise, SD 1
  double tremor_phase_rad = 0.0;
  double latest_s = 0.0;
  bool begun = false;
};

VirtualArm::Mind::Intention VirtualArm::Mind::asked(const Stimulus& picture) const noexcept {
  switch (picture.cue) {
    case Cue::hand_out:
    case Cue::relax:
    case Cue::let_go: return {Aim::start, {}, {}};
    case Cue::move: break;
    case Cue::squeeze:
    case Cue::press:
    case Cue::follow:
    case Cue::reproduce:
    case Cue::open:
    case Cue::close: return {};
  }
  if (picture.progress.getting_ready) return {};
  if (picture.turn) return {Aim::turn, {}, *picture.turn};
  // An object that is not on the screen for a while changes nothing of what is asked.
  if (!picture.object_shown || !picture.pose_target_shown)
    return seen.aim == Aim::target ? seen : Intention{};
  return {Aim::target, picture.X_WT, {}};
}

void VirtualArm::Mind::perceive(const Stimulus& picture, double t_s) noexcept {
  const Intention next = asked(picture);
  watch_target(next, picture.t_s, t_s);
  if (moving) {
    seen = next;
    if (acting.aim == Aim::target && !waiting) acting = next;
  } else if (!next.same(seen)) {
    waiting = true;
    act_s = t_s + person.reaction_s * (1.0 + person.reaction_cv * std::abs(attention.gaussian()));
    seen = next;
  }
  watch(picture, t_s);
}

/// Whether the target moves, and how fast. One that jumps does not move.
void VirtualArm::Mind::watch_target(const Intention& next, double picture_s, double t_s) noexcept {
  const double since_s = picture_s - target_s;
  if (next.aim != Aim::target || seen.aim != Aim::target || since_s <= 0.0) {
    moving = false;
    moves = 0;
  } else {
    const PoseError step = error_between(X_WT, next.X_WT);
    const bool jumped = step.p.norm() > kJumps_m || step.turn.norm() > kJumps_rad;
    const bool moved = !jumped && (step.p.norm() > kMoves || step.turn.norm() > kMoves);
    moves = moved ? moves + 1 : jumped ? 0 : moves;
    if (moved) moved_s = picture_s;
    if (jumped || picture_s - moved_s > kStands_s) {
      moving = false;
      moves = 0;
    }
    if (!moving && moves >= kMovesFor) {
      moving = true;
      target_speed = {};
      next_step_s =
          t_s + person.reaction_s * (1.0 + person.reaction_cv * std::abs(attention.gaussian()));
    }
    const double fresh = std::min(1.0, since_s / kSpeedMemory_s);
    target_speed.p += fresh * (step.p / since_s - target_speed.p);
    target_speed.turn += fresh * (step.turn / since_s - target_speed.turn);
  }
  X_WT = next.X_WT;
  target_s = picture_s;
}

/// The next movement after a moving target: to where it will be when the movement ends, as far as
/// the person foresees it.
void VirtualArm::Mind::follow(double t_s) noexcept {
  if (!moving || waiting || acting.aim != Aim::target || !object_seen || t_s < next_step_s) return;
  const double lasts_s = kShortest * person.movement_s;
  const double ahead_s = person.first_gain * (t_s - target_s + lasts_s);
  PoseError error = as_seen(error_between(X_WO, X_WT));
  error.p += ahead_s * target_speed.p;
  error.turn += ahead_s * target_speed.turn;
  const Pose X_now = object_at(pictured_s);
  const Pose goal{X_now.p + error.p, (so3::exp(error.turn) * X_now.q).normalized()};
  Joints way = reach.posture_for(goal) - plan.end();
  for (int k = 0; k < kJoints; ++k) way[k] *= 1.0 + person.amplitude_cv * muscles.gaussian();
  way = (plan.end() + way).cwiseMax(body.least).cwiseMin(body.most) - plan.end();
  plan.add(way, Joints::Zero(), t_s, lasts_s);
  next_step_s = t_s + std::max(lasts_s, person.reaction_s);
  missing_since_s = t_s;
  forget_error();
}

/// One joint to the other end of its range, all else as at the start. Who turns the forearm also
/// lifts the shoulder, as far as they share a turn.
void VirtualArm::Mind::turn_to_the_end(double t_s) noexcept {
  const auto k = joint_of(acting.turn);
  if (!k) return;
  towards_most = !towards_most;
  const double effort = 1.0 - std::min(1.0, person.amplitude_cv * std::abs(muscles.gaussian()));
  Joints goal = body.rest;
  goal[*k] = effort * (towards_most ? body.most[*k] : body.least[*k]);
  if (*k == joint::pronation)
    goal[joint::lift] = person.shoulder_share / person.forearm_share * goal[*k];
  goal = goal.cwiseMax(body.least).cwiseMin(body.most);
  go(goal - plan.end(), Joints::Zero(), t_s);
}

void VirtualArm::Mind::watch(const Stimulus& picture, double t_s) noexcept {
  content = picture.progress.holding || picture.progress.hold_fraction > 0.0;
  if (!picture.object_shown) {
    if (object_seen) missing_since_s = t_s;
    object_seen = false;
    forget_error();
    return;
  }
  const bool moved = picture.X_WO.p != X_WO.p || picture.X_WO.q.coeffs() != X_WO.q.coeffs();
  if (moved || !object_seen) answered_s = picture.t_s;
  X_WO = picture.X_WO;
  pictured_s = picture.t_s;
  object_seen = true;
  // A picture that stood still while the arm moved shows nothing.
  if (answered_s <= plan.began_s()) return;
  missing_since_s = t_s;
  if (acting.aim != Aim::target || picture.t_s < plan.ends_s() + kScreenDelay_s) return;
  if (looks == 0) error_since_s = picture.t_s;
  const PoseError error = error_between(X_WO, acting.X_WT);
  error_sum.p += error.p;
  error_sum.turn += error.turn;
  ++looks;
}

void VirtualArm::Mind::forget_error() noexcept {
  looks = 0;
  error_sum = {};
}

VirtualArm::Mind::PoseError VirtualArm::Mind::as_seen(PoseError error) noexcept {
  const double x = eyes.gaussian(), y = eyes.gaussian(), z = eyes.gaussian();
  error.p += Vec3(person.sight_m * x, person.sight_m * y, person.depth_m * z);
  const double a = eyes.gaussian(), b = eyes.gaussian(), c = eyes.gaussian();
  error.turn += person.sight_rad * Vec3(a, b, c);
  return error;
}

Pose VirtualArm::Mind::object_at(double t_s) const noexcept {
  return body.poses_W(plan.at(t_s))[index_of(Segment::object)];
}

void VirtualArm::Mind::act(double t_s) noexcept {
  waiting = false;
  acting = seen;
  forget_error();
  missing_since_s = t_s;
  switch (acting.aim) {
    case Aim::stay: break;
    case Aim::start: go(body.rest - plan.end(), Joints::Zero(), t_s); break;
    case Aim::target:
      if (!object_seen) break;  // correct() begins when it is there
      move(as_seen(error_between(X_WO, acting.X_WT)), object_at(pictured_s), person.first_gain, lag,
           t_s);
      break;
    case Aim::turn:
      towards_most = false;
      turn_to_the_end(t_s);
      break;
  }
}

void VirtualArm::Mind::correct(double t_s) noexcept {
  if (waiting || !standing(t_s)) return;
  if (acting.aim == Aim::turn && t_s >= plan.ends_s() + kAtTheEnd_s) turn_to_the_end(t_s);
  if (acting.aim != Aim::target || moving) return;
  if (t_s - missing_since_s > kLost_s) {
    missing_since_s = t_s;
    go(kBack * (body.rest - plan.end()), Joints::Zero(), t_s);
    return;
  }
  if (content || looks == 0 || pictured_s - error_since_s < kLook_s) return;
  const double share = 1.0 / looks;
  const PoseError error = as_seen({share * error_sum.p, share * error_sum.turn});
  const bool good = error.p.norm() < person.aim_m && error.turn.norm() < person.aim_rad;
  if (good && t_s - plan.ends_s() < kPatience_s) {
    forget_error();
    return;
  }
  move(error, body.poses_W(plan.end())[index_of(Segment::object)], 1.0, Joints::Zero(), t_s);
}

void VirtualArm::Mind::move(const PoseError& error, const Pose& X_now, double gain,
                            const Joints& lags, double t_s) noexcept {
  const Pose goal{X_now.p + error.p, (so3::exp(error.turn) * X_now.q).normalized()};
  Joints way = gain * (reach.posture_for(goal) - plan.end());
  for (int k = 0; k < kJoints; ++k) way[k] *= 1.0 + person.amplitude_cv * muscles.gaussian();
  // Nobody turns a joint beyond its end.
  way = (plan.end() + way).cwiseMax(body.least).cwiseMin(body.most) - plan.end();
  go(way, lags, t_s);
}

void VirtualArm::Mind::go(const Joints& way, const Joints& lags, double t_s) noexcept {
  double turn_rad = 0.0;
  for (const auto k : {joint::pronation, joint::swing_up, joint::swing_in, joint::flexion,
                       joint::ulnar, joint::turn_x, joint::turn_y, joint::turn_z, joint::lift})
    turn_rad = std::max(turn_rad, std::abs(way[k]));
  const double share =
      acting.aim == Aim::start ? kReturn_s : std::max(kShortest, std::sqrt(turn_rad));
  const double factor = std::clamp(1.0 + person.movement_cv * muscles.gaussian(),
                                   1.0 / kLargestFactor, kLargestFactor);
  plan.add(way, lags, t_s, person.movement_s * share * factor);
  forget_error();
}

void VirtualArm::Mind::begin_again(double t_s) noexcept {
  seen = acting = {};
  waiting = object_seen = content = moving = false;
  moves = 0;
  pictured_s = answered_s = missing_since_s = t_s;
  plan.stand(body.rest);
  forget_error();
}

Joints VirtualArm::Mind::unsteady_posture(double t_s, double dt_s) noexcept {
  // Ornstein-Uhlenbeck, exact for any step: the SD stays 1.
  const double keep = std::exp(-dt_s / person.wander_s);
  const double fresh = std::sqrt(1.0 - keep * keep);
  Joints q = plan.at(t_s);
  for (int k = 0; k < kJoints; ++k) {
    wander[k] = keep * wander[k] + fresh * muscles.gaussian();
    q[k] += person.wander_rad * unsteady[k] * wander[k];
  }
  tremor_phase_rad =
      std::fmod(tremor_phase_rad + kArmTurn_rad * person.tremor_Hz * dt_s, kArmTurn_rad);
  const double tremor = person.tremor_rad * std::sin(tremor_phase_rad);
  q[joint::pronation] += tremor;
  q[joint::flexion] += 0.5 * tremor;
  return q;
}

VirtualArm::VirtualArm(const ArmTraits& traits, std::uint64_t seed, Hand hand,
                       std::optional<std::uint64_t> day)
    : mind_(day ? std::make_unique<Mind>(arm_on_day(drawn(traits, seed), day_seed(seed, *day)),
                                         day_seed(seed, *day), hand)
                : std::make_unique<Mind>(drawn(traits, seed), seed, hand)) {}

VirtualArm::~VirtualArm() = default;

std::span<const std::string> VirtualArm::labels() const noexcept {
  return mind_->labels;
}

const ArmTraits& VirtualArm::person() const noexcept {
  return mind_->person;
}

const ArmBody& VirtualArm::body() const noexcept {
  return mind_->body;
}

const Joints& VirtualArm::posture() const noexcept {
  return mind_->posture;
}

void VirtualArm::see(const Stimulus& stimulus) noexcept {
  Stimulus picture = stimulus;
  picture.t_s = mind_->latest_s;
  static_cast<void>(mind_->memory.see(picture));
}

void VirtualArm::markers(double t_s, std::span<Vec3> p_W) noexcept {
  Mind& mind = *mind_;
  if (!mind.begun || t_s < mind.latest_s) mind.begin_again(t_s);
  const double dt_s = mind.begun ? std::max(0.0, t_s - mind.latest_s) : 0.0;
  mind.begun = true;
  mind.latest_s = t_s;
  while (const Stimulus* picture = mind.memory.next(t_s - mind.person.visual_delay_s))
    mind.perceive(*picture, t_s);
  if (mind.waiting && t_s >= mind.act_s) mind.act(t_s);
  mind.follow(t_s);
  mind.correct(t_s);
  mind.posture = mind.unsteady_posture(t_s, dt_s);
  mind.cameras.look(mind.body, mind.body.poses_W(mind.posture), dt_s, p_W);
  for (Vec3& p : p_W) p.x() = reflected_if(mind.hand, p.x());
}

}  // namespace isograsp::virtual_patient
