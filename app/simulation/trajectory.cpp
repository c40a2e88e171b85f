// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/trajectory.hpp"

#include "app/console.hpp"

namespace isograsp::app {

Result<TrajectoryWriter> TrajectoryWriter::create(const std::string& path,
                                                  std::span<const std::string> contacts) {
  std::vector<std::string> columns{"t_s"};
  add_three(columns, "", "_m");
  columns.insert(columns.end(), {"qw", "qx", "qy", "qz"});
  add_three(columns, "v", "_mps");
  add_three(columns, "w", "_radps");
  add_three(columns, "f", "_N");
  add_three(columns, "t", "_Nm");
  columns.insert(columns.end(), contacts.begin(), contacts.end());
  auto rows = NumberRows::create(path, columns);
  if (!rows) return rows.error();
  return TrajectoryWriter(*std::move(rows));
}

void TrajectoryWriter::add(double t_s, const ObjectState& state, const Wrench& F_O_W,
                           std::span<const bool> touching) {
  rows_.put(t_s);
  rows_.put(state.X_WO.p);
  rows_.put(state.X_WO.q);
  rows_.put(state.v_WO_W);
  rows_.put(state.w_WO_W);
  rows_.put(F_O_W.force);
  rows_.put(F_O_W.torque);
  for (const bool touches : touching) rows_.put(touches ? 1.0 : 0.0);
  rows_.end();
}

void HoldCount::print_notes() const {
  if (frozen > 0)
    print_note("the state stood still in %1 of %2 holds: no valid sample for over 50 ms"_text(
        frozen, all));
  if (inexact > 0)
    print_note(
        "%1 of %2 holds were too stiff for the stated tolerance; the trajectory is finite there "
        "but not exact"_text(inexact, all));
}

}  // namespace isograsp::app
