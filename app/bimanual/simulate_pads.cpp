// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate --proxies: soft pads that are led hold an object.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/console.hpp"
#include "app/hands_simulation.hpp"
#include "app/simulation/table_files.hpp"
#include "bimanual/pads/held_by_pads.hpp"
#include "bimanual/read_hands.hpp"

namespace isograsp::app {

namespace {

using bimanual::kSides;
using Proxies = std::array<Pose, kSides>;

/// A row of proxies: places, rotation vectors and gravity.
struct ProxyRow {
  double t_s = 0.0;
  std::array<Vec3, kSides> p_W;
  std::array<Vec3, kSides> rotation_rad;
  double gravity_y_m_s2 = 0.0;
};

class ProxyTable {
 public:
  static Result<ProxyTable> open(const std::string& path) {
    auto table = open_table(path);
    if (!table) return table.error();
    ProxyTable proxies(*std::move(table));
    std::vector<std::string> names{"t_s"};
    for (const std::string side : {"left_", "right_"}) {
      add_three(names, side, "_m");
      add_three(names, side + "r", "_rad");
    }
    for (const std::string& name : names) {
      const auto place = proxies.table_->find(name);
      if (!place)
        return proxies.table_->error_here(name, "the column is missing"_text,
                                          "add the column"_text);
      proxies.places_.push_back(*place);
    }
    if (const auto gravity = proxies.table_->find(kGravity)) proxies.places_.push_back(*gravity);
    proxies.fields_.resize(proxies.table_->columns().size());
    return proxies;
  }

  /// Nothing: there is no further row.
  Result<std::optional<ProxyRow>> next() {
    const auto more = table_->next(fields_);
    if (!more) return more.error();
    if (!*more) return std::optional<ProxyRow>();
    std::vector<double> values;
    for (const std::size_t place : places_) {
      if (std::isnan(fields_[place]))
        return table_->error_here(table_->columns()[place], "is empty"_text, "write a number"_text);
      values.push_back(fields_[place]);
    }
    ProxyRow row;
    row.t_s = values[0];
    for (std::size_t side = 0; side < kSides; ++side) {
      const double* const of = values.data() + 1 + 6 * side;
      row.p_W[side] = {of[0], of[1], of[2]};
      row.rotation_rad[side] = {of[3], of[4], of[5]};
    }
    if (values.size() > 1 + 6 * kSides) row.gravity_y_m_s2 = values.back();
    return std::optional<ProxyRow>(row);
  }
  [[nodiscard]] Error error_here(Text what, Text remedy) const {
    return table_->error_here("t_s", std::move(what), std::move(remedy));
  }

 private:
  static constexpr const char* kGravity = "gravity_y_m_s2";

  explicit ProxyTable(std::unique_ptr<TableReader> table) : table_(std::move(table)) {}
  std::unique_ptr<TableReader> table_;
  std::vector<std::size_t> places_;  ///< t_s, six of each hand, gravity if there is such a column
  std::vector<double> fields_;
};

/// Between two rows everything goes straight.
Proxies between(const ProxyRow& a, const ProxyRow& b, double t_s) {
  const double share = b.t_s > a.t_s ? (t_s - a.t_s) / (b.t_s - a.t_s) : 0.0;
  Proxies proxies;
  for (std::size_t side = 0; side < kSides; ++side) {
    proxies[side].p = a.p_W[side] + share * (b.p_W[side] - a.p_W[side]);
    const Vec3 rotation =
        a.rotation_rad[side] + share * (b.rotation_rad[side] - a.rotation_rad[side]);
    const double angle_rad = rotation.norm();
    proxies[side].q = angle_rad == 0.0 ? Quat::Identity()
                                       : Quat(Eigen::AngleAxisd(angle_rad, rotation / angle_rad));
  }
  return proxies;
}

std::vector<std::string> pads_columns(const std::vector<bimanual::PadSpec>& pads) {
  std::vector<std::string> names{"t_s", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"};
  for (const bimanual::PadSpec& pad : pads) {
    const std::string pad_name = pad.hand == bimanual::Side::left ? "left_pad_" : "right_pad_";
    add_three(names, pad_name + "f", "_N");
    add_three(names, pad_name + "t", "_Nm");
  }
  return names;
}

void add_row(NumberRows& out, double t_s, const bimanual::HeldByPads& held) {
  out.put(t_s);
  out.put(held.X_WO().p);
  out.put(held.X_WO().q);
  for (const Wrench& wrench : held.wrenches()) {
    out.put(wrench.force);
    out.put(wrench.torque);
  }
  out.end();
}

}  // namespace

Result<void> simulate_pads(const HandsSimulation& options, const std::string& solver) {
  const auto scene = bimanual::parse_hands_scene(options.text, options.scene);
  if (!scene) return scene.error();
  if (scene->pads.empty())
    return refused("has no pads that proxies could lead"_text, "give --forces"_text)
        .at(options.scene);
  const auto& names = bimanual::kPadSolverNames;
  const auto chosen = static_cast<bimanual::PadSolver>(
      std::find(names.begin(), names.end(), solver) - names.begin());
  auto table = ProxyTable::open(options.forces);
  if (!table) return table.error();
  auto row = table->next();
  if (!row) return row.error();
  if (!*row) return refused("has no rows"_text, "record for longer"_text).at(options.forces);
  auto out = NumberRows::create(options.out, pads_columns(scene->pads));
  if (!out) return out.error();
  ProxyRow last = **row;
  bimanual::HeldByPads held(scene->object, scene->pads, scene->pad_step_s, chosen,
                            between(last, last, last.t_s));
  add_row(*out, last.t_s, held);
  const double start_s = last.t_s;
  std::int64_t steps = 0;
  constexpr double kSlack = 1e-9;  // of a step: sums of steps are rounded
  for (;;) {
    row = table->next();
    if (!row) return row.error();
    if (!*row) break;
    const ProxyRow next = **row;
    if (!(next.t_s > last.t_s))
      return table->error_here("does not come after the row before"_text,
                               "put the rows in order"_text);
    for (;;) {
      const double end_s = start_s + static_cast<double>(steps + 1) * scene->pad_step_s;
      if (end_s > next.t_s + kSlack * scene->pad_step_s) break;
      held.step(between(last, next, std::min(end_s, next.t_s)),
                scene->object.gravity_m_s2 + Vec3(0.0, next.gravity_y_m_s2, 0.0));
      ++steps;
      add_row(*out, end_s, held);
    }
    last = next;
  }
  if (!held.settled())
    print_note("some steps ended before their sweeps had settled: forces there are not exact"_text);
  return out->commit();
}

}  // namespace isograsp::app
