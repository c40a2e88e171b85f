// SPDX-License-Identifier: GPL-3.0-or-later
// Two soft pads hold a block still for ten seconds, 2.5 mm beside its middle. One line a case:
// name, rows, median and 99th percentile of the processor time of a step of 1 ms [ns], median of
// sweeps, how fast the block creeps out of the pads that hold it [m/s], [rad/s]. Peers do the same
// (bench/peers/mujoco_pads.cpp).
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "bimanual/pads/pad_scenes.hpp"

namespace isograsp {

namespace {

using namespace bimanual;

constexpr double kHold_s = 10.0, kSettled_s = 2.0;

double now_ns() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

/// Of the block in the axes of a pad.
Pose seen_from(const Pose& pad, const Pose& block) {
  return {pad.q.conjugate() * (block.p - pad.p), pad.q.conjugate() * block.q};
}

void hold(int points, PadSolver solver) {
  PadGrasp grasp = *pad_grasp(PadScene::edge, points);
  grasp.hand_m.y() = 0.0;
  grasp.hand_m.z() = 0.0025;
  grasp.pull_m_s2.setZero();
  grasp.turn_rad_s2 = 0.0;
  HeldByPads held(grasp.object, grasp.pads, grasp.step_s, solver, grasp.proxies(0.0));
  const int steps = static_cast<int>(kHold_s / grasp.step_s);
  const int settled = static_cast<int>(kSettled_s / grasp.step_s);
  std::vector<double> times_ns;
  std::vector<int> sweeps;
  Pose then;
  for (int k = 1; k <= steps; ++k) {
    const double t_s = k * grasp.step_s;
    const double begin_ns = now_ns();
    held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
    if (k > settled) {
      times_ns.push_back(now_ns() - begin_ns);
      sweeps.push_back(held.sweeps());
    }
    if (k == settled) then = seen_from(held.X_WP().front(), held.X_WO());
  }
  const Pose last = seen_from(held.X_WP().front(), held.X_WO());
  const double over_s = kHold_s - kSettled_s;
  std::sort(times_ns.begin(), times_ns.end());
  std::sort(sweeps.begin(), sweeps.end());
  std::printf("%s, %d points\t%zu\t%.0f\t%.0f\t%d\t%.3g\t%.3g\n",
              std::string(kPadSolverNames[static_cast<std::size_t>(solver)]).c_str(), points,
              held.constraints(), times_ns[times_ns.size() / 2],
              times_ns[times_ns.size() * 99 / 100], sweeps[sweeps.size() / 2],
              (last.p - then.p).norm() / over_s, last.q.angularDistance(then.q) / over_s);
}

}  // namespace

}  // namespace isograsp

int main() {
  using isograsp::bimanual::PadSolver;
  for (const PadSolver solver :
       {PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact})
    for (const int points : {12, 24, 48, 96, 176, 200}) isograsp::hold(points, solver);
}
