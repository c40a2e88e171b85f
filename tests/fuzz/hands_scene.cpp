// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with two hands: what is accepted can be moved; the hands never cross, what they carry and
// what pads hold stays a place.
#include <algorithm>
#include <cmath>

#include "bimanual/carried_object.hpp"
#include "bimanual/grasp_of_hands.hpp"
#include "bimanual/pressed_by_hands.hpp"
#include "bimanual/read_hands.hpp"
#include "bimanual/two_hands.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;
using namespace isograsp::bimanual;

namespace {

constexpr double kRow_s = 0.01;

bool a_place(const Pose& X) {
  return X.p.allFinite() && X.q.coeffs().allFinite();
}

void move_by_pushes(const HandsScene& scene) {
  const auto plan = Plan::compile(scene.object, kRow_s);
  if (!plan) return;
  TwoHands hands(scene.hands);
  GraspOfHands grasp(scene.grasp.value_or(GraspDetection{}), scene.object.shape,
                     scene.object.size_m);
  CarriedObject object(*plan, scene.magnet);
  for (int k = 0; k < 40; ++k) {
    HandsInput input;
    const double turn = 0.7 * k;
    for (std::size_t side = 0; side < kSides; ++side) {
      const double in = side == index_of(Side::left) ? 1.0 : -1.0;
      input.push_N[side] = {in * 0.5 * k, 3.0 * std::sin(turn), in * 9.0 * std::cos(turn)};
      input.clutch[side] = k % 7 == 3;
    }
    const HandsState& seen = hands.see(input);
    const bool holds = grasp.see(seen.p_W, seen.push_W_N, object.state().X_WO) && scene.grasp;
    fuzz::require(seen.p_W[0].allFinite() && seen.p_W[1].allFinite() && seen.view.p_W.allFinite() &&
                      std::isfinite(seen.view.distance_m),
                  "hands and view have a place");
    const Vec3 line = seen.bubble_W[1] - seen.bubble_W[0];
    const Vec3 between = seen.p_W[1] - seen.p_W[0];
    fuzz::require(line.x() * between.x() + line.z() * between.z() >= 0.0, "hands never cross");
    object.move(seen.p_W, grasp, kRow_s);
    fuzz::require(a_place(object.state().X_WO), "the object has a place");
    hands.move(kRow_s, holds && scene.hands.joint_control);
  }
}

void press(const HandsScene& scene) {
  const auto pressed = PressedByHands::compile(scene.object, scene.contacts, kRow_s);
  if (!pressed) return;
  PressedState state = pressed->initial_state();
  for (int k = 0; k < 40; ++k) {
    HandWrenches wrench_C{};
    for (FingerWrenches& hand : wrench_C)
      for (Wrench& wrench : hand) wrench = {{0.1 * k - 2.0, 1.0, 0.3 * k}, {0.0, 0.0, 0.01}};
    const PressedWrench wrench = pressed->grasp(wrench_C, state);
    fuzz::require(wrench.both.F_O_W.force.allFinite(), "what hands press is a number");
    pressed->move(wrench, state);
  }
}

void hold_by_pads(const HandsScene& scene) {
  constexpr std::size_t kMostPoints = 500;  // more take longer and tell nothing
  std::size_t points = 0;
  for (const PadSpec& pad : scene.pads)
    points += static_cast<std::size_t>(pad.face.rays) * static_cast<std::size_t>(pad.face.rings);
  if (scene.pads.empty() || points > kMostPoints) return;
  std::array<Pose, kSides> proxies;
  for (std::size_t side = 0; side < kSides; ++side)
    proxies[side].p = scene.hands.hands[side].center_m;
  HeldByPads held(scene.object, scene.pads, scene.pad_step_s, PadSolver::aggregate, proxies);
  for (int k = 0; k < 5; ++k) {
    proxies[0].p.x() += 1e-4;
    proxies[1].p.x() -= 1e-4;
    held.step(proxies, Vec3(0.0, -9.81, 0.0));
    fuzz::require(a_place(held.X_WO()), "what pads hold has a place");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto scene = parse_hands_scene(text, "scene.toml");
  if (!scene) {
    fuzz::require_helpful(scene.error(), text);
    return 0;
  }
  switch (scene->coupling) {
    case Coupling::none: break;
    case Coupling::force: press(*scene); break;
    case Coupling::proxy:
      move_by_pushes(*scene);
      hold_by_pads(*scene);
      break;
  }
  return 0;
}
