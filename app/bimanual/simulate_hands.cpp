// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate, scenes with two hands: pushes in, hands, bubbles, view and object out.
#include <vector>

#include "app/bimanual/hand_forces.hpp"
#include "app/hands_simulation.hpp"
#include "app/simulation/table_files.hpp"
#include "bimanual/carried_object.hpp"
#include "bimanual/read_hands.hpp"
#include "bimanual/two_hands.hpp"

namespace isograsp::app {

namespace {

using bimanual::HandsInput;
using bimanual::HandsState;
using bimanual::kSides;
constexpr const char* kSideNames[] = {"left", "right"};

/// The rows of both hands.
struct PushRow {
  double t_s = 0.0;
  HandsInput input;
};

Result<std::vector<PushRow>> read_pushes(const std::string& path) {
  const auto grid = read_time_grid([&] { return open_table(path); });
  if (!grid) return grid.error();
  std::vector<PushRow> rows;
  for (std::size_t side = 0; side < kSides; ++side) {
    auto reader = HandForcesReader::open(path, static_cast<bimanual::Side>(side), {.push = true});
    if (!reader) return reader.error();
    HandForcesRow hand;
    for (std::size_t k = 0;; ++k) {
      const auto more = reader->next(hand);
      if (!more) return more.error();
      if (!*more) break;
      if (!hand.push_W) return reader->no_sample();
      if (side == 0) rows.push_back({hand.t_s, {}});
      rows[k].input.push_N[side] = hand.push_W->force;
      rows[k].input.clutch[side] = hand.clutch;
    }
  }
  return rows;
}

std::vector<std::string> hands_columns() {
  std::vector<std::string> names{"t_s"};
  for (const char* side : kSideNames) add_three(names, std::string(side) + "_", "_m");
  for (const char* side : kSideNames) add_three(names, std::string(side) + "_bubble_", "_m");
  names.insert(names.end(), {"left_excess", "right_excess"});
  add_three(names, "view_", "_m");
  names.insert(names.end(), {"view_yaw_rad", "view_distance_m"});
  for (const char* side : kSideNames) names.push_back(std::string(side) + "_squeeze_N");
  names.insert(names.end(), {"grasp", "joint"});
  add_three(names, "", "_m");
  names.insert(names.end(), {"qw", "qx", "qy", "qz"});
  add_three(names, "v", "_mps");
  add_three(names, "w", "_radps");
  return names;
}

void put_hands(NumberRows& out, const HandsState& hands) {
  for (const Vec3& p : hands.p_W) out.put(p);
  for (const Vec3& p : hands.bubble_W) out.put(p);
  for (const double excess : hands.excess) out.put(excess);
  out.put(hands.view.p_W);
  out.put(hands.view.yaw_rad);
  out.put(hands.view.distance_m);
}

void put_object(NumberRows& out, const ObjectState& object) {
  out.put(object.X_WO.p);
  out.put(object.X_WO.q);
  out.put(object.v_WO_W);
  out.put(object.w_WO_W);
}

}  // namespace

Result<void> simulate_hands(const HandsSimulation& options) {
  const auto scene = bimanual::parse_hands_scene(options.text, options.scene);
  if (!scene) return scene.error();
  if (scene->coupling == bimanual::Coupling::force) return simulate_pressed(*scene, options);
  if (scene->coupling == bimanual::Coupling::none) return simulate_uncoupled(options);
  if (scene->hands.explore == bimanual::Explore::prescribed)
    return refused("is no scene whose hands are moved by pushes"_text,
                   "write explore = \"bubble\", or give --proxies"_text)
        .at(options.scene)
        .about("hands");
  const auto rows = read_pushes(options.forces);
  if (!rows) return rows.error();
  const auto plan = Plan::compile(scene->object, (*rows)[1].t_s - (*rows)[0].t_s);
  if (!plan) return plan.error();
  auto rows_out = NumberRows::create(options.out, hands_columns());
  if (!rows_out) return rows_out.error();
  NumberRows& out = *rows_out;
  bimanual::TwoHands hands(scene->hands);
  bimanual::GraspOfHands grasp(scene->grasp.value_or(bimanual::GraspDetection{}),
                               scene->object.shape, scene->object.size_m);
  bimanual::CarriedObject object(*plan, scene->magnet);
  double hold_s = plan->hold_s();
  for (std::size_t k = 0; k < rows->size(); ++k) {
    const PushRow& row = (*rows)[k];
    if (k + 1 < rows->size()) hold_s = (*rows)[k + 1].t_s - row.t_s;
    const HandsState& seen = hands.see(row.input);
    const bool near = grasp.see(seen.p_W, seen.push_W_N, object.state().X_WO);
    const bool holds = scene->grasp && near;
    const bool joint = holds && scene->hands.joint_control;
    out.put(row.t_s);
    put_hands(out, seen);
    for (const double squeeze_N : grasp.squeeze_N()) out.put(squeeze_N);
    out.put(holds ? 1.0 : 0.0);
    out.put(joint ? 1.0 : 0.0);
    put_object(out, object.state());
    out.end();
    object.move(seen.p_W, grasp, hold_s);
    hands.move(hold_s, joint);
  }
  return out.commit();
}

}  // namespace isograsp::app
