// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate --proxies: soft pads that are led hold an object.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/console.hpp"
#include "app/hands_simulation.hpp"
#include "bimanual/pads/held_by_pads.hpp"
#include "bimanual/read_hands.hpp"
#include "core/csv.hpp"
#include "core/tables/word_table.hpp"

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
    auto table = WordTable::open(path);
    if (!table) return table.error();
    ProxyTable proxies(*std::move(table));
    std::vector<std::string> names{"t_s"};
    for (const char* side : {"left", "right"}) {
      for (const char axis : {'x', 'y', 'z'})
        names.push_back(std::string(side) + "_" + axis + "_m");
      for (const char axis : {'x', 'y', 'z'})
        names.push_back(std::string(side) + "_r" + axis + "_rad");
    }
    for (const std::string& name : names) {
      const auto place = proxies.table_.require(name);
      if (!place) return place.error();
      proxies.places_.push_back(*place);
    }
    proxies.gravity_ = proxies.table_.find("gravity_y_m_s2");
    return proxies;
  }

  /// Nothing: there is no further row.
  Result<std::optional<ProxyRow>> next() {
    const auto more = table_.next();
    if (!more) return more.error();
    if (!*more) return std::optional<ProxyRow>();
    std::vector<double> values;
    for (const std::size_t place : places_) {
      const auto number = table_.required_number(place);
      if (!number) return number.error();
      values.push_back(*number);
    }
    ProxyRow row;
    row.t_s = values[0];
    for (std::size_t side = 0; side < kSides; ++side) {
      const double* const of = values.data() + 1 + 6 * side;
      row.p_W[side] = {of[0], of[1], of[2]};
      row.rotation_rad[side] = {of[3], of[4], of[5]};
    }
    if (gravity_) {
      const auto gravity = table_.required_number(*gravity_);
      if (!gravity) return gravity.error();
      row.gravity_y_m_s2 = *gravity;
    }
    return std::optional<ProxyRow>(row);
  }
  [[nodiscard]] Error error_here(Text what, Text remedy) const {
    return table_.error_here("t_s", std::move(what), std::move(remedy));
  }

 private:
  explicit ProxyTable(WordTable table) : table_(std::move(table)) {}
  WordTable table_;
  std::vector<std::size_t> places_;
  std::optional<std::size_t> gravity_;
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

std::string pads_header(const std::vector<bimanual::PadSpec>& pads) {
  std::string head = "t_s,x_m,y_m,z_m,qw,qx,qy,qz";
  for (const bimanual::PadSpec& pad : pads) {
    const std::string name = pad.hand == bimanual::Side::left ? "left_pad_" : "right_pad_";
    for (const char axis : {'x', 'y', 'z'}) head += "," + name + "f" + axis + "_N";
    for (const char axis : {'x', 'y', 'z'}) head += "," + name + "t" + axis + "_Nm";
  }
  return head + "\n";
}

std::string pads_row(double t_s, const bimanual::HeldByPads& held) {
  std::string row;
  const auto put = [&row](double number) {
    if (!row.empty()) row += ',';
    append_number(row, number);
  };
  put(t_s);
  for (const double place : held.X_WO().p) put(place);
  const Quat& q = held.X_WO().q;
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) put(part);
  for (const Wrench& wrench : held.wrenches()) {
    for (const double part : wrench.force) put(part);
    for (const double part : wrench.torque) put(part);
  }
  return row + "\n";
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
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();
  ProxyRow last = **row;
  bimanual::HeldByPads held(scene->object, scene->pads, scene->pad_step_s, chosen,
                            between(last, last, last.t_s));
  file->write(pads_header(scene->pads));
  file->write(pads_row(last.t_s, held));
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
      file->write(pads_row(end_s, held));
    }
    last = next;
  }
  if (!held.settled())
    print_note("some steps ended before their sweeps had settled: forces there are not exact"_text);
  return file->commit();
}

}  // namespace isograsp::app
