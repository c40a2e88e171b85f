// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate, scenes with two hands: pushes in, hands, bubbles, view and object out.
#include <cmath>
#include <optional>
#include <vector>

#include "app/console.hpp"
#include "app/hands_simulation.hpp"
#include "bimanual/carried_object.hpp"
#include "bimanual/read_hands.hpp"
#include "bimanual/two_hands.hpp"
#include "core/csv.hpp"
#include "core/tables/word_table.hpp"

namespace isograsp::app {

namespace {

using bimanual::HandsInput;
using bimanual::HandsState;
using bimanual::kSides;
constexpr const char* kSideNames[] = {"left", "right"};

struct PushRow {
  double t_s = 0.0;
  HandsInput input;
};

/// Where the columns of the pushes stand.
struct PushColumns {
  std::size_t t_s = 0;
  std::array<std::array<std::size_t, 3>, kSides> push{};
  std::array<std::optional<std::size_t>, kSides> clutch;

  static Result<PushColumns> find(const WordTable& table) {
    PushColumns columns;
    const auto t_s = table.require("t_s");
    if (!t_s) return t_s.error();
    columns.t_s = *t_s;
    for (std::size_t side = 0; side < kSides; ++side) {
      const std::string name = kSideNames[side];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto place = table.require(name + "_push_" + "xyz"[axis] + "_N");
        if (!place) return place.error();
        columns.push[side][axis] = *place;
      }
      columns.clutch[side] = table.find(name + "_clutch");
    }
    return columns;
  }
};

Result<PushRow> read_push(const WordTable& table, const PushColumns& columns) {
  PushRow row;
  const auto t_s = table.required_number(columns.t_s);
  if (!t_s) return t_s.error();
  row.t_s = *t_s;
  for (std::size_t side = 0; side < kSides; ++side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto push_N = table.required_number(columns.push[side][axis]);
      if (!push_N) return push_N.error();
      row.input.push_N[side][static_cast<Eigen::Index>(axis)] = *push_N;
    }
    if (!columns.clutch[side]) continue;
    const auto held = table.required_number(*columns.clutch[side]);
    if (!held) return held.error();
    row.input.clutch[side] = *held != 0.0;
  }
  return row;
}

Result<std::vector<PushRow>> read_pushes(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  const auto columns = PushColumns::find(*table);
  if (!columns) return columns.error();
  std::vector<PushRow> rows;
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) break;
    const auto row = read_push(*table, *columns);
    if (!row) return row.error();
    if (!rows.empty() && !(row->t_s > rows.back().t_s))
      return table->error_here("t_s", "does not come after the row before"_text,
                               "put the rows in order"_text);
    rows.push_back(*row);
  }
  if (rows.size() < 2)
    return refused("has fewer than two rows"_text, "record for longer"_text).at(path);
  return rows;
}

/// One line of numbers after the other.
class NumberLines {
 public:
  explicit NumberLines(FileWriter file) : file_(std::move(file)) {}
  void head(const std::string& line) { file_.write(line + "\n"); }
  void put(double number) {
    if (!line_.empty()) line_ += ',';
    append_number(line_, number);
  }
  void put(const Vec3& v) {
    for (const double number : v) put(number);
  }
  void end() {
    file_.write(line_ + "\n");
    line_.clear();
  }
  [[nodiscard]] Result<void> commit() { return file_.commit(); }

 private:
  FileWriter file_;
  std::string line_;
};

std::string hands_header() {
  std::string head = "t_s";
  const auto three = [&](const std::string& name, const std::string& unit) {
    for (const char axis : {'x', 'y', 'z'}) head += "," + name + axis + unit;
  };
  for (const char* side : kSideNames) three(std::string(side) + "_", "_m");
  for (const char* side : kSideNames) three(std::string(side) + "_bubble_", "_m");
  head += ",left_excess,right_excess";
  three("view_", "_m");
  head += ",view_yaw_rad,view_distance_m,left_squeeze_N,right_squeeze_N,grasp,joint";
  three("", "_m");
  head += ",qw,qx,qy,qz";
  three("v", "_mps");
  three("w", "_radps");
  return head;
}

void put_hands(NumberLines& out, const HandsState& hands) {
  for (const Vec3& p : hands.p_W) out.put(p);
  for (const Vec3& p : hands.bubble_W) out.put(p);
  for (const double excess : hands.excess) out.put(excess);
  out.put(hands.view.p_W);
  out.put(hands.view.yaw_rad);
  out.put(hands.view.distance_m);
}

void put_object(NumberLines& out, const ObjectState& object) {
  out.put(object.X_WO.p);
  const Quat& q = object.X_WO.q;
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) out.put(part);
  out.put(object.v_WO_W);
  out.put(object.w_WO_W);
}

}  // namespace

Result<void> simulate_hands(const HandsSimulation& options) {
  const auto scene = bimanual::parse_hands_scene(options.text, options.scene);
  if (!scene) return scene.error();
  if (scene->coupling != bimanual::Coupling::proxy ||
      scene->hands.explore == bimanual::Explore::prescribed)
    return refused("is no scene whose hands are moved by pushes"_text,
                   "write coupling = \"proxy\" and explore = \"bubble\""_text)
        .at(options.scene)
        .about("hands");
  const auto rows = read_pushes(options.forces);
  if (!rows) return rows.error();
  const auto plan = Plan::compile(scene->object, (*rows)[1].t_s - (*rows)[0].t_s);
  if (!plan) return plan.error();
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();
  NumberLines out(std::move(*file));
  out.head(hands_header());
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
