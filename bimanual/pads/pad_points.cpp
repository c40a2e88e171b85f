// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/pad_points.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

namespace {

/// A pad whose points all stick is held this much harder at first than its bodies give, ...
constexpr double kFirst = 10.0;
/// ... a point that has not come to kNeeded of the largest slip of a round this much harder in the
/// next one, ...
constexpr double kHarder = 30.0, kNeeded = 0.2;
/// ... and none harder than this: rounding grows with it.
constexpr double kHardest = 1e7;
/// Of the largest velocity: what is sought of impulses, and of slip; kSettled must be reached.
constexpr double kSought = 1e-12, kSticks = 1e-15;
/// Slower than this sticks: pads that are all but sliding come to rest no sooner [m/s].
constexpr double kCreep_m_s = 2e-9;
/// Of the residual at the begin of a round: what may be left at its end.
constexpr double kCoarse = 1e-2;
/// Once settled, a round that leaves more than this of the slip before is the last one.
constexpr double kBetter = 0.5;
/// Of a pad's size, and as an angle: planes that move less stand.
constexpr double kPlanesStand = 1e-11;
constexpr int kMostNewtonRounds = 60, kMostNewtonSteps = 25, kMostTries = 10;

}  // namespace

PointSlip PointSolver::slip_of(const PadFace& spec, const Face& face, std::size_t i,
                               const Vec6& velocity) const {
  const PadPoint& point = spec.points[i];
  const Vec3 v = velocity_at(velocity, point.p_pad);
  const double closing = point.normal.dot(v);
  if (!one_plane_) return {closing, v - closing * point.normal};
  return {closing, across(velocity_at(velocity, face.arms[i]), face.plane)};
}

void PointSolver::begin(const PadStep& step, bool go_on, const PadSolution& before) {
  step_s_ = step.step_s;
  looks_ = 0;
  objects_.resize(step.inertia.size());
  faces_.resize(step.faces.size());
  const auto& velocity = go_on ? before.velocity : step.velocity_free;
  for (std::size_t b = 0; b < objects_.size(); ++b) {
    Object& object = objects_[b];
    object.inertia = step.inertia[b];
    object.inverse = object.inertia.inverse();
    object.free = step.velocity_free[b];
    object.velocity = velocity[b];
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const PadFace& spec = step.faces[f];
    Face& face = faces_[f];
    static_cast<Body&>(face) = objects_[spec.pad];
    // From here on it is the face that moves the pad.
    objects_[spec.pad].velocity = objects_[spec.pad].free;
    face.object = spec.object;
    face.there.setIdentity();
    if (!spec.points.empty())
      face.there.topRightCorner<3, 3>() =
          -skew(spec.points.front().p_object - spec.points.front().p_pad);
    face.relative_free = face.free - face.there * objects_[spec.object].free;
    face.relative = velocity[spec.pad] - face.there * velocity[spec.object];
    begin_points(spec, face);
    if (one_plane_) static_cast<void>(lay_plane(spec, face));
    if (go_on)
      for (std::size_t i = 0; i < face.points.size(); ++i)
        face.points[i].held_N = face.points[i].foreseen_N =
            across(before.memory[f].friction_W_N[i], normal_of(spec, face, i));
  }
}

void PointSolver::begin_points(const PadFace& spec, Face& face) const {
  face.points.assign(spec.points.size(), PointState());
  double area_m2 = 0.0;
  for (const PadPoint& point : spec.points) area_m2 += point.area_m2;
  const Mat6 give =
      face.inverse + face.there * objects_[face.object].inverse * face.there.transpose();
  const double hard = 3.0 / (step_s_ * give.topLeftCorner<3, 3>().trace() * area_m2);
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const PadPoint& point = spec.points[i];
    PointState& state = face.points[i];
    state.stiffness_N_m = spec.stiffness_N_m3 * point.area_m2;
    state.at_rest_m = point.penetration_free_m -
                      step_s_ * point.normal.dot(velocity_at(face.relative_free, point.p_pad));
    state.hardest = kHardest * hard * point.area_m2;
    state.firm = kFirst * hard * point.area_m2;
  }
}

/// Wrench of a pad on the object, and how it grows with the velocity of the pad over it.
void PointSolver::look_at_points(const PadFace& spec, Face& face) const {
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  Mat3 vv = Mat3::Zero(), vw = Mat3::Zero(), wv = Mat3::Zero(), ww = Mat3::Zero();
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const PadPoint& point = spec.points[i];
    const PointState& state = face.points[i];
    const Vec3& arm = point.p_pad;
    const PointForce force =
        force_at(state, spec.friction, step_s_, slip_of(spec, face, i, face.relative));
    if (force.normal_N == 0.0) continue;
    const Vec3 all = force.normal_N * point.normal + force.friction_N;
    sum += all;
    torque += arm.cross(all);
    // With the skew matrix S of the arm: K, -K S, S K, -S K S.
    const Mat3 K = friction_hardness(point.normal, state, force) +
                   step_s_ * state.stiffness_N_m *
                       (point.normal + friction_of_pressure(spec.friction, force)) *
                       point.normal.transpose();
    Mat3 KS;
    for (int k = 0; k < 3; ++k) KS.row(k) = arm.cross(K.row(k).transpose()).transpose();
    vv += K;
    vw += KS;
    for (int k = 0; k < 3; ++k) {
      wv.col(k) += arm.cross(K.col(k));
      ww.col(k) += arm.cross(KS.col(k));
    }
  }
  face.wrench << sum, torque;
  face.hardness << vv, vw, wv, ww;
}

/// A (v - v_free) - h J^T f of every body.
void PointSolver::look(const PadStep& step) {
  ++looks_;
  for (Object& object : objects_)
    object.residual = object.inertia * (object.velocity - object.free);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    Object& object = objects_[face.object];
    if (one_plane_)
      look_in_plane(step.faces[f], face);
    else
      look_at_points(step.faces[f], face);
    const Vec6 velocity = face.there * object.velocity + face.relative;
    face.residual = face.inertia * (velocity - face.free) + step_s_ * face.wrench;
    object.residual -= step_s_ * face.there.transpose() * face.wrench;
  }
}

/// A pad touches nothing but its object: without the pads each object is alone.
void PointSolver::find_way() {
  for (Object& object : objects_) {
    object.system = object.inertia;
    object.way = -object.residual;
  }
  for (Face& face : faces_) {
    Object& object = objects_[face.object];
    face.gives = Mat6(face.inertia + step_s_ * face.hardness).inverse();
    const Mat6 on_object = step_s_ * face.there.transpose() * face.hardness * face.gives;
    object.system += on_object * face.inertia * face.there;
    object.way -= on_object * face.residual;
  }
  for (Object& object : objects_)
    object.way = object.system.partialPivLu().solve(object.way).eval();
  for (Face& face : faces_)
    face.way =
        -face.gives * (face.residual + face.inertia * (face.there * objects_[face.object].way));
}

/// What friction would be after the whole way if it went straight.
void PointSolver::foresee(const PadStep& step) {
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const PadFace& spec = step.faces[f];
    Face& face = faces_[f];
    for (std::size_t i = 0; i < face.points.size(); ++i) {
      PointState& state = face.points[i];
      const PointForce force =
          force_at(state, spec.friction, step_s_, slip_of(spec, face, i, face.relative));
      if (force.normal_N == 0.0) continue;
      const PointSlip way = slip_of(spec, face, i, face.way);
      state.foreseen_N =
          force.friction_N +
          friction_hardness(normal_of(spec, face, i), state, force) * way.across +
          step_s_ * state.stiffness_N_m * way.closing * friction_of_pressure(spec.friction, force);
    }
  }
}

void PointSolver::go(double share) {
  for (Object& object : objects_) object.velocity += share * object.way;
  for (Face& face : faces_) face.relative += share * face.way;
}

/// Of the residual along the way: below 0 it goes down.
double PointSolver::work_left() const {
  double work = 0.0;
  for (const Object& object : objects_) work += object.way.dot(object.residual);
  for (const Face& face : faces_)
    work += face.residual.dot(face.there * objects_[face.object].way + face.way);
  return work;
}

/// As a velocity.
double PointSolver::residual() const {
  double most = 0.0;
  for (const Object& object : objects_)
    most = std::max(most, (object.inverse * object.residual).cwiseAbs().maxCoeff());
  for (const Face& face : faces_)
    most = std::max(most, (face.inverse * face.residual).cwiseAbs().maxCoeff());
  return most;
}

double PointSolver::speed() const {
  double most = kStill;
  for (const Object& object : objects_)
    most = std::max(most, object.velocity.cwiseAbs().maxCoeff());
  for (const Face& face : faces_) most = std::max(most, face.relative.cwiseAbs().maxCoeff());
  return most;
}

/// A step of Newton, cut where it would climb on the other side.
void PointSolver::advance(const PadStep& step) {
  constexpr double kClimbs = 0.5, kLess = 0.9, kInside = 0.1;
  find_way();
  const double before = work_left();
  foresee(step);
  double low = 0.0, low_work = before, high = 1.0, high_work = 0.0, share = 1.0, gone = 0.0;
  for (int k = 0; k < kMostTries; ++k) {
    go(share - gone);
    gone = share;
    look(step);
    const double work = work_left();
    const bool far_enough = share == 1.0 || work >= -kLess * std::abs(before);
    if (work <= kClimbs * std::abs(before) && far_enough) return;
    if (residual() <= kSettled * speed()) return;  // what is left is rounding
    if (work > 0.0) {
      high = share;
      high_work = work;
    } else {
      low = share;
      low_work = work;
    }
    const double width = high - low;
    share = std::clamp(low - low_work * width / (high_work - low_work), low + kInside * width,
                       high - kInside * width);
  }
}

/// What was given is held from now on. The largest slip [m/s] by which a point is not yet where
/// Coulomb wants it.
double PointSolver::hold(const PadStep& step, double slipped_before) {
  const double enough = std::max(kNeeded * slipped_before, kSought * speed());
  double slipped = 0.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const PadFace& spec = step.faces[f];
    for (std::size_t i = 0; i < spec.points.size(); ++i) {
      PointState& state = faces_[f].points[i];
      const PointSlip slip = slip_of(spec, faces_[f], i, faces_[f].relative);
      const auto friction_N = [&] {
        return force_at(state, spec.friction, step_s_, slip).friction_N;
      };
      state.held_N = state.foreseen_N = friction_N();
      const double off = (friction_N() - state.held_N).norm() / state.firm;
      slipped = std::max(slipped, off);
      if (off > enough) state.firm = std::min(kHarder * state.firm, state.hardest);
    }
  }
  return slipped;
}

void PointSolver::report(const PadStep& step, PadSolution& solution) const {
  solution.sweeps = looks_;
  solution.constraints = 0;
  solution.velocity.resize(objects_.size());
  solution.wrench_on_object.resize(faces_.size());
  solution.memory.resize(faces_.size());
  for (std::size_t b = 0; b < objects_.size(); ++b) solution.velocity[b] = objects_[b].velocity;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    const PadFace& spec = step.faces[f];
    solution.velocity[spec.pad] = face.there * objects_[face.object].velocity + face.relative;
    solution.wrench_on_object[f] = face.there.transpose() * face.wrench;
    solution.constraints += one_plane_ ? 4 : 3 * face.points.size();
    PadMemory& memory = solution.memory[f];
    memory.normal_N.resize(face.points.size());
    memory.friction_W_N.resize(face.points.size());
    for (std::size_t i = 0; i < face.points.size(); ++i) {
      memory.normal_N[i] =
          force_at(face.points[i], spec.friction, step_s_, slip_of(spec, face, i, face.relative))
              .normal_N;
      memory.friction_W_N[i] = face.points[i].held_N;
    }
  }
}

void PointSolver::solve(const PadStep& step, bool go_on, PadSolution& solution) {
  begin(step, go_on, solution);
  double slipped = 0.0, moved = 0.0;
  solution.settled = false;
  for (int round = 0; round < kMostNewtonRounds; ++round) {
    look(step);
    const bool coarse =
        round == 0 || slipped > std::max(kSettled * speed(), kCreep_m_s) || moved > kPlanesStand;
    const double enough = std::max(kSought * speed(), coarse ? kCoarse * residual() : 0.0);
    for (int k = 0; k < kMostNewtonSteps && residual() > enough; ++k) {
      const double left = residual();
      advance(step);
      if (left <= kSettled * speed() && residual() > kBetter * left) break;  // rounding
    }
    const double before = slipped;
    slipped = hold(step, before);
    if (one_plane_) moved = lay_planes(step);
    solution.settled = slipped <= std::max(kSettled * speed(), kCreep_m_s) &&
                       residual() <= kSettled * speed() && moved <= kPlanesStand;
    if (solution.settled && (slipped <= kSticks * speed() || slipped > kBetter * before)) break;
  }
  report(step, solution);
}

}  // namespace isograsp::bimanual
