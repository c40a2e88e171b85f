// SPDX-License-Identifier: GPL-3.0-or-later
// The 1 ms step of a tracked hand that moves what it holds, the best grasp, distances of capsules.
// One line a case: name, median and 99th percentile of the processor time [ns], median of sweeps,
// residual at the 99th percentile [m/s], error [m] against steps of a sixteenth: the largest
// distance of the object over a second.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench/default_hand.hpp"
#include "hand_world/world.hpp"

namespace isograsp {

namespace {

using namespace hand_world;
using namespace virtual_hand;

constexpr double kStep_s = 0.001;
constexpr int kSteps = 10000;

/// A hand around a box of 60 g: the first `count` digits press it.
struct Lift {
  explicit Lift(std::size_t count) {
    const HandModel model = bench::default_hand();
    HandPose pose;
    pose.X_WP.p = {0.0, 0.25, 0.1};
    pose.angles[0] = {0.5, 0.3, 0.3, 0.3};
    for (std::size_t d = 1; d < kDigitCount; ++d) pose.angles[d] = {0.0, 0.7, 0.7, 0.3};
    const HandInSpace hand = hand_in_space(model, pose);
    const auto pad = [&](std::size_t d) {
      return Vec3(0.5 * (hand.digits[d].joints[2] + hand.digits[d].joints[3]));
    };
    Vec3 others = Vec3::Zero();
    for (std::size_t d = 1; d < count; ++d) others += pad(d) / static_cast<double>(count - 1);
    const Vec3 across = (others - pad(0)).normalized();
    constexpr double kGap_m = 0.002;
    const double half_m = 0.5 * (others - pad(0)).norm() - model.digits[0].radii_m[2] - kGap_m;
    ObjectBody box = solid_object({ObjectShape::Kind::box, {half_m, 0.02, 0.05}}, 1.0);
    box.inertia_kg_m2 *= 0.06 / box.mass_kg;
    box.mass_kg = 0.06;
    world = std::make_unique<World>(box, WorldRules());
    world->place_hand(model, pose);
    ObjectMotion motion;
    motion.X_WO.p = 0.5 * (others + pad(0));
    Mat3 R_WO;
    const Vec3 y = across.cross(hand.digits[1].axes[1]).normalized();
    R_WO << across, y, across.cross(y);
    motion.X_WO.q = Quat(R_WO).normalized();
    world->place_object(motion);
    open = still_target(hand);
    constexpr double kPress_m = 0.012;
    for (std::size_t d = 0; d < count; ++d)
      for (LinkMotion& link : open.links[d]) link.X_W.p += (d == 0 ? kPress_m : -kPress_m) * across;
  }
  /// Up and down by 10 cm, once a second.
  [[nodiscard]] HandTarget target(double t_s) const {
    const double turn = 2.0 * std::numbers::pi;
    const double y_m = 0.05 * (1.0 - std::cos(turn * t_s));
    const double v_m_s = 0.05 * turn * std::sin(turn * t_s);
    HandTarget now = open;
    const auto lift = [&](LinkMotion& link) {
      link.X_W.p.y() += y_m;
      link.v_m_s.y() += v_m_s;
    };
    lift(now.palm);
    for (auto& digit : now.links)
      for (LinkMotion& link : digit) lift(link);
    return now;
  }
  std::unique_ptr<World> world;
  HandTarget open;
};

/// Processor time of this thread [ns].
double now_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

double at_share(std::vector<double> values, double share) {
  const auto nth =
      values.begin() + static_cast<long>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Where the object is every 10 ms of the first second, in steps of a part of a millisecond.
std::vector<Vec3> path_of(std::size_t digits, int parts) {
  Lift lift(digits);
  std::vector<Vec3> path;
  const double step_s = kStep_s / parts;
  for (int k = 0; k < 1000 * parts; ++k) {
    lift.world->step(step_s, lift.target((k + 0.5) * step_s));
    if ((k + 1) % (10 * parts) == 0) path.push_back(lift.world->object().motion().X_WO.p);
  }
  return path;
}

void step_with(const char* name, std::size_t digits) {
  Lift lift(digits);
  std::vector<double> times_ns, sweeps, residuals;
  for (int k = 0; k < kSteps; ++k) {
    const HandTarget target = lift.target((k + 0.5) * kStep_s);
    const double begin_ns = now_ns();
    lift.world->step(kStep_s, target);
    times_ns.push_back(now_ns() - begin_ns);
    sweeps.push_back(lift.world->solver_report().sweeps);
    residuals.push_back(lift.world->solver_report().residual_m_s);
  }
  const auto coarse = path_of(digits, 1);
  const auto fine = path_of(digits, 16);
  double error_m = 0.0;
  for (std::size_t k = 0; k < coarse.size(); ++k)
    error_m = std::max(error_m, (coarse[k] - fine[k]).norm());
  std::printf("%s\t%.4g\t%.4g\t%.0f\t%.2g\t%.2g\n", name, at_share(times_ns, 0.5),
              at_share(times_ns, 0.99), at_share(sweeps, 0.5), at_share(residuals, 0.99), error_m);
}

void criteria() {
  Lift lift(kDigitCount);
  for (int k = 0; k < 1000; ++k) lift.world->step(kStep_s, lift.target(0.0));
  const HandInSpace hand = lift.world->hand()->in_space();
  // The little finger need not touch: every tip counts where it is.
  std::vector<DigitContact> contacts;
  const Pose& X_WO = lift.world->object().motion().X_WO;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    DigitContact contact;
    if (const auto touching = lift.world->contact_of(static_cast<Digit>(d))) {
      contact = *touching;
    } else {
      contact.digit = static_cast<Digit>(d);
      contact.p_OC = X_WO.q.conjugate() * (hand.digits[d].joints[kLinkCount] - X_WO.p);
      const Vec3 normal = -contact.p_OC.normalized();
      const Vec3 tangent = normal.unitOrthogonal();
      contact.R_OC << tangent, normal.cross(tangent), normal;
    }
    contacts.push_back(contact);
  }
  const double scale_m = hand_scale_m(lift.world->hand()->model());
  const GraspLimits limits{0.01, 0.001, 1e-9, 0.01, 1e-9, true};
  std::vector<double> times_ns;
  for (int k = 0; k < 2000; ++k) {
    const double begin_ns = now_ns();
    const auto best = feasible_grasp(contacts, hand, X_WO, scale_m, {}, limits);
    times_ns.push_back(now_ns() - begin_ns);
    if (!best.feasible) std::exit(1);
  }
  std::printf("best grasp of ten pairs and ten triples\t%.4g\t%.4g\t\t\t\n",
              at_share(times_ns, 0.5), at_share(times_ns, 0.99));
}

void distances() {
  for (const auto kind : {ObjectShape::Kind::box, ObjectShape::Kind::cylinder}) {
    const ObjectShape shape{kind, {0.01, 0.01, 0.075}};
    constexpr int kPairs = 1000;
    std::vector<double> times_ns;
    double sum = 0.0;
    for (int round = 0; round < 200; ++round) {
      const double begin_ns = now_ns();
      for (int k = 0; k < kPairs; ++k) {
        const double shift = 1e-5 * k;
        sum +=
            capsule_contact({{0.02, 0.01 - shift, 0.03}, {0.03, 0.03, 0.01 + shift}, 0.008}, shape)
                .distance_m;
      }
      times_ns.push_back((now_ns() - begin_ns) / kPairs);
    }
    if (!std::isfinite(sum)) std::exit(1);
    std::printf("distance of a capsule from a %s\t%.4g\t%.4g\t\t\t\n",
                kind == ObjectShape::Kind::box ? "box" : "cylinder", at_share(times_ns, 0.5),
                at_share(times_ns, 0.99));
  }
}

}  // namespace

}  // namespace isograsp

int main() {
  isograsp::step_with("step, two digits touch", 2);
  isograsp::step_with("step, three digits touch", 3);
  isograsp::step_with("step, five digits press", 5);
  isograsp::criteria();
  isograsp::distances();
}
