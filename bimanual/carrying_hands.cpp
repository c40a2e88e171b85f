// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/carrying_hands.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace isograsp::bimanual {

namespace {

/// Where the hands are, as proxies of pads.
std::array<Pose, kSides> proxies_of(const HandsState& hands) noexcept {
  std::array<Pose, kSides> proxies;
  for (std::size_t side = 0; side < kSides; ++side)
    proxies[side] = {hands.p_W[side], Quat::Identity()};
  return proxies;
}

std::array<Pose, kSides> between(const std::array<Pose, kSides>& from,
                                 const std::array<Pose, kSides>& to, double share) noexcept {
  std::array<Pose, kSides> proxies = to;
  for (std::size_t side = 0; side < kSides; ++side)
    proxies[side].p = from[side].p + share * (to[side].p - from[side].p);
  return proxies;
}

}  // namespace

Result<HandsScene> with_technique(HandsScene scene, const Technique& technique) {
  const auto refuse = [&](Text what, Text remedy, const char* field) {
    return refused(std::move(what), std::move(remedy)).at(scene.object.file).about(field);
  };
  if (scene.coupling != Coupling::proxy)
    return refuse("is no scene in which hands are points"_text,
                  "write coupling = \"proxy\" in [hands]"_text, "coupling");
  if (!scene.grasp)
    return refuse("does not say when hands hold the object"_text, "add [grasp_detection]"_text,
                  "grasp_detection");
  for (const std::size_t dof : {2U, 3U, 4U, 5U})
    if (scene.object.free[dof] && (dof != 5 || !technique.pinch))
      return refuse("moves in more than the plane of the screen"_text,
                    technique.pinch ? "write free = [\"x\", \"y\"], or \"rz\" with them"_text
                                    : "write free = [\"x\", \"y\"]"_text,
                    "free");
  scene.hands.explore = technique.clutch ? Explore::clutch : Explore::bubble;
  scene.hands.joint_control = technique.pinch;
  if (technique.pinch) {
    if (scene.magnet.mode == Magnet::Mode::off)
      return refuse("has no magnet that a pinch could use"_text,
                    "write [magnet] mode = \"constraint\""_text, "magnet");
    scene.pads.clear();
    return scene;
  }
  scene.magnet = {};
  for (const Side side : {Side::left, Side::right})
    if (std::none_of(scene.pads.begin(), scene.pads.end(),
                     [side](const PadSpec& pad) { return pad.hand == side; }))
      return refuse("gives a hand no pad to hold with"_text, "add a [[pad]] for each hand"_text,
                    "pad");
  return scene;
}

struct CarryingHands::Parts {
  Parts(const HandsScene& of, Plan compiled, double frame_s)
      : scene(of),
        plan(std::move(compiled)),
        period_s(frame_s),
        hands(of.hands),
        grasp(of.grasp.value_or(GraspDetection{}), of.object.shape, of.object.size_m),
        led(plan, of.magnet),
        object(plan.initial_state()) {
    proxies = proxies_of(hands.see({}));
    if (of.pads.empty()) return;
    steps = std::max(1, static_cast<int>(std::lround(frame_s / of.pad_step_s)));
    pads.emplace(of.object, of.pads, frame_s / steps, PadSolver::aggregate, proxies);
    pads->step(proxies, Vec3::Zero());  // takes its memory
    pads->begin(proxies);
  }

  void move_pads() noexcept {
    const std::array<Pose, kSides> now = proxies_of(hands.state());
    const Vec3 gravity = held ? scene.object.gravity_m_s2 : Vec3::Zero();
    for (int k = 1; k <= steps; ++k) {
      pads->step(between(proxies, now, static_cast<double>(k) / steps), gravity);
      if (!held) pads->put(object.X_WO);
    }
    proxies = now;
    if (!held) return;
    const Pose before = object.X_WO;
    object = plan.at_rest(pads->X_WO());
    object.v_WO_W = (object.X_WO.p - before.p) / period_s;
  }

  /// Each hand presses with a pad.
  [[nodiscard]] bool pads_press() const noexcept {
    std::array<bool, kSides> presses{};
    for (std::size_t k = 0; k < pads->pads().size(); ++k) {
      const PadSpec& pad = pads->pads()[k];
      if (pads->wrenches()[k].force.dot(pad.normal) > 0.0) presses[index_of(pad.hand)] = true;
    }
    return presses[0] && presses[1];
  }

  HandsScene scene;
  Plan plan;
  double period_s;
  TwoHands hands;
  GraspOfHands grasp;
  CarriedObject led;
  std::optional<HeldByPads> pads;
  int steps = 1;  ///< of the pads in a frame
  std::array<Pose, kSides> proxies;
  ObjectState object;
  bool held = false;
};

Result<CarryingHands> CarryingHands::compile(const HandsScene& scene, double period_s) {
  auto plan = Plan::compile(scene.object, period_s);
  if (!plan) return plan.error();
  return CarryingHands(std::make_unique<Parts>(scene, *std::move(plan), period_s));
}

CarryingHands::CarryingHands(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CarryingHands::CarryingHands(CarryingHands&&) noexcept = default;
CarryingHands& CarryingHands::operator=(CarryingHands&&) noexcept = default;
CarryingHands::~CarryingHands() = default;

void CarryingHands::begin_hands() noexcept {
  Parts& p = *parts_;
  p.hands = TwoHands(p.scene.hands);
  p.proxies = proxies_of(p.hands.see({}));
  if (p.pads) p.pads->begin(p.proxies);
  p.grasp.let_go();
  p.held = false;
}

void CarryingHands::put(const Pose& X_WO) noexcept {
  Parts& p = *parts_;
  p.object = p.plan.at_rest(X_WO);
  p.led.put(X_WO);
  if (p.pads) p.pads->put(p.object.X_WO);
  p.grasp.let_go();
  p.held = false;
}

void CarryingHands::see(const HandsInput& input) noexcept {
  Parts& p = *parts_;
  HandsInput acts = input;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!p.scene.object.free[static_cast<std::size_t>(axis)])
      for (Vec3& push_N : acts.push_N) push_N[axis] = 0.0;
  const HandsState& seen = p.hands.see(acts);
  const bool near = p.grasp.see(seen.p_W, seen.push_W_N, p.object.X_WO);
  // Pads that hold it do so as long as they press; whoever squeezes less only holds it worse.
  p.held = !p.pads ? near : p.held ? p.pads_press() : near && p.pads_press();
  if (p.pads && !p.held) p.grasp.let_go();
}

void CarryingHands::move() noexcept {
  Parts& p = *parts_;
  if (p.pads) {
    p.move_pads();
  } else if (p.held) {
    p.led.move(p.hands.state().p_W, p.grasp, p.period_s);
    p.object = p.led.state();
  } else {
    p.led.put(p.object.X_WO);
    p.object = p.led.state();
  }
  p.hands.move(p.period_s, joint());
}

const HandsScene& CarryingHands::scene() const noexcept {
  return parts_->scene;
}
const HandsState& CarryingHands::hands() const noexcept {
  return parts_->hands.state();
}
const std::array<double, kSides>& CarryingHands::squeeze_N() const noexcept {
  return parts_->grasp.squeeze_N();
}
const ObjectState& CarryingHands::object() const noexcept {
  return parts_->object;
}
bool CarryingHands::held() const noexcept {
  return parts_->held;
}
bool CarryingHands::joint() const noexcept {
  return parts_->held && parts_->scene.hands.joint_control;
}

}  // namespace isograsp::bimanual
