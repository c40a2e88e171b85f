// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/hand/virtual_grasper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/random.hpp"
#include "grasp_model/rotation.hpp"
#include "kinematics/attitude.hpp"
#include "virtual_patient/hand/grip_shapes.hpp"
#include "virtual_patient/hand/hand_movement.hpp"
#include "virtual_patient/hand/seen_hand.hpp"
#include "virtual_patient/visual_memory.hpp"

namespace isograsp::virtual_patient {

/// What a picture says to this person, who is a right one: a left one sees it reflected.
struct SeenTask {
  Cue cue = Cue::relax;
  bool object = false;  ///< there is one to be grasped
  bool let_go = false;
  bool box = true;
  double width_m = 0.0;  ///< across the main axis
  Pose X_WO;
  Pose X_WT;

  [[nodiscard]] bool to_be_moved() const noexcept { return object && !let_go && cue == Cue::move; }
  [[nodiscard]] bool asks() const noexcept { return to_be_moved() || (object && let_go); }
};

namespace {

constexpr double kFirstReach_m = 0.3;   ///< the way that takes reach_s
constexpr double kShortestReach = 0.4;  ///< … and the least share of it
constexpr double kAbove_m = 0.05;       ///< a hand comes to an object from so far above
constexpr double kRelaxed_m = 0.04;     ///< opening of a hand at rest
constexpr double kSettle_s = 0.1;       ///< after closing, before lifting
constexpr double kLooksAt_s = 0.15;     ///< at a standing object before it is corrected
constexpr int kMostMoves = 12;          ///< corrections of one transport; then it is good enough
constexpr double kLost_m = 0.04;        ///< an object so far from where the hand has it is lost
constexpr double kStays_s = 0.3;        ///< … for so long
constexpr double kGivesUp_s = 2.0;      ///< a screen that asks for nothing any more
constexpr double kMostHarder = 4.0;     ///< times harder_m
constexpr double kSkinsMeet_m = 0.0;    ///< no hand closes further on what is not there
constexpr double kNarrow_m = 0.015;     ///< too narrow for two fingers beside each other
/// Where the hand rests: over the table before the person, on the side of the hand.
const Vec3 kRestPlace_W(0.12, 0.18, 0.18);
/// The line from thumb to fingers of a hand that comes from there, level.
const Vec3 kNaturalLine_W = Vec3(0.63, 0.0, -0.78).normalized();

SeenTask task_of(const Stimulus& picture, Hand side) noexcept {
  SeenTask task;
  task.cue = picture.cue;
  task.object = picture.virtual_object.has_value() && picture.object_shown;
  if (!task.object) return task;
  const ShownObject& object = *picture.virtual_object;
  task.let_go = object.let_go;
  task.box = object.shape == ShownObject::Shape::box;
  task.width_m = object.size_m.x();
  task.X_WO = picture.X_WO;
  task.X_WT = picture.pose_target_shown ? picture.X_WT : picture.X_WO;
  if (side == Hand::left) {
    task.X_WO = mirrored(task.X_WO);
    task.X_WT = mirrored(task.X_WT);
  }
  return task;
}

/// The level axis across the object along which a hand takes it.
Vec3 grasp_line(const SeenTask& task) noexcept {
  const auto level = [](const Vec3& axis) { return Vec3(axis.x(), 0.0, axis.z()); };
  if (!task.box) {
    // Any direction across a cylinder will do.
    const Vec3 main_W = task.X_WO.q * Vec3::UnitZ();
    const Vec3 across = level(kNaturalLine_W - kNaturalLine_W.dot(main_W) * main_W);
    return across.norm() > 0.1 ? Vec3(across.normalized()) : kNaturalLine_W;
  }
  Vec3 best = kNaturalLine_W;
  double most = 0.0;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 line = level(task.X_WO.q * (sign * axis));
      const double fits = line.dot(kNaturalLine_W);
      if (fits > most) {
        most = fits;
        best = line.normalized();
      }
    }
  return best;
}

/// The attitude of an object that turns the least until its main axis, either way, is the target's.
Quat aligned(const Quat& q_WO, const Quat& q_WT) noexcept {
  const Vec3 is = q_WO * Vec3::UnitZ();
  Vec3 wanted = q_WT * Vec3::UnitZ();
  if (is.dot(wanted) < 0.0) wanted = -wanted;
  return (so3::shortest(is, wanted) * q_WO).normalized();
}

Vec3 normal_vector(Random& random, double sd) noexcept {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return sd * Vec3(x, y, random.gaussian());
}

}  // namespace

struct VirtualGrasper::Mind {
  enum class Doing : std::uint8_t {
    resting,
    reaching,
    lowering,
    closing,
    carrying,
    opening,
    leaving
  };

  Mind(const virtual_hand::HandModel& model, const GraspTraits& traits, std::uint64_t seed,
       Hand of_side)
      : person(traits),
        hand(model),
        side(of_side),
        pinch(model, Grip::pinch),
        tripod(model, Grip::tripod),
        tracker(traits, seed),
        body(seed, 224),
        eyes(seed, 225) {
    hand.side = Hand::right;
    rest = {kRestPlace_W, Quat::Identity()};
    begin_again(0.0);
  }

  void begin_again(double t_s) noexcept;
  void perceive(const SeenTask& picture, double t_s) noexcept;
  void act(double t_s) noexcept;
  [[nodiscard]] HandFrame shown(double dt_s) noexcept;

  void reach(double t_s) noexcept;
  void lower(double t_s) noexcept;
  void close(double t_s) noexcept;
  void carry(double t_s) noexcept;
  /// The object has slipped: next time harder.
  void miss(double t_s) noexcept;
  void correct(double t_s) noexcept;
  void open(double t_s) noexcept;
  void leave(double t_s) noexcept;
  void follow_cue(double t_s) noexcept;
  void move_palm(const Pose& to, double t_s) noexcept;
  /// The object is not where the hand that was there then would have it. One that has turned in
  /// the hand is not lost: they look again.
  [[nodiscard]] bool lost() const noexcept {
    return (compose(palm.at(pictured_s), X_PO).p - task.X_WO.p).norm() > kLost_m;
  }
  /// Palm that holds the object as it is seen, closed.
  [[nodiscard]] Pose palm_at_object() const noexcept;
  [[nodiscard]] const GripShapes& shapes() const noexcept {
    return task.width_m < kNarrow_m ? pinch : tripod;
  }
  [[nodiscard]] double widest() const noexcept {
    return std::min(person.opening_m, shapes().widest_m());
  }
  [[nodiscard]] double wide_open() const noexcept {
    return std::min(widest(), task.width_m + person.spare_m);
  }
  /// The person has perceived something new and moves a reaction later.
  [[nodiscard]] bool reacted(double since_s, double t_s) const noexcept {
    return t_s >= since_s + person.reaction_s;
  }

  GraspTraits person;
  virtual_hand::HandModel hand;  ///< a right one
  Hand side;
  GripShapes pinch, tripod;
  SeenHand tracker;
  Random body, eyes;
  VisualMemory memory;
  Pose rest;

  SeenTask task;                ///< as perceived last
  double pictured_s = 0.0;      ///< time of that picture
  double wanted_since_s = 0.0;  ///< since when an object has been there to be grasped
  double purple_since_s = 0.0;  ///< since when it is to be let go
  double idle_since_s = 0.0;    ///< when something was asked for last
  double cue_since_s = 0.0;
  bool begun = false;
  double latest_s = 0.0;

  Doing doing = Doing::resting;
  HandMovement<Pose> palm;
  HandMovement<double> gap;
  HandMovement<double> together;  ///< 0 … 1: the posture is that of `tripod`
  double width_m = 0.0;           ///< of the object that was grasped last
  double harder_m = 0.0;          ///< so much more than usual they squeeze it since it slipped
  double closed_m = 0.0;          ///< to which the digits close
  Vec3 missed_W = Vec3::Zero();
  Pose X_PO;         ///< how the object lies in the hand that carries it
  bool had = false;  ///< X_PO is known
  double lost_since_s = 0.0;
  int moves = 0;
};

void VirtualGrasper::Mind::begin_again(double t_s) noexcept {
  task = {};
  pictured_s = wanted_since_s = purple_since_s = idle_since_s = cue_since_s = lost_since_s = t_s;
  doing = Doing::resting;
  palm.stand(rest);
  gap.stand(kRelaxed_m);
  together.stand(0.0);
  had = false;
}

void VirtualGrasper::Mind::perceive(const SeenTask& picture, double t_s) noexcept {
  if (picture.to_be_moved() && !task.to_be_moved()) wanted_since_s = t_s;
  if (picture.let_go && !task.let_go) purple_since_s = t_s;
  if (picture.asks()) idle_since_s = t_s;
  if (picture.cue != task.cue) cue_since_s = t_s;
  task = picture;
  pictured_s = t_s - person.visual_delay_s;
  if (!had || doing != Doing::carrying) {
    lost_since_s = t_s;
    return;
  }
  if (!lost()) lost_since_s = t_s;
}

Pose VirtualGrasper::Mind::palm_at_object() const noexcept {
  const Vec3 line = grasp_line(task);
  const Vec3 up = Vec3::UnitY();
  Mat3 R_WG;
  R_WG << line, up, line.cross(up);
  const Quat q_WP = (Quat(R_WG) * GripShapes::q_PG().conjugate()).normalized();
  return {task.X_WO.p + missed_W - q_WP * shapes().at(closed_m).p_PG, q_WP};
}

void VirtualGrasper::Mind::move_palm(const Pose& to, double t_s) noexcept {
  const double way_m = (to.p - palm.at(t_s).p).norm();
  palm.go(to, t_s, person.reach_s * std::max(kShortestReach, std::sqrt(way_m / kFirstReach_m)));
}

void VirtualGrasper::Mind::reach(double t_s) noexcept {
  doing = Doing::reaching;
  had = false;
  missed_W = normal_vector(body, person.place_m);
  if (task.width_m != width_m) harder_m = 0.0;
  width_m = task.width_m;
  closed_m = std::max(kSkinsMeet_m, task.width_m - person.squeeze_m - harder_m +
                                        person.squeeze_sd_m * body.gaussian());
  Pose to = palm_at_object();
  to.p.y() += kAbove_m;
  move_palm(to, t_s);
  gap.go(wide_open(), t_s, palm.ends_s() - t_s);
  together.go(&shapes() == &tripod ? 1.0 : 0.0, t_s, palm.ends_s() - t_s);
}

void VirtualGrasper::Mind::lower(double t_s) noexcept {
  doing = Doing::lowering;
  move_palm(palm_at_object(), t_s);
}

void VirtualGrasper::Mind::close(double t_s) noexcept {
  doing = Doing::closing;
  gap.go(closed_m, t_s, person.close_s);
}

void VirtualGrasper::Mind::carry(double t_s) noexcept {
  doing = Doing::carrying;
  moves = 0;
  lost_since_s = t_s;
  correct(t_s);
}

void VirtualGrasper::Mind::miss(double t_s) noexcept {
  harder_m = std::min(harder_m + person.harder_m, kMostHarder * person.harder_m);
  open(t_s);
}

void VirtualGrasper::Mind::correct(double t_s) noexcept {
  // Hand and object stand still: what is seen is how the object lies in the hand.
  Pose seen = task.X_WO;
  seen.p += normal_vector(eyes, person.sight_m);
  const Vec3 turn = normal_vector(eyes, person.sight_rad);
  if (turn.norm() > 0.0)
    seen.q = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * seen.q).normalized();
  const Pose goal{task.X_WT.p, aligned(seen.q, task.X_WT.q)};
  const bool good =
      (goal.p - seen.p).norm() < person.aim_m && angle_between(goal.q, seen.q) < person.aim_rad;
  if (moves > 0 && (good || moves >= kMostMoves)) return;
  X_PO = compose(inverse(palm.at(t_s)), seen);
  had = true;
  ++moves;
  move_palm(compose(goal, inverse(X_PO)), t_s);
}

void VirtualGrasper::Mind::open(double t_s) noexcept {
  doing = Doing::opening;
  gap.go(wide_open(), t_s, person.open_s);
}

void VirtualGrasper::Mind::leave(double t_s) noexcept {
  doing = Doing::leaving;
  Pose up = palm.at(t_s);
  up.p.y() += kAbove_m;
  move_palm(up, t_s);
}

void VirtualGrasper::Mind::follow_cue(double t_s) noexcept {
  double to_m = kRelaxed_m;
  if (together.end() > 0.0 && t_s >= palm.ends_s()) together.go(0.0, t_s, person.open_s);
  if (task.cue == Cue::open) to_m = std::min(person.opening_m, pinch.widest_m());
  if (task.cue == Cue::close) to_m = 0.0;
  if (!reacted(cue_since_s, t_s) || gap.end() == to_m) return;
  gap.go(to_m, t_s, to_m > gap.at(t_s) ? person.open_s : person.close_s);
}

void VirtualGrasper::Mind::act(double t_s) noexcept {
  const bool asks = task.asks();
  const bool still = t_s >= palm.ends_s();
  const bool let_go = task.let_go && reacted(purple_since_s, t_s);
  const bool given_up = !asks && t_s - idle_since_s > kGivesUp_s;
  switch (doing) {
    case Doing::resting:
      if (task.to_be_moved() && reacted(wanted_since_s, t_s))
        reach(t_s);
      else if (!asks)
        follow_cue(t_s);
      break;
    case Doing::reaching:
      if (given_up)
        leave(t_s);
      else if (still && asks)
        lower(t_s);
      break;
    case Doing::lowering:
      if (given_up)
        leave(t_s);
      else if (still && asks)
        close(t_s);
      break;
    case Doing::closing:
      if (let_go || given_up)
        open(t_s);
      else if (asks && t_s >= gap.ends_s() + person.visual_delay_s + kSettle_s)
        carry(t_s);
      break;
    case Doing::carrying:
      if (let_go || given_up)
        open(t_s);
      else if (t_s - lost_since_s > kStays_s + person.reaction_s)
        miss(t_s);
      else if (asks && still && !lost() && pictured_s >= palm.ends_s() + kLooksAt_s)
        correct(t_s);
      break;
    case Doing::opening:
      if (t_s >= gap.ends_s() + kSettle_s) leave(t_s);
      break;
    case Doing::leaving:
      if (!still) break;
      doing = Doing::resting;
      if (!task.to_be_moved()) move_palm(rest, t_s);
      break;
  }
}

HandFrame VirtualGrasper::Mind::shown(double dt_s) noexcept {
  const double now_m = gap.at(latest_s);
  const auto angles = between(pinch.at(now_m), tripod.at(now_m), together.at(latest_s)).angles;
  const auto joints =
      virtual_hand::joint_poses(virtual_hand::hand_in_space(hand, {palm.at(latest_s), angles}));
  std::array<Vec3, kHandJointCount> places;
  for (std::size_t j = 0; j < kHandJointCount; ++j) places[j] = joints[j].p;
  HandFrame frame = tracker.look(places, dt_s);
  frame.side = side;
  if (side == Hand::left)
    for (Vec3& p : frame.joints) p = mirrored(p);
  return frame;
}

VirtualGrasper::VirtualGrasper(const virtual_hand::HandModel& hand, const GraspTraits& traits,
                               std::uint64_t seed, Hand side)
    : mind_(std::make_unique<Mind>(hand, traits, seed, side)) {}

VirtualGrasper::~VirtualGrasper() = default;

const GraspTraits& VirtualGrasper::person() const noexcept {
  return mind_->person;
}

double VirtualGrasper::opening_m() const noexcept {
  return std::min(mind_->person.opening_m, mind_->pinch.widest_m());
}

double VirtualGrasper::seen_size() const noexcept {
  return mind_->tracker.size();
}

void VirtualGrasper::see(const Stimulus& stimulus) noexcept {
  Stimulus picture = stimulus;
  picture.t_s = mind_->latest_s + mind_->person.tracker_delay_s;
  static_cast<void>(mind_->memory.see(picture));
}

HandFrame VirtualGrasper::at(double t_s) noexcept {
  Mind& mind = *mind_;
  // The tracker shows the hand as it was a moment ago: the person lives then.
  const double lives_s = t_s - mind.person.tracker_delay_s;
  if (!mind.begun || lives_s < mind.latest_s) mind.begin_again(lives_s);
  const double dt_s = mind.begun ? lives_s - mind.latest_s : 0.0;
  mind.begun = true;
  mind.latest_s = lives_s;
  while (const Stimulus* picture = mind.memory.next(lives_s - mind.person.visual_delay_s))
    mind.perceive(task_of(*picture, mind.side), lives_s);
  mind.act(lives_s);
  HandFrame frame = mind.shown(std::max(0.0, dt_s));
  frame.t_s = t_s;
  return frame;
}

}  // namespace isograsp::virtual_patient
