// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate: the grasp model alone, finger forces in, trajectory out
// (docs/file_formats.md). Streams: its memory does not grow with the recording.
#include <array>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/hands_simulation.hpp"
#include "app/simulation/trajectory.hpp"
#include "bimanual/read_hands.hpp"
#include "core/files.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/scene.hpp"
#include "hand/finger_forces.hpp"
#include "hand/stale.hpp"

namespace isograsp::app {

namespace {

struct SimulateOptions {
  std::string scene;
  std::string forces;
  std::string proxies;  ///< in place of forces
  std::string pad_solver = "aggregate";
  std::string out;
  std::string hand;  ///< empty: the right one
};

Result<void> simulate(const SimulateOptions& options) {
  for (const std::string& in : {options.forces, options.proxies})
    if (auto different = check_different(in, options.out); !different) return different;
  auto text = read_text(options.scene);
  if (!text) return text.error();
  if (bimanual::has_hands(*text)) {
    if (!options.hand.empty())
      return refused("is not for scenes with two hands"_text, "leave it out"_text).about("--hand");
    return options.proxies.empty()
               ? simulate_hands({options.scene, *text, options.forces, options.out})
               : simulate_pads({options.scene, *text, options.proxies, options.out},
                               options.pad_solver);
  }
  if (!options.proxies.empty())
    return refused("has no pads that proxies could lead"_text, "give --forces"_text)
        .at(options.scene);
  auto scene = parse_scene(*text, options.scene);
  if (!scene) return scene.error();
  // A first pass over the times alone: the length of a hold depends on all of them.
  const auto grid = read_time_grid([&] { return open_table(options.forces); });
  if (!grid) return grid.error();
  const auto plan =
      Plan::compile(for_hand(std::move(*scene), hand_from_name(options.hand).value_or(Hand::right)),
                    grid->hold_s);
  if (!plan) return plan.error();
  const auto used = plan->scene().fingers_used();
  auto table = open_table(options.forces);
  if (!table) return table.error();
  auto forces = FingerForcesReader::open(*std::move(table), used);
  if (!forces) return forces.error();

  std::vector<std::string> contacts;
  for (const std::string_view finger : kFingerNames)
    contacts.push_back(std::string(finger) + "_contact");
  auto trajectory = TrajectoryWriter::create(options.out, contacts);
  if (!trajectory) return trajectory.error();
  ObjectState state = plan->initial_state();
  GraspWrench wrench;
  StaleRule stale;
  bool frozen = false;
  HoldCount count;
  const auto move = [&](double hold_s) {
    ++count.all;
    if (frozen)
      ++count.frozen;
    else
      plan->move(wrench, hold_s, state);
    if (state.tolerance_exceeded && !frozen) ++count.inexact;
  };
  FingerForcesRow row;
  FingerForcesRow next;
  if (auto first = forces->next(row); !first) return first.error();
  double hold_s = grid->hold_s;
  for (bool more = true; more;) {
    const auto read = forces->next(next);
    if (!read) return read.error();
    more = *read;
    // The last row holds as long as the row before it.
    if (more && !grid->regular) hold_s = next.t_s - row.t_s;
    frozen = stale.apply(row.wrench_C, row.present, used, hold_s) == StaleRule::Verdict::frozen;
    if (!frozen) wrench = plan->grasp(row.wrench_C, state);
    trajectory->add(row.t_s, state, wrench.F_O_W, wrench.contact);
    move(hold_s);
    if (!more) trajectory->add(row.t_s + hold_s, state, wrench.F_O_W, wrench.contact);
    row = next;
  }
  if (const auto done = trajectory->commit(); !done) return done.error();
  count.print_notes();
  return {};
}

}  // namespace

void add_simulate(CommandLine& line) {
  Subcommand command = line.subcommand("simulate", "Run the grasp model alone on recorded forces");
  const auto options = std::make_shared<SimulateOptions>();
  command.option("--scene", options->scene, "Scene (TOML)").required();
  OptionGroup motion = command.exactly_one("What moves");
  motion.option("--forces", options->forces,
                "Forces of fingers, or pushes of two hands (CSV, HDF5)");
  motion.option("--proxies", options->proxies,
                "Of a scene with pads: where what leads them is (CSV, HDF5)");
  command.option("--pad-solver", options->pad_solver, "Of a scene with pads")
      .one_of({"pointwise", "aggregate", "aggregate_exact"})
      .shows_default();
  command.option("--out", options->out, "Trajectory to write (CSV; HDF5 if its name ends in .h5)")
      .required();
  command.option("--hand", options->hand, "Which hand presses: right, if nothing is said")
      .one_of({"right", "left"});
  command.footer(
      "Example: isograsp simulate --scene library/scenes/planar_block.toml --forces forces.csv "
      "--out trajectory.csv");
  command.runs([options] { return simulate(*options); });
}

}  // namespace isograsp::app
