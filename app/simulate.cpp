// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate: the grasp model alone, finger forces in, trajectory out
// (docs/file_formats.md). Streams: its memory does not grow with the recording.
#include <array>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/hands_simulation.hpp"
#include "bimanual/read_hands.hpp"
#include "core/csv.hpp"
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
  std::string hand = "right";
};

constexpr std::string_view kTrajectoryHeader =
    "t_s,x_m,y_m,z_m,qw,qx,qy,qz,vx_mps,vy_mps,vz_mps,wx_radps,wy_radps,wz_radps,"
    "fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,thumb_contact,index_contact,middle_contact\n";

/// Prints rows straight into one block, which goes to the file when it is full.
class TrajectoryWriter {
 public:
  explicit TrajectoryWriter(FileWriter file) : file_(std::move(file)) {
    file_.write(kTrajectoryHeader);
  }

  void add(double t_s, const ObjectState& state, const GraspWrench& wrench) {
    const Vec3& p = state.X_WO.p;
    const Quat& q = state.X_WO.q;
    const Vec3& v = state.v_WO_W;
    const Vec3& w = state.w_WO_W;
    const Vec3& f = wrench.F_O_W.force;
    const Vec3& tau = wrench.F_O_W.torque;
    const std::array<double, kNumbers> numbers{t_s,   p.x(), p.y(), p.z(),   q.w(),   q.x(),  q.y(),
                                               q.z(), v.x(), v.y(), v.z(),   w.x(),   w.y(),  w.z(),
                                               f.x(), f.y(), f.z(), tau.x(), tau.y(), tau.z()};
    if (block_.size() - used_ < kLongestRow) flush();
    char* at = block_.data() + used_;
    for (const double number : numbers) {
      at = print_number(at, number);
      *at++ = ',';
    }
    for (const bool touching : wrench.contact) {
      *at++ = touching ? '1' : '0';
      *at++ = ',';
    }
    at[-1] = '\n';
    used_ = static_cast<std::size_t>(at - block_.data());
  }
  [[nodiscard]] Result<void> commit() {
    flush();
    return file_.commit();
  }

 private:
  static constexpr std::size_t kNumbers = 20;
  static constexpr std::size_t kLongestRow = kNumbers * (kLongestNumber + 1) + 2 * kFingerCount;

  void flush() {
    file_.write({block_.data(), used_});
    used_ = 0;
  }

  FileWriter file_;
  std::vector<char> block_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t used_ = 0;
};

Result<void> simulate(const SimulateOptions& options) {
  for (const std::string& in : {options.forces, options.proxies})
    if (auto different = check_different(in, options.out); !different) return different;
  auto text = read_text(options.scene);
  if (!text) return text.error();
  if (bimanual::has_hands(*text))
    return options.proxies.empty()
               ? simulate_hands({options.scene, *text, options.forces, options.out})
               : simulate_pads({options.scene, *text, options.proxies, options.out},
                               options.pad_solver);
  if (!options.proxies.empty())
    return refused("has no pads that proxies could lead"_text, "give --forces"_text)
        .at(options.scene);
  auto scene = parse_scene(*text, options.scene);
  if (!scene) return scene.error();
  // A first pass over the times alone: the length of a hold depends on all of them.
  const auto grid = read_time_grid(options.forces);
  if (!grid) return grid.error();
  const auto plan =
      Plan::compile(for_hand(std::move(*scene), *hand_from_name(options.hand)), grid->hold_s);
  if (!plan) return plan.error();
  const auto used = plan->scene().fingers_used();
  auto forces = FingerForcesReader::open(options.forces, used);
  if (!forces) return forces.error();
  auto out = FileWriter::create(options.out);
  if (!out) return out.error();

  TrajectoryWriter trajectory(std::move(*out));
  ObjectState state = plan->initial_state();
  GraspWrench wrench;
  StaleRule stale;
  bool frozen = false;
  std::size_t holds = 0;
  std::size_t frozen_holds = 0;
  std::size_t inexact_holds = 0;
  const auto move = [&](double hold_s) {
    ++holds;
    if (frozen)
      ++frozen_holds;
    else
      plan->move(wrench, hold_s, state);
    if (state.tolerance_exceeded && !frozen) ++inexact_holds;
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
    trajectory.add(row.t_s, state, wrench);
    move(hold_s);
    if (!more) trajectory.add(row.t_s + hold_s, state, wrench);
    row = next;
  }
  if (const auto done = trajectory.commit(); !done) return done.error();
  if (frozen_holds > 0)
    print_note("the state stood still in %1 of %2 holds: no valid sample for over 50 ms"_text(
        frozen_holds, holds));
  if (inexact_holds > 0)
    print_note(
        "%1 of %2 holds were too stiff for the stated tolerance; the trajectory is finite there "
        "but not exact"_text(inexact_holds, holds));
  return {};
}

}  // namespace

void add_simulate(CommandLine& line) {
  Subcommand command = line.subcommand("simulate", "Run the grasp model alone on recorded forces");
  const auto options = std::make_shared<SimulateOptions>();
  command.option("--scene", options->scene, "Scene (TOML)").required();
  OptionGroup motion = command.exactly_one("What moves");
  motion.option("--forces", options->forces, "Forces of fingers, or pushes of two hands (CSV)");
  motion.option("--proxies", options->proxies,
                "Of a scene with pads: where what leads them is (CSV)");
  command.option("--pad-solver", options->pad_solver, "Of a scene with pads")
      .one_of({"pointwise", "aggregate", "aggregate_exact"})
      .shows_default();
  command.option("--out", options->out, "Trajectory to write (CSV)").required();
  command.option("--hand", options->hand, "Which hand presses")
      .one_of({"right", "left"})
      .shows_default();
  command.footer(
      "Example: isograsp simulate --scene library/scenes/planar_block.toml --forces forces.csv "
      "--out trajectory.csv");
  command.runs([options] { return simulate(*options); });
}

}  // namespace isograsp::app
