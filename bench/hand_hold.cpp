// SPDX-License-Identifier: GPL-3.0-or-later
// The hold of bench/hold_scene.hpp by the whole virtual hand, in the steps of a session.
#include "bench/default_hand.hpp"
#include "bench/hold_scene.hpp"
#include "hand_world/world.hpp"

namespace isograsp {

namespace {

using namespace bench;
using namespace hand_world;
using namespace virtual_hand;

/// A hand whose first `digits` are led into the box from both sides.
class Grip {
 public:
  explicit Grip(std::size_t digits) : digits_(digits), model_(default_hand()) {
    pose_.X_WP.p = {0.0, 0.25, 0.1};
    pose_.angles[0] = {0.5, 0.3, 0.3, 0.3};
    for (std::size_t d = 1; d < kDigitCount; ++d) pose_.angles[d] = {0.0, 0.7, 0.7, 0.3};
    // Turned so that the digits press along x, with the box upright.
    const Mat3 R_WB = axes_of(hand_in_space(model_, pose_));
    pose_.X_WP.q = Quat(Mat3(R_WB.transpose())).normalized();
    const HandInSpace hand = hand_in_space(model_, pose_);
    constexpr double kGap_m = 0.002;
    half_m_ = 0.5 * (others_of(hand) - pad(hand, 0)).norm() - model_.digits[0].radii_m[2] - kGap_m;
    middle_ = 0.5 * (others_of(hand) + pad(hand, 0)) + kBeside_m * Vec3::UnitZ();
    open_ = still_target(hand);
  }
  [[nodiscard]] World world() const {
    ObjectBody box =
        solid_object({ObjectShape::Kind::box, {half_m_, kBoxHalf_y_m, kBoxHalf_z_m}}, 1.0);
    box.inertia_kg_m2 *= kBoxMass_kg / box.mass_kg;
    box.mass_kg = kBoxMass_kg;
    World world(box, WorldRules());
    world.place_hand(model_, pose_);
    ObjectMotion motion;
    motion.X_WO.p = middle_;
    world.place_object(motion);
    world.place_ground({middle_.y() - kBoxHalf_y_m, {}});  // it stands until it is lifted
    return world;
  }
  [[nodiscard]] HandTarget target(double t_s, double press_m) const {
    HandTarget now = open_;
    const Vec3 lift = height_at(t_s) * Vec3::UnitY(), rise = rise_at(t_s) * Vec3::UnitY();
    const auto move = [&](LinkMotion& link) {
      link.X_W.p += lift;
      link.v_m_s += rise;
    };
    move(now.palm);
    for (std::size_t d = 0; d < kDigitCount; ++d)
      for (LinkMotion& link : now.links[d]) {
        move(link);
        if (d < digits_) link.X_W.p += (d == 0 ? press_m : -press_m) * Vec3::UnitX();
      }
    return now;
  }
  /// How far the digits are led for the thumb to press with kPress_N.
  [[nodiscard]] double press_m() const {
    double little_m = 0.0, much_m = 0.03;
    for (int halving = 0; halving < 20; ++halving) {
      const double press_m = 0.5 * (little_m + much_m);
      World world = this->world();
      for (int k = 0; k < 1000; ++k) world.step(kStep_s, target(0.0, press_m));
      (world.touches()[0].normal_N < kPress_N ? little_m : much_m) = press_m;
    }
    return little_m;
  }

 private:
  [[nodiscard]] static Vec3 pad(const HandInSpace& hand, std::size_t d) {
    return 0.5 * (hand.digits[d].joints[2] + hand.digits[d].joints[3]);
  }
  [[nodiscard]] Vec3 others_of(const HandInSpace& hand) const {
    Vec3 others = Vec3::Zero();
    for (std::size_t d = 1; d < digits_; ++d)
      others += pad(hand, d) / static_cast<double>(digits_ - 1);
    return others;
  }
  [[nodiscard]] Mat3 axes_of(const HandInSpace& hand) const {
    const Vec3 across = (others_of(hand) - pad(hand, 0)).normalized();
    const Vec3 up = across.cross(hand.digits[1].axes[1]).normalized();
    Mat3 R_WB;
    R_WB << across, up, across.cross(up);
    return R_WB;
  }

  std::size_t digits_;
  HandModel model_;
  HandPose pose_;
  double half_m_ = 0.0;
  Vec3 middle_;
  HandTarget open_;
};

void hold(std::size_t digits) {
  const Grip grip(digits);
  const double press_m = grip.press_m();
  World world = grip.world();
  Hold hold;
  const int steps = static_cast<int>(kEnd_s / kStep_s);
  for (int k = 0; k < steps; ++k) {
    const double t_s = (k + 0.5) * kStep_s;
    const HandTarget target = grip.target(t_s, press_m);
    const double begin_ns = processor_ns();
    world.step(kStep_s, target);
    hold.timed(processor_ns() - begin_ns);
    const HandInSpace hand = world.hand()->in_space();
    const Pose& X_WO = world.object().motion().X_WO;
    hold.look(t_s, X_WO.q.conjugate() * (hand.digits[0].joints[kLinkCount] - X_WO.p), X_WO.q);
  }
  double depth_m = 0.0;
  for (std::size_t d = 0; d < digits; ++d) depth_m = std::max(depth_m, -world.touches()[d].gap_m);
  hold.print("IsoGrasp, whole hand", static_cast<int>(digits), depth_m);
}

}  // namespace

}  // namespace isograsp

int main() {
  isograsp::hold(2);
  isograsp::hold(3);
}
